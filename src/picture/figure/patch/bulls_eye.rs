//! The bull's-eye of a figure: colours, rings and sectors with their numbers, names of the walls, borders of patches.

use std::sync::Arc;

use crate::analysis::segments::{RING_RADII, Segment, ring};
use crate::picture::bulls_eye::{
    BullsEyeScale, PolarMap, PolarValues, ink_on, sector_line, sector_outline,
};
use crate::picture::figure::pen::Pen;
use crate::picture::legend::{ColourLegend, Tick};
use crate::picture::page::{Anchor, Mark, Page, Weight};
use crate::picture::patch_words::{PatchStanding, sentence};
use crate::render::Picture;

/// Lines between segments, and below borders of patches.
const BETWEEN: [f32; 3] = [0.09, 0.10, 0.12];
/// Of the lines of a hatch, through which the colours are still read.
const HATCH_OPACITY: f32 = 0.6;
/// Points along a line of a hatch at which it is looked for behind numbers.
const HATCH_STEPS: i32 = 40;
/// What has no value.
const NO_VALUE: [u8; 3] = [0x80, 0x85, 0x8c];
/// Borders of patches: seen on pale and on deep colours, above a dark line.
const BORDER: [f32; 3] = [1.0, 0.82, 0.40];
/// And of regions of low thickening without a verdict of a patch.
const FAINT: [f32; 3] = [0.78, 0.80, 0.83];
/// Walls by their angle, from the right against the clock.
const WALLS: [(f64, &str); 6] = [
    (30.0, "anterolateral"),
    (90.0, "anterior"),
    (150.0, "anteroseptal"),
    (210.0, "inferoseptal"),
    (270.0, "inferior"),
    (330.0, "inferolateral"),
];

/// What a bull's-eye shows.
#[derive(Clone, Debug, PartialEq)]
pub struct BullsEyeContent {
    /// The polar map of the wall; `None` without a long axis.
    pub flat: Option<(PolarMap, PolarValues)>,
    /// Why there is no polar map.
    pub without_flat: String,
    /// What it shows, in which colours and words.
    pub scale: BullsEyeScale,
    /// The pose that it shows: "ES", "frame 3".
    pub moment: String,
    /// What its patches may be called.
    pub standing: PatchStanding,
    /// One colour for each segment, where segments are known.
    pub by_segment: bool,
}

/// The unit disc on the page.
#[derive(Clone, Copy)]
struct Disc {
    centre: [f32; 2],
    radius: f32,
}

impl Disc {
    fn at(&self, [x, y]: [f64; 2]) -> [f32; 2] {
        let [cx, cy] = self.centre;
        [cx + self.radius * x as f32, cy - self.radius * y as f32]
    }

    fn polar(&self, angle_rad: f64, share: f64) -> [f32; 2] {
        let (sin, cos) = angle_rad.sin_cos();
        self.at([share * cos, share * sin])
    }

    fn circle(&self, share: f64) -> Vec<[f32; 2]> {
        let step = std::f64::consts::TAU / 180.0;
        (0..180)
            .map(|i| self.polar(f64::from(i) * step, share))
            .collect()
    }
}

