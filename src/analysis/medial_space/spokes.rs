//! Spokes of a medial surface on which the radius is known as a function.

use crate::mesh::Vector3;

/// Unit spokes [S₀, S₁] of an atom with unit normal N (from the inner to the outer side) and the
/// gradient of r along the surface: S = −∇r ∓ √(1 − |∇r|²) N.
///
/// The wall is the envelope of the spheres of the atoms; y = x + r S is where it touches each.
/// `None` where |∇r| ≥ 1: the spheres then lie in one another and have no envelope.
///
/// Follows from (x + r S)_u · S = 0 along every direction u of the surface: x_u · S = −r_u.
pub fn spokes_from_gradient(normal: &Vector3, gradient: &Vector3) -> Option<[Vector3; 2]> {
    let along = 1.0 - gradient.norm_squared();
    // Where r grows as fast as one walks, one sphere swallows the next.
    if along.is_nan() || along <= 0.0 {
        return None;
    }
    let across = normal * along.sqrt();
    Some([-gradient - across, across - gradient])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spokes_are_unit_and_mirror_each_other_in_the_surface() {
        let gradient = Vector3::new(0.3, -0.2, 0.0);
        let [inner, outer] = spokes_from_gradient(&Vector3::z(), &gradient).unwrap();
        assert!((inner.norm() - 1.0).abs() < 1e-15 && (outer.norm() - 1.0).abs() < 1e-15);
        assert_eq!([inner.x, inner.y, -inner.z], [outer.x, outer.y, outer.z]);
        assert!(outer.z > 0.0);
    }

    #[test]
    fn a_radius_that_grows_faster_than_the_way_has_no_wall() {
        assert_eq!(spokes_from_gradient(&Vector3::z(), &Vector3::x()), None);
    }
}
