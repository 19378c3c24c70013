//! How stiff each direction of a path is, about: what makes the search short.

use crate::analysis::metrics::{CheckedMetricParams, Corners, Regulariser};
use crate::mesh::{Faces, Point3, Vector3};
use crate::numeric::SparseCholesky;

/// Added to the diagonal, as a share of its mean, so that fields which the metric does not penalise
/// do not make the matrix singular; small enough not to be felt by those it penalises.
const SHIFT: f64 = 1e-6;

/// Stiffness of sides against turning, as a share of that against stretching.
///
/// A side under strain resists turning (or gives way to it) with about its strain, and the straight
/// line between two beating or galloping poses strains sides by some tenths: hence a tenth, of that order and not tuned. Without this
/// share the preconditioner takes sides for free to turn, and the search steps into high-frequency wrinkles,
/// which it must then take back. It changes how long a search takes, never what a path costs.
const TENSION: f64 = 0.1;

/// The inverse of T ⊗ 4G, factorised: about the Hessian of the path energy.
///
/// With the metric frozen at one pose, ⟨⟨X, Y⟩⟩ = Xᵀ G Y, the energy is Σ 2 XᵢᵀG Xᵢ, a quadratic
/// form with Hessian 4 T ⊗ G where T = tridiag(−1, 2, −1) couples neighbouring poses. G holds the
/// corner terms (or edge terms), a tension of the sides and the regulariser, and not the curvature term, which
/// with its averages would fill it; what is left out costs iterations, never accuracy.
#[derive(Clone, Debug)]
pub(super) struct Stiffness {
    factor: SparseCholesky,
}

impl Stiffness {
    /// At one pose; `None` if the pose is so degenerate that G is not positive definite.
    ///
    /// `corner_weights`, one per vertex, multiply squared corner terms: curvature change squared in
    /// the forms where it is a factor.
    pub fn new(
        faces: &Faces,
        pose: &[Point3],
        params: &CheckedMetricParams,
        corner_weights: Option<&[f64]>,
    ) -> Option<Self> {
        let size = 3 * faces.vertex_count();
        let areas: Vec<f64> = (faces.triangles().iter())
            .map(|triangle| {
                let [a, b, c] = triangle.map(|v| pose[v as usize]);
                0.5 * (b - a).cross(&(c - a)).norm()
            })
            .collect();
        let total: f64 = areas.iter().sum();
        // Shares of no area are not defined; the search then runs without a preconditioner.
        if !(total > 0.0 && total.is_finite()) {
            return None;
        }
        let own_displacement = if params.kind.penalises_displacement() {
            1.0
        } else {
            0.0
        };
        let mut entries = Vec::with_capacity(45 * areas.len() + size);
        let mut diagonal = vec![0.0; size];
        for (triangle, area) in faces.triangles().iter().zip(&areas) {
            let share = area / total;
            let weight = if params.area_weights { share } else { 1.0 };
            let corners = corner_weights.map(|w| triangle.map(|v| w[v as usize]));
            if let Some(block) = face_block(triangle.map(|v| pose[v as usize]), params, corners) {
                push_block(&mut entries, &mut diagonal, triangle, weight, &block);
            }
            let counted = match params.regulariser {
                Regulariser::Area => share / 3.0,
                Regulariser::Uniform => 0.0,
            };
            let own = if params.area_weights {
                own_displacement * share / 3.0
            } else {
                0.0
            };
            for &v in triangle {
                for axis in 0..3 {
                    diagonal[3 * v as usize + axis] += displacement(params, total) * counted + own;
                }
            }
        }
        let regulariser = match params.regulariser {
            Regulariser::Uniform => params.lambda,
            Regulariser::Area => 0.0,
        };
        let even = if params.area_weights {
            regulariser
        } else {
            regulariser + own_displacement
        };
        // Relative to the mean: a shift that is small for one size would be large for another.
        let mean = diagonal.iter().sum::<f64>() / size as f64 + even;
        for (k, value) in diagonal.into_iter().enumerate() {
            entries.push((k, k, value + even + SHIFT * mean));
        }
        let factor = SparseCholesky::new(size, &entries).ok()?;
        Some(Self { factor })
    }

    /// Multiplies a gradient over any number of poses by the inverse.
    pub fn solve(&self, gradient: &mut [f64]) {
        let size = self.factor.size();
        if size == 0 {
            return;
        }
        // A Kronecker product is inverted factor by factor: space for every pose, then time for every coordinate.
        self.factor.solve(gradient);
        solve_in_time(gradient, size);
        for value in gradient {
            // The Hessian is 4 T ⊗ G.
            *value *= 0.25;
        }
    }
}

/// Replaces each value over poses by tridiag(−1, 2, −1)⁻¹ of it, by elimination: with poses counted from 0, the pivot of
/// pose k is (k + 2) / (k + 1).
fn solve_in_time(values: &mut [f64], size: usize) {
    let poses = values.len() / size;
    for k in 1..poses {
        // Forwards, what the pose before adds: 1 over its pivot, (k + 1) / k.
        let factor = k as f64 / (k + 1) as f64;
        let (before, here) = values[(k - 1) * size..(k + 1) * size].split_at_mut(size);
        for (here, before) in here.iter_mut().zip(before) {
            *here += factor * *before;
        }
    }
    for k in (0..poses).rev() {
        // Backwards, divided by the own pivot.
        let inverse_pivot = (k + 1) as f64 / (k + 2) as f64;
        let (here, after) = values[k * size..].split_at_mut(size);
        if k + 1 < poses {
            for (here, after) in here.iter_mut().zip(after) {
                *here = (*here + *after) * inverse_pivot;
            }
        } else {
            for here in here {
                *here *= inverse_pivot;
            }
        }
    }
}

