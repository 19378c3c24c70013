//! A map of poses together with the distances that it shows.

use std::sync::Arc;

use crate::analysis::pose_distances::PoseDistances;

use super::Embedding;

/// The map of all poses.
#[derive(Clone, Debug, PartialEq)]
pub struct PoseMap {
    /// What the map shows; rows correspond.
    pub distances: Arc<PoseDistances>,
    /// Two coordinates per pose.
    pub embedding: Embedding,
}
