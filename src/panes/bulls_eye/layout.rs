//! Positions of the plot and its colour bar in the pane, and the segment at a point.

use egui::{Pos2, Rect, vec2};

use crate::analysis::segments::{Segment, ring, segment_on_plot};
use crate::ui::marks::distance_to;
use crate::ui::theme::space;

/// Height of the colour bar with its numbers and title.
const BAR_HEIGHT: f32 = 50.0;
/// Room for a name on each side.
const NAMES: f32 = 16.0;

/// The plot on the screen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disc {
    /// Its middle, the apex.
    pub centre: Pos2,
    /// Its radius, the base.
    pub radius: f32,
}

/// The plot and the colour bar in an area.
pub fn places(area: Rect, named: bool) -> (Disc, Rect) {
    let (plot, bar) = area.split_top_bottom_at_y(area.bottom() - BAR_HEIGHT);
    let mut inner = plot.shrink(if named { NAMES } else { 2.0 });
    if !named {
        // There is a note above that says so.
        inner.min.y = plot.top() + NAMES;
    }
    let disc = Disc {
        centre: inner.center(),
        radius: 0.5 * inner.width().min(inner.height()).max(0.0),
    };
    let bar = bar.shrink2(vec2(0.0, space::SMALL));
    let width = bar.width().min(240.0);
    let bar = Rect::from_center_size(bar.center(), vec2(width, bar.height()));
    (disc, bar)
}

impl Disc {
    /// Place of a point of the unit disc, x to the right and y up.
    pub fn at(&self, [x, y]: [f64; 2]) -> Pos2 {
        self.centre + self.radius * vec2(x as f32, -y as f32)
    }

    /// Place at an angle (0 to the right, π/2 up) and a share of the radius.
    pub fn polar(&self, angle_rad: f64, share: f64) -> Pos2 {
        let (sin, cos) = angle_rad.sin_cos();
        self.at([share * cos, share * sin])
    }

    /// The segment drawn at a place; `None` beside the plot.
    pub fn segment_at(&self, place: Pos2) -> Option<Segment> {
        let offset = (place - self.centre) / self.radius;
        segment_on_plot([f64::from(offset.x), f64::from(-offset.y)])
    }

    /// How far a place is from the nearest of these borders, closed lines of the unit disc.
    pub fn distance_to_borders(&self, borders: &[Vec<[f64; 2]>], place: Pos2) -> f32 {
        let sides = borders.iter().flat_map(|border| {
            let next = border.iter().cycle().skip(1);
            border.iter().zip(next)
        });
        sides
            .map(|(a, b)| distance_to(self.at(*a), self.at(*b), place).0)
            .fold(f32::INFINITY, f32::min)
    }

    /// Middle of a segment on the plot.
    pub fn middle_of(&self, segment: Segment) -> Pos2 {
        let [inner, outer] = ring(segment.level());
        if inner == 0.0 {
            return self.centre;
        }
        self.polar(segment.sector_rad()[0], 0.5 * (inner + outer))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::pos2;

    #[test]
    fn the_middle_of_each_drawn_segment_is_that_segment() {
        let area = Rect::from_min_size(pos2(10.0, 20.0), vec2(260.0, 280.0));
        let (disc, bar) = places(area, true);
        for segment in Segment::all() {
            assert_eq!(disc.segment_at(disc.middle_of(segment)), Some(segment));
        }
        assert_eq!(disc.segment_at(area.left_top()), None);
        assert!(bar.top() >= disc.centre.y + disc.radius);
        assert!(area.contains_rect(bar));
    }

    #[test]
    fn the_plot_takes_the_room_of_names_that_are_not_there() {
        let area = Rect::from_min_size(pos2(10.0, 20.0), vec2(150.0, 150.0));
        let [named, unnamed] = [true, false].map(|named| places(area, named).0.radius);
        assert!(unnamed >= named + 6.0, "{named} {unnamed}");
    }
}
