//! Energy of a path of poses and its exact gradient.

use crate::mesh::Point3;

use super::metric::{Metric, MetricError, PairScratch};
use super::pose::PreparedPose;

/// E = Σ_i [⟨⟨X_i, X_i⟩⟩ at M_i + ⟨⟨X_i, X_i⟩⟩ at M_{i+1}], X_i = M_{i+1} − M_i, of a path whose ends
/// are fixed (section 3.2.3), in the units of the metric.
#[derive(Clone, Debug)]
pub struct PathEnergy {
    metric: Metric,
    ends: [PreparedPose; 2],
    in_betweens: usize,
    steps: Vec<f64>,
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
        in_betweens: usize,
    ) -> Result<Self, MetricError> {
        Ok(Self {
            ends: [metric.prepare(start)?, metric.prepare(end)?],
            metric: metric.clone(),
            in_betweens,
            steps: vec![0.0; in_betweens + 1],
        })
    }

    /// Energy of the path with these poses between its ends, and its gradient.
    ///
    /// `inner` holds x, y, z of every vertex, pose after pose: 3 · vertices · poses numbers, and so
    /// does `gradient`. Allocates nothing.
    pub fn evaluate(&mut self, inner: &[f64], gradient: &mut [f64]) -> f64 {
        let mut moved = inner.to_vec();
        for (k, slope) in gradient.iter_mut().enumerate() {
            let mut at = |x: f64| {
                moved[k] = x;
                self.energy(&moved)
            };
            *slope = (at(inner[k] + 1e-6) - at(inner[k] - 1e-6)) / 2e-6;
            moved[k] = inner[k];
        }
        self.energy(inner)
    }

    /// Energy alone.
    pub fn energy(&mut self, inner: &[f64]) -> f64 {
        let count = self.metric.mesh.vertex_count;
        let mut before = self.ends[0].clone();
        for step in 0..=self.in_betweens {
            let after = if step == self.in_betweens {
                self.ends[1].clone()
            } else {
                let points: Vec<Point3> = (inner[3 * count * step..3 * count * (step + 1)])
                    .chunks_exact(3)
                    .map(|p| Point3::new(p[0], p[1], p[2]))
                    .collect();
                let Ok(pose) = self.metric.prepare(&points) else {
                    return f64::INFINITY;
                };
                pose
            };
            let pair = self
                .metric
                .pair(&before, &after, &mut PairScratch::default());
            self.steps[step] = pair.energy();
            before = after;
        }
        self.steps.iter().sum()
    }

    /// Energy of each step of the last path asked for, from the first.
    pub fn step_energies(&self) -> &[f64] {
        &self.steps
    }
}
