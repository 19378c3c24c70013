//! Which part of the map is seen: equal scale in both directions, so that distances can be read.

use egui::{Pos2, Rect, Vec2, pos2};

/// The middle of what is seen, and how large.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lens {
    /// Place on the map in the middle of the pane.
    pub centre: [f64; 2],
    /// Points of the screen for one unit of the map.
    pub points_per_unit: f64,
}

impl Lens {
    /// The lens that shows all places in a pane of a size.
    pub fn fit(places: impl Iterator<Item = [f64; 2]>, width: f32, height: f32) -> Self {
        let Some([low, high]) = bounds(places) else {
            return Self {
                centre: [0.0; 2],
                points_per_unit: 1.0,
            };
        };
        let room = [f64::from(width.max(1.0)), f64::from(height.max(1.0))];
        // Points that all lie in one place get a lens of one unit.
        let scales = [0, 1].map(|axis| {
            let span = high[axis] - low[axis];
            if span > 0.0 {
                room[axis] / span
            } else {
                f64::INFINITY
            }
        });
        let scale = scales[0].min(scales[1]);
        Self {
            centre: [0, 1].map(|axis| 0.5 * (low[axis] + high[axis])),
            points_per_unit: if scale.is_finite() {
                scale
            } else {
                room[0].min(room[1])
            },
        }
    }

    /// Where a place of the map lies on screen; the map's second axis points up.
    pub fn on_screen(&self, rect: Rect, at: [f64; 2]) -> Pos2 {
        let x = (at[0] - self.centre[0]) * self.points_per_unit;
        let y = (at[1] - self.centre[1]) * self.points_per_unit;
        pos2(rect.center().x + x as f32, rect.center().y - y as f32)
    }

    /// The place of the map at a point of the screen: the inverse of [`Self::on_screen`].
    pub fn place_at(&self, rect: Rect, at: Pos2) -> [f64; 2] {
        let offset = at - rect.center();
        [
            self.centre[0] + f64::from(offset.x) / self.points_per_unit,
            self.centre[1] - f64::from(offset.y) / self.points_per_unit,
        ]
    }

    /// Moves what is seen along with the pointer.
    pub fn drag(&mut self, delta: Vec2) {
        self.centre[0] -= f64::from(delta.x) / self.points_per_unit;
        self.centre[1] += f64::from(delta.y) / self.points_per_unit;
    }

    /// Zooms so that the place under `offset` from the middle of the pane stays there.
    pub fn zoom_about(&mut self, offset: Vec2, factor: f64) {
        if !(factor.is_finite() && factor > 0.0) || (factor - 1.0).abs() < 1e-6 {
            return;
        }
        let shift = (1.0 - 1.0 / factor) / self.points_per_unit;
        self.centre[0] += f64::from(offset.x) * shift;
        self.centre[1] -= f64::from(offset.y) * shift;
        self.points_per_unit *= factor;
    }
}

/// The least and greatest coordinates of all places that are finite; `None` where none is.
pub fn bounds(places: impl Iterator<Item = [f64; 2]>) -> Option<[[f64; 2]; 2]> {
    places
        .filter(|place| place.iter().all(|x| x.is_finite()))
        .map(|place| [place; 2])
        .reduce(|[low, high], [place, _]| {
            [
                [0, 1].map(|axis| f64::min(low[axis], place[axis])),
                [0, 1].map(|axis| f64::max(high[axis], place[axis])),
            ]
        })
}

/// What the user did to the lens, in terms of the one that shows all: it still fits when the map
/// takes on another scale.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moved {
    shift: [f64; 2],
    zoom: f64,
}

impl Moved {
    /// How `lens` differs from `fitted`; the shift is in points of the screen at the fitted scale.
    pub fn between(fitted: &Lens, lens: &Lens) -> Self {
        Self {
            shift: [0, 1]
                .map(|axis| (lens.centre[axis] - fitted.centre[axis]) * fitted.points_per_unit),
            zoom: lens.points_per_unit / fitted.points_per_unit,
        }
    }

    /// The lens that differs from `fitted` in this way.
    pub fn applied_to(&self, fitted: &Lens) -> Lens {
        Lens {
            centre: [0, 1]
                .map(|axis| fitted.centre[axis] + self.shift[axis] / fitted.points_per_unit),
            points_per_unit: fitted.points_per_unit * self.zoom,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_moved_lens_shows_the_same_part_of_a_map_of_another_scale() {
        let small = [[0.0, 0.0], [4.0, 1.0], [1.0, 3.0]];
        let large = small.map(|place| place.map(|x| 1000.0 * x + 7.0));
        let fitted = Lens::fit(small.into_iter(), 300.0, 200.0);
        let mut lens = fitted;
        lens.drag(egui::vec2(30.0, -12.0));
        lens.zoom_about(egui::vec2(10.0, 5.0), 2.5);
        let moved = Moved::between(&fitted, &lens);
        let other = moved.applied_to(&Lens::fit(large.into_iter(), 300.0, 200.0));
        let rect = Rect::from_min_size(pos2(5.0, 6.0), egui::vec2(300.0, 200.0));
        for (before, after) in small.into_iter().zip(large) {
            let apart = lens.on_screen(rect, before) - other.on_screen(rect, after);
            assert!(apart.length() < 1e-3);
        }
    }
}
