//! The plot itself: colours, rings and sectors, patches, numbers, names, colour bar.

use egui::epaint::Mesh;
use egui::text::{LayoutJob, TextWrapping};
use egui::{Align2, Color32, FontId, Pos2, Rect, Shape, Stroke, Ui, pos2, vec2};

use crate::analysis::segments::{RING_RADII, Segment};
use crate::panes::bulls_eye::layout::Disc;
use crate::panes::bulls_eye::{BullsEyePatch, BullsEyeView};
use crate::picture::{BullsEyeScale, ink_on, sector_line, sector_outline, sector_strip};
use crate::ui::marks::colour_strip;
use crate::ui::style::note_font;
use crate::ui::text::note_at;
use crate::ui::theme::{colours, line};

/// Lines between segments: dark on every colour of the map.
const BETWEEN: Color32 = Color32::from_rgba_premultiplied(22, 24, 28, 190);
/// What has no value.
const NO_VALUE: Color32 = Color32::from_rgb(0x80, 0x85, 0x8c);

fn colour(scale: &BullsEyeScale, value: f64) -> Color32 {
    scale.colour(value).map_or(NO_VALUE, |[red, green, blue]| {
        Color32::from_rgb(red, green, blue)
    })
}

/// Borders of patches, on whatever colour, in either theme.
const FOUND: Color32 = Color32::from_rgb(0xff, 0xd1, 0x66);
/// And of places that only thicken little.
const FAINT: Color32 = Color32::from_rgb(0xc8, 0xcd, 0xd3);

/// Lines inside a patch: the colours between them stay readable.
const HATCH: Color32 = Color32::from_rgba_premultiplied(10, 11, 13, 150);
/// Radius of the plate below the number of a patch.
const PLATE: f32 = 8.0;

/// Draws the disc.
pub fn plot(ui: &Ui, view: &BullsEyeView, disc: &Disc, hovered: Option<Segment>) {
    let painter = ui.painter();
    painter.circle_filled(disc.centre, disc.radius, colours(ui).control);
    if view.by_segment && view.flat.oriented {
        for segment in Segment::all() {
            let value = view.shown.segments[segment.index()].unwrap_or(f64::NAN);
            painter.add(sector_mesh(disc, segment, colour(view.scale, value)));
        }
    } else {
        painter.add(Shape::mesh(continuous(view, disc)));
    }
    borders(ui, view, disc);
    for patch in view.patches {
        patch_mark(ui, view, disc, patch);
    }
    if view.by_segment && view.flat.oriented {
        numbers(ui, view, disc);
    }
    for (segment, width) in [
        (hovered, line::MARK),
        (view.selected.filter(|_| view.flat.oriented), line::STRONG),
    ] {
        if let Some(segment) = segment {
            let stroke = Stroke::new(width, colours(ui).strong);
            let below = Stroke::new(width + 2.0, BETWEEN);
            let outline: Vec<Pos2> = (sector_outline(segment).into_iter())
                .map(|point| disc.at(point))
                .collect();
            painter.add(Shape::closed_line(outline.clone(), below));
            painter.add(Shape::closed_line(outline, stroke));
        }
    }
}

/// Outline, hatch and number of a patch: the hatched side is the patch.
fn patch_mark(ui: &Ui, view: &BullsEyeView, disc: &Disc, patch: &BullsEyePatch) {
    let painter = ui.painter();
    let fine = !patch.selected && view.patches.iter().any(|patch| patch.selected);
    let (width, colour) = match (fine, patch.faint) {
        (true, false) => (line::THIN, FOUND),
        (false, false) => (line::STRONG, FOUND),
        (true, true) => (line::THIN, FAINT),
        (false, true) => (line::MARK, FAINT),
    };
    let by_segment = view.by_segment && view.flat.oriented;
    let stride = hatch_stride(disc.radius);
    for (number, ends) in &patch.shape.hatch {
        // The numbers of segments are read; the outline is enough.
        if !by_segment && number.rem_euclid(stride) == 0 {
            let ends = ends.map(|end| disc.at(end));
            painter.line_segment(ends, Stroke::new(line::THIN, HATCH));
        }
    }
    for border in &patch.shape.borders {
        let points: Vec<Pos2> = border.iter().map(|&point| disc.at(point)).collect();
        // Dark below light: seen on pale and on deep colours.
        let below = Stroke::new(width + 2.0, BETWEEN);
        painter.extend(sides(&points, below));
        painter.extend(sides(&points, Stroke::new(width, colour)));
    }
    if let Some(at) = number_place(view.patches, patch, disc).filter(|_| !by_segment) {
        painter.circle_filled(at, PLATE, BETWEEN);
        let number = patch.number.as_str();
        painter.text(at, Align2::CENTER_CENTER, number, note_font(), colour);
    }
}

