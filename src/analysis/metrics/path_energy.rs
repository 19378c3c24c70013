//! Energy of a path of poses and its exact gradient.
//!
//! Steps go side by side in lanes, so that every formula is computed for four of them at once and no
//! face waits for another. All measures of a pose are lengths, areas and angles of its faces: derivatives
//! are collected on squared lengths of edges and brought to the vertices in one pass at the end.

mod backpropagation;
pub(super) mod faces;
mod measure;
pub(super) mod rigid_steps;
mod rows;
pub(super) mod state;
mod step_energies;

use crate::mesh::Point3;
#[cfg(test)]
use crate::mesh::Vector3;
use crate::numeric::LANES;

#[cfg(test)]
use super::metric::PairNorms;
use super::metric::{Metric, MetricError};

use state::{Gradients, PathState, Plan};

/// E = Σ_i [⟨⟨X_i, X_i⟩⟩ at M_i + ⟨⟨X_i, X_i⟩⟩ at M_{i+1}], X_i = M_{i+1} − M_i, of a path whose ends
/// are fixed, in the units of the metric.
///
/// The sum of [`super::PairNorms::energy`] over its steps, poses as they lie; but the weights of the frozen form are
/// those of the two ends for all steps. Printed and bilinear quasi-conformal forms take ΔK of
/// the step at both of its poses. The gradient takes everything along that depends on the poses: areas
/// and their sum, curvature, the unit of the regulariser. Where the printed form has a kink, at a corner
/// that does not change, the gradient is the subgradient that leaves this corner out.
///
/// Source: V. Taimouri, *Shape Analysis in Shape Space*, section 3.2.3.
#[derive(Clone, Debug)]
pub struct PathEnergy {
    plan: Plan,
    state: PathState,
    gradients: Gradients,
    steps: Vec<f64>,
    /// Mean factor of the regulariser at both ends.
    factor_of_ends: f64,
}

impl PathEnergy {
    /// For paths from `start` to `end` with so many poses between them.
    ///
    /// # Errors
    /// If a pose has another number of points than the connectivity, or lengths overflow.
    pub fn new(
        metric: &Metric,
        start: &[Point3],
        end: &[Point3],
        interpolated_poses: usize,
    ) -> Result<Self, MetricError> {
        let ends = [metric.prepare(start)?, metric.prepare(end)?];
        let frozen = metric.frozen_weights(&ends[0], &ends[1]);
        let plan = Plan {
            interpolated_poses,
            // Steps, one more than poses; lanes left over rest at the end, where a step costs nothing.
            blocks: (interpolated_poses + 1).div_ceil(LANES),
            // The energy squares its factors, and the weights are squares already.
            frozen: frozen.into_iter().map(f64::sqrt).collect(),
            shared_regulariser_factor: None,
            side_parts: metric.mesh.side_parts(metric.params.area_weights).collect(),
            mesh: metric.mesh.clone(),
            params: metric.params,
            curvature: metric.params.curvature_role(),
        };
        let mut path = Self {
            state: PathState::new(&plan),
            gradients: Gradients::new(&plan),
            steps: vec![0.0; interpolated_poses + 1],
            factor_of_ends: 0.5 * (ends[0].regulariser_factor + ends[1].regulariser_factor),
            plan,
        };
        // All poses at the start first, so that its measures can be kept as those of pose 0, which never moves.
        path.lay(0, start);
        measure::measure(&path.plan, &mut path.state, &mut path.gradients);
        path.state.keep_as_start();
        // All poses but the first at the end: lanes past the last step stay there for good.
        path.lay(1, end);
        Ok(path)
    }

    /// Measures the displacements of the regulariser by the size of the two ends, all along the path, and
    /// not by that of each pose.
    ///
    /// For searches: where displacement is relative to the size of each pose, the way is shorter for poses
    /// that swell, since that makes every step a smaller part of them. The volume of a test mesh (a horse) between
    /// two poses of its gallop then rises by 7 % with λ = 3 where it should stay.
    #[must_use]
    pub fn with_size_of_ends(mut self) -> Self {
        self.plan.shared_regulariser_factor = Some(self.factor_of_ends);
        self
    }

