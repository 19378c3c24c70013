//! Which faces make two poses differ.

use crate::analysis::pose_distances::{
    PairError, PoseDistanceParamError, PoseDistanceParams, PoseId, pair_contributions,
};
use crate::engine::queries::pose_distances::metric_words;
use crate::engine::queries::subject::{NoSubject, subject_of};
use crate::engine::store::{Context, Dependencies, Interrupted, Memory, Query};
use crate::study::Study;

/// Share of each face in the squared distance of two poses, surfaces one after the other.
#[derive(Clone, Debug, PartialEq)]
pub struct Contribution {
    /// One pose.
    pub a: PoseId,
    /// The other.
    pub b: PoseId,
    /// How they are compared; faces are those of the subjects themselves, whatever the transport.
    pub distances: PoseDistanceParams,
}

/// Why there are no contributions.
#[derive(Debug, thiserror::Error)]
pub enum ContributionError {
    /// There is no such subject.
    #[error(transparent)]
    NoSubject(#[from] NoSubject),
    /// A setting is out of range.
    #[error(transparent)]
    Settings(#[from] PoseDistanceParamError),
    /// The two have no distance.
    #[error(transparent)]
    Pair(PairError),
}

impl Query for Contribution {
    type Answer = Vec<f64>;
    type Error = ContributionError;
    const TITLE: &'static str = "Contributions to a distance";
    const FAILURE: Option<&'static str> =
        Some("Contributions to the distance could not be computed");

    fn parameters(&self) -> String {
        metric_words(&self.distances.metric)
    }

    fn depends_on(&self, study: &Study) -> Dependencies {
        Dependencies::shapes(study, [self.a.subject, self.b.subject])
    }

    fn run(&self, cx: &Context<'_>) -> Result<Vec<f64>, Interrupted<ContributionError>> {
        let failed = |error: ContributionError| Interrupted::Failed(error);
        let params = (self.distances.check()).map_err(|error| failed(error.into()))?;
        let pose = |pose: PoseId| match subject_of(cx.study(), pose.subject) {
            Ok(subject) => Ok((subject, pose.frame)),
            Err(error) => Err(failed(error.into())),
        };
        let (a, b) = (pose(self.a)?, pose(self.b)?);
        cx.progress()
            .begin_phase("computing contributions", 0.0, 1.0);
        match pair_contributions(a, b, &params, cx.progress()) {
            Ok(shares) => Ok(shares),
            Err(PairError::Stopped(_)) => Err(Interrupted::Stopped),
            Err(error) => Err(failed(ContributionError::Pair(error))),
        }
    }

    fn memory(shares: &Vec<f64>, memory: &mut Memory) {
        memory.own(size_of_val(&**shares));
    }

    fn replaces(&self, other: &Self) -> bool {
        (self.a.subject, self.b.subject, self.distances)
            == (other.a.subject, other.b.subject, other.distances)
    }
}
