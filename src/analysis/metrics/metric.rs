//! The metric as a solver: made for a connectivity, asked for poses, pairs and fields.

use nalgebra::Matrix3;

use crate::mesh::{Faces, Point3, Vector3};

use super::connectivity::Connectivity;
use super::params::CheckedMetricParams;
use super::pose::PreparedPose;

/// A metric on the poses of one connectivity.
#[derive(Clone, Debug)]
pub struct Metric {
    pub(super) mesh: Connectivity,
    pub(super) params: CheckedMetricParams,
}

/// Why a metric cannot answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum MetricError {
    /// A pose has another number of vertices than the connectivity.
    #[error("{points} points for connectivity of {expected} vertices")]
    VertexCount {
        /// Points given.
        points: usize,
        /// Vertices of the connectivity.
        expected: usize,
    },
    /// Coordinates are not finite, or so large that squared lengths are not.
    #[error("lengths or areas of the pose overflow")]
    Overflow,
}

/// Squared norms of X = B − A at both poses.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PairNorms {
    /// ⟨⟨X, X⟩⟩ at A.
    pub norm2_a: f64,
    /// ⟨⟨X, X⟩⟩ at B.
    pub norm2_b: f64,
}

impl PairNorms {
    /// Energy of the one-step path: the sum of both (section 3.2.3).
    pub fn energy(&self) -> f64 {
        self.norm2_a + self.norm2_b
    }

    /// √(energy / 2): the mean of both norms in the quadratic sense, a length.
    pub fn distance(&self) -> f64 {
        (0.5 * self.energy()).max(0.0).sqrt()
    }
}

/// Memory that pairs reuse; make one per thread.
#[derive(Clone, Debug, Default)]
pub struct PairScratch {
    /// Relative rate of length of each edge at A and at B.
    pub(super) stretch: Vec<[f64; 2]>,
    /// K(B) − K(A) of each vertex.
    pub(super) curvature_change: Vec<f64>,
}

impl Metric {
    /// A metric with checked settings on poses with these faces.
    pub fn new(faces: &Faces, params: CheckedMetricParams) -> Self {
        Self {
            mesh: Connectivity::new(faces),
            params,
        }
    }

    /// The settings it was made with.
    pub fn params(&self) -> &CheckedMetricParams {
        &self.params
    }

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
        Ok(PreparedPose::new(&self.mesh, &self.params, points))
    }

    /// Squared norms of X = B − A at A and at B, for poses as they lie.
    pub fn pair(&self, a: &PreparedPose, b: &PreparedPose, scratch: &mut PairScratch) -> PairNorms {
        self.pair_moved(a, b, &Matrix3::identity(), &Vector3::zeros(), scratch)
    }

    /// Squared norms of X = (R B + t) − A, where the rigid motion lays B onto A first.
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
        super::pair::norms(self, a, b, rotation, translation, scratch)
    }
}
