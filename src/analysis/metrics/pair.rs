//! Poses are prepared, and compared in pairs.

use nalgebra::Matrix3;

use crate::mesh::{Point3, Vector3};

use super::kinds::terms;
use super::metric::{Metric, MetricError, PairNorms, PairScratch};
use super::pair_sums::regulariser;
use super::params::CurvatureRole;
use super::pose::PreparedPose;

impl Metric {
    /// Computes what pairs and inner products need of a pose.
    ///
    /// # Errors
    /// If the number of points is not that of the connectivity, or lengths overflow.
    pub fn prepare(&self, points: &[Point3]) -> Result<PreparedPose, MetricError> {
        if points.len() != self.mesh.vertex_count {
            return Err(MetricError::VertexCount {
                points: points.len(),
                expected: self.mesh.vertex_count,
            });
        }
        // The fourth power of lengths enters raw corners and areas squared.
        let reach = points.iter().fold(0.0_f64, |m, p| m.max(p.coords.amax()));
        if !(reach.powi(4) * 1e8).is_finite() || points.iter().any(|p| p.iter().any(|x| x.is_nan()))
        {
            return Err(MetricError::Overflow);
        }
        // Curvature averaged over rings is the most costly part of a pose, and only some metrics compare it.
        let with_curvature = self.params.curvature_role() != CurvatureRole::Unused;
        let (mesh, params) = (&self.mesh, &self.params);
        Ok(PreparedPose::new(mesh, params, with_curvature, points))
    }

    /// Squared norms of X = B − A at A and at B, for poses as they lie.
    pub fn pair(&self, a: &PreparedPose, b: &PreparedPose, scratch: &mut PairScratch) -> PairNorms {
        self.pair_moved(a, b, &Matrix3::identity(), &Vector3::zeros(), scratch)
    }

    /// Squared norms of X = (R B + t) − A, where the rigid motion aligns B with A first.
    ///
    /// Neither curvature nor areas nor lengths of B are touched by the motion, so no pose has to be
    /// prepared again.
    pub fn pair_moved(
        &self,
        a: &PreparedPose,
        b: &PreparedPose,
        rotation: &Matrix3<f64>,
        translation: &Vector3,
        scratch: &mut PairScratch,
    ) -> PairNorms {
        let motion = (rotation, translation);
        let own = terms(self.params.kind).pair(self, [a, b], motion, scratch);
        let rest = regulariser(self, a, b, rotation, translation);
        PairNorms {
            norm2_a: own[0] + rest[0],
            norm2_b: own[1] + rest[1],
        }
    }
}