/// Draws the bull's-eye with its colour bar into a rectangle.
pub(in crate::picture) fn draw_bulls_eye(
    pen: &mut Pen<'_>,
    content: &BullsEyeContent,
    low: [f32; 2],
    high: [f32; 2],
) {
    let Some((flat, shown)) = &content.flat else {
        let set = pen.regular(pen.theme.muted);
        let at = [0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1])];
        pen.write_within(
            &content.without_flat,
            set,
            Anchor::Middle,
            at,
            high[0] - low[0],
        );
        return;
    };
    let line = pen.line_height();
    let legend = legend(&content.scale, shown);
    // Wide enough wherever the bar begins.
    let heading_width = 0.6 * (high[0] - low[0]);
    let heading = (pen.fonts).wrapped(&title(content), Weight::Regular, pen.text, heading_width);
    let bar_height = (1.4 + heading.len() as f32) * line + 0.9 * pen.text;
    let names = pen.fonts.width("inferolateral", Weight::Regular, pen.text);
    let across = 0.5 * (high[0] - low[0]) - 0.72 * names;
    let down = 0.5 * (high[1] - bar_height - low[1]) - 1.4 * line;
    let disc = Disc {
        centre: [
            0.5 * (low[0] + high[0]),
            low[1] + 1.4 * line + down.max(1.0),
        ],
        radius: across.min(down).max(1.0),
    };
    let width = (pen.text / 14.0).max(1.0);
    let ground = NO_VALUE.map(|channel| f32::from(channel) / 255.0);
    pen.page.fill(&disc.circle(1.0), ground);
    if content.by_segment && flat.oriented {
        fill_segments(pen.page, shown, &content.scale, &disc);
    } else {
        let behind = colours(flat, shown, &content.scale, disc.radius);
        let corner = [disc.centre[0] - disc.radius, disc.centre[1] - disc.radius];
        pen.page
            .picture(corner, [2.0 * disc.radius; 2], Arc::new(behind));
    }
    for radius in RING_RADII {
        pen.page.line(&disc.circle(radius), true, width, BETWEEN);
    }
    if flat.oriented {
        for ends in Segment::all().filter_map(sector_line) {
            let ends = ends.map(|end| disc.at(end));
            pen.page.line(&ends, false, width, BETWEEN);
        }
    }
    let colour = match content.standing {
        PatchStanding::RegionOnly => FAINT,
        PatchStanding::NoVerdict
        | PatchStanding::UnclassifiedPatch
        | PatchStanding::AbnormalPatch => BORDER,
    };
    hatch(pen.page, flat, &disc, width);
    for border in flat.patches.iter().flat_map(|patch| &patch.borders) {
        let points: Vec<[f32; 2]> = border.iter().map(|&point| disc.at(point)).collect();
        pen.page.line(&points, true, 4.5 * width, BETWEEN);
        pen.page.line(&points, true, 2.6 * width, colour);
    }
    if flat.oriented {
        let borders = flat.patches.iter().flat_map(|patch| &patch.borders);
        let hatched = flat.patches.iter().flat_map(|patch| &patch.hatch);
        let hatched = hatched.flat_map(|(_, [from, to])| {
            let steps = (0..=HATCH_STEPS).map(|step| f64::from(step) / f64::from(HATCH_STEPS));
            steps.map(|share| [0, 1].map(|axis| from[axis] + share * (to[axis] - from[axis])))
        });
        let lines: Vec<[f32; 2]> = (borders.flatten().copied())
            .chain(hatched)
            .map(|point| disc.at(point))
            .collect();
        numbers(pen, &content.scale, shown, &disc, &lines);
        names_of_walls(pen, &disc);
    } else {
        let set = pen.regular(pen.theme.muted);
        let at = [disc.centre[0], disc.centre[1] - disc.radius - 0.5 * line];
        pen.write(
            "orientation not known: no segments",
            set,
            Anchor::Middle,
            at,
        );
    }
    let bar = (1.5 * disc.radius).min(high[0] - low[0]);
    let left = disc.centre[0] - 0.5 * bar;
    pen.colour_bar(&legend, &heading, [left, high[1]], bar);
}

/// Thin dark lines over the inside of patches: which side of an outline is the patch.
fn hatch(page: &mut Page, flat: &PolarMap, disc: &Disc, width: f32) {
    for (_, ends) in flat.patches.iter().flat_map(|patch| &patch.hatch) {
        page.marks.push(Mark::Line {
            points: ends.map(|end| disc.at(end)).to_vec(),
            closed: false,
            width: 0.8 * width,
            colour: BETWEEN,
            opacity: HATCH_OPACITY,
        });
    }
}

