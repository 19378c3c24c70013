//! The map of whole deformations with the curves that it was made from.

use crate::analysis::embedding::Embedding;

/// One curve and one point per subject.
#[derive(Clone, Debug, PartialEq)]
pub struct DeformationMap {
    /// What each row stands for: indices into the study's subjects, ascending.
    pub subjects: Vec<usize>,
    /// (x, y, w t) of each subject, from end-diastole to the end-diastole of the next beat, at equal
    /// steps of arc length; x and y in the units of the pose map.
    pub curves: Vec<Vec<[f64; 3]>>,
    /// Weight w of time: units of the map per beat.
    pub time_weight: f64,
    /// Two coordinates per subject, with the number of neighbours and the reconstruction error.
    pub embedding: Embedding,
}
