//! Where the picture is taken from.

use glam::{Mat4, Quat, Vec2, Vec3, Vec4};

/// A camera that looks at a point from a distance, with a parallel or perspective lens.
///
/// Sizes and places on the picture may be in any pixels (logical or physical) as long as they agree; y points down.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// The point in the middle of the picture, about which the camera turns.
    pub target: Vec3,
    /// Rotation from camera axes (x right, y up, z towards the viewer) to the world.
    pub world_from_camera: Quat,
    /// Half the height of what is seen at the target, in coordinates.
    pub half_height: f32,
    /// Vertical field of view; 0 is a parallel projection.
    pub field_of_view_rad: f32,
}

impl Default for Camera {
    fn default() -> Self {
        Self {
            target: Vec3::ZERO,
            world_from_camera: Quat::IDENTITY,
            half_height: 1.0,
            field_of_view_rad: 0.35,
        }
    }
}

/// A half-line from the eye into the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray {
    /// Where it starts.
    pub origin: Vec3,
    /// Unit direction.
    pub direction: Vec3,
}

/// A point on the picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Projected {
    /// Pixels from the upper left corner, y down.
    pub pixel: Vec2,
    /// Distance in front of the eye plane, in coordinates.
    pub distance: f32,
}

/// A parallel camera sees this many half heights before and behind its target: enough to look at a millimetre of a subject.
const PARALLEL_REACH: f32 = 256.0;
/// The near plane, as a share of the distance from eye to target.
const NEAR_SHARE: f32 = 0.01;

impl Camera {
    /// Whether the projection is parallel.
    pub fn is_parallel(&self) -> bool {
        self.field_of_view_rad < 1e-3
    }

    /// Distance from the eye (for a parallel lens: the plane where depth starts) to the target, in coordinates.
    pub fn eye_distance(&self) -> f32 {
        if self.is_parallel() {
            PARALLEL_REACH * self.half_height
        } else {
            self.half_height / (0.5 * self.field_of_view_rad).tan()
        }
    }

    /// Where the eye is.
    pub fn eye(&self) -> Vec3 {
        self.target + self.backward() * self.eye_distance()
    }

    /// Unit vector in the world towards the right of the picture.
    pub fn right(&self) -> Vec3 {
        self.world_from_camera * Vec3::X
    }

    /// Unit vector in the world towards the top of the picture.
    pub fn up(&self) -> Vec3 {
        self.world_from_camera * Vec3::Y
    }

    /// Unit vector in the world from the target to the eye.
    pub fn backward(&self) -> Vec3 {
        self.world_from_camera * Vec3::Z
    }

    /// Rigid motion from the world to camera axes with the eye at the origin, looking along −z.
    pub fn view_from_world(&self) -> Mat4 {
        Mat4::from_translation(Vec3::new(0.0, 0.0, -self.eye_distance()))
            * Mat4::from_quat(self.world_from_camera.inverse())
            * Mat4::from_translation(-self.target)
    }

    /// Scale of camera coordinates to the square −1..=1, and the near distance (perspective) or depth range (parallel).
    pub(super) fn lens(&self, aspect: f32) -> (Vec2, f32) {
        let distance = self.eye_distance();
        if self.is_parallel() {
            let y = 1.0 / self.half_height;
            (Vec2::new(y / aspect, y), 2.0 * distance)
        } else {
            let y = distance / self.half_height;
            (Vec2::new(y / aspect, y), NEAR_SHARE * distance)
        }
    }

    /// Projection with depth 1 at the near plane and 0 far away (reverse-Z; infinite if perspective).
    pub fn clip_from_view(&self, aspect: f32) -> Mat4 {
        let (scale, depth) = self.lens(aspect);
        if self.is_parallel() {
            Mat4::from_cols(
                Vec4::X * scale.x,
                Vec4::Y * scale.y,
                Vec4::Z / depth,
                Vec4::new(0.0, 0.0, 1.0, 1.0),
            )
        } else {
            Mat4::from_cols(
                Vec4::X * scale.x,
                Vec4::Y * scale.y,
                Vec4::new(0.0, 0.0, 0.0, -1.0),
                Vec4::new(0.0, 0.0, depth, 0.0),
            )
        }
    }

    /// View and projection in one.
    pub fn clip_from_world(&self, aspect: f32) -> Mat4 {
        self.clip_from_view(aspect) * self.view_from_world()
    }

