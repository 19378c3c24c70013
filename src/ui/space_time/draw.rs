//! Draws curves from back to front, with end-diastole, end-systole and where the beat stands.

use egui::{Align2, Color32, Painter, Pos2, Rect, Shape, Stroke, Ui, pos2, vec2};

use crate::ui::map_ground::{Labels, MapState};
use crate::ui::marks::role_mark;
use crate::ui::pose_map::PosePhase;
use crate::ui::space_time::axes::draw_axes;
use crate::ui::space_time::eye::Eye;
use crate::ui::space_time::{SpaceTimeCurve, SpaceTimeView};
use crate::ui::style::note_font;
use crate::ui::theme::{Colours, colours, line};

/// Something to draw at a depth.
struct Piece {
    depth: f32,
    shape: PieceShape,
}

enum PieceShape {
    Line([Pos2; 2], Stroke, bool),
    Mark(Pos2, f32, crate::study::LabelRole, Color32, bool),
}

/// Draws everything; `pointed` is the curve under the pointer.
pub fn draw(ui: &Ui, view: &SpaceTimeView, eye: &Eye, pointed: Option<usize>) {
    let painter = ui.painter_at(eye.rect);
    let colours = colours(ui);
    draw_axes(&painter, eye, colours);
    draw_now(&painter, view, eye, colours);
    let dimmed = !matches!(view.state, MapState::Ready | MapState::Empty);
    let chosen =
        |curve: &SpaceTimeCurve| [view.selected, view.compared].contains(&Some(curve.subject));
    let mut pieces = Vec::new();
    for curve in view.curves.iter().filter(|curve| !chosen(curve)) {
        let role = colours.role(view.role(curve));
        let strength = if dimmed { 0.2 } else { 0.55 };
        add_curve(&mut pieces, view, eye, curve, &|depth| {
            // What is far fades into the pane.
            let fade = (0.75 - 0.28 * depth).clamp(0.25, 1.0);
            colours.pane.lerp_to_gamma(role, strength * fade)
        });
    }
    // From far to near; what has no depth is a bug elsewhere, not here.
    pieces.sort_by(|a, b| b.depth.total_cmp(&a.depth));
    for piece in &pieces {
        paint(&painter, piece);
    }
    let mut labels = Labels::new(&painter, eye.rect, colours.pane);
    for (subject, colour) in [
        (view.compared, colours.strong),
        (view.selected, colours.selection),
    ] {
        for curve in view.curves.iter().filter(|c| Some(c.subject) == subject) {
            draw_chosen(&painter, view, eye, curve, colour);
        }
    }
    for (subject, colour) in [
        (view.selected, colours.selection),
        (view.compared, colours.strong),
    ] {
        for curve in view.curves.iter().filter(|c| Some(c.subject) == subject) {
            name_phases(view, eye, curve, colour, &mut labels);
        }
    }
    if let Some(curve) = pointed.and_then(|index| view.curves.get(index)) {
        let places = curve.points.iter().map(|p| eye.see(p.at, p.share).0);
        let stroke = Stroke::new(line::STRONG, colours.strong);
        painter.add(Shape::line(places.collect(), stroke));
    }
}

fn add_curve(
    pieces: &mut Vec<Piece>,
    view: &SpaceTimeView,
    eye: &Eye,
    curve: &SpaceTimeCurve,
    colour: &dyn Fn(f32) -> Color32,
) {
    let seen: Vec<(Pos2, f32)> = curve
        .points
        .iter()
        .map(|p| eye.see(p.at, p.share))
        .collect();
    for pair in seen.windows(2) {
        let depth = 0.5 * (pair[0].1 + pair[1].1);
        let stroke = Stroke::new(line::THIN, colour(depth));
        let shape = PieceShape::Line([pair[0].0, pair[1].0], stroke, false);
        pieces.push(Piece { depth, shape });
    }
    if let Some(ends) = closing(eye, curve) {
        let depth = ends[1].1;
        let stroke = Stroke::new(line::THIN, colour(depth).gamma_multiply(0.7));
        let shape = PieceShape::Line([ends[0].0, ends[1].0], stroke, true);
        pieces.push(Piece { depth, shape });
    }
    let role = view.role(curve);
    for (point, (place, depth)) in curve.points.iter().zip(&seen) {
        if point.phase != PosePhase::Between {
            let filled = point.phase == PosePhase::EndDiastole;
            let shape = PieceShape::Mark(*place, 3.2, role, colour(*depth - 0.8), filled);
            pieces.push(Piece {
                depth: *depth - 0.01,
                shape,
            });
        }
    }
}

/// From the last pose to the first at the end of the beat.
fn closing(eye: &Eye, curve: &SpaceTimeCurve) -> Option<[(Pos2, f32); 2]> {
    let (first, last) = (curve.points.first()?, curve.points.last()?);
    (curve.points.len() > 2).then(|| [eye.see(last.at, last.share), eye.see(first.at, 1.0)])
}

fn paint(painter: &Painter, piece: &Piece) {
    match &piece.shape {
        PieceShape::Line(ends, stroke, false) => {
            painter.line_segment(*ends, *stroke);
        }
        PieceShape::Line(ends, stroke, true) => {
            painter.extend(Shape::dashed_line(ends, *stroke, 2.0, 3.0));
        }
        PieceShape::Mark(at, radius, role, colour, filled) => {
            role_mark(painter, *at, *radius, *role, *colour, *filled);
        }
    }
}

