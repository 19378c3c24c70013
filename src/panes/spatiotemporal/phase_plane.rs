//! The plane of the present phase in the spatiotemporal plot, and where paths go through it.

use egui::{Align2, Painter, Pos2, Shape, Stroke, pos2};

use crate::panes::scatter_map::{Projection, ScatterPoint, ScatterView, paths};
use crate::ui::style::note_font;
use crate::ui::theme::{Colours, line};

use super::eye::Eye;

/// Draws the plane with a dot where each path goes through it.
pub fn draw_phase_plane(
    painter: &Painter,
    view: &ScatterView,
    share: f64,
    eye: &Eye,
    colours: &Colours,
) {
    let level = (2.0 * share - 1.0) as f32 * eye.half[2];
    let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0_f32]];
    let plane = corners.map(|[x, y]| eye.see_in_box([x * eye.half[0], y * eye.half[1], level]).0);
    let right = plane.iter().max_by(|a, b| a.x.total_cmp(&b.x));
    let right = right.copied().unwrap_or_default();
    painter.add(Shape::convex_polygon(
        plane.to_vec(),
        colours.selection.gamma_multiply(0.06),
        Stroke::new(line::THIN, colours.selection.gamma_multiply(0.5)),
    ));
    for (subject, place) in places_at(view.points, share, eye) {
        let colour = view.mark(subject).colour(colours).gamma_multiply(0.8);
        painter.circle_filled(place, 1.8, colour);
    }
    let text = format!("{:.0} %", 100.0 * share);
    let galley = painter.layout_no_wrap(text, note_font(), colours.selection);
    let at = pos2(
        (right.x + 4.0).min(eye.rect.right() - galley.size().x - 3.0),
        right.y,
    );
    let rect = Align2::LEFT_CENTER.anchor_size(at, galley.size());
    painter.galley(rect.min, galley, colours.selection);
}

/// Subjects with where their paths go through the plane.
pub fn places_at(
    points: &[ScatterPoint],
    share: f64,
    eye: &Eye,
) -> impl Iterator<Item = (usize, Pos2)> {
    paths(points).filter_map(move |path| {
        let path = &points[path];
        let at = place_at(path, share)?;
        Some((path[0].subject, eye.see(at, share).0))
    })
}

/// Where a path is at a share of the cycle, on straight lines between its poses; the last runs into
/// the first.
fn place_at(path: &[ScatterPoint], share: f64) -> Option<[f64; 2]> {
    let count = path.len();
    let after = path.partition_point(|point| point.share <= share);
    let from = path.get(after.checked_sub(1).unwrap_or(count.checked_sub(1)?))?;
    let to = path.get(after % count)?;
    let end = if after >= count { 1.0 } else { to.share };
    let part = if after > 0 && end > from.share {
        ((share - from.share) / (end - from.share)).clamp(0.0, 1.0)
    } else {
        0.0
    };
    Some([0, 1].map(|axis| from.at[axis] + part * (to.at[axis] - from.at[axis])))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn between_poses_a_beat_is_on_the_straight_line_and_its_end_runs_into_its_start() {
        let path = [(0.0, 0.0), (4.0, 0.4), (8.0, 0.6)].map(|(x, share)| ScatterPoint {
            at: [x, 0.0],
            share,
            ..ScatterPoint::default()
        });
        let x = |share| place_at(&path, share).unwrap()[0];
        assert!((x(0.1) - 1.0).abs() < 1e-12);
        assert!((x(0.5) - 6.0).abs() < 1e-12);
        assert!((x(0.8) - 4.0).abs() < 1e-12);
        assert_eq!(place_at(&[], 0.3), None);
    }
}
