//! The box around the curves: its floor, its ticks of time, and names that do not overlap.

use egui::{Align2, Painter, Pos2, Rect, Shape, Stroke, Vec2, vec2};

use crate::ui::style::note_font;
use crate::ui::theme::{Colours, line};

use super::eye::Eye;

/// Draws edges of the box, the floor's grid and the ticks of time behind the curves.
pub fn draw_axes(painter: &Painter, eye: &Eye, colours: &Colours) {
    draw_floor(painter, eye, colours);
    let mut taken = Vec::new();
    let edge = time_edge(eye);
    draw_uprights(painter, eye, edge, colours);
    draw_time(painter, eye, edge, colours, &mut taken);
    for axis in [0, 1] {
        name_floor_axis(painter, eye, axis, colours, &mut taken);
    }
}

/// Corners of the box as signs along x and y.
const CORNERS: [[f32; 2]; 4] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];

fn corner(eye: &Eye, [x, y]: [f32; 2], t: f32) -> (Pos2, f32) {
    eye.see_in_box([x * eye.half[0], y * eye.half[1], t * eye.half[2]])
}

fn draw_floor(painter: &Painter, eye: &Eye, colours: &Colours) {
    let floor: Vec<Pos2> = CORNERS.iter().map(|c| corner(eye, *c, -1.0).0).collect();
    let fill = colours.grid.gamma_multiply(0.35);
    painter.add(Shape::convex_polygon(floor, fill, Stroke::NONE));
    let thin = Stroke::new(line::THIN, colours.grid);
    for step in 1..4 {
        let at = 0.5 * step as f32 - 1.0;
        for ends in [[[at, -1.0], [at, 1.0]], [[-1.0, at], [1.0, at]]] {
            let ends = ends.map(|end| corner(eye, end, -1.0).0);
            painter.line_segment(ends, thin);
        }
    }
    let edge = Stroke::new(line::THIN, colours.line);
    for index in 0..4 {
        let ends = [CORNERS[index], CORNERS[(index + 1) % 4]];
        painter.line_segment(ends.map(|end| corner(eye, end, -1.0).0), edge);
    }
}

/// The upright edge that carries the ticks of time: the leftmost on screen.
fn time_edge(eye: &Eye) -> [f32; 2] {
    let left = |c: &[f32; 2]| corner(eye, *c, 0.0).0.x;
    CORNERS
        .into_iter()
        .min_by(|a, b| left(a).total_cmp(&left(b)))
        .unwrap_or(CORNERS[0])
}

/// The uprights behind the curves, and the upper edges between them.
fn draw_uprights(painter: &Painter, eye: &Eye, time_edge: [f32; 2], colours: &Colours) {
    let nearest = CORNERS
        .into_iter()
        .min_by(|a, b| corner(eye, *a, 0.0).1.total_cmp(&corner(eye, *b, 0.0).1));
    let stroke = Stroke::new(line::THIN, colours.grid);
    for index in 0..4 {
        let (here, next) = (CORNERS[index], CORNERS[(index + 1) % 4]);
        if Some(here) != nearest && here != time_edge {
            painter.line_segment([-1.0, 1.0].map(|t| corner(eye, here, t).0), stroke);
        }
        if Some(here) != nearest && Some(next) != nearest {
            painter.line_segment([here, next].map(|c| corner(eye, c, 1.0).0), stroke);
        }
    }
}

fn draw_time(
    painter: &Painter,
    eye: &Eye,
    edge: [f32; 2],
    colours: &Colours,
    taken: &mut Vec<Rect>,
) {
    let (bottom, top) = (corner(eye, edge, -1.0).0, corner(eye, edge, 1.0).0);
    let stroke = Stroke::new(line::THIN, colours.muted);
    painter.line_segment([bottom, top], stroke);
    // Seen along time, ticks would lie upon each other.
    let length = (top - bottom).length();
    let outward = away_from_middle(eye, edge);
    let name_at = top + vec2(0.0, -10.0);
    write(
        painter,
        name_at,
        Align2::CENTER_BOTTOM,
        "time, % R-R",
        colours,
        taken,
        eye.rect,
    );
    for percent in [0, 25, 50, 75, 100] {
        if length < 60.0 && percent % 100 != 0 || length < 24.0 {
            continue;
        }
        let at = corner(eye, edge, 0.02 * percent as f32 - 1.0).0;
        painter.line_segment([at, at + 4.0 * outward], stroke);
        let text = percent.to_string();
        let place = at + 7.0 * outward;
        write(
            painter,
            place,
            Align2::RIGHT_CENTER,
            &text,
            colours,
            taken,
            eye.rect,
        );
    }
}

/// To the left, and a little with the slope of the floor.
fn away_from_middle(eye: &Eye, edge: [f32; 2]) -> Vec2 {
    let offset = corner(eye, edge, 0.0).0 - eye.rect.center();
    vec2(if offset.x > 0.0 { 1.0 } else { -1.0 }, 0.0)
}

/// Names an axis of the map along the lower of its two edges on the floor.
fn name_floor_axis(
    painter: &Painter,
    eye: &Eye,
    axis: usize,
    colours: &Colours,
    taken: &mut Vec<Rect>,
) {
    let middle_of = |side: f32| {
        let at = if axis == 0 { [0.0, side] } else { [side, 0.0] };
        corner(eye, at, -1.0).0
    };
    let (one, other) = (middle_of(-1.0), middle_of(1.0));
    let floor = 0.5 * (one.to_vec2() + other.to_vec2());
    let middle = if one.y > other.y { one } else { other };
    let outward = (middle.to_vec2() - floor).normalized();
    let name = ["x", "y"][axis];
    let place = middle + 13.0 * outward;
    write(
        painter,
        place,
        Align2::CENTER_CENTER,
        name,
        colours,
        taken,
        eye.rect,
    );
}

/// Writes where nothing is written yet, within the pane.
fn write(
    painter: &Painter,
    at: Pos2,
    anchor: Align2,
    text: &str,
    colours: &Colours,
    taken: &mut Vec<Rect>,
    pane: Rect,
) {
    let galley = painter.layout_no_wrap(text.to_owned(), note_font(), colours.muted);
    let mut rect = anchor.anchor_size(at, galley.size());
    let inside = pane.shrink(3.0);
    // Names at the rim move in; those far outside belong to an end that is not seen.
    let shift_x = (inside.left() - rect.left()).max(0.0) - (rect.right() - inside.right()).max(0.0);
    let shift_y = (inside.top() - rect.top()).max(0.0) - (rect.bottom() - inside.bottom()).max(0.0);
    if shift_x.abs() > 24.0 || shift_y.abs() > 14.0 {
        return;
    }
    rect = rect.translate(vec2(shift_x, shift_y));
    if taken.iter().any(|other| other.expand(1.0).intersects(rect)) {
        return;
    }
    painter.galley(rect.min, galley, colours.muted);
    taken.push(rect);
}
