//! What the store says in this frame of the questions that the window asks. Results live in the store alone.

use std::sync::Arc;

use crate::analysis::classification::Classes;
use crate::analysis::deformations::DeformationMap;
use crate::analysis::embedding::PoseMap;
use crate::analysis::measures::SubjectMeasures;
use crate::analysis::verdicts::{SubjectThickening, Verdicts};
use crate::engine::{EstimatedPose, Interrupted, NoEstimate, Showing};
use crate::study::Revision;

use crate::document::interpolated_poses::InterpolatedMotion;
use crate::document::transported::{TransportState, TransportedSubject};

/// How a wall thickens, or why that cannot be told.
pub type FoundWall = Result<Arc<SubjectThickening>, String>;

/// The answers of one frame; made anew in the next. `None` where nothing is asked.
#[derive(Clone, Debug, Default)]
pub struct Answers {
    /// Which list of subjects they are about; indices mean the same within one.
    pub(crate) listing: Revision,
    pub(crate) measures: Option<Showing<Vec<SubjectMeasures>>>,
    pub(crate) map: Option<Showing<PoseMap>>,
    /// The pose at a place of the map, while one is looked at.
    pub(crate) estimate: Option<Showing<Result<EstimatedPose, NoEstimate>>>,
    pub(crate) deformations: Option<Showing<DeformationMap>>,
    pub(crate) classes: Option<Showing<Classes>>,
    pub(crate) verdicts: Option<Showing<Verdicts>>,
    /// Of the subjects on screen, while those of the cohort are not known.
    pub(crate) measures_of_one: Vec<(usize, Showing<SubjectMeasures>)>,
    /// Of the subjects on screen.
    pub(crate) walls: Vec<WallAnswer>,
    /// Of the motions on screen.
    pub(crate) interpolated_poses: Vec<InterpolationAnswer>,
    pub(crate) transported: Option<TransportedSubject>,
    pub(crate) transport_state: TransportState,
    /// Where the poses side by side differ: one number per vertex, one list for all poses.
    pub(crate) difference: Option<Arc<Vec<Vec<f32>>>>,
}

/// What is known of a wall on screen.
#[derive(Clone, Debug)]
pub(crate) struct WallAnswer {
    pub subject: usize,
    pub showing: Showing<SubjectThickening>,
    /// With whether it is the answer to the settings of today; else it is the one before.
    pub found: Option<(FoundWall, bool)>,
}

impl WallAnswer {
    /// What cannot be told of a wall is an answer too: "not assessed", with its reason.
    pub fn new(subject: usize, showing: Showing<SubjectThickening>) -> Self {
        // Colours and borders of a wall that is not resolved would look like findings.
        let assessed = |found: &Arc<SubjectThickening>| match &found.not_assessed {
            Some(reason) => Err(reason.to_string()),
            None => Ok(Arc::clone(found)),
        };
        let found = match &showing {
            Showing::Ready(found) => Some((assessed(found), true)),
            Showing::Interrupted {
                why: Interrupted::Failed(error),
                ..
            } => Some((Err(error.to_string()), true)),
            Showing::Computing { previous, .. } | Showing::Interrupted { previous, .. } => {
                previous.as_ref().map(|found| (assessed(found), false))
            }
        };
        Self {
            subject,
            showing,
            found,
        }
    }
}

/// What is known of the poses between the frames of a motion on screen.
#[derive(Clone, Debug)]
pub(crate) struct InterpolationAnswer {
    pub subject: usize,
    /// As far as they are computed.
    pub motion: Option<Arc<InterpolatedMotion>>,
    /// Whether the user stopped the work.
    pub stopped: bool,
}

impl Answers {
    /// How transporting the motion that the document asks for stands.
    pub fn transport_state(&self) -> TransportState {
        self.transport_state
    }

    /// Where the poses side by side differ, once that is known.
    pub fn difference(&self) -> Option<&Arc<Vec<Vec<f32>>>> {
        self.difference.as_ref()
    }

    /// The measures of a subject on screen.
    pub(crate) fn measures_of_one(&self, subject: usize) -> Option<&SubjectMeasures> {
        let mut known = self.measures_of_one.iter();
        let (_, showing) = known.find(|(index, _)| *index == subject)?;
        showing.latest().map(|measures| &**measures)
    }

    /// Subjects have other places now.
    pub(crate) fn follow(&mut self, index: &[usize]) {
        let measured = self.measures_of_one.iter_mut().map(|(subject, _)| subject);
        let walls = self.walls.iter_mut().map(|wall| &mut wall.subject);
        let motions = self.interpolated_poses.iter_mut();
        let motions = motions.map(|motion| &mut motion.subject);
        for subject in measured.chain(walls).chain(motions) {
            *subject = index.get(*subject).copied().unwrap_or(*subject);
        }
    }

    /// How the wall of a subject on screen stands.
    pub(crate) fn wall(&self, subject: usize) -> Option<&WallAnswer> {
        self.walls.iter().find(|wall| wall.subject == subject)
    }

    /// How the poses between the frames of a subject on screen stand.
    pub(crate) fn interpolated_poses(&self, subject: usize) -> Option<&InterpolationAnswer> {
        let mut motions = self.interpolated_poses.iter();
        motions.find(|motion| motion.subject == subject)
    }
}
