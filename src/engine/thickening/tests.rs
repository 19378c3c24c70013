//! What of a heart's answer is found again, what an edit leaves of it, and what it does to other answers.

use super::*;
use crate::analysis::pose_distances::PoseDistanceParams;
use crate::engine::activity::WorkKind;
use crate::engine::outcome::AnalysisOutcome;
use crate::study::built_in::{BuiltInParams, cohort};
use crate::study::{MeshSequence, Revision, Subject, SurfaceKind, SurfaceSequence};

/// Two hearts, the second with a patch.
fn study() -> Study {
    let params = BuiltInParams {
        vertices: 600,
        ..BuiltInParams::default()
    };
    let whole = cohort(&params).unwrap().study;
    let ill = whole.subjects.iter().find(|s| s.id.starts_with('P'));
    Study {
        subjects: vec![Arc::clone(&whole.subjects[0]), Arc::clone(ill.unwrap())],
        revision: Revision(7),
        ..whole
    }
}

/// The study after an edit of one subject.
fn edited(study: &Study, subject: usize, edit: impl FnOnce(&mut Subject)) -> Study {
    let mut after = study.clone();
    after.revision = Revision(study.revision.0 + 1);
    edit(Arc::make_mut(&mut after.subjects[subject]));
    after
}

fn request(subject: usize, tolerance: Option<f64>) -> AnalysisRequest {
    let mut params = ThickeningSettings::default();
    params.thickening.tolerance = tolerance;
    AnalysisRequest::Thickening { subject, params }
}

fn answer(study: &Study, request: &AnalysisRequest, cache: &Cache) -> Arc<SubjectThickening> {
    let outcome = run(study, request, cache, &Progress::default()).unwrap();
    Arc::clone(outcome.thickening().unwrap())
}

#[test]
fn another_tolerance_or_border_lays_no_ball_again() {
    let (study, cache) = (study(), Cache::default());
    let first = answer(&study, &request(1, None), &cache);
    let second = answer(&study, &request(1, Some(0.3)), &cache);
    assert!(Arc::ptr_eq(&first.beat, &second.beat));
    assert_ne!(first.thickening.steps, second.thickening.steps);
    let mut params = ThickeningSettings::default();
    params.thickening.border = 0.6;
    let wider = AnalysisRequest::Thickening { subject: 1, params };
    let third = answer(&study, &wider, &cache);
    assert!(Arc::ptr_eq(&first.beat, &third.beat));
    assert!(third.thickening.patches[0].share > first.thickening.patches[0].share);
    params.medial.smoothing = 0.0;
    let rough = AnalysisRequest::Thickening { subject: 1, params };
    assert_ne!(answer(&study, &rough, &cache).beat, first.beat);
}

#[test]
fn an_answer_survives_edits_of_other_hearts_and_of_labels() {
    let (study, cache) = (study(), Cache::default());
    let ask = request(1, None);
    let first = answer(&study, &ask, &cache);
    let other = edited(&study, 0, |subject| subject.end_diastole = Some(2));
    assert!(Arc::ptr_eq(&first, &answer(&other, &ask, &cache)));
    let renamed = edited(&study, 1, |subject| subject.label = Some("DCM".to_owned()));
    assert!(Arc::ptr_eq(&first, &answer(&renamed, &ask, &cache)));
}

#[test]
fn an_edit_that_the_answer_reads_brings_another_of_the_same_atoms() {
    let (study, cache) = (study(), Cache::default());
    let ask = request(1, None);
    let first = answer(&study, &ask, &cache);
    let edits: [fn(&mut Subject); 4] = [
        |subject| subject.end_diastole = Some(1),
        |subject| subject.end_systole = Some(2),
        |subject| subject.unit = crate::units::LengthUnit::FileUnit,
        |subject| subject.anatomy = None,
    ];
    for edit in edits {
        let after = edited(&study, 1, edit);
        let second = answer(&after, &ask, &cache);
        assert_ne!(*first, *second);
        assert!(Arc::ptr_eq(&first.beat, &second.beat));
    }
}

#[test]
fn going_through_many_hearts_pushes_out_no_distances_of_poses() {
    let (study, cache) = (study(), Cache::default());
    let distances = AnalysisRequest::PoseDistances(PoseDistanceParams::default());
    run(&study, &distances, &cache, &Progress::default()).unwrap();
    let outcome = run(&study, &request(1, None), &cache, &Progress::default()).unwrap();
    for heart in 0..1000 {
        cache.put(&study, request(heart, Some(0.5)), outcome.clone());
    }
    assert!(cache.get(&study, &distances).is_some());
    assert!(cache.get(&study, &request(999, Some(0.5))).is_some());
    assert!(cache.get(&study, &request(0, Some(0.5))).is_none());
    assert!(cache.len() < 200, "{}", cache.len());
}

