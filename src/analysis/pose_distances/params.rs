//! What the distances between poses are made of.

use crate::analysis::metrics::{CheckedMetricParams, MetricParams, ParamError};
use crate::analysis::transport::{CohortTransferParams, TransportParamError};

/// Settings of a matrix of pose distances.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PoseDistanceParams {
    /// The metric between aligned poses.
    pub metric: MetricParams,
    /// Whether all motions are carried onto one heart before poses are compared, so that distances
    /// tell of motion alone; `None` compares poses as they are, so that they tell of shape as well.
    pub transfer: Option<CohortTransferParams>,
}

/// Settings that have been checked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CheckedPoseDistanceParams {
    pub(super) metric: CheckedMetricParams,
    pub(super) transfer: Option<CohortTransferParams>,
}

/// Why settings cannot be used.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PoseDistanceParamError {
    /// Those of the metric.
    #[error(transparent)]
    Metric(#[from] ParamError),
    /// Those of the transfer.
    #[error(transparent)]
    Transfer(#[from] TransportParamError),
}

impl PoseDistanceParams {
    /// Makes settings usable.
    ///
    /// # Errors
    /// If those of the metric or of the transfer are not.
    pub fn check(self) -> Result<CheckedPoseDistanceParams, PoseDistanceParamError> {
        let metric = self.metric.check()?;
        if let Some(transfer) = self.transfer {
            transfer.with_metric(self.metric).check()?;
        }
        Ok(CheckedPoseDistanceParams {
            metric,
            transfer: self.transfer,
        })
    }
}
