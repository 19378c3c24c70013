//! All ways of measuring on a wall of known thickness, and where they say nothing.

use std::sync::Arc;

use super::*;
use crate::engine::queries::tests::{ask, is_stopped, refusal, store};
use crate::mesh::phantom;
use crate::study::{SurfaceKind, SurfaceSequence};
use crate::units::LengthUnit;

/// Half shells of 20 and 28 mm, and of 18 and 29 mm at the second frame.
fn study(kinds: &[SurfaceKind]) -> Arc<Study> {
    let radii = |kind: SurfaceKind| match kind {
        SurfaceKind::Epicardium => [28.0, 29.0],
        _ => [20.0, 18.0],
    };
    let surfaces = (kinds.iter())
        .map(|&kind| {
            let frames = radii(kind).map(|radius| phantom::bowl(radius, 20, 48));
            SurfaceSequence::new(kind, frames.to_vec()).unwrap()
        })
        .collect();
    let sequence = MeshSequence::new(surfaces).unwrap();
    let subject = Subject::new("shell", sequence, LengthUnit::Millimetre);
    of_one(subject)
}

fn of_one(subject: Subject) -> Arc<Study> {
    Arc::new(Study {
        subjects: vec![Arc::new(subject)],
        ..Study::default()
    })
}

const BOTH: [SurfaceKind; 2] = [SurfaceKind::Endocardium, SurfaceKind::Epicardium];

fn query(frame: usize) -> PoseThicknessQuery {
    PoseThicknessQuery {
        subject: 0,
        frame,
        settings: ThicknessSettings::default(),
        after: [None; 2],
    }
}

#[test]
fn a_frame_is_measured_after_those_that_it_waits_for() {
    let (study, store) = (study(&BOTH), store());
    let last = PoseThicknessQuery {
        after: [Some(0), None],
        ..query(1)
    };
    ask(&store, &study, &last);
    assert_eq!(store.answers::<PoseThicknessQuery>(), 2);
    // The order is no part of the question: both are known.
    ask(&store, &study, &query(0));
    ask(&store, &study, &query(1));
    assert_eq!(store.answers::<PoseThicknessQuery>(), 2);
}

#[test]
fn all_methods_measure_the_thickness_of_a_shell_and_how_they_differ() {
    let (study, store) = (study(&BOTH), store());
    for (frame, thickness) in [(0, 8.0), (1, 11.0)] {
        let found = ask(&store, &study, &query(frame));
        assert_eq!((found.frame, found.results.len()), (frame, 5));
        for result in &found.results {
            let name = result.method.name();
            let spread = result.thickness.as_ref().unwrap();
            // Slices cut a sphere at a slant, more so towards its pole.
            let slack = match result.method {
                ComparedMethod::Other(ThicknessMethod::Centreline) => 0.25,
                _ => 0.06,
            };
            let off = spread.median / thickness - 1.0;
            assert!(off.abs() < slack, "{name}: {spread:?}");
            assert!(spread.low <= spread.quarter && spread.three_quarters <= spread.high);
            assert!(result.seconds > 0.0, "{name}");
            let Some(agreement) = result.agreement else {
                assert_eq!(result.method, ComparedMethod::Medial);
                continue;
            };
            assert!(
                agreement.bias.abs() < slack * thickness,
                "{name}: {agreement:?}"
            );
        }
    }
}

#[test]
fn a_pose_is_measured_once_and_the_other_is_another_question() {
    let (study, store) = (study(&BOTH), store());
    let first = ask(&store, &study, &query(0));
    let again = ask(&store, &study, &query(0));
    assert!(Arc::ptr_eq(&first, &again));
    assert!(is_stopped(&store, &study, &query(1)));
}

#[test]
fn a_method_that_does_not_apply_has_a_reason_and_the_others_go_on() {
    let hollow = study(&BOTH[..1]);
    for result in &ask(&store(), &hollow, &query(0)).results {
        let reason = result.thickness.as_ref().unwrap_err();
        assert!(reason.starts_with("no wall"), "{reason}");
        assert!(result.agreement.is_none());
    }
    // Closed spheres have a wall, but no base and so no long axis.
    let surfaces = [(SurfaceKind::Cavity, 20.0), (SurfaceKind::Epicardium, 28.0)];
    let surfaces = surfaces.map(|(kind, radius)| {
        SurfaceSequence::new(kind, vec![phantom::sphere(4, radius)]).unwrap()
    });
    let sequence = MeshSequence::new(surfaces.to_vec()).unwrap();
    let sphere = Subject::new("sphere", sequence, LengthUnit::Millimetre);
    let found = ask(&store(), &of_one(sphere), &query(0));
    let measured: Vec<bool> = (found.results.iter())
        .map(|result| result.thickness.is_ok())
        .collect();
    assert_eq!(measured, [true, true, false, true, false]);
}

#[test]
fn a_frame_that_is_not_there_is_refused_with_its_number() {
    let message = refusal(&store(), &study(&BOTH), &query(7));
    assert_eq!(message, "there is no frame 7 in a sequence of 2 frames");
}