fn title(content: &BullsEyeContent) -> String {
    let title = sentence(&content.scale.title(&content.moment));
    let patches = (content.flat.as_ref()).is_some_and(|(flat, _)| !flat.patches.is_empty());
    if !patches {
        return format!("{title} (grey: no value)");
    }
    let part = content.standing.part().to_lowercase();
    format!("{title} (grey: no value; hatched: {part})")
}

/// The colours with numbers.
fn legend(scale: &BullsEyeScale, shown: &PolarValues) -> ColourLegend {
    let ticks = scale.ticks(5).into_iter().map(|(value, text)| Tick {
        value,
        position: scale.share(value) as f32,
        text,
    });
    let limits = scale.limits;
    ColourLegend {
        title: String::new(),
        unit: "",
        note: "",
        limits,
        ticks: ticks.collect(),
        map: scale.map.clone(),
        below: shown.values.iter().any(|&value| value < limits.low),
        above: shown.values.iter().any(|&value| value > limits.high),
    }
}

/// Number of each segment, and its mean below. Where lines run through, they are broken there, as contours are at their
/// heights.
fn numbers(
    pen: &mut Pen<'_>,
    scale: &BullsEyeScale,
    shown: &PolarValues,
    disc: &Disc,
    lines: &[[f32; 2]],
) {
    let size = (0.082 * disc.radius).min(1.2 * pen.text);
    for segment in Segment::all() {
        let [inner, outer] = ring(segment.level());
        let middle = if inner == 0.0 {
            disc.centre
        } else {
            disc.polar(segment.sector_rad()[0], 0.5 * (inner + outer))
        };
        let value = shown.segments[segment.index()];
        let behind = value
            .and_then(|value| scale.colour(value))
            .unwrap_or(NO_VALUE);
        let colour = ink_on(behind).map(|channel| f32::from(channel) / 255.0);
        let text = value.map_or_else(|| "–".to_owned(), |value| scale.text(value));
        let set = pen.strong(colour, size);
        let half = [
            0.5 * pen.fonts.width(&text, set.weight, size) + 0.5 * size,
            1.25 * size,
        ];
        let is_under = |point: &[f32; 2]| (0..2).all(|k| (point[k] - middle[k]).abs() < half[k]);
        if lines.iter().any(is_under) {
            let around = (0_u8..32).map(|step| {
                let (sin, cos) = (f32::from(step) * std::f32::consts::TAU / 32.0).sin_cos();
                [middle[0] + half[0] * cos, middle[1] + half[1] * sin]
            });
            let ground = behind.map(|channel| f32::from(channel) / 255.0);
            pen.page.fill(&around.collect::<Vec<_>>(), ground);
        }
        let mut small = pen.regular(colour);
        small.size = 0.72 * size;
        let at = [middle[0], middle[1] - 0.25 * size];
        pen.write(&segment.number().to_string(), small, Anchor::Middle, at);
        pen.write(
            &text,
            set,
            Anchor::Middle,
            [middle[0], middle[1] + 0.75 * size],
        );
    }
}

fn names_of_walls(pen: &mut Pen<'_>, disc: &Disc) {
    let text = pen.text;
    for (degrees, name) in WALLS {
        let [x, y] = disc.polar(
            degrees.to_radians(),
            1.0 + 0.6 * f64::from(text / disc.radius),
        );
        let side = degrees.to_radians().cos();
        let anchor = if side.abs() < 0.1 {
            Anchor::Middle
        } else if side > 0.0 {
            Anchor::Start
        } else {
            Anchor::End
        };
        // Below the middle a name hangs, above it stands.
        let down = (0.5 - 0.5 * degrees.to_radians().sin()) as f32;
        let set = pen.regular(pen.theme.muted);
        pen.write(name, set, anchor, [x, y + 0.75 * text * down]);
    }
}

