//! Why there is no map.

use crate::numeric::{EigenDiverged, LeadingEigenError};
use crate::progress::Stopped;

/// Why there is no map.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum EmbeddingError {
    /// It was asked to stop.
    #[error("{0}")]
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
    /// Distances so large that the map has coordinates beyond the largest number.
    #[error(
        "the map has coordinates beyond the largest number: give the distances in a larger unit"
    )]
    TooLarge,
}

impl From<LeadingEigenError> for EmbeddingError {
    fn from(error: LeadingEigenError) -> Self {
        match error {
            LeadingEigenError::Stopped(stopped) => Self::Stopped(stopped),
            LeadingEigenError::Diverged(diverged) => Self::Diverged(diverged),
        }
    }
}
