//! Hearts and walls made ready for drawing: questions to the store, like every analysis.

use std::sync::Arc;

use crate::analysis::medial::MedialBeat;
use crate::engine::{
    Context, Dependencies, Interrupted, Memory, Query, Store, SubjectThickening, Urgency,
};
use crate::picture::{CohortLimits, HeartFrame, PreparedMedial, PreparedSubject, fitted_camera};
use crate::render::Camera;
use crate::study::{Study, Subject};

use crate::document::interpolated_poses::InterpolatedMotion;

/// Bytes of a vertex at a frame: position, normal and colour values on both sides of the graphics card.
const BYTES_OF_A_VERTEX: usize = 40;

/// Bytes of an atom at a frame: the corners of its disc with their values.
const BYTES_OF_AN_ATOM: usize = 400;

/// A heart ready for drawing, with where it lies.
#[derive(Debug)]
pub struct Heart {
    /// Its geometry and colour values.
    pub prepared: PreparedSubject,
    /// Where it lies in the world.
    pub frame: HeartFrame,
    /// Vertices of all its poses together.
    vertex_frames: usize,
}

impl Heart {
    /// A camera with this rotation that has all frames in view.
    pub fn fitted(&self, world_from_camera: glam::Quat, aspect: f32) -> Camera {
        fitted_camera(self.prepared.all_positions(), world_from_camera, aspect)
    }
}

/// What a heart is made from.
#[derive(Clone, Debug)]
struct SubjectPicture {
    subject: Arc<Subject>,
    reference_frame: usize,
    interpolated_poses: Option<Arc<InterpolatedMotion>>,
}

impl PartialEq for SubjectPicture {
    /// Whether both are made from the same values, not from equal ones.
    fn eq(&self, other: &Self) -> bool {
        let same_poses = match (&self.interpolated_poses, &other.interpolated_poses) {
            (Some(a), Some(b)) => Arc::ptr_eq(a, b),
            (None, None) => true,
            (Some(_), None) | (None, Some(_)) => false,
        };
        same_poses
            && Arc::ptr_eq(&self.subject, &other.subject)
            && self.reference_frame == other.reference_frame
    }
}

impl Query for SubjectPicture {
    type Answer = Heart;
    const TITLE: &'static str = "Surfaces for the 3D view";
    const FAILURE: Option<&'static str> = Some("The surfaces could not be prepared");
    const URGENCY: Urgency = Urgency::Interactive;
    const LISTED: bool = false;

    fn depends_on(&self, _: &Study) -> Dependencies {
        Dependencies::nothing()
    }

    fn run(&self, _: &Context<'_>) -> Result<Heart, Interrupted> {
        let between = self.interpolated_poses.as_ref();
        let between = between.map_or_else(Vec::new, |beat| beat.inner_poses());
        let prepared =
            PreparedSubject::with_interpolated_poses(&self.subject, self.reference_frame, &between);
        let sequence = &self.subject.sequence;
        let recorded = sequence.vertex_count() * sequence.frame_count();
        let computed = self
            .interpolated_poses
            .as_ref()
            .map_or(0, |beat| beat.vertices());
        Ok(Heart {
            frame: HeartFrame::of(&prepared),
            vertex_frames: recorded + computed,
            prepared,
        })
    }

    fn memory(heart: &Heart, memory: &mut Memory) {
        memory.own(heart.vertex_frames * BYTES_OF_A_VERTEX);
    }

    /// The 3D view itself keeps the hearts on screen until all new ones are there.
    fn replaces(&self, _: &Self) -> bool {
        false
    }
}

/// What a medial surface is made from.
#[derive(Clone, Debug)]
struct MedialPicture {
    subject: Arc<Subject>,
    beat: Arc<MedialBeat>,
    end_diastole: usize,
}

impl PartialEq for MedialPicture {
    /// Whether both are made from the same values, not from equal ones.
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.subject, &other.subject)
            && Arc::ptr_eq(&self.beat, &other.beat)
            && self.end_diastole == other.end_diastole
    }
}

impl Query for MedialPicture {
    type Answer = PreparedMedial;
    const TITLE: &'static str = "Medial surface for the 3D view";
    const FAILURE: Option<&'static str> = Some("The medial surface could not be prepared");
    const URGENCY: Urgency = Urgency::Interactive;
    const LISTED: bool = false;

    fn depends_on(&self, _: &Study) -> Dependencies {
        Dependencies::nothing()
    }

    fn run(&self, _: &Context<'_>) -> Result<PreparedMedial, Interrupted> {
        let medial = PreparedMedial::new(&self.subject, &self.beat, self.end_diastole);
        Ok(medial)
    }

    fn memory(medial: &PreparedMedial, memory: &mut Memory) {
        let beat = &medial.beat;
        memory.own(beat.frames.len() * beat.vertices.len() * BYTES_OF_AN_ATOM);
    }

