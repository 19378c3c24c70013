//! The map of whole deformations with what it was made from.

use std::sync::Arc;

use crate::analysis::embedding::Embedding;
use crate::analysis::pose_distances::DistanceMatrix;

use super::PartDistances;

/// One point per subject.
#[derive(Clone, Debug, PartialEq)]
pub struct DeformationMap {
    /// What each row stands for: indices into the study's subjects, ascending.
    pub subjects: Vec<usize>,
    /// (x, y, w t) of each subject, from end-diastole to the end-diastole of the next beat, at equal
    /// steps of arc length; x and y in the units of the pose map. None where parts of distances are mapped.
    pub curves: Vec<Vec<[f64; 3]>>,
    /// Weight w of time in the curves: units of the pose map per beat.
    pub time_weight: Option<f64>,
    /// The distances that are mapped, and their parts; `None` where curves are.
    pub parts: Option<MappedParts>,
    /// Two coordinates per subject, with the number of neighbours and the reconstruction error.
    pub embedding: Embedding,
}

/// Distances of two parts as they are weighted on a map, with the parts; rows are those of the map.
#[derive(Clone, Debug, PartialEq)]
pub struct MappedParts {
    /// See [`PartDistances::weighted`].
    pub distances: DistanceMatrix,
    /// Both parts.
    pub parts: Arc<PartDistances>,
}
