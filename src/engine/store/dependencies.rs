//! What of a study an answer depends on: it stays true as long as that stays as it is.

use crate::study::{Anatomy, CycleTiming, Revision, SequenceId, ShapeKey, Study};
use crate::units::LengthUnit;

/// The state of what an answer was computed from. Equal dependencies, equal answers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Dependencies {
    revision: Option<Revision>,
    /// Whether it depends on every subject that there is.
    cohort: bool,
    /// `None` for a subject that does not exist.
    subjects: Vec<Option<SubjectKey>>,
    /// Times of frames, one entry a subject; empty where they are not read.
    times: Vec<CycleTiming>,
}

/// What was read of a subject; `None` for what was not read.
#[derive(Clone, Copy, Debug, PartialEq)]
struct SubjectKey {
    surfaces: SequenceId,
    shape: Option<ShapeKey>,
    geometry: Option<(Option<usize>, LengthUnit, Option<Anatomy>)>,
}

/// How much of a subject is read.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Reads {
    Surfaces,
    Shape,
    Geometry,
}

impl Dependencies {
    /// On nothing of the study: the question holds all that it needs.
    pub fn nothing() -> Self {
        Self::default()
    }

    /// On everything, labels included: any edit asks for another answer.
    pub fn study(study: &Study) -> Self {
        let mut all = Self::of(study, 0..study.count(), Reads::Surfaces);
        all.revision = Some(study.revision);
        all.cohort = true;
        all
    }

    /// On everything that is read so far: for what is no result, and is made again when more is read.
    pub fn study_as_read(study: &Study) -> Self {
        Self {
            cohort: false,
            ..Self::study(study)
        }
    }

    /// On the surfaces of these subjects.
    pub fn surfaces(study: &Study, subjects: impl IntoIterator<Item = usize>) -> Self {
        Self::of(study, subjects, Reads::Surfaces)
    }

    /// On the surfaces and end-diastole of these subjects.
    pub fn shapes(study: &Study, subjects: impl IntoIterator<Item = usize>) -> Self {
        Self::of(study, subjects, Reads::Shape)
    }

    /// On surfaces and end-diastole of all subjects.
    pub fn all_shapes(study: &Study) -> Self {
        Self {
            cohort: true,
            ..Self::shapes(study, 0..study.subjects.len())
        }
    }

    /// On surfaces, end-diastole and times of frames of all subjects.
    pub fn all_motions(study: &Study) -> Self {
        let times = study.subjects.iter().map(|subject| subject.timing.clone());
        Self {
            times: times.collect(),
            ..Self::all_shapes(study)
        }
    }

    /// Whether it depends on subjects that are still to be read.
    pub(super) fn waits_for(&self, study: &Study) -> bool {
        self.cohort && !study.unread.is_empty()
    }

    /// The places in a study of the subjects that it depends on one by one; `None` for those that it lacks.
    pub(super) fn places(&self, study: &Study) -> Vec<Option<usize>> {
        let place = |key: &Option<SubjectKey>| {
            let surfaces = key.as_ref()?.surfaces;
            let mut subjects = study.subjects.iter();
            subjects.position(|subject| subject.sequence.id() == surfaces)
        };
        self.subjects.iter().map(place).collect()
    }

    /// On surfaces, both phases, unit and landmarks of these subjects: all that is read of a wall. Times of frames, labels
    /// and what is known of the patient are not.
    pub fn geometry(study: &Study, subjects: impl IntoIterator<Item = usize>) -> Self {
        Self::of(study, subjects, Reads::Geometry)
    }

    /// Whether both were computed from the same surfaces, whatever else was edited: then one may stay on screen while
    /// the other is computed.
    pub fn same_surfaces(&self, other: &Self) -> bool {
        let surfaces = |all: &Self| -> Vec<Option<SequenceId>> {
            let subjects = all.subjects.iter();
            subjects.map(|key| key.map(|key| key.surfaces)).collect()
        };
        self.subjects.len() == other.subjects.len() && surfaces(self) == surfaces(other)
    }

    /// What the shapes of the subjects were known by; `None` if more or less than shapes was read.
    pub fn shape_keys(&self) -> Option<Vec<ShapeKey>> {
        self.subjects
            .iter()
            .map(|key| key.as_ref()?.shape)
            .collect()
    }

    fn of(study: &Study, subjects: impl IntoIterator<Item = usize>, reads: Reads) -> Self {
        let key = |index: usize| {
            let subject = study.subject(index)?;
            Some(SubjectKey {
                surfaces: subject.sequence.id(),
                shape: (reads >= Reads::Shape).then(|| subject.shape_key()),
                geometry: (reads >= Reads::Geometry).then_some((
                    subject.end_systole,
                    subject.unit,
                    subject.anatomy,
                )),
            })
        };
        Self {
            revision: None,
            cohort: false,
            subjects: subjects.into_iter().map(key).collect(),
            times: Vec::new(),
        }
    }
}