/// Where the number of a patch covers neither its outline nor most of it: in its middle, else beside it, nearer to it than
/// to any other. The only patch needs no number.
fn number_place(patches: &[BullsEyePatch], patch: &BullsEyePatch, disc: &Disc) -> Option<Pos2> {
    let middle = disc.at(patch.shape.middle?);
    let distance = |patch: &BullsEyePatch, at| disc.distance_to_borders(&patch.shape.borders, at);
    if distance(patch, middle) > PLATE + 3.0 {
        return Some(middle);
    }
    if patches.len() < 2 {
        return None;
    }
    let mut around = (2..12).flat_map(|step| {
        (0..16).map(move |turn| {
            let angle = std::f32::consts::TAU * turn as f32 / 16.0;
            middle + 0.75 * PLATE * step as f32 * egui::Vec2::angled(angle)
        })
    });
    around.find(|&at| {
        let own = distance(patch, at);
        let free = |other: &BullsEyePatch| distance(other, at) > own.max(PLATE + 1.0);
        let others = patches.iter().filter(|other| other.number != patch.number);
        own > PLATE
            && at.distance(disc.centre) < disc.radius + PLATE
            && others.into_iter().all(free)
    })
}

/// A closed line, side by side: drawn in one piece, its joints run far out where it turns back sharply, as long lines
/// across the plot and beyond.
fn sides(points: &[Pos2], stroke: Stroke) -> Vec<Shape> {
    let next = points.iter().cycle().skip(1);
    let sides = points.iter().zip(next);
    sides
        .map(|(from, to)| Shape::line_segment([*from, *to], stroke))
        .collect()
}

/// Every how manieth line of a hatch is drawn, so that lines stay five points apart on a small disc.
fn hatch_stride(radius: f32) -> i32 {
    let lines = (5.0 / (0.07 * radius.max(1.0))).ceil();
    (lines as i32).max(1)
}

/// Every place its own colour.
fn continuous(view: &BullsEyeView, disc: &Disc) -> Mesh {
    let mut mesh = Mesh::default();
    for (point, &value) in view.flat.points.iter().zip(&view.shown.values) {
        mesh.colored_vertex(disc.at(*point), colour(view.scale, f64::from(value)));
    }
    let count = mesh.vertices.len() as u32;
    for face in &view.flat.faces {
        if face.iter().all(|&vertex| vertex < count) {
            mesh.add_triangle(face[0], face[1], face[2]);
        }
    }
    mesh
}

fn sector_mesh(disc: &Disc, segment: Segment, colour: Color32) -> Shape {
    let strip = sector_strip(segment).into_iter();
    colour_strip(strip.map(|ends| (ends.map(|end| disc.at(end)), colour)))
}

/// Rings, and sectors where the orientation is known.
fn borders(ui: &Ui, view: &BullsEyeView, disc: &Disc) {
    let stroke = Stroke::new(line::THIN, BETWEEN);
    for radius in RING_RADII {
        let radius = disc.radius * radius as f32;
        ui.painter().circle_stroke(disc.centre, radius, stroke);
    }
    if !view.flat.oriented {
        return;
    }
    for ends in Segment::all().filter_map(sector_line) {
        ui.painter()
            .line_segment(ends.map(|end| disc.at(end)), stroke);
    }
}

fn numbers(ui: &Ui, view: &BullsEyeView, disc: &Disc) {
    let size = (0.1 * disc.radius).clamp(8.0, 13.0);
    for segment in Segment::all() {
        let Some(value) = view.shown.segments[segment.index()] else {
            continue;
        };
        let [red, green, blue, _] = colour(view.scale, value).to_array();
        let [ink_red, ink_green, ink_blue] = ink_on([red, green, blue]);
        let ink = Color32::from_rgb(ink_red, ink_green, ink_blue);
        let at = disc.middle_of(segment);
        let text = view.scale.text(value);
        let galley = (ui.painter()).layout_no_wrap(text, FontId::proportional(size), ink);
        let place = Align2::CENTER_CENTER.anchor_size(at, galley.size());
        if !view.patches.is_empty() {
            // Over outlines that may run through the middle of a segment.
            let plate = Color32::from_rgb(red, green, blue);
            ui.painter()
                .rect_filled(place.expand2(vec2(2.0, -1.0)), 3.0, plate);
        }
        ui.painter().galley(place.min, galley, ink);
    }
}

/// The sides by name, where they are known; elsewhere that they are not.
pub fn names(ui: &Ui, view: &BullsEyeView, disc: &Disc, area: Rect) {
    let put = |at: Pos2, align: Align2, text: &str| note_at(ui, at, align, text);
    if !view.flat.oriented {
        return;
    }
    let (c, r) = (disc.centre, disc.radius + 3.0);
    put(pos2(c.x, c.y - r), Align2::CENTER_BOTTOM, "anterior");
    put(pos2(c.x, c.y + r), Align2::CENTER_TOP, "inferior");
    // Words where they have room, initials where they have none.
    let side = c.x - r - area.left();
    let [left, right] = if side > 42.0 {
        ["septal", "lateral"]
    } else {
        ["S", "L"]
    };
    put(pos2(c.x - r, c.y), Align2::RIGHT_CENTER, left);
    put(pos2(c.x + r, c.y), Align2::LEFT_CENTER, right);
}

