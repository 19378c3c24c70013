//! What the distances between poses are made of.

use crate::analysis::metrics::MetricParams;

/// Settings of a matrix of pose distances.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PoseDistanceParams {
    /// The metric between aligned poses.
    pub metric: MetricParams,
}
