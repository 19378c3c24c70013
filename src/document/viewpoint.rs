//! From where a heart is looked at, told in the heart's own axes, so that one look fits every heart.

use glam::{Quat, Vec3};

use crate::picture::{AnatomicalView, HeartAxes, HeartFrame};
use crate::render::Camera;

/// Which way the camera looks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Direction {
    /// The first look: base up, a little from above and from the side.
    Home,
    /// From one of the six anatomical sides.
    From(AnatomicalView),
    /// Turned by hand: rotation from camera axes to the heart's axes.
    Turned(Quat),
}

/// A look at a heart, kept when another heart is selected.
///
/// Sizes are in coordinates, so hearts of one cohort appear in proportion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Look {
    /// Which way.
    pub direction: Direction,
    /// From the heart's middle to the middle of the picture, in the heart's axes.
    pub offset: Vec3,
    /// Half the height of what is seen; `None` fits the heart.
    pub half_height: Option<f32>,
}

impl Default for Look {
    fn default() -> Self {
        Self {
            direction: Direction::Home,
            offset: Vec3::ZERO,
            half_height: None,
        }
    }
}

impl Look {
    /// Rotation from camera axes to the world, for a heart that lies like `axes`.
    pub fn rotation(&self, axes: &HeartAxes) -> Quat {
        match self.direction {
            Direction::Home => axes.home(),
            Direction::From(side) => axes.view(side),
            Direction::Turned(heart_from_camera) => {
                (HeartFrame::rotation(axes) * heart_from_camera).normalize()
            }
        }
    }

    /// The camera in the world, given one that fits the heart in this look's direction.
    pub fn camera(&self, frame: &HeartFrame, fitted: Camera) -> Camera {
        match self.half_height {
            None => fitted,
            Some(half_height) => Camera {
                target: frame.middle + frame.world_from_heart * self.offset,
                half_height,
                ..fitted
            },
        }
    }
}
