//! A camera that holds a whole beat, however it is turned.

use crate::render::{Camera, GeometryPose};

use super::prepared::PreparedSubject;

impl PreparedSubject {
    /// The first picture of this subject: all frames in view, base up, a little from above.
    pub fn home_camera(&self, aspect: f32) -> Camera {
        self.camera_from(self.axes.home(), aspect)
    }

    /// All frames in view, from a given direction.
    pub fn camera_from(&self, world_from_camera: glam::Quat, aspect: f32) -> Camera {
        fitted_camera(self.all_positions(), world_from_camera, aspect)
    }
}

/// Free room around what is fitted.
const MARGIN: f32 = 1.06;

/// A camera with the given rotation, just far enough for all points to be seen; `aspect` is
/// width by height of the picture.
///
/// With t = tan(field of view / 2) and (x, y, z) a point in camera axes about the target, z to the
/// viewer, the point is seen if |y| ≤ h − z·t and |x| ≤ aspect · (h − z·t), where h is half the
/// height seen at the target: so h is the greatest |y| + z·t and |x| / aspect + z·t.
pub fn fitted_camera<'a>(
    points: impl Iterator<Item = &'a [f32; 3]> + Clone,
    world_from_camera: glam::Quat,
    aspect: f32,
) -> Camera {
    let camera = Camera::default();
    let camera_from_world = world_from_camera.inverse();
    let mut low = glam::Vec3::INFINITY;
    let mut high = glam::Vec3::NEG_INFINITY;
    for &point in points.clone() {
        let seen = camera_from_world * glam::Vec3::from(point);
        low = low.min(seen);
        high = high.max(seen);
    }
    if !(low.is_finite() && high.is_finite()) {
        return Camera {
            world_from_camera,
            ..camera
        };
    }
    let middle = 0.5 * (low + high);
    let slope = (0.5 * camera.field_of_view_rad).tan();
    let aspect = aspect.max(0.05);
    let mut half_height = 0.0_f32;
    for &point in points {
        let seen = camera_from_world * glam::Vec3::from(point) - middle;
        let reach = seen.y.abs().max(seen.x.abs() / aspect) + seen.z * slope;
        half_height = half_height.max(reach);
    }
    Camera {
        target: world_from_camera * middle,
        world_from_camera,
        half_height: (half_height * MARGIN).max(f32::MIN_POSITIVE),
        ..camera
    }
}

/// Positions at a pose between two frames, blended as the renderer blends them.
pub(crate) fn blended(from: &[[f32; 3]], to: &[[f32; 3]], pose: GeometryPose) -> Vec<[f32; 3]> {
    from.iter()
        .zip(to)
        .map(|(a, b)| std::array::from_fn(|i| a[i] + pose.blend * (b[i] - a[i])))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_point_is_inside_the_picture_and_one_touches_its_margin() {
        let points = [
            [0.0, 0.0, 40.0],
            [30.0, 10.0, -10.0],
            [-20.0, -50.0, 5.0],
            [5.0, 25.0, 0.0],
        ];
        for aspect in [0.5, 1.0, 2.0] {
            let turn = glam::Quat::from_rotation_y(0.7) * glam::Quat::from_rotation_x(0.4);
            let camera = fitted_camera(points.iter(), turn, aspect);
            let slope = (0.5 * camera.field_of_view_rad).tan();
            let distance = camera.half_height / slope;
            let reach = points
                .iter()
                .map(|&point| {
                    let seen = turn.inverse() * (glam::Vec3::from(point) - camera.target);
                    let scale = slope * (distance - seen.z);
                    (seen.y.abs() / scale).max(seen.x.abs() / (aspect * scale))
                })
                .fold(0.0, f32::max);
            assert!((0.9..=1.0).contains(&reach), "{aspect}: {reach}");
        }
    }

    #[test]
    fn nothing_to_see_gives_a_usable_camera() {
        let camera = fitted_camera([].iter(), glam::Quat::IDENTITY, 1.0);
        assert!(camera.half_height > 0.0 && camera.target.is_finite());
    }
}
