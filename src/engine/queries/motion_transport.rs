//! The motion of one subject on another, by parallel transport.

use crate::analysis::transport::{TransportParams, TransportedMotion, transported_motion};
use crate::engine::queries::pose_distances::metric_words;
use crate::engine::queries::subject::subject_of;
use crate::engine::store::{Context, Dependencies, Interrupted, Memory, Query};
use crate::mesh::Point3;
use crate::study::Study;

/// The motion of one subject on another, in the coordinates of the other.
#[derive(Clone, Debug, PartialEq)]
pub struct MotionTransportQuery {
    /// Whose motion.
    pub from: usize,
    /// Onto which subject.
    pub onto: usize,
    /// Along which path, and what is kept.
    pub params: TransportParams,
}

impl Query for MotionTransportQuery {
    type Answer = TransportedMotion;
    const TITLE: &'static str = "Motion transport";
    const FAILURE: Option<&'static str> = Some("The motion could not be transported");

    fn parameters(&self) -> String {
        let metric = metric_words(&self.params.metric);
        let count = self.params.interpolated_poses;
        format!("{count} interpolated poses between the subjects, {metric}")
    }

    fn depends_on(&self, study: &Study) -> Dependencies {
        Dependencies::shapes(study, [self.from, self.onto])
    }

    fn run(&self, cx: &Context<'_>) -> Result<TransportedMotion, Interrupted> {
        let params = self.params.check()?;
        let subject = |index| subject_of(cx.study(), index);
        let (from, onto) = (subject(self.from)?, subject(self.onto)?);
        cx.progress()
            .begin_phase("transporting the motion", 0.0, 1.0);
        Ok(transported_motion(from, onto, &params, cx.progress())?)
    }

    fn memory(motion: &TransportedMotion, memory: &mut Memory) {
        let sequence = &motion.sequence;
        memory.own(sequence.frame_count() * sequence.vertex_count() * size_of::<Point3>());
    }

    fn subjects(&mut self) -> Vec<&mut usize> {
        vec![&mut self.from, &mut self.onto]
    }

    fn replaces(&self, other: &Self) -> bool {
        (self.from, self.onto) == (other.from, other.onto)
    }
}
