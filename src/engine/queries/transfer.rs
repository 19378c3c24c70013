//! The motion of one subject on another, by parallel transport.

use crate::analysis::transport::{
    TransportError, TransportParamError, TransportParams, transported_motion,
};
use crate::engine::queries::pose_distances::metric_words;
use crate::engine::queries::subject::{NoSubject, subject_of};
use crate::engine::store::{Context, Dependencies, Interrupted, Memory, Query};
use crate::mesh::Point3;
use crate::study::{MeshSequence, Study};

/// The motion of one subject on another, in the coordinates of the other.
#[derive(Clone, Debug, PartialEq)]
pub struct Transfer {
    /// Whose motion.
    pub from: usize,
    /// Onto which subject.
    pub onto: usize,
    /// Along which path, and what is kept.
    pub params: TransportParams,
}

/// Why a motion cannot be transported.
#[derive(Debug, thiserror::Error)]
pub enum TransferError {
    /// There is no such subject.
    #[error(transparent)]
    NoSubject(#[from] NoSubject),
    /// A setting is out of range.
    #[error(transparent)]
    Settings(#[from] TransportParamError),
    /// The transport has no answer.
    #[error(transparent)]
    Transport(TransportError),
}

impl Query for Transfer {
    type Answer = MeshSequence;
    type Error = TransferError;
    const TITLE: &'static str = "Motion transport";
    const FAILURE: Option<&'static str> = Some("The motion could not be transported");

    fn parameters(&self) -> String {
        let metric = metric_words(&self.params.metric);
        let count = self.params.in_betweens;
        format!("{count} interpolated poses between the subjects, {metric}")
    }

    fn depends_on(&self, study: &Study) -> Dependencies {
        Dependencies::shapes(study, [self.from, self.onto])
    }

    fn run(&self, cx: &Context<'_>) -> Result<MeshSequence, Interrupted<TransferError>> {
        let failed = |error: TransferError| Interrupted::Failed(error);
        let params = (self.params.check()).map_err(|error| failed(error.into()))?;
        let subject = |index| subject_of(cx.study(), index).map_err(|error| failed(error.into()));
        let (from, onto) = (subject(self.from)?, subject(self.onto)?);
        cx.progress()
            .begin_phase("transporting the motion", 0.0, 1.0);
        match transported_motion(from, onto, &params, cx.progress()) {
            Ok(sequence) => Ok(sequence),
            Err(TransportError::Stopped(_)) => Err(Interrupted::Stopped),
            Err(error) => Err(failed(TransferError::Transport(error))),
        }
    }

    fn memory(sequence: &MeshSequence, memory: &mut Memory) {
        memory.own(sequence.frame_count() * sequence.vertex_count() * size_of::<Point3>());
    }

    fn replaces(&self, other: &Self) -> bool {
        (self.from, self.onto) == (other.from, other.onto)
    }
}
