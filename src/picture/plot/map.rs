//! A map of points on a page: paths, marks by label and phase, and the names of subjects where there is room.

use crate::picture::figure::Pen;
use crate::picture::label_marks::LabelMark;
use crate::picture::page::{Anchor, Mark, Type};

use super::axes::PlotAxis;
use super::label_legend::LegendEntry;
use super::marks::{dashed, draw_mark};
use super::names::{Name, placed};

/// Paths lie behind marks.
const PALE: f32 = 0.55;
/// Strength of subjects that a filter leaves out: seen as where the others lie, and no more.
const DIMMED: f32 = 0.16;
/// Widest name, in ems of running text.
const NAME_WIDTH_EM: f32 = 10.0;

/// How a point is marked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PointLook {
    /// Large and filled: end-diastole, or a whole motion.
    Filled,
    /// Large and open: end-systole.
    Open,
    /// Small: any other pose.
    Small,
}

/// A point of a path.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MapPoint {
    /// Its place on the map, which has no unit.
    pub at: [f64; 2],
    /// Its mark.
    pub look: PointLook,
    /// Whether the way from the point before is known; a dashed line joins them where it is not.
    pub joined: bool,
}

/// The points of one subject, or of one of its patches, in order of frames.
#[derive(Clone, Debug, PartialEq)]
pub struct MapPath {
    /// What stands beside its first point.
    pub name: String,
    /// Mark of its subject.
    pub mark: LabelMark,
    /// Its points.
    pub points: Vec<MapPoint>,
    /// Whether a dashed line leads from its last point back to its first one, at the end of the cycle.
    pub cyclic: bool,
    /// Whether it is the subject that is selected.
    pub selected: bool,
    /// Whether a filter leaves its subject out.
    pub dimmed: bool,
}

/// A map of points.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MapPlot {
    /// All paths.
    pub paths: Vec<MapPath>,
    /// What the marks mean.
    pub legend: Vec<LegendEntry>,
}

/// Sizes of a map on a page, in pixels.
#[derive(Clone, Copy, Debug)]
pub(in crate::picture) struct MapLook {
    /// Half the size of a large mark.
    pub(in crate::picture) mark: f32,
    /// Width of paths.
    pub(in crate::picture) path: f32,
    /// The em of names.
    pub(in crate::picture) name: f32,
    /// Between the outermost points and the frame.
    pub(in crate::picture) air: f32,
}

/// Where places of a map lie on a page: one scale for both axes, so that distances mean the same in every direction.
#[derive(Clone, Copy, Debug)]
pub(super) struct MapFrame {
    area: [[f32; 2]; 2],
    middle: [f64; 2],
    /// Pixels for one unit of the map.
    scale: f64,
}

impl MapFrame {
    /// The frame that shows all points within `area` with `air` around them.
    pub(super) fn of(plot: &MapPlot, area: [[f32; 2]; 2], air: f32) -> Self {
        let points =
            || (plot.paths.iter()).flat_map(|path| path.points.iter().map(|point| point.at));
        let bound = |axis: usize, pick: fn(f64, f64) -> f64, start: f64| {
            let finite = points().filter(|at| at.iter().all(|x| x.is_finite()));
            finite.map(|at| at[axis]).fold(start, pick)
        };
        let low = [0, 1].map(|axis| bound(axis, f64::min, f64::INFINITY));
        let high = [0, 1].map(|axis| bound(axis, f64::max, f64::NEG_INFINITY));
        let scales = [0, 1].map(|axis| {
            let room = f64::from((area[1][axis] - area[0][axis] - 2.0 * air).max(1.0));
            // Points that all lie in one place get a plot of almost nothing around them.
            room / (high[axis] - low[axis]).max(1e-12)
        });
        let middle = [0, 1].map(|axis| 0.5 * (low[axis] + high[axis]));
        Self {
            area,
            middle: middle.map(|at| if at.is_finite() { at } else { 0.0 }),
            scale: scales[0].min(scales[1]),
        }
    }

    fn place(&self, at: [f64; 2]) -> [f32; 2] {
        let [low, high] = self.area;
        let from = [0, 1].map(|axis| (self.scale * (at[axis] - self.middle[axis])) as f32);
        [
            0.5 * (low[0] + high[0]) + from[0],
            0.5 * (low[1] + high[1]) - from[1],
        ]
    }

    /// The axes of the plot, which have no unit.
    pub(super) fn axes(&self) -> [PlotAxis; 2] {
        [0, 1].map(|axis| {
            let half = f64::from(self.area[1][axis] - self.area[0][axis]) / (2.0 * self.scale);
            PlotAxis {
                title: format!("Coordinate {} of the embedding (no unit)", axis + 1),
                low: self.middle[axis] - half,
                high: self.middle[axis] + half,
            }
        })
    }
}

