//! What of a heart's answer is found again, what an edit leaves of it, and what it does to other answers.

use std::sync::Arc;

use super::*;
use crate::analysis::medial::{MedialBeat, MedialParams};
use crate::analysis::segments::{polar, segment};
use crate::engine::queries::tests::{ask, edited, is_stopped, refusal, store};
use crate::engine::store::{Store, StoreOptions};
use crate::study::built_in::{BuiltInParams, cohort};
use crate::study::{MeshSequence, Revision, Subject, SurfaceKind, SurfaceSequence};

/// Two hearts, the second with a patch.
fn study() -> Arc<Study> {
    let params = BuiltInParams {
        vertices: 600,
        ..BuiltInParams::default()
    };
    let whole = cohort(&params).unwrap().study;
    let ill = whole.subjects.iter().find(|s| s.id.starts_with('P'));
    Arc::new(Study {
        subjects: vec![Arc::clone(&whole.subjects[0]), Arc::clone(ill.unwrap())],
        revision: Revision(7),
        ..whole
    })
}

fn query(subject: usize, tolerance: Option<f64>) -> WallThickeningQuery {
    let mut settings = ThickeningSettings::default();
    settings.patches.tolerance = tolerance;
    WallThickeningQuery { subject, settings }
}

#[test]
fn another_tolerance_or_border_fits_no_sphere_again() {
    let (study, store) = (study(), store());
    let first = ask(&store, &study, &query(1, None));
    let second = ask(&store, &study, &query(1, Some(0.3)));
    assert!(Arc::ptr_eq(&first.beat, &second.beat));
    assert_ne!(first.thickening.steps, second.thickening.steps);
    let mut settings = ThickeningSettings::default();
    settings.patches.extent_threshold = 0.6;
    let wider = WallThickeningQuery {
        subject: 1,
        settings,
    };
    let third = ask(&store, &study, &wider);
    assert!(Arc::ptr_eq(&first.beat, &third.beat));
    assert!(third.thickening.patches[0].share > first.thickening.patches[0].share);
    settings.medial.smoothing = 0.0;
    let rough = WallThickeningQuery {
        subject: 1,
        settings,
    };
    assert_ne!(ask(&store, &study, &rough).beat, first.beat);
}

#[test]
fn an_answer_survives_edits_of_other_hearts_and_of_labels() {
    let (study, store) = (study(), store());
    let asked = query(1, None);
    let first = ask(&store, &study, &asked);
    let other = edited(&study, 0, |subject| subject.end_diastole = Some(2));
    assert!(Arc::ptr_eq(&first, &ask(&store, &other, &asked)));
    let renamed = edited(&study, 1, |subject| subject.label = Some("DCM".to_owned()));
    assert!(Arc::ptr_eq(&first, &ask(&store, &renamed, &asked)));
}

#[test]
fn an_edit_that_the_answer_reads_brings_another_of_the_same_atoms() {
    let (study, store) = (study(), store());
    let asked = query(1, None);
    let first = ask(&store, &study, &asked);
    let edits: [fn(&mut Subject); 4] = [
        |subject| subject.end_diastole = Some(1),
        |subject| subject.end_systole = Some(2),
        |subject| subject.unit = crate::units::LengthUnit::FileUnit,
        |subject| subject.anatomy = None,
    ];
    for edit in edits {
        let after = edited(&study, 1, edit);
        let second = ask(&store, &after, &asked);
        assert_ne!(*first, *second);
        assert!(Arc::ptr_eq(&first.beat, &second.beat));
    }
}

