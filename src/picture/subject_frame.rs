//! Where a subject lies in the world, and cameras told in its own axes, so that one look fits every subject.

use glam::{Quat, Vec3};

use crate::picture::axes::{AnatomicalView, SubjectAxes};
use crate::picture::prepared::PreparedSubject;
use crate::render::Camera;

/// Where a subject lies in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SubjectFrame {
    /// Middle of the box around all poses.
    pub middle: Vec3,
    /// Rotation from the heart's axes to the world; the identity where its anatomy is unknown.
    pub world_from_heart: Quat,
}

impl SubjectFrame {
    /// Rotation from the axes of a heart that lies like `axes` to the world.
    pub fn rotation(axes: &SubjectAxes) -> Quat {
        axes.view(AnatomicalView::Anterior)
    }

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
            world_from_heart: Self::rotation(&prepared.axes),
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
        let frame = SubjectFrame {
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
