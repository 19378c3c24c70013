//! What the distances between poses are made of.

use crate::analysis::metrics::{CheckedMetricParams, MetricParams, ParamError};
use crate::analysis::transport::{CohortTransportParams, TransportParamError};

/// Settings of a matrix of pose distances.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PoseDistanceParams {
    /// The metric between aligned poses.
    pub metric: MetricParams,
    /// Whether all motions are transported onto one subject before poses are compared, so that distances
    /// tell of motion alone; `None` compares poses as they are, so that they tell of shape as well.
    pub transport: Option<CohortTransportParams>,
    /// Radius ρ, in shares of the square root of a surface's area, below which poses are smoothed
    /// before all else ([`Smoother`](crate::analysis::metrics::Smoother)); 0 leaves them as they are.
    pub smoothing: f64,
}

impl Default for PoseDistanceParams {
    /// The default metric on poses smoothed by ρ = 0.1, without transport. Strain of noise grows as the mesh gets finer,
    /// and drowns that of motion; displacement stands noise better, and best after smoothing:
    ///
    /// | ρ | partner: displacement, strain | clean | 1 % | 5 % | 20 % |
    /// |---|---|---|---|---|---|
    /// | 0 | 19, 17 | 98, 100 | 98, 95 | 92, 84 | 87, 50 |
    /// | 0.08 | | –, 100 | –, 100 | –, 98 | –, 95 |
    /// | **0.1** | 18, 19 | 100, 100 | 99, 100 | 98, 98 | 94, 95 |
    /// | 0.12 | | –, 99 | –, 99 | –, 96 | –, 94 |
    /// | 0.2 | 13, 16 | | | | |
    ///
    /// *Strain:* quasi-conformal with μ = 10⁻³ and λ = 3. *Partner:* gated SPECT, nearest of 20. *Percent:* mean τ of four
    /// classes of synthetic deformations of six kinds of objects with so much Gaussian noise, three draws
    /// ([`noise_deformation`](crate::analysis::experiments::noise_deformation)). More than 0.12 eats the shape itself: the
    /// tube of the torus has radius 0.1 √A.
    fn default() -> Self {
        Self {
            metric: MetricParams::default(),
            transport: None,
            smoothing: 0.1,
        }
    }
}

/// A radius past which nothing is left of any surface's shape.
const LARGEST_RADIUS: f64 = 1.0;

/// Settings that have been checked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CheckedPoseDistanceParams {
    pub(super) metric: CheckedMetricParams,
    pub(super) transport: Option<CohortTransportParams>,
    pub(super) smoothing: f64,
}

/// Why settings cannot be used.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PoseDistanceParamError {
    /// Those of the metric.
    #[error(transparent)]
    Metric(#[from] ParamError),
    /// Those of the transport.
    #[error(transparent)]
    Transport(#[from] TransportParamError),
    /// Not a radius.
    #[error("the smoothing radius must be between 0 and {LARGEST_RADIUS} of √area, not {0}")]
    Smoothing(f64),
}

impl PoseDistanceParams {
    /// Checks the settings once; an algorithm takes the checked type only.
    ///
    /// # Errors
    /// If those of the metric or of the transport are not, or the radius is out of range.
    pub fn check(self) -> Result<CheckedPoseDistanceParams, PoseDistanceParamError> {
        let metric = self.metric.check()?;
        if !(0.0..=LARGEST_RADIUS).contains(&self.smoothing) {
            return Err(PoseDistanceParamError::Smoothing(self.smoothing));
        }
        // Checked with the metric in force, not with the one that the transport was made with.
        if let Some(transport) = self.transport {
            transport.with_metric(self.metric).check()?;
        }
        Ok(CheckedPoseDistanceParams {
            metric,
            transport: self.transport,
            smoothing: self.smoothing,
        })
    }
}