/// Whose wall it is, in the corner that the disc leaves free; without orientation in the line above the disc.
pub fn subject(ui: &Ui, view: &BullsEyeView, disc: &Disc, area: Rect) {
    let (words, width) = match view.flat.oriented {
        true => (view.subject.to_owned(), corner_width(disc, area)),
        false => (
            format!("orientation unknown · {}", view.subject),
            area.width(),
        ),
    };
    let mut words = LayoutJob::simple_singleline(words, note_font(), colours(ui).muted);
    words.wrap = TextWrapping::truncate_at_width(width);
    let galley = ui.painter().layout_job(words);
    ui.painter()
        .galley(area.left_top(), galley, colours(ui).muted);
}

/// Width of the corner beside the disc: up to the word above it.
fn corner_width(disc: &Disc, area: Rect) -> f32 {
    (disc.centre.x - 26.0 - area.left()).max(24.0)
}

/// The colours with numbers, title and unit.
pub fn colour_bar(ui: &Ui, view: &BullsEyeView, area: Rect) {
    const HEIGHT: f32 = 7.0;
    let colours = colours(ui);
    let painter = ui.painter();
    let bar = Rect::from_min_max(
        pos2(area.left() + 16.0, area.top()),
        pos2(area.right() - 16.0, area.top() + HEIGHT),
    );
    const STEPS: u32 = 64;
    painter.add(colour_strip((0..=STEPS).map(|step| {
        let part = f64::from(step) / f64::from(STEPS);
        let [red, green, blue] = view.scale.map.at(part);
        let x = egui::lerp(bar.x_range(), part as f32);
        let ends = [pos2(x, bar.top()), pos2(x, bar.bottom())];
        (ends, Color32::from_rgb(red, green, blue))
    })));
    let mut free_from = f32::NEG_INFINITY;
    for (value, text) in view.scale.ticks(4) {
        let x = egui::lerp(bar.x_range(), view.scale.share(value) as f32);
        if x < free_from {
            continue;
        }
        let at = pos2(x, bar.bottom() + 1.0);
        note_at(ui, at, Align2::CENTER_TOP, text);
        free_from = x + 34.0;
    }
    let title = view.scale.title(view.moment);
    let at = pos2(area.center().x, area.bottom());
    painter.text(at, Align2::CENTER_BOTTOM, title, note_font(), colours.text);
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::epaint::{ClippedShape, Primitive};

    #[test]
    fn the_number_of_a_patch_never_covers_it() {
        let square = |number: &str, [x, y]: [f64; 2], half: f64| {
            let corner = |i: f64, j: f64| [x + half * i, y + half * j];
            let border = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
            BullsEyePatch {
                shape: crate::picture::PolarPatch {
                    borders: vec![border.map(|(i, j)| corner(i, j)).to_vec()],
                    middle: Some([x, y]),
                    ..Default::default()
                },
                number: number.to_owned(),
                ..BullsEyePatch::default()
            }
        };
        let disc = |radius| Disc {
            centre: pos2(80.0, 80.0),
            radius,
        };
        let one = [square("1", [0.5, 0.2], 0.2)];
        let large = number_place(&one, &one[0], &disc(120.0));
        assert_eq!(large, Some(disc(120.0).at([0.5, 0.2])));
        assert_eq!(number_place(&one, &one[0], &disc(38.0)), None);
        let two = [one[0].clone(), square("2", [-0.3, 0.2], 0.2)];
        let disc = disc(38.0);
        for patch in &two {
            let at = number_place(&two, patch, &disc).unwrap();
            let own = disc.distance_to_borders(&patch.shape.borders, at);
            assert!(own > PLATE && own < 2.0 * PLATE);
        }
    }

    #[test]
    fn an_outline_that_turns_back_sharply_sends_no_line_across_the_plot() {
        let points = [[0.0, 0.0], [50.0, 0.0], [0.0, 0.4], [25.0, 30.0]].map(Pos2::from);
        let ctx = egui::Context::default();
        // Fonts exist from the first frame on, and shapes are made triangles after it.
        let output = ctx.run_ui(Default::default(), |_| {});
        output.drop_without_applying_deltas();
        let shapes = sides(&points, Stroke::new(4.0, Color32::WHITE)).into_iter();
        let clipped = shapes.map(|shape| ClippedShape {
            clip_rect: Rect::EVERYTHING,
            shape,
            transform_after_tessellation: Default::default(),
        });
        let allowed = Rect::from_points(&points).expand(4.0);
        for drawn in ctx.tessellate(clipped.collect(), 1.0) {
            if let Primitive::Mesh(mesh) = drawn.primitive {
                assert!(
                    mesh.vertices
                        .iter()
                        .all(|vertex| allowed.contains(vertex.pos))
                );
            }
        }
    }
}