#[test]
fn atoms_that_answers_share_count_once() {
    let study = study();
    let small = ask(&store(), &study, &query(1, None));
    // Many atoms: a hundred answers about one beat fit, where two such beats do not.
    let mut beat = (*small.beat).clone();
    let frame = &mut beat.frames[0];
    frame.atoms = vec![frame.atoms[0]; 400_000];
    let budget = beat_bytes(&beat) * 3 / 2;
    let store = Store::start(StoreOptions {
        budget,
        ..StoreOptions::default()
    });
    let store = store.unwrap();
    let put = |subject: usize, tolerance: f64, beat: &Arc<MedialBeat>| {
        let found = SubjectThickening {
            beat: Arc::clone(beat),
            ..(*small).clone()
        };
        store.put(&study, &query(subject, Some(tolerance)), Arc::new(found));
    };
    let known = |subject: usize, tolerance: f64| {
        let known = store.known(&study, &query(subject, Some(tolerance)));
        known.is_some()
    };
    let shared = Arc::new(beat);
    for step in 0..100 {
        put(0, f64::from(step), &shared);
    }
    assert!(known(0, 0.0) && known(0, 99.0));
    put(1, 0.0, &Arc::new((*shared).clone()));
    assert!(known(1, 0.0) && !known(0, 50.0));
}

#[test]
fn one_heart_alone_is_measured_as_it_is_in_its_study() {
    let study = study();
    let (alone, together) = (store(), store());
    ask(&together, &study, &MeasuresQuery);
    let asked = query(1, None);
    assert_eq!(
        *ask(&alone, &study, &asked),
        *ask(&together, &study, &asked)
    );
    assert!(alone.known(&study, &MeasuresQuery).is_none());
}

#[test]
fn places_are_given_per_atom_at_end_diastole() {
    let (study, store) = (study(), store());
    let found = ask(&store, &study, &query(1, None));
    let axis = found.axis.unwrap();
    assert!(axis.is_oriented() && found.without_axis.is_none());
    assert_eq!(found.segments.len(), found.beat.vertices.len());
    let atoms = &found.beat.frames[found.thickening.end_diastole].atoms;
    for (atom, (place, polar_place)) in atoms.iter().zip(found.segments.iter().zip(&found.polar)) {
        assert_eq!(*place, segment(&axis, atom.position));
        assert_eq!(*polar_place, Some(polar(&axis, atom.position)));
    }
    assert!(!found.thickening.patches[0].segments.is_empty());
}

#[test]
fn a_cavity_alone_and_a_single_frame_are_answered_in_words() {
    let study = study();
    let only = |kinds: &[SurfaceKind], frames: usize| {
        let after = edited(&study, 0, |subject| {
            let surfaces = (kinds.iter())
                .map(|&kind| {
                    let surface = subject.sequence.surface(kind).unwrap();
                    SurfaceSequence::new(kind, surface.frames()[..frames].to_vec()).unwrap()
                })
                .collect();
            subject.sequence = MeshSequence::new(surfaces).unwrap();
        });
        refusal(&store(), &after, &query(0, None))
    };
    let both = [SurfaceKind::Endocardium, SurfaceKind::Epicardium];
    assert!(only(&both[..1], 8).starts_with("no wall: "));
    assert!(only(&both, 1).contains("needs at least two"));
    let message = refusal(&store(), &study, &query(9, None));
    assert_eq!(message, "there is no subject 9 among 2");
}

#[test]
fn stopped_and_wrongly_set_work_keeps_nothing() {
    let (study, store) = (study(), store());
    let mut wrong = query(0, None);
    wrong.settings.patches.core_threshold = 2.0;
    let message = refusal(&store, &study, &wrong);
    assert!(message.contains("core"), "{message}");
    let atoms = MedialSurfacesQuery {
        subject: 0,
        params: MedialParams::default(),
    };
    assert!(is_stopped(&store, &study, &query(0, None)));
    assert!(is_stopped(&store, &study, &atoms));
}

#[test]
fn settings_read_as_a_person_would_say_them() {
    assert_eq!(
        query(0, None).parameters(),
        "smoothed over 0.3 thicknesses, separation 60°, end 120°, tolerance of ln PT estimated from noise, \
         ratio as geometric mean, core threshold 0.2, akinetic threshold 0.095, extent threshold 0.4, \
         minimum area 0.02, minimum thickening 0.095, averaged over 0.01, 50 redraws, seed 2009"
    );
    assert!(query(0, Some(0.05)).parameters().contains("ln PT ± 0.05"));
}
