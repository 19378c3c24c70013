//! Distances that were computed before the study was edited, or a subject added.

use std::collections::HashMap;

use crate::analysis::transport::{CohortTransportParams, Reference};
use crate::study::{ShapeKey, Study};

use super::{DistanceMatrix, PoseDistances, PoseId};

/// An answer to the same settings on another state of the study.
#[derive(Clone, Copy, Debug)]
pub struct KnownDistances<'a> {
    /// What the subjects of that state were known by, in their order.
    pub shapes: &'a [ShapeKey],
    /// The answer.
    pub distances: &'a PoseDistances,
}

impl KnownDistances<'_> {
    /// Whether it still holds for the poses that are in both states: always without a transport, and
    /// with one if all is transported onto the same subject.
    pub(super) fn hold(&self, study: &Study, transport: Option<&CohortTransportParams>) -> bool {
        let now = || study.subjects.iter().map(|subject| subject.shape_key());
        match transport.map(|transport| transport.reference) {
            None => true,
            // The mean moves with every subject, and with it everything that is transported onto it.
            Some(Reference::Mean) => now().eq(self.shapes.iter().copied()),
            // Only the subject onto which all are transported must be as it was.
            Some(Reference::Subject(index)) => now().nth(index).as_ref() == self.shapes.get(index),
        }
    }
}

/// Which rows of a matrix are rows of a known one.
pub(super) struct KnownRows<'a> {
    known: Option<&'a DistanceMatrix>,
    /// For each pose its row of the known matrix.
    rows: Vec<Option<usize>>,
}

impl<'a> KnownRows<'a> {
    pub(super) fn of(known: Option<&KnownDistances<'a>>, study: &Study, poses: &[PoseId]) -> Self {
        let Some(known) = known else {
            return Self {
                known: None,
                rows: vec![None; poses.len()],
            };
        };
        let mut subjects: HashMap<ShapeKey, usize> = HashMap::new();
        for (index, shape) in known.shapes.iter().enumerate() {
            // Copies of one subject have the same distances, so the first stands for all.
            subjects.entry(*shape).or_insert(index);
        }
        let rows: HashMap<PoseId, usize> =
            (known.distances.poses.iter().copied()).zip(0..).collect();
        let row_of = |pose: &PoseId| {
            let subject = *subjects.get(&study.subjects.get(pose.subject)?.shape_key())?;
            let frame = pose.frame;
            rows.get(&PoseId { subject, frame }).copied()
        };
        Self {
            known: Some(&known.distances.distances),
            rows: poses.iter().map(row_of).collect(),
        }
    }

    /// Whether no pair is left to compute.
    pub(super) fn all_known(&self) -> bool {
        let rows: Option<Vec<usize>> = self.rows.iter().copied().collect();
        // A pair in the other order is computed anew, because its last bits may differ.
        rows.is_some_and(|rows| rows.is_sorted_by(|a, b| a < b))
    }

    /// The distance of two poses, i < j. A pair that stood in the other order counts as unknown:
    /// its last bits may differ.
    pub(super) fn distance(&self, i: usize, j: usize) -> Option<f64> {
        let (a, b) = (self.rows[i]?, self.rows[j]?);
        (a < b).then(|| self.known.map(|known| known.get(a, b)))?
    }
}
