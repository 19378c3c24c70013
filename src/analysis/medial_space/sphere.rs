//! Directions as points of the unit sphere: exponential and logarithm at any base point, geodesics, angles.

use std::f64::consts::PI;

use crate::mesh::Vector3;

/// Sine of the angle below which two opposite directions count as antipodes: what round-off leaves
/// of the product of two unit vectors.
const ANTIPODE_SINE: f64 = 4.0 * f64::EPSILON;

/// A logarithm on the sphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Log {
    /// Tangent at the base point; its length is the angle to the other point, in radians.
    pub tangent: Vector3,
    /// Whether the point lies opposite to the base: every direction then leads there, and one that
    /// is always the same was taken.
    pub antipodal: bool,
}

/// A logarithm at the pole (0, 0, 1), in the plane of x and y.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PoleLog {
    /// Tangent; its length is the angle to the pole, in radians.
    pub tangent: [f64; 2],
    /// As in [`Log`]; the direction taken is x.
    pub antipodal: bool,
}

/// Angle between two directions in radians, 0..=π: atan2(|a × b|, a · b).
///
/// Exact to round-off at every angle, where arccos(a · b) loses half the digits near 0 and π.
/// Lengths do not matter; without one direction the angle is 0.
pub fn angle(a: &Vector3, b: &Vector3) -> f64 {
    a.cross(b).norm().atan2(a.dot(b))
}

/// Point at the end of the geodesic that leaves `base` with `tangent`:
/// Exp_p(v) = cos|v| p + (sin|v| / |v|) v, for unit p and v ⊥ p. Longer tangents than π go on around.
pub fn exp(base: &Vector3, tangent: &Vector3) -> Vector3 {
    let length = tangent.norm();
    base * length.cos() + tangent * sin_over(length)
}

/// Tangent at the unit vector `base` of the shortest geodesic to the unit vector `point`, in
/// ambient coordinates; the inverse of [`exp`] for tangents shorter than π.
pub fn log(base: &Vector3, point: &Vector3) -> Log {
    let across = base.cross(point);
    let (sine, cosine) = (across.norm(), base.dot(point));
    if sine <= ANTIPODE_SINE && cosine < 0.0 {
        return Log {
            tangent: square_to(base) * PI,
            antipodal: true,
        };
    }
    // (p × q) × p is q without its part along p, and keeps its digits where q is near ±p.
    let direction = across.cross(base);
    Log {
        tangent: direction * over_sin(sine, cosine),
        antipodal: false,
    }
}

/// Equation 4.1: Exp_p(v) = (v₁ sin‖v‖/‖v‖, v₂ sin‖v‖/‖v‖, cos‖v‖) at the pole p = (0, 0, 1).
pub fn exp_pole([v1, v2]: [f64; 2]) -> Vector3 {
    let length = v1.hypot(v2);
    let share = sin_over(length);
    Vector3::new(v1 * share, v2 * share, length.cos())
}

/// Equation 4.2: Log_p(x) = (x₁ θ/sin θ, x₂ θ/sin θ) at the pole p = (0, 0, 1).
///
/// θ = atan2(√(x₁² + x₂²), x₃) in the place of the printed arccos(x₃), which loses half the digits
/// near 0 and π.
pub fn log_pole(point: &Vector3) -> PoleLog {
    let sine = point.x.hypot(point.y);
    if sine <= ANTIPODE_SINE && point.z < 0.0 {
        return PoleLog {
            tangent: [PI, 0.0],
            antipodal: true,
        };
    }
    let share = over_sin(sine, point.z);
    PoleLog {
        tangent: [point.x * share, point.y * share],
        antipodal: false,
    }
}

/// Point at the share `t` of the shortest geodesic from `a` (t = 0) to `b` (t = 1).
pub fn between(a: &Vector3, b: &Vector3, t: f64) -> Vector3 {
    exp(a, &(log(a, b).tangent * t))
}

