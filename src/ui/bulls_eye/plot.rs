//! Where the disc lies on screen, and what is under the pointer.

use egui::{Pos2, Rect, pos2};

use crate::analysis::segments::{Level, Segment, segment_on_plot};
use crate::ui::theme::{space, type_size};

/// What of the wall was clicked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BullsEyePick {
    /// The ring.
    pub level: Level,
    /// The segment, where septum and anterior wall are known.
    pub segment: Option<Segment>,
    /// The place in the unit disc, x to the right and y up.
    pub at: [f64; 2],
}

/// The disc on screen.
#[derive(Clone, Copy, Debug)]
pub struct Plot {
    /// All the room.
    pub rect: Rect,
    /// Middle of the disc.
    pub centre: Pos2,
    /// Its radius in points.
    pub radius: f32,
}

impl Plot {
    /// The greatest disc with room for a line of text around it.
    pub fn new(rect: Rect) -> Self {
        let margin = type_size::NOTE + 2.0 * space::SMALL;
        Self {
            rect,
            centre: rect.center(),
            radius: (0.5 * rect.width().min(rect.height()) - margin).max(1.0),
        }
    }

    /// A place of the unit disc on screen, where y grows downwards.
    pub fn on_screen(&self, [x, y]: [f64; 2]) -> Pos2 {
        pos2(
            self.centre.x + self.radius * x as f32,
            self.centre.y - self.radius * y as f32,
        )
    }

    /// A place given by radius and angle.
    pub fn at(&self, radius: f64, angle_rad: f64) -> Pos2 {
        let (sin, cos) = angle_rad.sin_cos();
        self.on_screen([radius * cos, radius * sin])
    }

    /// What lies under the pointer; `None` beside the disc.
    pub fn pick(&self, pointer: Pos2, oriented: bool) -> Option<BullsEyePick> {
        let offset = (pointer - self.centre) / self.radius;
        let at = [f64::from(offset.x), f64::from(-offset.y)];
        let segment = segment_on_plot(at)?;
        Some(BullsEyePick {
            level: segment.level(),
            segment: oriented.then_some(segment),
            at,
        })
    }
}
