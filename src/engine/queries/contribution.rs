//! Which faces make two poses differ.

use crate::analysis::pose_distances::{PoseDistanceParams, PoseId, pair_contributions};
use crate::engine::queries::pose_distances::metric_words;
use crate::engine::queries::subject::subject_of;
use crate::engine::store::{Context, Dependencies, Interrupted, Memory, Query};
use crate::study::Study;

/// Share of each face in the squared distance of two poses, surfaces one after the other.
#[derive(Clone, Debug, PartialEq)]
pub struct ContributionQuery {
    /// One pose.
    pub a: PoseId,
    /// The other.
    pub b: PoseId,
    /// How they are compared; faces are those of the subjects themselves, whatever the transport.
    pub distances: PoseDistanceParams,
}

impl Query for ContributionQuery {
    type Answer = Vec<f64>;
    const TITLE: &'static str = "Contributions to a distance";
    const FAILURE: Option<&'static str> =
        Some("Contributions to the distance could not be computed");

    fn parameters(&self) -> String {
        metric_words(&self.distances.metric)
    }

    fn depends_on(&self, study: &Study) -> Dependencies {
        Dependencies::shapes(study, [self.a.subject, self.b.subject])
    }

    fn run(&self, cx: &Context<'_>) -> Result<Vec<f64>, Interrupted> {
        let params = self.distances.check()?;
        let [a, b] = [self.a, self.b]
            .map(|pose| subject_of(cx.study(), pose.subject).map(|subject| (subject, pose.frame)));
        let (a, b) = (a?, b?);
        cx.progress()
            .begin_phase("computing contributions", 0.0, 1.0);
        Ok(pair_contributions(a, b, &params, cx.progress())?)
    }

    fn memory(shares: &Vec<f64>, memory: &mut Memory) {
        memory.own(size_of_val(&**shares));
    }

    fn subjects(&mut self) -> Vec<&mut usize> {
        vec![&mut self.a.subject, &mut self.b.subject]
    }

    fn replaces(&self, other: &Self) -> bool {
        (self.a.subject, self.b.subject, self.distances)
            == (other.a.subject, other.b.subject, other.distances)
    }
}
