//! What the 3D view asks the store: subjects and medial surfaces made ready for drawing, and colour ranges.
//!
//! These queries stand here and not in `engine/queries/`, for what they make is of the room `picture`, above `engine`.

use std::sync::Arc;

use crate::analysis::medial::MedialBeat;
use crate::analysis::verdicts::SubjectThickening;
use crate::engine::{Context, Dependencies, Interrupted, Memory, Query, Store, Urgency};
use crate::picture::{
    CohortColourRanges, PreparedMedial, PreparedSubject, SubjectFrame, fitted_camera,
};
use crate::render::Camera;
use crate::study::{Study, Subject};

use crate::document::interpolated_poses::InterpolatedMotion;
use crate::panes::same::Same;

/// Bytes of a vertex at a frame: position, normal and colour values on both sides of the graphics card.
const BYTES_OF_A_VERTEX: usize = 40;

/// Bytes of an atom at a frame: the corners of its disc with their values.
const BYTES_OF_AN_ATOM: usize = 400;

/// A subject ready for drawing, with where it lies.
#[derive(Debug)]
pub struct PlacedSubject {
    /// Its geometry and colour values.
    pub prepared: PreparedSubject,
    /// Where it lies in the world.
    pub frame: SubjectFrame,
    /// Vertices of all its poses together.
    vertex_frames: usize,
}

impl PlacedSubject {
    /// A camera with this rotation that has all frames in view.
    pub fn fitted(&self, world_from_camera: glam::Quat, aspect: f32) -> Camera {
        fitted_camera(self.prepared.all_positions(), world_from_camera, aspect)
    }
}

/// What a subject is made from.
#[derive(Clone, Debug, PartialEq)]
struct SubjectPictureQuery {
    subject: Same<Subject>,
    reference_frame: usize,
    interpolated_poses: Option<Same<InterpolatedMotion>>,
}

impl Query for SubjectPictureQuery {
    type Answer = PlacedSubject;
    const TITLE: &'static str = "Surfaces for the 3D view";
    const FAILURE: Option<&'static str> = Some("The surfaces could not be prepared");
    const URGENCY: Urgency = Urgency::Interactive;
    const LISTED: bool = false;

    fn depends_on(&self, _: &Study) -> Dependencies {
        Dependencies::nothing()
    }

    fn run(&self, _: &Context<'_>) -> Result<PlacedSubject, Interrupted> {
        let subject = &self.subject.0;
        let motion = self.interpolated_poses.as_ref().map(|motion| &motion.0);
        let between = motion.map_or_else(Vec::new, |motion| motion.inner_poses());
        let prepared =
            PreparedSubject::with_interpolated_poses(subject, self.reference_frame, &between);
        let recorded = subject.sequence.vertex_count() * subject.sequence.frame_count();
        let computed = motion.map_or(0, |motion| motion.vertices());
        Ok(PlacedSubject {
            frame: SubjectFrame::of(&prepared),
            vertex_frames: recorded + computed,
            prepared,
        })
    }

    fn memory(placed: &PlacedSubject, memory: &mut Memory) {
        memory.own(placed.vertex_frames * BYTES_OF_A_VERTEX);
    }

    /// The 3D view itself keeps the subjects on screen until all new ones are there.
    fn replaces(&self, _: &Self) -> bool {
        false
    }
}

/// What a medial surface is made from.
#[derive(Clone, Debug, PartialEq)]
struct MedialPictureQuery {
    subject: Same<Subject>,
    beat: Same<MedialBeat>,
    end_diastole: usize,
}

impl Query for MedialPictureQuery {
    type Answer = PreparedMedial;
    const TITLE: &'static str = "Medial surface for the 3D view";
    const FAILURE: Option<&'static str> = Some("The medial surface could not be prepared");
    const URGENCY: Urgency = Urgency::Interactive;
    const LISTED: bool = false;

    fn depends_on(&self, _: &Study) -> Dependencies {
        Dependencies::nothing()
    }

    fn run(&self, _: &Context<'_>) -> Result<PreparedMedial, Interrupted> {
        let (subject, beat) = (&self.subject.0, &self.beat.0);
        Ok(PreparedMedial::new(subject, beat, self.end_diastole))
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
struct ColourRangesQuery {
    reference_frames: Vec<usize>,
}

impl Query for ColourRangesQuery {
    type Answer = CohortColourRanges;
    const TITLE: &'static str = "Colour ranges";
    const FAILURE: Option<&'static str> = Some("The colour ranges could not be computed");
    const LISTED: bool = false;

    fn depends_on(&self, study: &Study) -> Dependencies {
        Dependencies::study_as_read(study)
    }

    fn run(&self, cx: &Context<'_>) -> Result<CohortColourRanges, Interrupted> {
        Ok(CohortColourRanges::of(cx.study(), &self.reference_frames))
    }

    fn memory(_: &CohortColourRanges, _: &mut Memory) {}

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

    /// The subject, if it is ready; else it is begun. Cheap every frame.
    pub fn placed(
        &self,
        subject: &Arc<Subject>,
        reference_frame: usize,
    ) -> Option<Arc<PlacedSubject>> {
        self.placed_of(subject, reference_frame, None)
    }

    /// The subject with poses between its frames; while it is being made, the subject without them.
    pub fn placed_between(
        &self,
        subject: &Arc<Subject>,
        reference_frame: usize,
        interpolated_poses: Option<&Arc<InterpolatedMotion>>,
    ) -> Option<Arc<PlacedSubject>> {
        let whole = interpolated_poses
            .and_then(|motion| self.placed_of(subject, reference_frame, Some(motion)));
        whole.or_else(|| self.placed(subject, reference_frame))
    }

    /// The medial surface of a subject, if it is ready; else it is begun. Cheap every frame.
    pub fn medial(
        &self,
        subject: &Arc<Subject>,
        wall: &Arc<SubjectThickening>,
    ) -> Option<ShownMedial> {
        let query = MedialPictureQuery {
            subject: Same(Arc::clone(subject)),
            beat: Same(Arc::clone(&wall.beat)),
            end_diastole: wall.thickening.end_diastole,
        };
        let showing = self.store.ask(self.study, &query);
        showing.ready().map(|prepared| ShownMedial {
            prepared: Arc::clone(prepared),
            wall: Arc::clone(wall),
        })
    }

    /// The fixed colour ranges of the study; the ones before while new ones are computed.
    pub fn cohort_ranges(&self, reference_frames: &[usize]) -> Option<CohortColourRanges> {
        let query = ColourRangesQuery {
            reference_frames: reference_frames.to_vec(),
        };
        let showing = self.store.ask(self.study, &query);
        showing.latest().map(|limits| **limits)
    }

    fn placed_of(
        &self,
        subject: &Arc<Subject>,
        reference_frame: usize,
        interpolated_poses: Option<&Arc<InterpolatedMotion>>,
    ) -> Option<Arc<PlacedSubject>> {
        let query = SubjectPictureQuery {
            subject: Same(Arc::clone(subject)),
            reference_frame,
            interpolated_poses: Same::of(interpolated_poses),
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
        let placed = loop {
            if let Some(placed) = pictures.placed(subject, 0) {
                break placed;
            }
            assert!(begin.elapsed() < Duration::from_secs(5));
            std::hint::spin_loop();
        };
        assert_eq!(placed.prepared.frame_count, 3);
        assert!(placed.frame.middle.length() < 1e-3);
        let again = pictures.placed(subject, 0).unwrap();
        assert!(Arc::ptr_eq(&placed, &again));
        assert!(store.activities().is_empty(), "pictures are not listed");
    }
}