#[test]
fn atoms_of_large_hearts_are_bounded_in_bytes_and_count_once() {
    let (study, cache) = (study(), Cache::default());
    let small = answer(&study, &request(1, None), &cache);
    // 400,000 atoms at one frame are 60 MB or more: three such beats fit, or a hundred answers about one.
    let mut beat = (*small.beat).clone();
    let frame = &mut beat.frames[0];
    frame.atoms = vec![frame.atoms[0]; 400_000];
    frame.normals = vec![frame.normals[0]; 400_000];
    frame.end = vec![None; 400_000];
    assert!(beat_bytes(&beat) > 50 << 20);
    let put = |subject: usize, tolerance: f64, beat: &Arc<MedialBeat>| {
        let found = SubjectThickening {
            beat: Arc::clone(beat),
            ..(*small).clone()
        };
        let outcome = AnalysisOutcome::Thickening(Arc::new(found));
        cache.put(&study, request(subject, Some(tolerance)), outcome);
    };
    let kept = |subject: usize, tolerance: f64| {
        let request = request(subject, Some(tolerance));
        cache.get(&study, &request).is_some()
    };
    let shared = Arc::new(beat);
    for step in 0..100 {
        put(0, f64::from(step), &shared);
    }
    assert!(kept(0, 0.0) && kept(0, 99.0));
    for heart in 1..6 {
        put(heart, 0.0, &Arc::new((*shared).clone()));
    }
    assert!(kept(5, 0.0) && kept(4, 0.0));
    assert!(!kept(1, 0.0) && !kept(0, 50.0));
}

#[test]
fn one_heart_alone_is_measured_as_it_is_in_its_study() {
    let study = study();
    let (alone, together) = (Cache::default(), Cache::default());
    run(
        &study,
        &AnalysisRequest::Measures,
        &together,
        &Progress::default(),
    )
    .unwrap();
    let ask = request(1, None);
    assert_eq!(
        *answer(&study, &ask, &alone),
        *answer(&study, &ask, &together)
    );
    assert!(alone.get(&study, &AnalysisRequest::Measures).is_none());
}

#[test]
fn places_are_told_per_atom_at_end_diastole() {
    let (study, cache) = (study(), Cache::default());
    let found = answer(&study, &request(1, None), &cache);
    let axis = found.axis.unwrap();
    assert!(axis.is_oriented() && found.without_axis.is_none());
    assert_eq!(found.segments.len(), found.beat.vertices.len());
    let atoms = &found.beat.frames[found.thickening.end_diastole].atoms;
    for (atom, (place, told)) in atoms.iter().zip(found.segments.iter().zip(&found.polar)) {
        assert_eq!(*place, segment(&axis, atom.position));
        assert_eq!(*told, Some(polar(&axis, atom.position)));
    }
    assert!(!found.thickening.patches[0].segments.is_empty());
}

#[test]
fn a_cavity_alone_and_a_single_frame_are_answered_in_words() {
    let study = study();
    let only = |kinds: &[SurfaceKind], frames: usize| {
        let mut after = edited(&study, 0, |_| {});
        let subject = Arc::make_mut(&mut after.subjects[0]);
        let surfaces = (kinds.iter())
            .map(|&kind| {
                let surface = subject.sequence.surface(kind).unwrap();
                SurfaceSequence::new(kind, surface.frames()[..frames].to_vec()).unwrap()
            })
            .collect();
        subject.sequence = MeshSequence::new(surfaces).unwrap();
        let error = run(
            &after,
            &request(0, None),
            &Cache::default(),
            &Progress::default(),
        );
        error.unwrap_err().to_string()
    };
    let both = [SurfaceKind::Endocardium, SurfaceKind::Epicardium];
    assert!(only(&both[..1], 8).starts_with("no wall: "));
    assert!(only(&both, 1).contains("needs at least two"));
    let none = request(9, None);
    let error = run(&study, &none, &Cache::default(), &Progress::default()).unwrap_err();
    assert_eq!(error.to_string(), "there is no subject 9 among 2");
}

#[test]
fn stopped_and_wrongly_set_work_keeps_nothing() {
    let (study, cache, progress) = (study(), Cache::default(), Progress::default());
    let mut params = ThickeningSettings::default();
    params.thickening.core = 2.0;
    let wrong = AnalysisRequest::Thickening { subject: 0, params };
    let error = run(&study, &wrong, &cache, &progress).unwrap_err();
    assert!(error.to_string().contains("core"), "{error}");
    progress.stop();
    let atoms = AnalysisRequest::MedialBeat {
        subject: 0,
        params: MedialParams::default(),
    };
    for request in [request(0, None), atoms] {
        let error = run(&study, &request, &cache, &progress).unwrap_err();
        assert_eq!(error, AnalysisError::Stopped(Stopped));
        assert_eq!(request.kind(), WorkKind::Medial);
    }
    assert!(cache.is_empty());
}

#[test]
fn settings_read_as_a_person_would_say_them() {
    assert_eq!(
        request(0, None).parameters(),
        "smoothed over 0.3 thicknesses, separation 60°, end 120°, tolerance of ln PT by noise, ratio as \
         geometric mean, core 0.2, still 0.095, border 0.4, least share 0.02, least thickening 0.095, \
         averaged over 0.01, 50 redraws, seed 2009"
    );
    assert!(request(0, Some(0.05)).parameters().contains("ln PT ± 0.05"));
    assert_eq!(request(0, None).name(), "Thickening");
}