fn draw_chosen(
    painter: &Painter,
    view: &SpaceTimeView,
    eye: &Eye,
    curve: &SpaceTimeCurve,
    colour: Color32,
) {
    let places: Vec<Pos2> = curve
        .points
        .iter()
        .map(|point| eye.see(point.at, point.share).0)
        .collect();
    if let Some(ends) = closing(eye, curve) {
        let stroke = Stroke::new(line::STRONG, colour.gamma_multiply(0.7));
        painter.extend(Shape::dashed_line(&ends.map(|end| end.0), stroke, 2.0, 3.0));
    }
    painter.add(Shape::line(
        places.clone(),
        Stroke::new(line::STRONG, colour),
    ));
    let role = view.role(curve);
    for (point, place) in curve.points.iter().zip(places) {
        let (radius, filled) = match point.phase {
            PosePhase::EndDiastole => (5.0, true),
            PosePhase::EndSystole => (5.0, false),
            PosePhase::Between => (2.4, true),
        };
        role_mark(painter, place, radius, role, colour, filled);
    }
    if let Some(place) = place_at(curve, view.share).map(|at| eye.see(at, view.share).0) {
        let behind = Colours::of(painter.ctx().global_style().visuals.dark_mode);
        painter.circle_filled(place, 6.5, behind.pane);
        painter.circle_filled(place, 4.5, colour);
        painter.circle_stroke(place, 6.5, Stroke::new(line::MARK, colour));
    }
}

/// Where a beat is at a share, on straight lines between its poses; the last runs into the first.
fn place_at(curve: &SpaceTimeCurve, share: f64) -> Option<[f64; 2]> {
    let count = curve.points.len();
    let after = curve.points.partition_point(|point| point.share <= share);
    let from = curve
        .points
        .get(after.checked_sub(1).unwrap_or(count.checked_sub(1)?))?;
    let to = curve.points.get(after % count)?;
    let end = if after >= count { 1.0 } else { to.share };
    let part = if after > 0 && end > from.share {
        ((share - from.share) / (end - from.share)).clamp(0.0, 1.0)
    } else {
        0.0
    };
    Some([0, 1].map(|axis| from.at[axis] + part * (to.at[axis] - from.at[axis])))
}

fn name_phases(
    view: &SpaceTimeView,
    eye: &Eye,
    curve: &SpaceTimeCurve,
    colour: Color32,
    labels: &mut Labels,
) {
    let id = view
        .subjects
        .get(curve.subject)
        .map_or("", |subject| &subject.id);
    let places: Vec<Pos2> = curve
        .points
        .iter()
        .map(|point| eye.see(point.at, point.share).0)
        .collect();
    if let Some(place) = place_at(curve, view.share).map(|at| eye.see(at, view.share).0) {
        labels.keep_free(Rect::from_center_size(place, vec2(14.0, 14.0)));
    }
    for (point, place) in curve.points.iter().zip(&places) {
        let text = match point.phase {
            PosePhase::EndDiastole => format!("{id} ED"),
            PosePhase::EndSystole => format!("{id} ES"),
            PosePhase::Between => continue,
        };
        labels.beside(*place, 9.0, text, colour, &places);
    }
}

/// The plane of the present phase, with a dot where each curve goes through it.
fn draw_now(painter: &Painter, view: &SpaceTimeView, eye: &Eye, colours: &Colours) {
    let level = (2.0 * view.share - 1.0) as f32 * eye.half[2];
    let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0_f32]];
    let plane: Vec<Pos2> = corners
        .iter()
        .map(|[x, y]| eye.see_in_box([x * eye.half[0], y * eye.half[1], level]).0)
        .collect();
    let right = plane
        .iter()
        .copied()
        .max_by(|a, b| a.x.total_cmp(&b.x))
        .unwrap_or_default();
    painter.add(Shape::convex_polygon(
        plane,
        colours.selection.gamma_multiply(0.06),
        Stroke::new(line::THIN, colours.selection.gamma_multiply(0.5)),
    ));
    for curve in view.curves {
        if let Some(at) = place_at(curve, view.share) {
            let (place, _) = eye.see(at, view.share);
            let colour = colours.role(view.role(curve)).gamma_multiply(0.8);
            painter.circle_filled(place, 1.8, colour);
        }
    }
    let text = format!("{:.0} %", 100.0 * view.share);
    let galley = painter.layout_no_wrap(text, note_font(), colours.selection);
    let at = pos2(
        (right.x + 4.0).min(eye.rect.right() - galley.size().x - 3.0),
        right.y,
    );
    let rect = Align2::LEFT_CENTER.anchor_size(at, galley.size());
    painter.galley(rect.min, galley, colours.selection);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ui::space_time::SpaceTimePoint;

    #[test]
    fn between_poses_a_beat_is_on_the_straight_line_and_its_end_runs_into_its_start() {
        let point = |x, share| SpaceTimePoint {
            at: [x, 0.0],
            share,
            ..SpaceTimePoint::default()
        };
        let curve = SpaceTimeCurve {
            subject: 0,
            points: vec![point(0.0, 0.0), point(4.0, 0.4), point(8.0, 0.6)],
        };
        let x = |share| place_at(&curve, share).unwrap()[0];
        assert!((x(0.1) - 1.0).abs() < 1e-12);
        assert!((x(0.5) - 6.0).abs() < 1e-12);
        assert!((x(0.8) - 4.0).abs() < 1e-12);
        assert_eq!(place_at(&SpaceTimeCurve::default(), 0.3), None);
    }
}
