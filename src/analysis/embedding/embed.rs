//! A map by the method of choice.

use crate::analysis::pose_distances::DistanceMatrix;
use crate::progress::Progress;

use super::smacof::CheckedSmacofParams;
use super::{Embedding, EmbeddingError, MapMethod, classical_mds, isomap, smacof};

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
