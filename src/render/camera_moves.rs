//! How the camera moves: fit, turn, pan, zoom, look from a side. Every move returns a new camera.

use glam::{Mat3, Quat, Vec2, Vec3};

use super::{Bounds, Camera};

/// The turntable stops this short of looking straight along its axis, where "up" would be lost.
const STEEPEST_PITCH_RAD: f32 = 1.553;
/// Room left around what is fitted.
const FIT_MARGIN: f32 = 1.06;

impl Camera {
    /// The same view direction and lens, with a box filling a picture of this aspect (width by height).
    #[must_use]
    pub fn fitted(self, bounds: &Bounds, aspect: f32) -> Self {
        let centre = bounds.centre();
        let camera_from_world = self.world_from_camera.inverse();
        let slope = if self.is_parallel() {
            0.0
        } else {
            (0.5 * self.field_of_view_rad).tan()
        };
        // At depth z before the target half the seen height is half_height − z · slope.
        let half_height = bounds
            .corners()
            .into_iter()
            .map(|corner| {
                let q = camera_from_world * (corner - centre);
                q.y.abs().max(q.x.abs() / aspect.max(1e-3)) + q.z * slope
            })
            .fold(0.0f32, f32::max);
        Self {
            target: centre,
            half_height: if half_height > 0.0 {
                half_height * FIT_MARGIN
            } else {
                self.half_height
            },
            ..self
        }
    }

    /// Looks along `direction` (from the eye into the scene) with `up` upwards as far as possible.
    #[must_use]
    pub fn look_from(self, direction: Vec3, up: Vec3) -> Self {
        let backward = -direction.normalize_or(Vec3::NEG_Z);
        let right = up
            .cross(backward)
            .normalize_or(backward.any_orthonormal_vector());
        let axes = Mat3::from_cols(right, backward.cross(right), backward);
        Self {
            world_from_camera: Quat::from_mat3(&axes).normalize(),
            ..self
        }
    }

    /// Turns about the axis `world_up` by `yaw_rad` (a drag to the right brings the left side to the front) and
    /// tilts by `pitch_rad` (a drag downwards brings the top to the front), as far as the axis.
    #[must_use]
    pub fn turned(self, world_up: Vec3, yaw_rad: f32, pitch_rad: f32) -> Self {
        let up = world_up.normalize_or(Vec3::Y);
        let backward = Quat::from_axis_angle(up, -yaw_rad) * self.backward();
        let height = backward.dot(up).clamp(-1.0, 1.0);
        let flat = (backward - up * height).normalize_or_zero();
        let flat = if flat == Vec3::ZERO {
            // Straight above: what is upwards on the picture points away from the viewer.
            let away = self.up() - up * self.up().dot(up);
            (Quat::from_axis_angle(up, -yaw_rad) * away * -height.signum())
                .normalize_or(up.any_orthonormal_vector())
        } else {
            flat
        };
        let pitch = (height.asin() + pitch_rad).clamp(-STEEPEST_PITCH_RAD, STEEPEST_PITCH_RAD);
        let backward = flat * pitch.cos() + up * pitch.sin();
        self.look_from(-backward, up)
    }

    /// Turns freely, as if a sphere about the target were dragged from one pixel to another.
    ///
    /// Outside the sphere of radius one half of the shorter side, Bell's hyperbola z = r² / (2 √(x² + y²)) continues it smoothly.
    #[must_use]
    pub fn rolled(self, from: Vec2, to: Vec2, size: Vec2) -> Self {
        let radius = (0.5 * size.min_element()).max(1.0);
        let on_ball = |pixel: Vec2| {
            let p = (pixel - 0.5 * size) / radius * Vec2::new(1.0, -1.0);
            let r2 = p.length_squared();
            let z = if r2 < 0.5 {
                (1.0 - r2).sqrt()
            } else {
                0.5 / r2.sqrt()
            };
            p.extend(z).normalize()
        };
        let turn = Quat::from_rotation_arc(on_ball(from), on_ball(to));
        Self {
            world_from_camera: (self.world_from_camera * turn.inverse()).normalize(),
            ..self
        }
    }

    /// Moves the target so that what lies at its depth follows a drag by `drag` pixels.
    #[must_use]
    pub fn panned(self, drag: Vec2, size: Vec2) -> Self {
        let shift = drag * self.length_per_pixel(size.y);
        Self {
            target: self.target - self.right() * shift.x + self.up() * shift.y,
            ..self
        }
    }

    /// Magnifies by `factor` (2 shows things twice as large) while the point under the cursor at the target's depth stays.
    #[must_use]
    pub fn zoomed(self, factor: f32, cursor: Vec2, size: Vec2) -> Self {
        if !(factor.is_finite() && factor > 0.0) {
            return self;
        }
        let fixed = self.on_target_plane(cursor, size);
        let half_height = (self.half_height / factor).clamp(1e-4, 1e7);
        let kept = half_height / self.half_height;
        Self {
            target: fixed + (self.target - fixed) * kept,
            half_height,
            ..self
        }
    }

