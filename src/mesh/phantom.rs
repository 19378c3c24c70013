//! Surfaces whose measures are known in closed form, for tests and for experiments.

use std::collections::HashMap;
use std::f64::consts::{FRAC_PI_2, TAU};

use super::{Faces, Point3, TriMesh, Vector3};

/// A sphere around the origin: an icosahedron subdivided `subdivisions` times, every vertex at
/// distance `radius`; 10·4ⁿ + 2 vertices, normals outwards.
pub fn sphere(subdivisions: u32, radius: f64) -> TriMesh {
    let (mut points, mut triangles) = icosahedron();
    for _ in 0..subdivisions {
        let mut middles: HashMap<[u32; 2], u32> = HashMap::new();
        let mut finer = Vec::with_capacity(4 * triangles.len());
        for [a, b, c] in triangles {
            let mut middle = |i: u32, j: u32| {
                *middles.entry([i.min(j), i.max(j)]).or_insert_with(|| {
                    points.push((points[i as usize] + points[j as usize]).normalize());
                    points.len() as u32 - 1
                })
            };
            let (ab, bc, ca) = (middle(a, b), middle(b, c), middle(c, a));
            finer.extend([[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]);
        }
        triangles = finer;
    }
    let points: Vec<Point3> = points.iter().map(|p| Point3::from(p * radius)).collect();
    built(points, triangles)
}

/// A torus around the z axis with tube radius `minor`: `around` × `across` vertices, normals
/// outwards.
pub fn torus(major: f64, minor: f64, around: u32, across: u32) -> TriMesh {
    let mut points = Vec::new();
    for i in 0..around {
        let (sin_u, cos_u) = (TAU * f64::from(i) / f64::from(around)).sin_cos();
        for j in 0..across {
            let (sin_v, cos_v) = (TAU * f64::from(j) / f64::from(across)).sin_cos();
            let ring = major + minor * cos_v;
            points.push(Point3::new(ring * cos_u, ring * sin_u, minor * sin_v));
        }
    }
    let at = |i: u32, j: u32| (i % around) * across + j % across;
    let triangles = (0..around)
        .flat_map(|i| (0..across).map(move |j| (i, j)))
        .flat_map(|(i, j)| {
            let [a, b] = [at(i, j), at(i + 1, j)];
            let [c, d] = [at(i + 1, j + 1), at(i, j + 1)];
            [[a, b, c], [a, c, d]]
        })
        .collect();
    built(points, triangles)
}

/// The lower half of a sphere, open at z = 0, with its pole at (0, 0, −radius): `rings` rings of
/// `around` vertices and the pole, normals outwards.
pub fn bowl(radius: f64, rings: u32, around: u32) -> TriMesh {
    let mut points = vec![Point3::new(0.0, 0.0, -radius)];
    for ring in 1..=rings {
        let (sin_polar, cos_polar) = (FRAC_PI_2 * f64::from(ring) / f64::from(rings)).sin_cos();
        for step in 0..around {
            let (sin, cos) = (TAU * f64::from(step) / f64::from(around)).sin_cos();
            points.push(Point3::new(
                radius * sin_polar * cos,
                radius * sin_polar * sin,
                -radius * cos_polar,
            ));
        }
    }
    let at = |ring: u32, step: u32| 1 + (ring - 1) * around + step % around;
    let mut triangles: Vec<[u32; 3]> = (0..around)
        .map(|step| [0, at(1, step + 1), at(1, step)])
        .collect();
    for ring in 1..rings {
        for step in 0..around {
            let [a, b] = [at(ring, step), at(ring, step + 1)];
            let [c, d] = [at(ring + 1, step + 1), at(ring + 1, step)];
            triangles.extend([[a, b, c], [a, c, d]]);
        }
    }
    built(points, triangles)
}

fn icosahedron() -> (Vec<Vector3>, Vec<[u32; 3]>) {
    let golden = (1.0 + 5.0_f64.sqrt()) / 2.0;
    let mut points = Vec::with_capacity(12);
    for (one, long) in [
        (-1.0, golden),
        (1.0, golden),
        (-1.0, -golden),
        (1.0, -golden),
    ] {
        points.push(Vector3::new(one, long, 0.0).normalize());
    }
    for (one, long) in [
        (-1.0, golden),
        (1.0, golden),
        (-1.0, -golden),
        (1.0, -golden),
    ] {
        points.push(Vector3::new(0.0, one, long).normalize());
    }
    for (long, one) in [
        (golden, -1.0),
        (golden, 1.0),
        (-golden, -1.0),
        (-golden, 1.0),
    ] {
        points.push(Vector3::new(long, 0.0, one).normalize());
    }
    let triangles = vec![
        [0, 11, 5],
        [0, 5, 1],
        [0, 1, 7],
        [0, 7, 10],
        [0, 10, 11],
        [1, 5, 9],
        [5, 11, 4],
        [11, 10, 2],
        [10, 7, 6],
        [7, 1, 8],
        [3, 9, 4],
        [3, 4, 2],
        [3, 2, 6],
        [3, 6, 8],
        [3, 8, 9],
        [4, 9, 5],
        [2, 4, 11],
        [6, 2, 10],
        [8, 6, 7],
        [9, 8, 1],
    ];
    (points, triangles)
}

/// Phantoms are right by construction; a wrong one is a bug that its tests show.
fn built(points: Vec<Point3>, triangles: Vec<[u32; 3]>) -> TriMesh {
    #[expect(
        clippy::expect_used,
        reason = "indices and coordinates are computed above"
    )]
    Faces::new(points.len(), triangles)
        .and_then(|faces| TriMesh::new(points, faces))
        .expect("a phantom is a mesh")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn euler(mesh: &TriMesh) -> i64 {
        mesh.vertices().len() as i64 - mesh.faces().edges().len() as i64
            + mesh.triangles().len() as i64
    }

    #[test]
    fn phantoms_have_the_euler_number_of_their_kind() {
        assert_eq!(euler(&sphere(3, 1.0)), 2);
        assert_eq!(euler(&torus(2.0, 0.5, 20, 10)), 0);
        assert_eq!(euler(&bowl(1.0, 4, 12)), 1);
    }

    #[test]
    fn a_sphere_of_level_four_has_2562_vertices_at_its_radius() {
        let ball = sphere(4, 3.0);
        assert_eq!(ball.vertices().len(), 2562);
        for point in ball.vertices() {
            assert!((point.coords.norm() - 3.0).abs() < 1e-12);
        }
    }
}
