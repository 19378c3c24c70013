//! The curvature that the quasi-conformal metric compares, and its rate along a field: Gaussian curvature as
//! a density of angle deficits (`mesh/angle_deficit.rs`), relative to the size of the surface.

use std::f64::consts::PI;

use crate::mesh::{Point3, Vector3, angle_deficits_rad};
use crate::numeric::Arithmetic;

use super::connectivity::Connectivity;
use super::corner::{cotangents, density, face_shape};

/// Surface of a sphere of radius 1, which the density is measured against.
const UNIT_SPHERE: f64 = 4.0 * PI;

/// Numerator, denominator and value of the averaged density, kept for its rate.
struct Density {
    /// Gathered angle deficits and areas around the vertices.
    gathered: Vec<[f64; 2]>,
    total_area: f64,
}

impl Density {
    fn new(mesh: &Connectivity, points: &[Point3], areas: &Areas, rings: u32) -> Self {
        let deficits = angle_deficits_rad(points, &mesh.triangles, &mesh.flat_rad);
        Self {
            gathered: gathered_inside(mesh, &deficits, &areas.of_vertices, rings),
            total_area: areas.total,
        }
    }

    fn at(&self, vertex: usize) -> f64 {
        let [turn, area] = self.gathered[vertex];
        density(turn, area, self.total_area)
    }
}

/// Areas of faces and a third of them around each vertex, in squared units of the coordinates.
pub(super) struct Areas {
    pub of_faces: Vec<f64>,
    pub of_vertices: Vec<f64>,
    pub total: f64,
}

impl Areas {
    pub fn new(mesh: &Connectivity, points: &[Point3]) -> Self {
        let mut of_vertices = vec![0.0; mesh.vertex_count];
        let mut of_faces = Vec::with_capacity(mesh.triangles.len());
        for triangle in &mesh.triangles {
            let [a, b, c] = triangle.map(|index| points[index as usize]);
            let area = 0.5 * (b - a).cross(&(c - a)).norm();
            of_faces.push(area);
            for &corner in triangle {
                // Barycentric shares: never negative, unlike those of Voronoi cells with obtuse corners.
                of_vertices[corner as usize] += area / 3.0;
            }
        }
        Self {
            total: of_faces.iter().sum(),
            of_faces,
            of_vertices,
        }
    }
}

/// Gaussian curvature at each vertex relative to a sphere of the same area, averaged: with K the
/// angle deficits and a the vertex areas, Σ K / Σ a · A / 4π over the neighbourhood.
///
/// Equal to 1 on a sphere of any size. The boundary, where K is the turning of the rim and no
/// curvature of the surface, takes no part; it receives the value of its neighbourhood. 0 where the
/// neighbourhood has no area.
pub(super) fn curvature_density(
    mesh: &Connectivity,
    points: &[Point3],
    areas: &Areas,
    rings: u32,
) -> Vec<f64> {
    let density = Density::new(mesh, points, areas, rings);
    (0..mesh.vertex_count).map(|v| density.at(v)).collect()
}

/// Rate of the angle deficits along a field X: dK_p = −Σ dθ_p over the corners at p.
///
/// With e₀, e₁, e₂ = ab, bc, ca and s the rates of relative length, the angle at a changes by
/// dθ_a = cot c (s₁ − s₂) + cot b (s₁ − s₀); the derivative of the law of cosines.
pub(super) fn deficit_rates(mesh: &Connectivity, points: &[Point3], field: &[Vector3]) -> Vec<f64> {
    let mut rates = vec![0.0; mesh.vertex_count];
    for triangle in &mesh.triangles {
        let (cotangents, side) = (
            face_cotangents(points, triangle),
            sides(points, field, triangle),
        );
        let s = side.map(|(rate, length2)| rate.over(length2));
        for corner in 0..3 {
            let [first, across, last] = [corner, corner + 1, corner + 2].map(|e| s[e % 3]);
            let [next, before] = [corner + 1, corner + 2].map(|c| cotangents[c % 3]);
            rates[triangle[corner] as usize] -= before * (across - last) + next * (across - first);
        }
    }
    rates
}

/// Rate of [`curvature_density`] along a field.
pub(super) fn density_rates(
    mesh: &Connectivity,
    points: &[Point3],
    field: &[Vector3],
    rings: u32,
) -> Vec<f64> {
    let density = Density::new(mesh, points, &Areas::new(mesh, points), rings);
    let turn = deficit_rates(mesh, points, field);
    let mut area = vec![0.0; mesh.vertex_count];
    let mut total = 0.0;
    for triangle in &mesh.triangles {
        let (cotangents, side) = (
            face_cotangents(points, triangle),
            sides(points, field, triangle),
        );
        // A = ¼ Σ cot · length², and the corner opposite side e is e + 2.
        let rate: f64 = (0..3)
            .map(|e| 0.5 * cotangents[(e + 2) % 3] * side[e].0)
            .sum();
        total += rate;
        for &corner in triangle {
            area[corner as usize] += rate / 3.0;
        }
    }
    let rates = gathered_inside(mesh, &turn, &area, rings);
    (density.gathered.iter().zip(rates))
        .map(|(&[turn, area], [turn_rate, area_rate])| {
            // The quotient rule for T / a · A with all three changing.
            let mean = turn.over(area);
            let local = (turn_rate - mean * area_rate).over(area);
            (local * density.total_area + mean * total) / UNIT_SPHERE
        })
        .collect()
}

/// ⟨X_p − X_q, p − q⟩ and |p − q|² for the sides ab, bc, ca.
fn sides(points: &[Point3], field: &[Vector3], triangle: &[u32; 3]) -> [(f64, f64); 3] {
    [0, 1, 2].map(|e| {
        let (p, q) = (triangle[e] as usize, triangle[(e + 1) % 3] as usize);
        let side = points[p] - points[q];
        ((field[p] - field[q]).dot(&side), side.norm_squared())
    })
}

/// Cotangents of the angles at a, b, c; zero in a face of zero area.
fn face_cotangents(points: &[Point3], triangle: &[u32; 3]) -> [f64; 3] {
    let [a, b, c] = triangle.map(|index| points[index as usize].coords.into());
    cotangents(face_shape(a, b, c))
}

/// Deficits and areas of the vertices inside, gathered.
fn gathered_inside(
    mesh: &Connectivity,
    deficits: &[f64],
    areas: &[f64],
    rings: u32,
) -> Vec<[f64; 2]> {
    let mut values: Vec<[f64; 2]> = (deficits.iter().zip(areas).zip(&mesh.inside))
        // At the rim the turn depends on where the surface was cut, so it gives nothing to the mean.
        .map(|((&turn, &area), &inside)| if inside { [turn, area] } else { [0.0; 2] })
        .collect();
    let mut spare = values.clone();
    mesh.gather(&mut values, &mut spare, 1, rings);
    values
}
