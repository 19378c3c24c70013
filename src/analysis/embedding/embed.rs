//! A map by the method of choice.

use crate::analysis::pose_distances::DistanceMatrix;
use crate::numeric::{EigenDiverged, LeadingEigenError};
use crate::progress::{Progress, Stopped};

use super::smacof::CheckedSmacofParams;
use super::{Embedding, MapMethod, classical_mds, isomap, smacof};

/// Why there is no map.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum EmbeddingError {
    /// It was asked to stop.
    #[error(transparent)]
    Stopped(#[from] Stopped),
    /// The eigenvalues did not converge.
    #[error(transparent)]
    Diverged(#[from] EigenDiverged),
    /// Coordinates of points do not make rows of equal length, or are not finite.
    #[error("{values} values do not make {items} rows of finite numbers")]
    Points {
        /// Numbers given.
        values: usize,
        /// Rows they should make.
        items: usize,
    },
    /// Not fewer neighbours than there are items, or none at all.
    #[error("{neighbours} neighbours of each of {items} items: 1 to {} are possible", items.saturating_sub(1))]
    Neighbours {
        /// Neighbours asked for.
        neighbours: usize,
        /// Items there are.
        items: usize,
    },
    /// A map of more dimensions than items can span.
    #[error("{dimensions} dimensions of {items} items: at most {} are possible", items.saturating_sub(1))]
    Dimensions {
        /// Dimensions asked for.
        dimensions: usize,
        /// Items there are.
        items: usize,
    },
}

impl From<LeadingEigenError> for EmbeddingError {
    fn from(error: LeadingEigenError) -> Self {
        match error {
            LeadingEigenError::Stopped(stopped) => Self::Stopped(stopped),
            LeadingEigenError::Diverged(diverged) => Self::Diverged(diverged),
        }
    }
}

/// A map of items in `dimensions` numbers each, with the settings that the window uses.
///
/// Stress majorisation starts from classical scaling; see [`classical_mds`] and [`smacof()`].
/// Where distances fill fewer dimensions than asked for, the rest are zero.
///
/// # Errors
/// If stopped, or eigenvalues do not converge.
pub fn embed(
    distances: &DistanceMatrix,
    method: MapMethod,
    dimensions: usize,
    progress: &Progress,
) -> Result<Embedding, EmbeddingError> {
    match method {
        MapMethod::ClassicalMds => classical_mds(distances, dimensions, progress),
        MapMethod::Smacof => smacof(
            distances,
            dimensions,
            &CheckedSmacofParams::default(),
            progress,
        ),
        MapMethod::Isomap { neighbours } => {
            isomap(distances, usize::from(neighbours), dimensions, progress)
        }
    }
}