    /// A camera between two, for short eased moves: `share` 0 is `self`, 1 is `other`.
    #[must_use]
    pub fn towards(self, other: Self, share: f32) -> Self {
        let mix = |a: f32, b: f32| a + (b - a) * share;
        Self {
            target: self.target.lerp(other.target, share),
            world_from_camera: self
                .world_from_camera
                .slerp(other.world_from_camera, share)
                .normalize(),
            half_height: mix(self.half_height.ln(), other.half_height.ln()).exp(),
            field_of_view_rad: mix(self.field_of_view_rad, other.field_of_view_rad),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: Vec2 = Vec2::new(800.0, 500.0);

    fn unit_box() -> Bounds {
        Bounds {
            low: Vec3::new(-3.0, 1.0, 2.0),
            high: Vec3::new(1.0, 9.0, 5.0),
        }
    }

    #[test]
    fn a_fitted_box_is_inside_the_picture_and_touches_its_margin() {
        for field_of_view_rad in [0.0, 0.35, 1.0] {
            let camera = Camera {
                field_of_view_rad,
                ..Camera::default()
            }
            .look_from(Vec3::new(-1.0, -0.4, -0.7), Vec3::Z)
            .fitted(&unit_box(), SIZE.x / SIZE.y);
            let furthest = unit_box()
                .corners()
                .into_iter()
                .map(|corner| {
                    let pixel = camera.project(corner, SIZE).unwrap().pixel;
                    let ndc = (pixel / SIZE * 2.0 - 1.0).abs();
                    ndc.max_element()
                })
                .fold(0.0f32, f32::max);
            assert!((0.85..=1.0).contains(&furthest), "reaches {furthest}");
        }
    }

    #[test]
    fn looking_from_a_direction_keeps_up_upwards() {
        let camera = Camera::default().look_from(Vec3::NEG_X, Vec3::Z);
        assert!((camera.backward() - Vec3::X).length() < 1e-6);
        assert!((camera.up() - Vec3::Z).length() < 1e-6);
        assert!((camera.right() - Vec3::Y).length() < 1e-6);
    }

    #[test]
    fn a_turntable_keeps_its_axis_upright_and_stops_before_the_pole() {
        let mut camera = Camera::default().look_from(Vec3::NEG_X, Vec3::Z);
        for _ in 0..100 {
            camera = camera.turned(Vec3::Z, 0.13, 0.07);
            assert!(camera.right().dot(Vec3::Z).abs() < 1e-4);
            assert!(camera.up().dot(Vec3::Z) > 0.0);
        }
        assert!((camera.backward().dot(Vec3::Z).asin() - STEEPEST_PITCH_RAD).abs() < 2e-3);
    }

    #[test]
    fn a_turntable_leaves_a_view_along_its_axis_without_a_jump() {
        let above = Camera::default().look_from(Vec3::NEG_Z, Vec3::Y);
        let turned = above.turned(Vec3::Z, 0.0, -0.02);
        assert!(turned.up().dot(above.up()) > 0.99);
        let below = Camera::default().look_from(Vec3::Z, Vec3::Y);
        let turned = below.turned(Vec3::Z, 0.0, 0.02);
        assert!(turned.up().dot(below.up()) > 0.99);
    }

    #[test]
    fn a_drag_to_the_right_moves_the_front_of_the_scene_to_the_right() {
        let camera = Camera {
            half_height: 2.0,
            ..Camera::default()
        };
        let front = Vec3::new(0.0, 0.0, 1.0);
        let before = camera.project(front, SIZE).unwrap().pixel;
        let turned = camera
            .turned(Vec3::Y, 0.1, 0.0)
            .project(front, SIZE)
            .unwrap();
        assert!(turned.pixel.x > before.x + 1.0);
        let down = camera
            .turned(Vec3::Y, 0.0, 0.1)
            .project(front, SIZE)
            .unwrap();
        assert!(down.pixel.y > before.y + 1.0);
        let middle = 0.5 * SIZE;
        let rolled = camera.rolled(middle, middle + Vec2::new(25.0, 0.0), SIZE);
        assert!(rolled.project(front, SIZE).unwrap().pixel.x > before.x + 1.0);
    }

    #[test]
    fn rolling_there_and_back_is_no_turn() {
        let camera = Camera::default();
        let (a, b) = (Vec2::new(100.0, 80.0), Vec2::new(420.0, 390.0));
        let back = camera.rolled(a, b, SIZE).rolled(b, a, SIZE);
        assert!(
            back.world_from_camera
                .angle_between(camera.world_from_camera)
                < 1e-3
        );
    }

    #[test]
    fn what_is_under_the_cursor_stays_there_while_zooming_and_follows_a_pan() {
        let camera = Camera {
            half_height: 50.0,
            ..Camera::default()
        }
        .look_from(Vec3::new(0.3, -1.0, 0.2), Vec3::Z);
        let cursor = Vec2::new(600.0, 120.0);
        let point = camera.on_target_plane(cursor, SIZE);
        let zoomed = camera.zoomed(1.7, cursor, SIZE);
        assert!((zoomed.project(point, SIZE).unwrap().pixel - cursor).length() < 0.05);
        let drag = Vec2::new(-31.0, 17.0);
        let panned = camera.panned(drag, SIZE);
        assert!((panned.project(point, SIZE).unwrap().pixel - cursor - drag).length() < 0.05);
    }

    #[test]
    fn a_move_between_cameras_starts_and_ends_at_them() {
        let a = Camera::default();
        let b = a.look_from(Vec3::X, Vec3::Z).zoomed(3.0, Vec2::ZERO, SIZE);
        let (start, end) = (a.towards(b, 0.0), a.towards(b, 1.0));
        assert!((start.half_height - a.half_height).abs() < 1e-5);
        assert!((end.half_height - b.half_height).abs() < 1e-5);
        assert!((end.target - b.target).length() < 1e-4);
        assert!(end.world_from_camera.angle_between(b.world_from_camera) < 1e-3);
    }
}
