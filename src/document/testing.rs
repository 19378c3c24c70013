//! Small studies for the tests of this room.

use std::sync::Arc;

use crate::mesh::phantom;
use crate::study::{MeshSequence, Revision, Study, Subject, SurfaceKind, SurfaceSequence};
use crate::units::LengthUnit;

use crate::document::document::{OpeningReport, StudyRef};
use crate::document::state::State;

/// A subject of one small sphere that contracts over `frames` frames.
pub fn subject_with_frames(id: &str, frames: usize) -> Subject {
    let meshes = (0..frames)
        .map(|frame| phantom::sphere(1, 30.0 - frame as f64))
        .collect();
    let cavity = SurfaceSequence::new(SurfaceKind::Cavity, meshes).unwrap();
    let sequence = MeshSequence::new(vec![cavity]).unwrap();
    Subject::new(id, sequence, LengthUnit::Millimetre)
}

/// A study of these subjects.
pub fn study_of(subjects: Vec<Subject>) -> Arc<Study> {
    Arc::new(Study {
        name: "test".to_owned(),
        subjects: subjects.into_iter().map(Arc::new).collect(),
        revision: Revision(1),
        ..Study::default()
    })
}

/// A study as a document holds it, opened first.
pub fn study_ref(study: Arc<Study>) -> StudyRef {
    StudyRef {
        listing: study.revision,
        study,
        opening: 1,
        report: Arc::default(),
    }
}

/// A window's state with these subjects on screen.
pub fn state_of(subjects: Vec<Subject>) -> State {
    let mut state = State::default();
    state.show_study(study_of(subjects), OpeningReport::default());
    state.answers.listing = state.document.study.listing;
    state
}
