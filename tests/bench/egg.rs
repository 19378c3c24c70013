//! The pose that costs are measured on; peers in `tests/bench/peers` bend theirs alike.

use cardiomorph::mesh::{Point3, TriMesh};

/// An egg that narrows and bends with `amount`.
pub fn egg(sphere: &TriMesh, amount: f64) -> Vec<Point3> {
    sphere
        .vertices()
        .iter()
        .map(|p| {
            let narrow = 1.0 - 0.3 * amount * (1.0 - p.z * p.z);
            Point3::new(
                narrow * p.x + 0.1 * amount * (2.0 * p.z).sin(),
                narrow * p.y,
                1.6 * p.z,
            )
        })
        .collect()
}
