//! The signed volume of a surface whose openings are closed by fans.

use crate::mesh::{Point3, Vector3};

/// Volume enclosed by triangles, with every boundary loop closed by a fan around its centroid, in
/// cubic coordinates: V = Σ (a − o) · ((b − o) × (c − o)) / 6 with o a vertex, which keeps rounding small.
///
/// Positive where faces wind so that normals point out. `loops` are those of
/// [`crate::mesh::Faces::boundary_loops`]. Meaningless for inconsistent winding.
pub fn enclosed_volume(vertices: &[Point3], triangles: &[[u32; 3]], loops: &[Vec<u32>]) -> f64 {
    let Some(origin) = vertices.first() else {
        return 0.0;
    };
    let arm = |vertex: u32| vertices[vertex as usize] - origin;
    let mut sixfold: f64 = triangles
        .iter()
        .map(|&[a, b, c]| arm(a).dot(&arm(b).cross(&arm(c))))
        .sum();
    for ring in loops.iter().filter(|ring| !ring.is_empty()) {
        let centre: Vector3 = ring.iter().map(|&v| arm(v)).sum::<Vector3>() / ring.len() as f64;
        for (place, &from) in ring.iter().enumerate() {
            let to = ring[(place + 1) % ring.len()];
            // The cap's sides run against the boundary's, as in any neighbouring face.
            sixfold += arm(to).dot(&arm(from).cross(&centre));
        }
    }
    sixfold / 6.0
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Faces, phantom};
    use std::f64::consts::PI;

    #[test]
    fn a_bowl_encloses_half_a_ball_with_second_order_error() {
        let error = |steps: u32| {
            let bowl = phantom::bowl(2.0, steps, 4 * steps);
            let loops = bowl.faces().boundary_loops();
            let volume = enclosed_volume(bowl.vertices(), bowl.triangles(), &loops);
            (volume - 2.0 / 3.0 * PI * 8.0).abs()
        };
        let order = (error(8) / error(16)).log2();
        assert!((order - 2.0).abs() < 0.1, "order {order}");
    }

    #[test]
    fn turning_the_faces_round_turns_the_sign() {
        let ball = phantom::sphere(2, 1.0);
        let turned: Vec<[u32; 3]> = ball
            .triangles()
            .iter()
            .map(|&[a, b, c]| [a, c, b])
            .collect();
        let faces = Faces::new(ball.vertices().len(), turned).unwrap();
        let out = enclosed_volume(ball.vertices(), ball.triangles(), &[]);
        let inwards = enclosed_volume(ball.vertices(), faces.triangles(), &[]);
        assert!(out > 3.9 && (out + inwards).abs() < 1e-12);
    }
}
