//! What a distance is made of: how much of its energy is the metric's own term, change of curvature and the regulariser.

use nalgebra::Matrix3;

use crate::mesh::Vector3;

use super::metric::{Metric, PairScratch};
use super::pair_sums::{curvature, regulariser};
use super::params::CurvatureRole;
use super::pose::PreparedPose;

/// Parts of the energy of a pair, as shares of it; they sum to one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EnergyShares {
    /// The metric's own term, see [`super::MetricWords::term`]; with change of curvature where that is a factor of it.
    pub own: f64,
    /// The term of change of curvature, where it is one.
    pub curvature: f64,
    /// Displacement of vertices, which the regulariser penalises.
    pub displacement: f64,
}

impl Metric {
    /// What the energy of a pair is made of, for poses as they lie; `None` where they do not differ.
    pub fn shares(
        &self,
        a: &PreparedPose,
        b: &PreparedPose,
        scratch: &mut PairScratch,
    ) -> Option<EnergyShares> {
        let energy = self.pair(a, b, scratch).energy();
        let share = |[at_a, at_b]: [f64; 2]| (at_a + at_b) / energy;
        let displacement = regulariser(self, a, b, &Matrix3::identity(), &Vector3::zeros());
        let curvature = match self.params.curvature_role() {
            CurvatureRole::Term => curvature(self, a, b).map(|sum| self.params.mu * sum),
            CurvatureRole::Unused | CurvatureRole::FrozenFactor | CurvatureRole::StepFactor => {
                [0.0; 2]
            }
        };
        let (curvature, displacement) = (share(curvature), share(displacement));
        (energy > 0.0).then_some(EnergyShares {
            own: 1.0 - curvature - displacement,
            curvature,
            displacement,
        })
    }
}
