//! Where the picture is taken from.

/// A camera that looks at a point from a distance, with a parallel or perspective lens.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// The point in the middle of the picture, about which the camera turns.
    pub target: glam::Vec3,
    /// Rotation from camera axes (x right, y up, z towards the viewer) to the world.
    pub world_from_camera: glam::Quat,
    /// Half the height of what is seen at the target, in coordinates.
    pub half_height: f32,
    /// Vertical field of view; 0 is a parallel projection.
    pub field_of_view_rad: f32,
}

impl Default for Camera {
    fn default() -> Self {
        Self {
            target: glam::Vec3::ZERO,
            world_from_camera: glam::Quat::IDENTITY,
            half_height: 1.0,
            field_of_view_rad: 0.35,
        }
    }
}