    /// Energy of the path with these poses between its ends, and its gradient.
    ///
    /// `inner` holds x, y, z of every vertex, pose after pose: 3 · vertices · number of interpolated poses, and so
    /// does `gradient`; missing ones count as where they were before. Allocates nothing.
    pub fn evaluate(&mut self, inner: &[f64], gradient: &mut [f64]) -> f64 {
        // Forward first: the way back reads what every measure was.
        let energy = self.energy(inner);
        backpropagation::backpropagate(&self.plan, &self.state, &mut self.gradients);
        let (coordinates, blocks) = (3 * self.plan.mesh.vertex_count, self.plan.blocks);
        let poses = gradient.chunks_exact_mut(coordinates.max(1));
        for (k, pose) in poses.take(self.plan.interpolated_poses).enumerate() {
            let (block, lane) = (k / LANES, k % LANES);
            for (v, point) in pose.chunks_exact_mut(3).enumerate() {
                let slope = &self.gradients.points[v * blocks + block];
                for axis in 0..3 {
                    point[axis] = slope[axis].0[lane];
                }
            }
        }
        energy
    }

    /// Energy alone.
    pub fn energy(&mut self, inner: &[f64]) -> f64 {
        let coordinates = 3 * self.plan.mesh.vertex_count;
        let poses = inner.chunks_exact(coordinates.max(1));
        for (k, pose) in poses.take(self.plan.interpolated_poses).enumerate() {
            for (item, &x) in pose.iter().enumerate() {
                self.state.points.put(item, k + 1, x);
            }
        }
        measure::measure(&self.plan, &mut self.state, &mut self.gradients);
        step_energies::add_step_energies(&self.plan, &mut self.state, &mut self.gradients);
        for (step, energy) in self.steps.iter_mut().enumerate() {
            *energy = self.state.norms(step).iter().sum();
        }
        self.steps.iter().sum()
    }

    /// Energy of each step of the last path asked for, from the first.
    pub fn step_energies(&self) -> &[f64] {
        &self.steps
    }

    /// How many poses lie between the ends.
    pub fn interpolated_poses(&self) -> usize {
        self.plan.interpolated_poses
    }

    /// Lets all poses from `first` on be the same.
    fn lay(&mut self, first: usize, points: &[Point3]) {
        for (v, point) in points.iter().enumerate() {
            for axis in 0..3 {
                for pose in first..=LANES * self.plan.blocks {
                    self.state.points.put(3 * v + axis, pose, point[axis]);
                }
            }
        }
    }
}

#[cfg(test)]
impl Metric {
    /// Squared norms of X = B − A at A and at B, and the gradient of their sum with respect to the vertices
    /// of A and of B. What the tests compare with finite differences.
    fn pair_gradient(
        &self,
        a: &[Point3],
        b: &[Point3],
    ) -> Result<(PairNorms, [Vec<Vector3>; 2]), MetricError> {
        // A path that waits at both ends: waiting costs nothing, and has no gradient.
        // With two interpolated poses, both poses of the step are free and so have a gradient.
        let mut path = PathEnergy::new(self, a, b, 2)?;
        let inner: Vec<f64> = (a.iter().chain(b))
            .flat_map(|p| p.iter().copied())
            .collect();
        let mut gradient = vec![0.0; inner.len()];
        path.evaluate(&inner, &mut gradient);
        let [norm2_a, norm2_b] = path.state.norms(1);
        let (of_a, of_b) = gradient.split_at(gradient.len() / 2);
        let vectors = |gradients: &[f64]| {
            (gradients.chunks_exact(3))
                .map(|x| Vector3::new(x[0], x[1], x[2]))
                .collect()
        };
        Ok((
            PairNorms { norm2_a, norm2_b },
            [vectors(of_a), vectors(of_b)],
        ))
    }
}

#[cfg(test)]
mod tests;