/// Every segment in the colour of its mean.
fn fill_segments(page: &mut Page, shown: &PolarValues, scale: &BullsEyeScale, disc: &Disc) {
    for segment in Segment::all() {
        let value = shown.segments[segment.index()];
        let colour = value.and_then(|value| scale.colour(value));
        let outline = sector_outline(segment).into_iter();
        let corners: Vec<[f32; 2]> = outline.map(|point| disc.at(point)).collect();
        let colour = colour.unwrap_or(NO_VALUE);
        page.fill(&corners, colour.map(|channel| f32::from(channel) / 255.0));
    }
}

/// Every place its own colour, on transparent ground; twice as fine as the page, for smooth edges.
fn colours(flat: &PolarMap, shown: &PolarValues, scale: &BullsEyeScale, radius: f32) -> Picture {
    let side = (4.0 * radius).ceil().clamp(2.0, 4096.0) as u32;
    let mut rgba = vec![0; side as usize * side as usize * 4];
    let half = 0.5 * f64::from(side);
    for face in &flat.faces {
        let corner = |index: u32| {
            let [x, y] = *flat.points.get(index as usize)?;
            let value = f64::from(*shown.values.get(index as usize)?);
            Some(([half * (1.0 + x), half * (1.0 - y)], value))
        };
        let Some(corners) = face.map(corner).into_iter().collect::<Option<Vec<_>>>() else {
            continue;
        };
        let colour = |value| scale.colour(value).unwrap_or(NO_VALUE);
        fill_face(&mut rgba, side, &corners, colour);
    }
    Picture {
        width: side,
        height: side,
        rgba,
    }
}

/// Colours the pixels whose middle lies in a triangle by the number interpolated there.
fn fill_face(
    rgba: &mut [u8],
    side: u32,
    corners: &[([f64; 2], f64)],
    colour: impl Fn(f64) -> [u8; 3],
) {
    let [(a, va), (b, vb), (c, vc)] = *corners else {
        return;
    };
    let cross = |p: [f64; 2], q: [f64; 2], r: [f64; 2]| {
        (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])
    };
    let area = cross(a, b, c);
    if area == 0.0 {
        return;
    }
    let span = |axis: usize| {
        let low = a[axis].min(b[axis]).min(c[axis]).floor().max(0.0) as u32;
        let high = a[axis].max(b[axis]).max(c[axis]).ceil().max(0.0) as u32;
        low..high.min(side)
    };
    for y in span(1) {
        for x in span(0) {
            let p = [f64::from(x) + 0.5, f64::from(y) + 0.5];
            let weights = [
                cross(p, b, c) / area,
                cross(a, p, c) / area,
                cross(a, b, p) / area,
            ];
            // A little beyond the edge, so that no seam is left between faces.
            if weights.iter().all(|&weight| weight >= -1e-6) {
                let value = weights[0] * va + weights[1] * vb + weights[2] * vc;
                let [red, green, blue] = colour(value);
                let place = (y as usize * side as usize + x as usize) * 4;
                rgba[place..place + 4].copy_from_slice(&[red, green, blue, 255]);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_face_is_coloured_by_what_lies_between_its_corners() {
        let mut rgba = vec![0; 20 * 20 * 4];
        let corners = [([0.0, 0.0], 0.0), ([20.0, 0.0], 20.0), ([0.0, 20.0], 0.0)];
        fill_face(&mut rgba, 20, &corners, |value| [value.round() as u8, 0, 0]);
        let pixel = |x: usize, y: usize| &rgba[(y * 20 + x) * 4..][..4];
        assert_eq!(pixel(10, 2), [11, 0, 0, 255].map(|v: u8| v));
        assert_eq!(pixel(18, 18), [0, 0, 0, 0]);
        let covered = rgba.chunks(4).filter(|pixel| pixel[3] == 255).count();
        assert!((190..=210).contains(&covered), "{covered}");
    }

    #[test]
    fn the_names_of_walls_are_those_of_the_segments() {
        for (degrees, name) in WALLS {
            let segment = Segment::at(0.0, degrees.to_radians());
            assert_eq!(segment.name(), format!("basal {name}"));
        }
    }
}
