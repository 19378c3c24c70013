//! From where a heart is looked at, told in the heart's own axes, so that one look fits every heart.

use glam::{Quat, Vec3};

use crate::render::Camera;
use crate::ui::AnatomicalView;

/// Which way the camera looks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Direction {
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
            direction: Direction::From(AnatomicalView::Anterior),
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

impl HeartFrame {
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