    /// Where a point of the world appears; `None` if it is behind the eye.
    pub fn project(&self, point: Vec3, size: Vec2) -> Option<Projected> {
        let q = self.world_from_camera.inverse() * (point - self.target);
        let distance = self.eye_distance() - q.z;
        if distance <= 0.0 || size.min_element() <= 0.0 {
            return None;
        }
        let (scale, _) = self.lens(size.x / size.y);
        let spread = if self.is_parallel() { 1.0 } else { distance };
        let ndc = Vec2::new(q.x, q.y) * scale / spread;
        let pixel = 0.5 * size * Vec2::new(1.0 + ndc.x, 1.0 - ndc.y);
        Some(Projected { pixel, distance })
    }

    /// The ray through a place on the picture.
    pub fn ray(&self, pixel: Vec2, size: Vec2) -> Ray {
        let at_target = self.on_target_plane(pixel, size);
        if self.is_parallel() {
            Ray {
                origin: at_target + self.backward() * self.eye_distance(),
                direction: -self.backward(),
            }
        } else {
            let origin = self.eye();
            Ray {
                origin,
                direction: (at_target - origin).normalize(),
            }
        }
    }

    /// The point under a pixel on the plane through the target that faces the viewer.
    pub fn on_target_plane(&self, pixel: Vec2, size: Vec2) -> Vec3 {
        let from_middle = (pixel - 0.5 * size) * self.length_per_pixel(size.y);
        self.target + self.right() * from_middle.x - self.up() * from_middle.y
    }

    /// Length of a pixel at the target, in coordinates: what a scale bar stands for.
    pub fn length_per_pixel(&self, picture_height: f32) -> f32 {
        2.0 * self.half_height / picture_height.max(1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: Vec2 = Vec2::new(640.0, 480.0);

    fn tilted(field_of_view_rad: f32) -> Camera {
        Camera {
            target: Vec3::new(10.0, -5.0, 3.0),
            world_from_camera: Quat::from_euler(glam::EulerRot::YXZ, 0.7, -0.4, 0.2),
            half_height: 60.0,
            field_of_view_rad,
        }
    }

    #[test]
    fn the_target_is_in_the_middle_of_the_picture() {
        for camera in [tilted(0.0), tilted(0.35)] {
            let seen = camera.project(camera.target, SIZE).unwrap();
            assert!((seen.pixel - 0.5 * SIZE).length() < 1e-3);
            assert!((seen.distance / camera.eye_distance() - 1.0).abs() < 1e-6);
        }
    }

    #[test]
    fn half_the_height_at_the_target_reaches_the_upper_edge() {
        for camera in [tilted(0.0), tilted(0.35)] {
            let top = camera.target + camera.up() * camera.half_height;
            let seen = camera.project(top, SIZE).unwrap();
            assert!((seen.pixel - Vec2::new(320.0, 0.0)).length() < 0.01);
        }
    }

    #[test]
    fn the_ray_through_a_projected_point_meets_the_point() {
        let point = Vec3::new(31.0, 12.0, -20.0);
        for camera in [tilted(0.0), tilted(0.35)] {
            let seen = camera.project(point, SIZE).unwrap();
            let ray = camera.ray(seen.pixel, SIZE);
            let along = (point - ray.origin).dot(ray.direction);
            let miss = (ray.origin + ray.direction * along - point).length();
            // f32 at a distance of 15,000 coordinates (parallel) resolves 1e-3.
            assert!(miss < 5e-3, "misses by {miss}");
        }
    }

    #[test]
    fn the_matrix_puts_points_where_project_does_with_depth_growing_towards_the_eye() {
        let (near, far) = (Vec3::new(12.0, 3.0, 25.0), Vec3::new(-8.0, 9.0, -30.0));
        for mut camera in [tilted(0.0), tilted(0.35)] {
            camera.world_from_camera = Quat::IDENTITY;
            let depth = |point: Vec3| {
                let clip = camera.clip_from_world(SIZE.x / SIZE.y) * point.extend(1.0);
                let ndc = clip / clip.w;
                let seen = camera.project(point, SIZE).unwrap();
                let pixel = 0.5 * SIZE * Vec2::new(1.0 + ndc.x, 1.0 - ndc.y);
                assert!((pixel - seen.pixel).length() < 0.02);
                assert!((0.0..=1.0).contains(&ndc.z));
                ndc.z
            };
            assert!(depth(near) > depth(far));
        }
    }

    #[test]
    fn a_point_behind_the_eye_is_not_on_the_picture() {
        let camera = tilted(0.35);
        let behind = camera.eye() + camera.backward();
        assert_eq!(camera.project(behind, SIZE), None);
    }

    #[test]
    fn a_scale_bar_of_one_pixel_is_the_height_divided_by_pixels() {
        assert_eq!(tilted(0.35).length_per_pixel(480.0), 0.25);
    }
}
