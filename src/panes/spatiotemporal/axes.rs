//! The box around the curves: its floor, its ticks of time, and names that do not overlap.

use egui::{Align2, Painter, Pos2, Rect, Shape, Stroke, Vec2, vec2};

use crate::picture::share_unit;
use crate::ui::style::note_font;
use crate::ui::theme::{Colours, line};

use super::eye::Eye;

/// Draws edges of the box, the floor's grid and the ticks of time behind the curves. `rr_is_known` says whether the
/// cycles of all curves have a known length.
pub fn draw_axes(painter: &Painter, eye: &Eye, colours: &Colours, rr_is_known: bool) {
    let mut axes = Axes {
        painter,
        eye,
        colours,
        taken: Vec::new(),
    };
    axes.draw_floor();
    let edge = axes.time_edge();
    axes.draw_uprights(edge);
    axes.draw_time(edge, rr_is_known);
    for axis in [0, 1] {
        axes.name_floor_axis(axis);
    }
}

struct Axes<'a> {
    painter: &'a Painter,
    eye: &'a Eye,
    colours: &'a Colours,
    /// Where text stands already.
    taken: Vec<Rect>,
}

/// Corners of the box as signs along x and y.
const CORNERS: [[f32; 2]; 4] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];

impl Axes<'_> {
    /// Place on screen and depth of a corner at a height of the box from −1 to 1.
    fn corner(&self, [x, y]: [f32; 2], t: f32) -> (Pos2, f32) {
        let half = self.eye.half;
        self.eye.see_in_box([x * half[0], y * half[1], t * half[2]])
    }

    fn place(&self, corner: [f32; 2], t: f32) -> Pos2 {
        self.corner(corner, t).0
    }

    fn draw_floor(&self) {
        let floor = CORNERS.map(|corner| self.place(corner, -1.0));
        let fill = self.colours.grid.gamma_multiply(0.35);
        let polygon = Shape::convex_polygon(floor.to_vec(), fill, Stroke::NONE);
        self.painter.add(polygon);
        let thin = Stroke::new(line::THIN, self.colours.grid);
        for step in 1..4 {
            let at = 0.5 * step as f32 - 1.0;
            for ends in [[[at, -1.0], [at, 1.0]], [[-1.0, at], [1.0, at]]] {
                let ends = ends.map(|end| self.place(end, -1.0));
                self.painter.line_segment(ends, thin);
            }
        }
        let edge = Stroke::new(line::THIN, self.colours.line);
        for index in 0..4 {
            self.painter
                .line_segment([floor[index], floor[(index + 1) % 4]], edge);
        }
    }

    /// The upright edge that carries the ticks of time: the leftmost on screen.
    fn time_edge(&self) -> [f32; 2] {
        let left = |corner: &[f32; 2]| self.place(*corner, 0.0).x;
        let leftmost = CORNERS
            .into_iter()
            .min_by(|a, b| left(a).total_cmp(&left(b)));
        leftmost.unwrap_or(CORNERS[0])
    }

    /// The uprights behind the curves, and the upper edges between them.
    fn draw_uprights(&self, time_edge: [f32; 2]) {
        let depth = |corner: &[f32; 2]| self.corner(*corner, 0.0).1;
        let nearest = CORNERS
            .into_iter()
            .min_by(|a, b| depth(a).total_cmp(&depth(b)));
        let stroke = Stroke::new(line::THIN, self.colours.grid);
        for index in 0..4 {
            let (here, next) = (CORNERS[index], CORNERS[(index + 1) % 4]);
            if Some(here) != nearest && here != time_edge {
                let ends = [-1.0, 1.0].map(|t| self.place(here, t));
                self.painter.line_segment(ends, stroke);
            }
            if Some(here) != nearest && Some(next) != nearest {
                let ends = [here, next].map(|corner| self.place(corner, 1.0));
                self.painter.line_segment(ends, stroke);
            }
        }
    }

    fn draw_time(&mut self, edge: [f32; 2], rr_is_known: bool) {
        let (bottom, top) = (self.place(edge, -1.0), self.place(edge, 1.0));
        let stroke = Stroke::new(line::THIN, self.colours.muted);
        self.painter.line_segment([bottom, top], stroke);
        let above = top + vec2(0.0, -10.0);
        let name = format!("time, {}", share_unit(rr_is_known));
        self.write(above, Align2::CENTER_BOTTOM, &name);
        // Ticks point away from the middle of the plot.
        let right = self.place(edge, 0.0).x > self.eye.rect.center().x;
        let outward = vec2(if right { 1.0 } else { -1.0 }, 0.0);
        // Seen along time, ticks would lie upon each other.
        let length = (top - bottom).length();
        for percent in [0, 25, 50, 75, 100] {
            if length < 60.0 && percent % 100 != 0 || length < 24.0 {
                continue;
            }
            let at = self.place(edge, 0.02 * percent as f32 - 1.0);
            self.painter.line_segment([at, at + 4.0 * outward], stroke);
            let text = percent.to_string();
            self.write(at + 7.0 * outward, Align2::RIGHT_CENTER, &text);
        }
    }

    /// Names an axis of the map along the lower of its two edges on the floor.
    fn name_floor_axis(&mut self, axis: usize) {
        let middle_of = |side: f32| {
            let at = if axis == 0 { [0.0, side] } else { [side, 0.0] };
            self.place(at, -1.0)
        };
        let (one, other) = (middle_of(-1.0), middle_of(1.0));
        let floor = 0.5 * (one.to_vec2() + other.to_vec2());
        let middle = if one.y > other.y { one } else { other };
        let outward = (middle.to_vec2() - floor).normalized();
        let name = ["x", "y"][axis];
        self.write(middle + 13.0 * outward, Align2::CENTER_CENTER, name);
    }

    /// Writes where nothing is written yet, within the pane.
    fn write(&mut self, at: Pos2, anchor: Align2, text: &str) {
        let colour = self.colours.muted;
        let galley = self
            .painter
            .layout_no_wrap(text.to_owned(), note_font(), colour);
        let mut rect = anchor.anchor_size(at, galley.size());
        let inside = self.eye.rect.shrink(3.0);
        // Names at the rim move in; those far outside belong to an end that is not seen.
        let shift =
            (inside.min - rect.min).max(Vec2::ZERO) - (rect.max - inside.max).max(Vec2::ZERO);
        if shift.x.abs() > 24.0 || shift.y.abs() > 14.0 {
            return;
        }
        rect = rect.translate(shift);
        if self
            .taken
            .iter()
            .any(|other| other.expand(1.0).intersects(rect))
        {
            return;
        }
        self.painter.galley(rect.min, galley, colour);
        self.taken.push(rect);
    }
}
