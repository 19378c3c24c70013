//! The curvature that the quasi-conformal metric compares, and its rate along a field.

use std::f64::consts::PI;

use crate::mesh::{Point3, Vector3, angle_deficits_rad};

use super::connectivity::Connectivity;

/// Surface of a sphere of radius 1, which the density is measured against.
const UNIT_SPHERE: f64 = 4.0 * PI;

/// Numerator, denominator and value of the averaged density, kept for its rate.
struct Density {
    /// Gathered angle deficits.
    turn: Vec<f64>,
    /// Gathered areas around the vertices.
    area: Vec<f64>,
    total_area: f64,
}

impl Density {
    fn new(mesh: &Connectivity, points: &[Point3], areas: &Areas, rings: u32) -> Self {
        let deficits = angle_deficits_rad(points, &mesh.triangles, &mesh.flat_rad);
        Self {
            turn: mesh.gathered(&kept_inside(mesh, &deficits), rings),
            area: mesh.gathered(&kept_inside(mesh, &areas.of_vertices), rings),
            total_area: areas.total,
        }
    }

    fn at(&self, vertex: usize) -> f64 {
        over(self.turn[vertex], self.area[vertex]) * self.total_area / UNIT_SPHERE
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
        let (cotangents, side) = (cotangents(points, triangle), sides(points, field, triangle));
        let s = side.map(|(rate, length2)| over(rate, length2));
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
    let turn = kept_inside(mesh, &deficit_rates(mesh, points, field));
    let mut area = vec![0.0; mesh.vertex_count];
    let mut total = 0.0;
    for triangle in &mesh.triangles {
        let (cotangents, side) = (cotangents(points, triangle), sides(points, field, triangle));
        // A = ¼ Σ cot · length², and the corner opposite side e is e + 2.
        let rate: f64 = (0..3)
            .map(|e| 0.5 * cotangents[(e + 2) % 3] * side[e].0)
            .sum();
        total += rate;
        for &corner in triangle {
            area[corner as usize] += rate / 3.0;
        }
    }
    let turn = mesh.gathered(&turn, rings);
    let area = mesh.gathered(&kept_inside(mesh, &area), rings);
    (0..mesh.vertex_count)
        .map(|v| {
            let mean = over(density.turn[v], density.area[v]);
            let local = over(turn[v] - mean * area[v], density.area[v]);
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

/// Cotangents of the angles at a, b, c; zero in a face without area.
fn cotangents(points: &[Point3], triangle: &[u32; 3]) -> [f64; 3] {
    let corner = triangle.map(|index| points[index as usize]);
    let doubled_area = (corner[1] - corner[0])
        .cross(&(corner[2] - corner[0]))
        .norm();
    [0, 1, 2].map(|c| {
        let (u, v) = (
            corner[(c + 1) % 3] - corner[c],
            corner[(c + 2) % 3] - corner[c],
        );
        over(u.dot(&v), doubled_area)
    })
}

fn kept_inside(mesh: &Connectivity, values: &[f64]) -> Vec<f64> {
    (values.iter().zip(&mesh.inside))
        .map(|(&value, &inside)| if inside { value } else { 0.0 })
        .collect()
}

fn over(numerator: f64, denominator: f64) -> f64 {
    if denominator > 0.0 {
        numerator / denominator
    } else {
        0.0
    }
}
