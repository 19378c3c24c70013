//! Poses without what is finer than a stated radius, since strain of noise drowns that of motion.

use std::collections::HashMap;

use crate::mesh::{Faces, Point3};
use crate::numeric::{SparseCholesky, SparseCholeskyError};

/// A smoother of poses of one connectivity: factorises once, answers for every pose.
///
/// The pose S that minimises Σᵢ |sᵢ − pᵢ|² + τ² Σᵢ |(L s)ᵢ|² for a pose P, with (L s)ᵢ = Σⱼ (sᵢ − sⱼ)
/// over neighbours along edges and τ = ρ² n / √3: the smoothing spline of the graph of edges.
///
/// On a mesh of n equal triangles L is −√3 (A/n) ∇², A the area, so that what has wave number k
/// passes by 1 / (1 + (ρ √A k)⁴), whatever the fineness of the mesh: ρ is a radius over √A.
/// Noise that is independent from vertex to vertex is divided by some (8 π ρ² n)½ in amplitude.
///
/// It is linear, symmetric, and made of the faces alone: so it commutes with rigid motions, scales and
/// renumbering, keeps the mean of the vertices, and is the same for every pose that corresponds.
/// Weights that follow the geometry, such as cotangents, would be noise where the geometry is.
///
/// Source: Green and Silverman, *Nonparametric Regression and Generalized Linear Models*, section 2.3,
/// with L in the place of the second derivative.
#[derive(Clone, Debug)]
pub struct Smoother {
    /// `None` leaves poses as they are.
    factors: Option<SparseCholesky>,
    vertex_count: usize,
}

impl Smoother {
    /// A smoother of radius `radius` · √area for poses of these faces; 0 leaves poses as they are.
    ///
    /// # Errors
    /// If the radius is so large that the matrix is numerically singular.
    pub fn new(faces: &Faces, radius: f64) -> Result<Self, SparseCholeskyError> {
        let vertex_count = faces.vertex_count();
        let factors = if radius > 0.0 {
            // The Laplacian of the graph is about 1.5 edge² times that of the surface, and n vertices of equal
            // triangles have edge² = 2 A / (√3 n).
            let tau = radius * radius * vertex_count as f64 / 3.0_f64.sqrt();
            Some(SparseCholesky::new(vertex_count, &penalised(faces, tau))?)
        } else {
            None
        };
        Ok(Self {
            factors,
            vertex_count,
        })
    }

    /// The pose without what is finer; a pose with another number of vertices as it is.
    pub fn smoothed(&self, points: &[Point3]) -> Vec<Point3> {
        let n = self.vertex_count;
        let Some(factors) = self.factors.as_ref().filter(|_| points.len() == n) else {
            return points.to_vec();
        };
        // Around the mean, so that far from the origin no digits are lost.
        let mean = points
            .iter()
            .map(|p| p.coords / n as f64)
            .sum::<crate::mesh::Vector3>();
        let mut columns: Vec<f64> = (0..3)
            .flat_map(|axis| points.iter().map(move |p| p[axis] - mean[axis]))
            .collect();
        factors.solve(&mut columns);
        (0..n)
            .map(|v| Point3::new(columns[v], columns[n + v], columns[2 * n + v]) + mean)
            .collect()
    }
}

/// Lower triangle of 1 + τ² L², entries that stand twice adding up; in a fixed order.
fn penalised(faces: &Faces, tau: f64) -> Vec<(usize, usize, f64)> {
    let n = faces.vertex_count();
    let mut neighbours: Vec<Vec<usize>> = vec![Vec::new(); n];
    for [a, b] in faces.edges() {
        neighbours[a as usize].push(b as usize);
        neighbours[b as usize].push(a as usize);
    }
    let mut entries = Vec::new();
    // A row of the squared Laplacian reaches two edges far: few entries, found by column.
    let mut row: HashMap<usize, f64> = HashMap::new();
    for i in 0..n {
        row.clear();
        row.insert(i, 1.0);
        let of = |v: usize| {
            let own = [(v, neighbours[v].len() as f64)];
            own.into_iter()
                .chain(neighbours[v].iter().map(|&j| (j, -1.0)))
        };
        for (k, left) in of(i) {
            for (j, right) in of(k) {
                *row.entry(j).or_insert(0.0) += tau * tau * left * right;
            }
        }
        let mut lower: Vec<(usize, usize, f64)> = (row.iter())
            // Symmetric: the factorisation reads the lower triangle.
            .filter(|(column, _)| **column <= i)
            .map(|(&column, &value)| (i, column, value))
            .collect();
        // A hash map has no order, and sums must have the same bits on every run.
        lower.sort_unstable_by_key(|&(_, column, _)| column);
        entries.extend(lower);
    }
    entries
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Vector3, phantom};
    use nalgebra::Rotation3;

    /// Y₂₀ of a sphere in its radius, which has wave number √6.
    fn waved(subdivisions: u32) -> (crate::mesh::TriMesh, Vec<Point3>) {
        let ball = phantom::sphere(subdivisions, 1.0);
        let points = (ball.vertices().iter())
            .map(|p| Point3::new(1.5 * p.z * p.z - 0.5, 0.0, 0.0))
            .collect();
        (ball, points)
    }

    #[test]
    fn a_wave_passes_by_the_share_that_its_length_says_at_any_fineness() {
        let area = 4.0 * std::f64::consts::PI;
        let radius = 0.12;
        let expected = 1.0 / (1.0 + (radius * radius * area * 6.0).powi(2));
        for (subdivisions, tolerance) in [(2, 0.04), (3, 0.02), (4, 0.02)] {
            let (ball, wave) = waved(subdivisions);
            let smoother = Smoother::new(ball.faces(), radius).unwrap();
            let found = smoother.smoothed(&wave);
            let product: f64 = found.iter().zip(&wave).map(|(a, b)| a.x * b.x).sum();
            let share = product / wave.iter().map(|b| b.x * b.x).sum::<f64>();
            assert!((share - expected).abs() < tolerance, "{share} {expected}");
        }
    }

    #[test]
    fn smoothing_commutes_with_rigid_motions_and_keeps_the_mean() {
        let bowl = phantom::bowl(2.0, 6, 12);
        let smoother = Smoother::new(bowl.faces(), 0.2).unwrap();
        let turn = Rotation3::from_euler_angles(0.3, -1.0, 2.0);
        let place = Vector3::new(100.0, -3.0, 0.5);
        let moved: Vec<Point3> = bowl.vertices().iter().map(|p| turn * p + place).collect();
        let (own, other) = (
            smoother.smoothed(bowl.vertices()),
            smoother.smoothed(&moved),
        );
        for (p, q) in own.iter().zip(&other) {
            assert!((turn * p + place - q).norm() < 1e-11);
        }
        let mean = |points: &[Point3]| {
            points.iter().map(|p| p.coords).sum::<Vector3>() / points.len() as f64
        };
        assert!((mean(&own) - mean(bowl.vertices())).norm() < 1e-12);
    }

    #[test]
    fn no_radius_and_foreign_poses_change_nothing() {
        let ball = phantom::sphere(1, 1.0);
        let still = Smoother::new(ball.faces(), 0.0).unwrap();
        assert_eq!(still.smoothed(ball.vertices()), ball.vertices());
        let smoother = Smoother::new(ball.faces(), 0.1).unwrap();
        assert_eq!(
            smoother.smoothed(&ball.vertices()[..5]),
            ball.vertices()[..5]
        );
    }
}
