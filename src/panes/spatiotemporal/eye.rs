//! From poses and shares of the cycle to places on screen: a box that is turned, then seen in weak perspective.

use egui::{Pos2, Rect, Vec2, pos2};

use crate::panes::scatter_map::{Projection, ScatterPoint, bounds};

/// From where the box is seen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turn {
    /// About the axis of time, in radians.
    yaw: f32,
    /// Height above the map, in radians; a right angle looks down along time.
    pitch: f32,
    /// 1 shows the whole box.
    zoom: f32,
}

impl Default for Turn {
    /// From the front left and a little above: all three axes are seen at length.
    fn default() -> Self {
        Self {
            yaw: 0.55,
            pitch: 0.42,
            zoom: 1.0,
        }
    }
}

impl Turn {
    /// Turns along with the pointer: a drag over 160 points turns by one radian.
    pub fn drag(&mut self, delta: Vec2) {
        const RADIANS_PER_POINT: f32 = 1.0 / 160.0;
        self.yaw = (self.yaw - delta.x * RADIANS_PER_POINT).rem_euclid(std::f32::consts::TAU);
        let right_angle = std::f32::consts::FRAC_PI_2;
        self.pitch = (self.pitch + delta.y * RADIANS_PER_POINT).clamp(-right_angle, right_angle);
    }

    /// Nearer or farther.
    pub fn zoom_by(&mut self, factor: f32) {
        if factor.is_finite() && factor > 0.0 {
            self.zoom = (self.zoom * factor).clamp(0.3, 12.0);
        }
    }
}

/// Half the height of the box, where half its greatest width is 1.
const HALF_HEIGHT: f32 = 0.8;

/// How far the eye is from the middle of the box, in half widths: far enough that parallels stay
/// nearly parallel, near enough to distinguish front from back.
const DISTANCE: f32 = 7.0;

/// Places on screen for one frame.
#[derive(Clone, Copy, Debug)]
pub struct Eye {
    /// The pane.
    pub rect: Rect,
    centre: [f64; 2],
    scale: f64,
    /// Half the box: along x, along y, along time.
    pub half: [f32; 3],
    points_per_unit: f32,
    sin_cos: [(f32, f32); 2],
}

impl Eye {
    /// Sees all points in a pane; both axes of the map have one scale.
    pub fn new(turn: Turn, rect: Rect, points: &[ScatterPoint]) -> Self {
        let places = points.iter().map(|point| point.at);
        let [low, high] = bounds(places).unwrap_or_default();
        let spans = [0, 1].map(|axis| 0.5 * (high[axis] - low[axis]));
        let widest = spans[0].max(spans[1]);
        let scale = if widest > 0.0 { 1.0 / widest } else { 1.0 };
        // A box as flat as a sheet could not be read from the side.
        let half = [0, 1].map(|axis| ((spans[axis] * scale) as f32).max(0.3));
        let half = [half[0] * 1.06, half[1] * 1.06, HALF_HEIGHT];
        // Turned any way about time, the box stays within these.
        let across = half[0].hypot(half[1]);
        let upright = HALF_HEIGHT + 0.42 * across;
        let room = rect.size() - egui::vec2(84.0, 52.0);
        let fit = (0.5 * room.x / across).min(0.5 * room.y / upright).max(4.0);
        Self {
            rect,
            centre: [0, 1].map(|axis| 0.5 * (low[axis] + high[axis])),
            scale,
            half,
            points_per_unit: fit * turn.zoom,
            sin_cos: [turn.yaw.sin_cos(), turn.pitch.sin_cos()],
        }
    }

    /// Where a pose lies in the box: along x, along y, along time.
    fn in_box(&self, at: [f64; 2], share: f64) -> [f32; 3] {
        [
            ((at[0] - self.centre[0]) * self.scale) as f32,
            ((at[1] - self.centre[1]) * self.scale) as f32,
            (2.0 * share - 1.0) as f32 * self.half[2],
        ]
    }

    /// Place on screen and depth, about −1 to 1, of a place in the box; nearer is less.
    pub fn see_in_box(&self, [x, y, t]: [f32; 3]) -> (Pos2, f32) {
        let [(sin_yaw, cos_yaw), (sin_pitch, cos_pitch)] = self.sin_cos;
        let right = cos_yaw * x + sin_yaw * y;
        let away = cos_yaw * y - sin_yaw * x;
        let up = cos_pitch * t + sin_pitch * away;
        let depth = cos_pitch * away - sin_pitch * t;
        let size = self.points_per_unit * DISTANCE / (DISTANCE + depth).max(0.5);
        let centre = self.rect.center();
        (pos2(centre.x + right * size, centre.y - up * size), depth)
    }
}

impl Projection for Eye {
    const HAS_DEPTH: bool = true;

    fn rect(&self) -> Rect {
        self.rect
    }

    fn see(&self, at: [f64; 2], share: f64) -> (Pos2, f32) {
        self.see_in_box(self.in_box(at, share))
    }

    /// What is far fades into the pane.
    fn fade(&self, depth: f32) -> f32 {
        (1.2 - 0.45 * depth).clamp(0.4, 1.7)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::vec2;

    fn eye(turn: Turn) -> Eye {
        let points = [([-2.0, 0.0], 0.0), ([6.0, 3.0], 0.9)].map(|(at, share)| ScatterPoint {
            at,
            share,
            ..ScatterPoint::default()
        });
        let rect = Rect::from_min_size(pos2(10.0, 20.0), vec2(400.0, 300.0));
        Eye::new(turn, rect, &points)
    }

    #[test]
    fn the_whole_box_is_on_screen_from_every_side_above() {
        for step in 0..24 {
            let mut turn = Turn::default();
            turn.drag(vec2(40.0 * step as f32, 0.0));
            let eye = eye(turn);
            for corner in 0..8 {
                let side = |axis: usize| {
                    let sign = if corner >> axis & 1 == 0 { -1.0 } else { 1.0 };
                    sign * eye.half[axis]
                };
                let (place, _) = eye.see_in_box([side(0), side(1), side(2)]);
                assert!(eye.rect.contains(place), "{step} {corner} {place:?}");
            }
        }
    }

    #[test]
    fn from_above_time_has_no_length_and_the_map_lies_as_in_its_pane() {
        let mut turn = Turn {
            yaw: 0.0,
            ..Turn::default()
        };
        turn.drag(vec2(0.0, 1000.0));
        let eye = eye(turn);
        let middle = eye.rect.center();
        let (start, far) = eye.see([2.0, 1.5], 0.0);
        let (end, near) = eye.see([2.0, 1.5], 1.0);
        assert!((start - middle).length() < 1e-3 && (end - middle).length() < 1e-3);
        assert!(near < far, "later is nearer to an eye above");
        assert!(eye.see([6.0, 1.5], 0.5).0.x > middle.x);
        assert!(eye.see([2.0, 3.0], 0.5).0.y < middle.y);
    }

    #[test]
    fn a_full_turn_comes_back() {
        let mut turn = Turn::default();
        turn.drag(vec2(160.0 * std::f32::consts::TAU, 0.0));
        assert!((turn.yaw - Turn::default().yaw).abs() < 1e-4);
    }
}
