//! Angles at the corners of triangles and what they lack of a full turn: curvature gathered at a vertex, which the
//! quasi-conformal metric makes a density of (`analysis/metrics/compared_curvature.rs`).

use std::f64::consts::{PI, TAU};

use super::{Faces, Point3};

/// Angle at each corner of each face, in the order of its corners; 0 where two sides have no
/// length.
///
/// atan2(|u × v|, u·v + 0), where adding zero turns −0, which would count as half a turn, into 0; exact to round-off for flat and for needle-like triangles alike.
pub fn corner_angles_rad(vertices: &[Point3], triangles: &[[u32; 3]]) -> Vec<[f64; 3]> {
    triangles
        .iter()
        .map(|triangle| {
            let [a, b, c] = triangle.map(|index| vertices[index as usize]);
            let (ab, bc, ca) = (b - a, c - b, a - c);
            let doubled_area = ab.cross(&bc).norm();
            [-ab.dot(&ca), -ab.dot(&bc), -bc.dot(&ca)]
                .map(|cosine| doubled_area.atan2(cosine + 0.0))
        })
        .collect()
}

/// Angles that add up to flat at each vertex: 2π inside, π on the boundary, 0 at a vertex of no face.
pub fn flat_angles_rad(faces: &Faces) -> Vec<f64> {
    let mut flat = vec![0.0; faces.vertex_count()];
    for &corner in faces.triangles().iter().flatten() {
        flat[corner as usize] = TAU;
    }
    for (angle, boundary) in flat.iter_mut().zip(faces.boundary_vertices()) {
        if boundary {
            *angle = PI;
        }
    }
    flat
}

/// Angle deficit K of each vertex: `flat` (see [`flat_angles_rad`]) minus the angles of its corners.
///
/// Inside, K is the integral of Gaussian curvature over the surroundings of the vertex; on the
/// boundary, that of geodesic curvature. By Gauss and Bonnet Σ K = 2π χ for a manifold mesh.
///
/// Source: V. Taimouri, *Shape Analysis in Shape Space*, section 3.2.2.
pub fn angle_deficits_rad(
    vertices: &[Point3],
    triangles: &[[u32; 3]],
    flat_rad: &[f64],
) -> Vec<f64> {
    let mut deficits = flat_rad.to_vec();
    for (triangle, angles) in triangles.iter().zip(corner_angles_rad(vertices, triangles)) {
        for (&corner, angle) in triangle.iter().zip(angles) {
            deficits[corner as usize] -= angle;
        }
    }
    deficits
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{TriMesh, phantom};

    fn deficits(mesh: &TriMesh) -> Vec<f64> {
        angle_deficits_rad(
            mesh.vertices(),
            mesh.triangles(),
            &flat_angles_rad(mesh.faces()),
        )
    }

    #[test]
    fn total_curvature_is_two_pi_times_the_euler_number() {
        for (mesh, euler) in [
            (phantom::sphere(3, 2.0), 2.0),
            (phantom::torus(2.0, 0.5, 20, 10), 0.0),
            (phantom::bowl(1.0, 6, 14), 1.0),
        ] {
            let total: f64 = deficits(&mesh).iter().sum();
            assert!((total - TAU * euler).abs() < 1e-10, "{total}");
        }
    }

    #[test]
    fn a_corner_of_a_right_triangle_is_a_quarter_turn() {
        let points = [
            Point3::origin(),
            Point3::new(2.0, 0.0, 0.0),
            Point3::new(0.0, 1.0, 0.0),
        ];
        let [angles] = corner_angles_rad(&points, &[[0, 1, 2]])[..] else {
            panic!("one face has one triple of angles");
        };
        assert!((angles[0] - PI / 2.0).abs() < 1e-15);
        assert!((angles.iter().sum::<f64>() - PI).abs() < 1e-15);
    }

    #[test]
    fn coincident_corners_have_no_angle_and_no_nan() {
        let points = vec![Point3::new(1.0, 2.0, 3.0); 3];
        assert_eq!(corner_angles_rad(&points, &[[0, 1, 2]]), [[0.0; 3]]);
    }

    #[test]
    fn a_vertex_of_no_face_is_flat() {
        let faces = Faces::new(4, vec![[0, 1, 2]]).unwrap();
        assert_eq!(flat_angles_rad(&faces)[3], 0.0);
    }
}
