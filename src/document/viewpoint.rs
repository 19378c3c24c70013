//! From where a subject is looked at, told in the subject's own axes, so that one look fits every subject.

use glam::{Quat, Vec3};

use crate::picture::{AnatomicalView, SubjectAxes, SubjectFrame};
use crate::render::Camera;

/// Which way the camera looks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Direction {
    /// The first look: base up, a little from above and from the side.
    Home,
    /// From one of the six anatomical sides.
    From(AnatomicalView),
    /// Turned by hand: rotation from camera axes to the subject's axes.
    Turned(Quat),
}

/// A look at a subject, kept when another subject is selected.
///
/// Sizes are in coordinates, so subjects of one cohort appear in proportion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Viewpoint {
    /// Which way.
    pub direction: Direction,
    /// From the subject's middle to the middle of the picture, in the subject's axes.
    pub offset: Vec3,
    /// Half the height of what is seen; `None` fits the subject.
    pub half_height: Option<f32>,
}

impl Default for Viewpoint {
    fn default() -> Self {
        Self {
            direction: Direction::Home,
            offset: Vec3::ZERO,
            half_height: None,
        }
    }
}

impl Viewpoint {
    /// The look of a camera in the subject's axes; `None` for one that sees nothing.
    pub fn through(camera: &Camera) -> Option<Self> {
        let half_height = Some(camera.half_height).filter(|half| half.is_finite() && *half > 0.0);
        half_height.map(|_| Self {
            direction: Direction::Turned(camera.world_from_camera),
            offset: camera.target,
            half_height,
        })
    }

    /// Rotation from camera axes to the world, for a subject that lies like `axes`.
    pub fn rotation(&self, axes: &SubjectAxes) -> Quat {
        match self.direction {
            Direction::Home => axes.home(),
            Direction::From(side) => axes.view(side),
            Direction::Turned(heart_from_camera) => {
                (SubjectFrame::rotation(axes) * heart_from_camera).normalize()
            }
        }
    }

    /// The camera in the world, given one that fits the subject in this look's direction.
    pub fn camera(&self, frame: &SubjectFrame, fitted: Camera) -> Camera {
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
