//! What the distances between poses are made of.

use crate::analysis::metrics::{CheckedMetricParams, MetricParams, ParamError};

/// Settings of a matrix of pose distances.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PoseDistanceParams {
    /// The metric between aligned poses.
    pub metric: MetricParams,
}

/// Settings that have been checked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CheckedPoseDistanceParams {
    pub(super) metric: CheckedMetricParams,
}

impl PoseDistanceParams {
    /// Makes settings usable.
    ///
    /// # Errors
    /// If those of the metric are not.
    pub fn check(self) -> Result<CheckedPoseDistanceParams, ParamError> {
        Ok(CheckedPoseDistanceParams {
            metric: self.metric.check()?,
        })
    }
}