    fn replaces(&self, _: &Self) -> bool {
        false
    }
}

/// The colour ranges of a study.
#[derive(Clone, Debug, PartialEq)]
struct ColourRanges {
    reference_frames: Vec<usize>,
}

impl Query for ColourRanges {
    type Answer = CohortLimits;
    const TITLE: &'static str = "Colour ranges";
    const FAILURE: Option<&'static str> = Some("The colour ranges could not be computed");
    const LISTED: bool = false;

    fn depends_on(&self, study: &Study) -> Dependencies {
        Dependencies::study(study)
    }

    fn run(&self, cx: &Context<'_>) -> Result<CohortLimits, Interrupted> {
        Ok(CohortLimits::of(cx.study(), &self.reference_frames))
    }

    fn memory(_: &CohortLimits, _: &mut Memory) {}

    fn replaces(&self, _: &Self) -> bool {
        true
    }
}

/// A medial surface on screen: the drawn one, and the assessed wall.
#[derive(Clone, Debug)]
pub struct ShownMedial {
    /// Ready for drawing.
    pub prepared: Arc<PreparedMedial>,
    /// The wall that it belongs to, assessed.
    pub wall: Arc<SubjectThickening>,
}

/// Asks the store for what is drawn of a study.
#[derive(Clone, Copy)]
pub struct Pictures<'a> {
    store: &'a Store,
    study: &'a Arc<Study>,
}

impl<'a> Pictures<'a> {
    /// Of one study.
    pub fn new(store: &'a Store, study: &'a Arc<Study>) -> Self {
        Self { store, study }
    }

    /// The heart, if it is ready; else it is begun. Cheap every frame.
    pub fn heart(&self, subject: &Arc<Subject>, reference_frame: usize) -> Option<Arc<Heart>> {
        self.heart_of(subject, reference_frame, None)
    }

    /// The heart with poses between its frames; while it is being made, the heart without them.
    pub fn heart_between(
        &self,
        subject: &Arc<Subject>,
        reference_frame: usize,
        interpolated_poses: Option<&Arc<InterpolatedMotion>>,
    ) -> Option<Arc<Heart>> {
        let whole =
            interpolated_poses.and_then(|beat| self.heart_of(subject, reference_frame, Some(beat)));
        whole.or_else(|| self.heart(subject, reference_frame))
    }

    /// The medial surface of a heart, if it is ready; else it is begun. Cheap every frame.
    pub fn medial(
        &self,
        subject: &Arc<Subject>,
        wall: &Arc<SubjectThickening>,
    ) -> Option<ShownMedial> {
        let query = MedialPicture {
            subject: Arc::clone(subject),
            beat: Arc::clone(&wall.beat),
            end_diastole: wall.thickening.end_diastole,
        };
        let showing = self.store.ask(self.study, &query);
        showing.ready().map(|prepared| ShownMedial {
            prepared: Arc::clone(prepared),
            wall: Arc::clone(wall),
        })
    }

    /// The fixed colour ranges of the study; the ones before while new ones are computed.
    pub fn cohort_limits(&self, reference_frames: &[usize]) -> Option<CohortLimits> {
        let query = ColourRanges {
            reference_frames: reference_frames.to_vec(),
        };
        let showing = self.store.ask(self.study, &query);
        showing.latest().map(|limits| **limits)
    }

    fn heart_of(
        &self,
        subject: &Arc<Subject>,
        reference_frame: usize,
        interpolated_poses: Option<&Arc<InterpolatedMotion>>,
    ) -> Option<Arc<Heart>> {
        let query = SubjectPicture {
            subject: Arc::clone(subject),
            reference_frame,
            interpolated_poses: interpolated_poses.cloned(),
        };
        self.store.ask(self.study, &query).ready().cloned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::testing::{study_of, subject_with_frames};
    use crate::engine::StoreOptions;
    use std::time::{Duration, Instant};

    #[test]
    fn a_heart_is_made_once_and_then_kept() {
        let store = Store::start(StoreOptions::default()).unwrap();
        let study = study_of(vec![subject_with_frames("a", 3)]);
        let (pictures, subject) = (Pictures::new(&store, &study), &study.subjects[0]);
        let begin = Instant::now();
        let heart = loop {
            if let Some(heart) = pictures.heart(subject, 0) {
                break heart;
            }
            assert!(begin.elapsed() < Duration::from_secs(5));
            std::hint::spin_loop();
        };
        assert_eq!(heart.prepared.frame_count, 3);
        assert!(heart.frame.middle.length() < 1e-3);
        let again = pictures.heart(subject, 0).unwrap();
        assert!(Arc::ptr_eq(&heart, &again));
        assert!(store.activities().is_empty(), "pictures are not listed");
    }
}
