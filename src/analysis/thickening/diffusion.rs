//! Means of a quantity over neighbourhoods of the medial surface, the same on coarse and fine meshes.

use std::f64::consts::PI;

use crate::mesh::{Point3, vertex_areas};
use crate::numeric::{SparseCholesky, SparseCholeskyError};

/// The part of the medial mesh that takes part, and the areas of its atoms.
#[derive(Clone, Debug)]
pub(super) struct RegularMesh {
    /// Faces whose three atoms are regular.
    pub triangles: Vec<[u32; 3]>,
    /// A third of the area of the faces around each atom; 0 for atoms that do not take part.
    pub areas: Vec<f64>,
    /// Σ of `areas`.
    pub whole: f64,
}

impl RegularMesh {
    /// From the faces whose atoms are all regular, with areas at given positions.
    pub fn new(triangles: &[[u32; 3]], positions: &[Point3], regular: &[bool]) -> Self {
        let triangles: Vec<[u32; 3]> = (triangles.iter().copied())
            .filter(|triangle| triangle.iter().all(|&atom| regular[atom as usize]))
            .collect();
        let areas = vertex_areas(positions, &triangles);
        let whole = areas.iter().sum();
        Self {
            triangles,
            areas,
            whole,
        }
    }
}

/// Diffusion over the regular medial surface: solves once factorised.
///
/// Two backward Euler steps of the heat equation with cotangent weights and lumped areas:
/// u ← ((M + ½ t L)⁻¹ M)² u. On a plane what has wave number k passes by (1 + ½ t k²)⁻², and the mean
/// that results reaches over an area 1 / ∫ K² = 6 π t: noise that is independent from atom to atom has its
/// variance divided by the number of atoms therein. Constants stay as they are, and so does the
/// area-weighted mean.
#[derive(Clone, Debug)]
pub(super) struct Diffusion {
    factors: SparseCholesky,
    masses: Vec<f64>,
}

impl Diffusion {
    /// Over a share of the area of the mesh.
    pub fn new(
        mesh: &RegularMesh,
        positions: &[Point3],
        share: f64,
    ) -> Result<Self, SparseCholeskyError> {
        // Solved from 6 π t = the area to be averaged over.
        let time = share * mesh.whole / (6.0 * PI);
        // An atom without a face has nobody to share with: it keeps what it has.
        let lone = |area: f64| if area > 0.0 { area } else { 1.0 };
        let masses: Vec<f64> = mesh.areas.iter().map(|&area| lone(area)).collect();
        let mut entries: Vec<(usize, usize, f64)> = (masses.iter().enumerate())
            .map(|(i, &m)| (i, i, m))
            .collect();
        for &triangle in &mesh.triangles {
            for corner in 0..3 {
                let [i, j, k] = [0, 1, 2].map(|step| triangle[(corner + step) % 3] as usize);
                let (u, v) = (positions[j] - positions[i], positions[k] - positions[i]);
                // Cotangent of the corner is the scalar product over this.
                let doubled_area = u.cross(&v).norm();
                // A face of zero area has no angles and conducts nothing.
                if doubled_area > 0.0 {
                    // ½ cot of the corner at i, times half the time of the two steps.
                    let weight = 0.25 * time * u.dot(&v) / doubled_area;
                    entries.extend([
                        (j, j, weight),
                        (k, k, weight),
                        (j.max(k), j.min(k), -weight),
                    ]);
                }
            }
        }
        Ok(Self {
            factors: SparseCholesky::new(masses.len(), &entries)?,
            masses,
        })
    }

    /// Replaces each column of one value per atom by its means.
    pub fn apply(&self, columns: &mut [f64]) {
        // Two half steps: one leaves a cusp of high weight at each atom itself.
        for _ in 0..2 {
            for column in columns.chunks_exact_mut(self.masses.len()) {
                column
                    .iter_mut()
                    .zip(&self.masses)
                    .for_each(|(x, mass)| *x *= mass);
            }
            self.factors.solve(columns);
        }
    }
}