/// Factor of the regulariser that is area-weighted, as the metric has it.
fn displacement(params: &CheckedMetricParams, total_area: f64) -> f64 {
    match params.corners {
        Corners::ScaleFree => params.lambda * 4.0 * std::f64::consts::PI / total_area,
        Corners::Raw => params.lambda,
    }
}

type Block = [[f64; 9]; 9];

/// BᵀCB of a face: B takes displacements of its corners to the stretches s of its sides, C
/// is the form of the metric on stretches; `None` where faces have no terms.
fn face_block(
    corner: [Point3; 3],
    params: &CheckedMetricParams,
    corner_weights: Option<[f64; 3]>,
) -> Option<Block> {
    let sides: [Vector3; 3] = [0, 1, 2].map(|e| corner[e] - corner[(e + 1) % 3]);
    let length2 = sides.map(|side| side.norm_squared());
    let mut b = [[0.0; 9]; 3];
    for e in 0..3 {
        if length2[e] > 0.0 {
            for axis in 0..3 {
                let rate = sides[e][axis] / length2[e];
                b[e][3 * e + axis] += rate;
                b[e][3 * ((e + 1) % 3) + axis] -= rate;
            }
        }
    }
    let c = params.side_stiffness(length2, corner_weights)?;
    let mut block = [[0.0; 9]; 9];
    let stiffest = (0..3).map(|e| c[e][e]).fold(0.0, f64::max);
    for (e, &length2) in length2.iter().enumerate() {
        if length2 > 0.0 {
            let (p, q) = (3 * e, 3 * ((e + 1) % 3));
            // Sides that were free to turn would wrinkle, and the search would have to take that back.
            let tension = TENSION * stiffest / length2;
            for axis in 0..3 {
                block[p + axis][p + axis] += tension;
                block[q + axis][q + axis] += tension;
                block[p + axis][q + axis] -= tension;
                block[q + axis][p + axis] -= tension;
            }
        }
    }
    for (i, row) in block.iter_mut().enumerate() {
        for (j, entry) in row.iter_mut().enumerate() {
            for e in 0..3 {
                for f in 0..3 {
                    *entry += b[e][i] * c[e][f] * b[f][j];
                }
            }
        }
    }
    Some(block)
}

fn push_block(
    entries: &mut Vec<(usize, usize, f64)>,
    diagonal: &mut [f64],
    triangle: &[u32; 3],
    weight: f64,
    block: &Block,
) {
    let index = |k: usize| 3 * triangle[k / 3] as usize + k % 3;
    for (i, row) in block.iter().enumerate() {
        for (j, value) in row.iter().enumerate() {
            let (row, column) = (index(i), index(j));
            // The lower triangle alone: the matrix is symmetric and so is its factor.
            if row > column {
                entries.push((row, column, weight * value));
            } else if row == column {
                diagonal[row] += weight * value;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::metrics::{
        CurvatureRole, Form, METRICS, Metric, MetricParams, PathEnergy,
    };
    use crate::mesh::phantom;

    #[test]
    fn elimination_over_poses_inverts_the_second_difference() {
        let right = [3.0, -1.0, 0.5, 2.0, 7.0];
        let mut x = right;
        solve_in_time(&mut x, 1);
        for k in 0..5 {
            let before = if k > 0 { x[k - 1] } else { 0.0 };
            let after = if k < 4 { x[k + 1] } else { 0.0 };
            assert!((2.0 * x[k] - before - after - right[k]).abs() < 1e-12);
        }
    }

    /// Near a path that does not move, the energy is the quadratic form XᵀHX / 2; what is solved for, P,
    /// differs from it by the tension only, which no field feels more than the stiffest.
    #[test]
    fn of_small_displacements_it_nearly_inverts_the_hessian() {
        let ball = phantom::sphere(1, 2.0);
        let settings = [
            (Corners::ScaleFree, true, Regulariser::Area),
            (Corners::Raw, false, Regulariser::Uniform),
        ];
        let all = METRICS
            .into_iter()
            .flat_map(|kind| settings.map(|settings| (kind, settings)));
        for (kind, (corners, area_weights, regulariser)) in all {
            let params = MetricParams {
                kind,
                // Without curvature the same as the bilinear form.
                form: Form::Additive,
                corners,
                area_weights,
                regulariser,
                lambda: 3.0,
                ..MetricParams::default()
            };
            let params = params.check().unwrap();
            let metric = Metric::new(ball.faces(), params);
            let stiffness = Stiffness::new(ball.faces(), ball.vertices(), &params, None).unwrap();
            let mut energy = PathEnergy::new(&metric, ball.vertices(), ball.vertices(), 2).unwrap();
            let still: Vec<f64> = (ball.vertices().iter().chain(ball.vertices()))
                .flat_map(|p| [p.x, p.y, p.z])
                .collect();
            let small: Vec<f64> = (0..still.len())
                .map(|k| 1e-4 * (1.7 * k as f64).sin())
                .collect();
            let moved: Vec<f64> = still.iter().zip(&small).map(|(x, d)| x + d).collect();
            let mut back = vec![0.0; still.len()];
            energy.evaluate(&moved, &mut back);
            stiffness.solve(&mut back);
            let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
            // P⁻¹H has no eigenvalue above 1, and of a field that turns and stretches none near 0. The term of curvature, which
            // P leaves out, only adds to H.
            let share = dot(&back, &small) / dot(&small, &small);
            let most = match params.curvature_role() {
                CurvatureRole::Unused => 1.0,
                _ => f64::INFINITY,
            };
            assert!(
                (0.3..most).contains(&share),
                "{kind:?} {corners:?}: {share}"
            );
        }
    }
}
