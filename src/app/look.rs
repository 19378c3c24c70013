//! From where a heart is looked at, told in the heart's own axes, so that one look fits every heart.

use glam::{Quat, Vec3};

use crate::picture::{AnatomicalView, HeartAxes, PreparedSubject};
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

/// Where a heart lies in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HeartFrame {
    /// Middle of the box around all poses.
    pub middle: Vec3,
    /// Rotation from the heart's axes to the world; the identity where its anatomy is unknown.
    pub world_from_heart: Quat,
}

impl Look {
    /// Rotation from camera axes to the world, for a heart that lies like `axes`.
    pub fn rotation(&self, axes: &HeartAxes) -> Quat {
        match self.direction {
            Direction::Home => axes.home(),
            Direction::From(side) => axes.view(side),
            Direction::Turned(heart_from_camera) => {
                (world_from_heart(axes) * heart_from_camera).normalize()
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

fn world_from_heart(axes: &HeartAxes) -> Quat {
    axes.view(AnatomicalView::Anterior)
}

impl HeartFrame {
    /// Where a prepared heart lies: the middle of the box around all its poses.
    pub fn of(prepared: &PreparedSubject) -> Self {
        let (mut low, mut high) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
        for point in prepared.all_positions() {
            low = low.min(Vec3::from(*point));
            high = high.max(Vec3::from(*point));
        }
        let middle = 0.5 * (low + high);
        Self {
            middle: if middle.is_finite() {
                middle
            } else {
                Vec3::ZERO
            },
            world_from_heart: world_from_heart(&prepared.axes),
        }
    }

    /// A camera in the world told in the heart's axes.
    pub fn heart_camera(&self, camera: Camera) -> Camera {
        let heart_from_world = self.world_from_heart.inverse();
        Camera {
            target: heart_from_world * (camera.target - self.middle),
            world_from_camera: (heart_from_world * camera.world_from_camera).normalize(),
            ..camera
        }
    }

    /// A camera told in the heart's axes placed in the world.
    pub fn world_camera(&self, camera: Camera) -> Camera {
        Camera {
            target: self.middle + self.world_from_heart * camera.target,
            world_from_camera: (self.world_from_heart * camera.world_from_camera).normalize(),
            ..camera
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_camera_comes_back_from_the_hearts_axes() {
        let frame = HeartFrame {
            middle: Vec3::new(10.0, -40.0, 90.0),
            world_from_heart: Quat::from_euler(glam::EulerRot::XYZ, 0.3, -1.1, 2.0),
        };
        let camera = Camera {
            target: Vec3::new(1.0, 2.0, 3.0),
            world_from_camera: Quat::from_rotation_y(0.7),
            half_height: 55.0,
            ..Camera::default()
        };
        let back = frame.world_camera(frame.heart_camera(camera));
        assert!((back.target - camera.target).length() < 1e-4);
        assert!(back.world_from_camera.dot(camera.world_from_camera).abs() > 1.0 - 1e-6);
        assert_eq!(back.half_height, 55.0);
    }
}