/// The direction, or `None` where the length is 0 or not a number.
pub(super) fn unit(vector: &Vector3) -> Option<Vector3> {
    vector.try_normalize(0.0)
}

/// sin x / x, 1 at 0.
fn sin_over(x: f64) -> f64 {
    // The limit at 0; for any other x, however small, the quotient is exact to round-off.
    if x == 0.0 { 1.0 } else { x.sin() / x }
}

/// θ / sin θ of the angle with these, 1 at 0.
fn over_sin(sine: f64, cosine: f64) -> f64 {
    if sine == 0.0 {
        1.0
    } else {
        // The arctangent keeps its digits where the arccosine is flat.
        sine.atan2(cosine) / sine
    }
}

/// A unit vector at right angles: the axis that lies least along `base`, without its part along it.
fn square_to(base: &Vector3) -> Vector3 {
    // The axis farthest from parallel: the part along the base takes the fewest digits away.
    let least = (0..3)
        .min_by(|&i, &j| base[i].abs().total_cmp(&base[j].abs()))
        .unwrap_or(0);
    let axis = Vector3::ith(least, 1.0);
    (axis - base * base.dot(&axis)).normalize()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn direction() -> impl Strategy<Value = Vector3> {
        proptest::array::uniform3(-1.0..1.0_f64)
            .prop_map(|[x, y, z]| Vector3::new(x, y, z))
            .prop_filter("a direction", |v| v.norm() > 1e-3)
            .prop_map(|v| v.normalize())
    }

    proptest! {
        #[test]
        fn the_logarithm_undoes_the_exponential(p in direction(), q in direction()) {
            let there = log(&p, &q);
            prop_assert!(there.tangent.dot(&p).abs() < 1e-14);
            prop_assert!((there.tangent.norm() - angle(&p, &q)).abs() < 1e-13);
            prop_assert!((exp(&p, &there.tangent) - q).norm() < 1e-14);
        }

        #[test]
        fn turning_the_sphere_turns_its_geodesics(
            p in direction(), q in direction(), turn in proptest::array::uniform3(-3.0..3.0_f64),
        ) {
            let turn = nalgebra::Rotation3::from_scaled_axis(Vector3::from(turn));
            let turned = log(&(turn * p), &(turn * q)).tangent;
            prop_assume!(angle(&p, &q) < 3.1);
            prop_assert!((turned - turn * log(&p, &q).tangent).norm() < 1e-12);
        }

        #[test]
        fn at_the_pole_the_general_forms_are_the_printed_ones(q in direction()) {
            let printed = log_pole(&q).tangent;
            let general = log(&Vector3::z(), &q).tangent;
            prop_assert!((general - Vector3::new(printed[0], printed[1], 0.0)).norm() < 1e-13);
            prop_assert!((exp_pole(printed) - q).norm() < 1e-14);
        }
    }

    #[test]
    fn tiny_angles_keep_their_digits() {
        let p = Vector3::new(0.6, 0.0, 0.8);
        let step = Vector3::new(0.8e-9, 1e-9, -0.6e-9);
        let back = log(&p, &exp(&p, &step)).tangent;
        assert!((back - step).norm() < 1e-16 + 1e-7 * step.norm());
        assert_eq!(log(&p, &p).tangent.norm(), 0.0);
    }

    #[test]
    fn the_antipode_is_flagged_and_half_a_turn_away() {
        for base in [Vector3::z(), Vector3::new(0.6, -0.48, 0.64)] {
            let opposite = log(&base, &-base);
            assert!(opposite.antipodal);
            assert!((opposite.tangent.norm() - PI).abs() < 1e-15);
            assert!(opposite.tangent.dot(&base).abs() < 1e-15);
            assert!((exp(&base, &opposite.tangent) + base).norm() < 1e-15);
        }
        let pole = log_pole(&-Vector3::z());
        assert!(pole.antipodal);
        assert_eq!(pole.tangent, [PI, 0.0]);
    }
}