/// Draws paths, names and marks into `area`; returns how many of how many names have no room.
pub(in crate::picture) fn draw_map(
    pen: &mut Pen<'_>,
    plot: &MapPlot,
    area: [[f32; 2]; 2],
    look: MapLook,
) -> [usize; 2] {
    let frame = MapFrame::of(plot, area, look.air);
    // What is selected lies on top, and its name chooses its place first.
    let mut paths: Vec<&MapPath> = plot.paths.iter().collect();
    paths.sort_by_key(|path| path.selected);
    for path in &paths {
        draw_path(pen, path, &frame, look);
    }
    let without = write_names(pen, &paths, &frame, look);
    for path in &paths {
        let colour = pen.shade(path, 1.0);
        for point in &path.points {
            let (share, filled) = match point.look {
                PointLook::Filled => (1.0, true),
                PointLook::Open => (1.0, false),
                PointLook::Small => (0.5, true),
            };
            let size = share * if path.selected { 1.3 } else { 1.0 } * look.mark;
            draw_mark(
                pen.page,
                path.mark,
                colour,
                frame.place(point.at),
                size,
                filled,
            );
        }
    }
    without
}

impl Pen<'_> {
    /// The colour of a path on its ground, at a strength.
    fn shade(&self, path: &MapPath, strength: f32) -> [f32; 3] {
        let colour = match path.selected {
            true => self.theme.emphasis,
            false => path.mark.colour_on(self.theme),
        };
        let strength = if path.dimmed { DIMMED } else { strength };
        let ground = self.theme.background;
        [0, 1, 2].map(|part| ground[part] + strength * (colour[part] - ground[part]))
    }
}

fn draw_path(pen: &mut Pen<'_>, path: &MapPath, frame: &MapFrame, look: MapLook) {
    let (colour, width) = match path.selected {
        true => (pen.shade(path, 1.0), 2.0 * look.path),
        false => (pen.shade(path, PALE), look.path),
    };
    let dash = 0.6 * look.mark;
    let mut run: Vec<[f32; 2]> = Vec::new();
    for point in &path.points {
        let at = frame.place(point.at);
        if let Some(before) = run.last().copied().filter(|_| !point.joined) {
            pen.page.line(&run, false, width, colour);
            run.clear();
            dashed(pen.page, [before, at], dash, width, colour);
        }
        run.push(at);
    }
    if run.len() > 1 {
        pen.page.line(&run, false, width, colour);
    }
    if let ([first, .., last], true) = (&path.points[..], path.cyclic) {
        let ends = [last, first].map(|point| frame.place(point.at));
        dashed(pen.page, ends, dash, width, colour);
    }
}

/// Names beside the first points of paths; returns how many of how many have no room.
fn write_names(
    pen: &mut Pen<'_>,
    paths: &[&MapPath],
    frame: &MapFrame,
    look: MapLook,
) -> [usize; 2] {
    let mut small = pen.regular(pen.theme.text);
    small.size = look.name;
    let named: Vec<(&MapPath, [f32; 2])> = (paths.iter().rev())
        .filter(|path| !path.dimmed)
        .filter_map(|path| Some((*path, frame.place(path.points.first()?.at))))
        .collect();
    let most = NAME_WIDTH_EM * pen.text;
    let words: Vec<String> = (named.iter())
        .map(|(path, _)| {
            pen.fonts
                .shortened(&path.name, small.weight, small.size, most)
        })
        .collect();
    let names: Vec<Name> = (named.iter().zip(&words))
        .map(|((_, at), words)| Name {
            at: *at,
            size: [pen.fonts.width(words, small.weight, small.size), small.size],
        })
        .collect();
    let gap = 1.5 * look.mark;
    let selected = paths.iter().filter(|path| path.selected);
    let marks: Vec<[f32; 2]> = (named.iter().map(|(_, at)| *at))
        .chain(selected.flat_map(|path| along(path, frame, gap)))
        .collect();
    let places = placed(&names, &marks, gap, frame.area);
    for ((words, at), (path, _)) in words.iter().zip(&places).zip(&named) {
        if let Some(at) = at {
            let colour = match path.selected {
                true => pen.theme.emphasis,
                false => small.colour,
            };
            let set = Type { colour, ..small };
            ground(pen, words, set, *at);
            pen.write(words, set, Anchor::Start, *at);
        }
    }
    let without = places.iter().filter(|place| place.is_none()).count();
    [without, places.len()]
}

/// Places along the way through the points of a path, so close that no name fits between them.
fn along(path: &MapPath, frame: &MapFrame, gap: f32) -> Vec<[f32; 2]> {
    let points: Vec<[f32; 2]> = path
        .points
        .iter()
        .map(|point| frame.place(point.at))
        .collect();
    let between = |ends: &[[f32; 2]]| {
        let [from, to] = [ends[0], ends[1]];
        let steps = ((to[0] - from[0]).hypot(to[1] - from[1]) / gap).ceil();
        let steps = steps.clamp(1.0, 1000.0) as u16;
        (1..=steps).map(move |step| {
            let share = f32::from(step) / f32::from(steps);
            [0, 1].map(|axis| from[axis] + share * (to[axis] - from[axis]))
        })
    };
    points.windows(2).flat_map(between).collect()
}

/// Hides some of what lies below a name.
fn ground(pen: &mut Pen<'_>, words: &str, set: Type, [left, base]: [f32; 2]) {
    let width = pen.fonts.width(words, set.weight, set.size);
    let [upper, lower] = [base - 0.85 * set.size, base + 0.25 * set.size];
    let right = left + width;
    pen.page.marks.push(Mark::Fill {
        corners: vec![[left, upper], [right, upper], [right, lower], [left, lower]],
        colour: pen.theme.background,
        opacity: 0.7,
    });
}

#[cfg(test)]
mod tests;
