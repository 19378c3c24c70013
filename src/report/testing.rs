//! A small study for the tests of tables.

use std::sync::Arc;

use crate::mesh::TriMesh;
use crate::study::{MeshSequence, Study, Subject, SurfaceKind, SurfaceSequence};
use crate::units::LengthUnit;

/// Subjects with these pseudonyms and labels, of which all have the same cavity.
pub(super) fn study(subjects: &[(&str, &str)], frames: Vec<TriMesh>) -> Study {
    let surface = SurfaceSequence::new(SurfaceKind::Cavity, frames).unwrap();
    let sequence = MeshSequence::new(vec![surface]).unwrap();
    let subject = |&(id, label): &(&str, &str)| {
        let mut subject = Subject::new(id, sequence.clone(), LengthUnit::Millimetre);
        subject.label = Some(label.to_owned());
        Arc::new(subject)
    };
    Study {
        subjects: subjects.iter().map(subject).collect(),
        ..Study::default()
    }
}
