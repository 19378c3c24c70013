//! Marks of labels on a page, and dashed lines.

use crate::picture::label_marks::{LabelMark, MarkShape};
use crate::picture::page::Page;

/// Width of the arms of a mark, and of the outline of an open one, in radii.
const ARM: f32 = 0.4;
/// Corners of the outline of a disc: no corner is seen at the size of a mark.
const DISC_CORNERS: usize = 24;

/// The shape of a label, filled or open; what consists of lines is thinner instead of open.
pub(super) fn draw_mark(
    page: &mut Page,
    label: LabelMark,
    colour: [f32; 3],
    [x, y]: [f32; 2],
    size: f32,
    filled: bool,
) {
    let at = |[right, down]: [f32; 2]| [x + size * right, y + size * down];
    let mut polygon = |corners: &[[f32; 2]]| {
        let corners: Vec<[f32; 2]> = corners.iter().copied().map(at).collect();
        match filled {
            true => page.fill(&corners, colour),
            false => page.line(&corners, true, ARM * size, colour),
        }
    };
    match label.shape() {
        // A line without length has round ends: a disc.
        MarkShape::Disc if filled => {
            page.line(&[[x, y], [x + 0.01, y]], false, 2.0 * size, colour);
        }
        MarkShape::Disc => {
            let step = std::f32::consts::TAU / DISC_CORNERS as f32;
            let corner = |index: usize| (step * index as f32).sin_cos();
            let corners = (0..DISC_CORNERS).map(|index| <[f32; 2]>::from(corner(index)));
            polygon(&corners.collect::<Vec<_>>());
        }
        MarkShape::Square(side) => {
            polygon(&[[-side, -side], [side, -side], [side, side], [-side, side]]);
        }
        MarkShape::Arms(arms) => {
            let width = if filled { ARM } else { 0.5 * ARM };
            for ends in arms {
                page.line(&ends.map(at), false, width * size, colour);
            }
        }
        MarkShape::Polygons(polygons) => polygons.iter().for_each(|corners| polygon(corners)),
    }
}

/// A line of dashes, as long as the gaps between them.
pub(super) fn dashed(
    page: &mut Page,
    [from, to]: [[f32; 2]; 2],
    dash: f32,
    width: f32,
    colour: [f32; 3],
) {
    let [right, down] = [0, 1].map(|axis| to[axis] - from[axis]);
    let length = right.hypot(down);
    if !(length > 0.0 && dash > 0.0) {
        return;
    }
    let at = |along: f32| {
        let share = (along / length).min(1.0);
        [from[0] + share * right, from[1] + share * down]
    };
    let count = (0.5 * length / dash).ceil() as usize;
    for index in 0..count {
        let start = 2.0 * dash * index as f32;
        page.line(&[at(start), at(start + dash)], false, width, colour);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::picture::page::Mark;

    #[test]
    fn an_open_mark_has_an_outline_and_a_filled_one_an_inside() {
        let drawn = |label, filled| {
            let mut page = Page::new([20.0, 20.0], None);
            draw_mark(&mut page, label, [0.0; 3], [10.0, 10.0], 5.0, filled);
            page.marks
        };
        for label in [LabelMark::Unlabelled, LabelMark::Label(1)] {
            assert!(matches!(drawn(label, true)[..], [Mark::Fill { .. }]));
            let open = drawn(label, false);
            assert!(matches!(open[..], [Mark::Line { closed: true, .. }]));
        }
        let disc = drawn(LabelMark::Normal, false);
        let [Mark::Line { points, closed, .. }] = &disc[..] else {
            panic!("{disc:?}");
        };
        assert!(*closed);
        for point in points {
            let radius = (point[0] - 10.0).hypot(point[1] - 10.0);
            assert!((radius - 5.0).abs() < 1e-4);
        }
    }

    #[test]
    fn dashes_begin_and_end_on_their_line() {
        let mut page = Page::new([100.0, 100.0], None);
        dashed(&mut page, [[0.0, 0.0], [0.0, 50.0]], 4.0, 1.0, [0.0; 3]);
        assert_eq!(page.marks.len(), 7);
        for mark in &page.marks {
            let Mark::Line { points, .. } = mark else {
                panic!("{mark:?}");
            };
            assert!(points.iter().all(|[x, y]| *x == 0.0 && *y <= 50.0));
        }
    }
}
