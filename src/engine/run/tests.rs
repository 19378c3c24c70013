//! Every request: what it is made of, what is found again, what a stop leaves.

use super::*;
use crate::analysis::classification::ClassesParams;
use crate::analysis::deformations::DeformationMapParams;
use crate::analysis::embedding::MapMethod;
use crate::analysis::geodesics::GeodesicParams;
use crate::analysis::pose_distances::PoseId;
use crate::analysis::transport::{CohortTransportParams, TransportParams};
use crate::study::built_in::{BuiltInParams, cohort};
use crate::study::{Revision, Study, Subject};
mod settings;

fn study() -> Study {
    of_cohort(|whole| whole[..4].to_vec())
}

fn of_cohort(choose: impl Fn(&[Arc<Subject>]) -> Vec<Arc<Subject>>) -> Study {
    let params = BuiltInParams {
        vertices: 200,
        ..BuiltInParams::default()
    };
    let whole = cohort(&params).unwrap().study;
    Study {
        subjects: choose(&whole.subjects),
        revision: Revision(7),
        ..whole
    }
}

fn map(method: MapMethod) -> AnalysisRequest {
    AnalysisRequest::PoseMap(PoseMapParams {
        method,
        ..PoseMapParams::default()
    })
}

#[test]
fn another_method_of_mapping_computes_no_distance_again() {
    let (study, cache, progress) = (study(), Cache::default(), Progress::default());
    let first = run(&study, &map(MapMethod::ClassicalMds), &cache, &progress).unwrap();
    let second = run(&study, &map(MapMethod::Smacof), &cache, &progress).unwrap();
    let (first, second) = (first.pose_map().unwrap(), second.pose_map().unwrap());
    assert!(Arc::ptr_eq(&first.distances, &second.distances));
    assert_ne!(first.embedding, second.embedding);
    assert_eq!(first.embedding.len(), 32);
}

#[test]
fn the_same_question_brings_the_same_answer_back() {
    let (study, cache, progress) = (study(), Cache::default(), Progress::default());
    let ask = || run(&study, &AnalysisRequest::Measures, &cache, &progress).unwrap();
    let (first, second) = (ask(), ask());
    assert!(Arc::ptr_eq(
        first.measures().unwrap(),
        second.measures().unwrap()
    ));
    let edited = Study {
        revision: Revision(8),
        ..study.clone()
    };
    let third = run(&edited, &AnalysisRequest::Measures, &cache, &progress).unwrap();
    assert!(!Arc::ptr_eq(
        first.measures().unwrap(),
        third.measures().unwrap()
    ));
}

#[test]
fn a_stopped_run_keeps_nothing() {
    let (study, cache, progress) = (study(), Cache::default(), Progress::default());
    progress.stop();
    for request in [AnalysisRequest::Measures, map(MapMethod::Smacof)] {
        let error = run(&study, &request, &cache, &progress).unwrap_err();
        assert_eq!(error, AnalysisError::Stopped(Stopped));
    }
    assert!(cache.is_empty());
}

#[test]
fn settings_out_of_range_are_an_answer_in_words() {
    let mut params = PoseDistanceParams::default();
    params.metric.lambda = -1.0;
    let error = run(
        &study(),
        &AnalysisRequest::PoseDistances(params),
        &Cache::default(),
        &Progress::default(),
    )
    .unwrap_err();
    assert!(error.to_string().contains("-1"), "{error}");
}

/// The first five hearts and the last five: normal ones and patients.
fn two_classes() -> Study {
    of_cohort(|whole| [&whole[..5], &whole[whole.len() - 5..]].concat())
}

/// The same study after an edit of one subject.
fn edited(study: &Study, index: usize, edit: impl FnOnce(&mut Subject)) -> Study {
    let mut subject = Subject::clone(&study.subjects[index]);
    edit(&mut subject);
    study.with_subject(index, subject, Revision(study.revision.0 + 1))
}

fn classes_request() -> AnalysisRequest {
    AnalysisRequest::Classes(ClassesSettings {
        classes: ClassesParams {
            permutations: 50,
            ..ClassesParams::default()
        },
        ..ClassesSettings::default()
    })
}

fn few_in_betweens() -> GeodesicParams {
    GeodesicParams {
        in_betweens: 1,
        max_iterations: 3,
        ..GeodesicParams::default()
    }
}

fn in_betweens() -> AnalysisRequest {
    AnalysisRequest::InBetweens {
        subject: 1,
        params: few_in_betweens(),
    }
}

fn interval(interval: usize) -> AnalysisRequest {
    AnalysisRequest::Interval {
        subject: 1,
        interval,
        params: few_in_betweens(),
    }
}

fn contribution() -> AnalysisRequest {
    let pose = |subject| PoseId { subject, frame: 3 };
    AnalysisRequest::Contribution {
        a: pose(0),
        b: pose(2),
        distances: PoseDistanceParams::default(),
    }
}

fn transfer() -> AnalysisRequest {
    AnalysisRequest::Transfer {
        from: 3,
        onto: 0,
        params: TransportParams {
            in_betweens: 0,
            ..TransportParams::default()
        },
    }
}

#[test]
fn deformations_are_mapped_from_the_map_of_poses_that_is_there() {
    let (study, cache, progress) = (study(), Cache::default(), Progress::default());
    let settings = DeformationMapSettings::default();
    let poses = run(
        &study,
        &AnalysisRequest::PoseMap(settings.poses),
        &cache,
        &progress,
    )
    .unwrap();
    let request = AnalysisRequest::DeformationMap(settings);
    let outcome = run(&study, &request, &cache, &progress).unwrap();
    let map = outcome.deformation_map().unwrap();
    assert_eq!(map.subjects, [0, 1, 2, 3]);
    assert_eq!(map.embedding.len(), 4);
    let begin = map.curves[2][0];
    let poses = poses.pose_map().unwrap();
    assert_eq!(poses.embedding.point(16), [begin[0], begin[1]]);
    // Distances, map of poses, map of deformations.
    assert_eq!(cache.len(), 3);
    let heavier = AnalysisRequest::DeformationMap(DeformationMapSettings {
        map: DeformationMapParams {
            time_weight: Some(2.0 * map.time_weight),
            ..settings.map
        },
        ..settings
    });
    run(&study, &heavier, &cache, &progress).unwrap();
    assert_eq!(cache.len(), 4, "only the last step anew");
}

#[test]
fn classes_are_told_apart_on_the_rows_of_the_deformation_map() {
    let (study, cache, progress) = (two_classes(), Cache::default(), Progress::default());
    let request = classes_request();
    let outcome = run(&study, &request, &cache, &progress).unwrap();
    let classes = outcome.classes().unwrap();
    assert_eq!(classes.of_row.len(), 10);
    assert_eq!(classes.names.len(), 2);
    assert_eq!(classes.nearest_neighbour.unwrap().of, 10);
    // A label taken away is one case less, and no distance is computed for that.
    let relabelled = edited(&study, 0, |subject| subject.label = None);
    let again = run(&relabelled, &request, &cache, &progress).unwrap();
    assert_eq!(again.classes().unwrap().nearest_neighbour.unwrap().of, 9);
}

#[test]
fn a_beat_has_in_betweens_in_every_interval_and_the_last_runs_into_the_first() {
    let (study, cache, progress) = (study(), Cache::default(), Progress::default());
    let outcome = run(&study, &in_betweens(), &cache, &progress).unwrap();
    let paths = outcome.in_betweens().unwrap();
    let sequence = &study.subjects[1].sequence;
    assert_eq!(paths.len(), sequence.frame_count());
    let last = paths.last().unwrap();
    assert_eq!(last.poses.len(), 3);
    assert_eq!(
        last.poses[0],
        sequence.pose(sequence.frame_count() - 1).unwrap()
    );
    assert_eq!(last.poses[2], sequence.pose(0).unwrap());
    let third = run(&study, &interval(2), &cache, &progress).unwrap();
    assert!(Arc::ptr_eq(third.interval().unwrap(), &paths[2]));
}

#[test]
fn the_interval_looked_at_is_found_first() {
    let (study, cache) = (study(), Cache::default());
    cache.look_at_interval(5);
    let progress = Progress::default();
    let watched = std::thread::scope(|scope| {
        scope.spawn(|| run(&study, &in_betweens(), &cache, &progress));
        while cache.is_empty() {
            std::thread::yield_now();
        }
        progress.stop();
        [5, 4].map(|i| cache.get(&study, &interval(i)).is_some())
    });
    assert_eq!(watched, [true, false]);
}

#[test]
fn a_stopped_beat_keeps_the_intervals_that_were_done() {
    let (study, cache, progress) = (study(), Cache::default(), Progress::default());
    run(&study, &interval(0), &cache, &progress).unwrap();
    progress.stop();
    let error = run(&study, &in_betweens(), &cache, &progress).unwrap_err();
    assert_eq!(error, AnalysisError::Stopped(Stopped));
    assert_eq!(cache.len(), 1);
}

#[test]
fn a_stopped_path_is_the_best_so_far_and_is_not_kept() {
    let (study, cache, progress) = (study(), Cache::default(), Progress::default());
    let endless = AnalysisRequest::Interval {
        subject: 1,
        interval: 0,
        params: GeodesicParams {
            in_betweens: 127,
            tolerance: 0.0,
            max_iterations: u32::MAX,
            ..GeodesicParams::default()
        },
    };
    let outcome = std::thread::scope(|scope| {
        let work = scope.spawn(|| run(&study, &endless, &cache, &progress));
        while progress.phase().is_empty() {
            std::thread::yield_now();
        }
        std::thread::sleep(std::time::Duration::from_millis(50));
        progress.stop();
        work.join().unwrap()
    });
    let path = outcome.unwrap().interval().cloned().unwrap();
    assert!(path.stopped && path.energy <= path.energy_linear);
    assert_eq!(path.poses.len(), 129);
    assert!(cache.is_empty());
}

#[test]
fn what_depends_on_shapes_alone_survives_an_edited_label() {
    let (study, cache, progress) = (study(), Cache::default(), Progress::default());
    let ask =
        |study: &Study, request: &AnalysisRequest| run(study, request, &cache, &progress).unwrap();
    let (path, beat) = (ask(&study, &interval(0)), ask(&study, &transfer()));
    let labelled = edited(&study, 1, |subject| subject.label = Some("MINF".to_owned()));
    let (path, again) = (
        path.interval().cloned().unwrap(),
        ask(&labelled, &interval(0)),
    );
    assert!(Arc::ptr_eq(&path, again.interval().unwrap()));
    let beat = beat.transfer().cloned().unwrap();
    assert!(Arc::ptr_eq(
        &beat,
        ask(&labelled, &transfer()).transfer().unwrap()
    ));
    let restated = edited(&study, 0, |subject| subject.end_diastole = Some(1));
    assert!(!Arc::ptr_eq(
        &beat,
        ask(&restated, &transfer()).transfer().unwrap()
    ));
}

#[test]
fn a_transferred_beat_begins_as_the_heart_that_it_moves() {
    let (study, cache, progress) = (study(), Cache::default(), Progress::default());
    let outcome = run(&study, &transfer(), &cache, &progress).unwrap();
    let (from, onto) = (&study.subjects[3].sequence, &study.subjects[0].sequence);
    let beat = outcome.transfer().unwrap();
    assert_eq!(beat.frame_count(), from.frame_count());
    assert_eq!(beat.pose(0), onto.pose(0));
    assert_ne!(beat.pose(3), onto.pose(3));
    assert_eq!(beat.correspondence(), onto.correspondence());
}

#[test]
fn shares_of_faces_sum_to_the_squared_distance_of_the_matrix() {
    let (study, cache, progress) = (study(), Cache::default(), Progress::default());
    let params = PoseDistanceParams::default();
    let distances = AnalysisRequest::PoseDistances(params);
    let distances = run(&study, &distances, &cache, &progress).unwrap();
    let distances = distances.pose_distances().unwrap();
    let [a, b] = [3, 21].map(|row| distances.poses[row]);
    let request = AnalysisRequest::Contribution {
        a,
        b,
        distances: params,
    };
    let outcome = run(&study, &request, &cache, &progress).unwrap();
    let shares = outcome.contribution().unwrap();
    assert_eq!(shares.len(), study.subjects[0].sequence.face_count());
    let whole: f64 = shares.iter().sum();
    let squared = distances.distances.get(3, 21).powi(2);
    assert!(
        (whole - squared).abs() < 1e-9 * squared,
        "{whole} {squared}"
    );
}

#[test]
fn distances_after_a_transfer_are_another_answer() {
    let (study, cache, progress) = (study(), Cache::default(), Progress::default());
    let ask = |transfer: Option<CohortTransportParams>| {
        let params = PoseDistanceParams {
            transport: transfer,
            ..PoseDistanceParams::default()
        };
        let outcome = run(
            &study,
            &AnalysisRequest::PoseDistances(params),
            &cache,
            &progress,
        );
        outcome.unwrap().pose_distances().unwrap().clone()
    };
    let straight = CohortTransportParams {
        in_betweens: 0,
        ..CohortTransportParams::default()
    };
    let (plain, carried) = (ask(None), ask(Some(straight)));
    assert_eq!(plain.poses, carried.poses);
    // End-diastole of all hearts is one pose then.
    assert!(plain.distances.get(0, 8) > 1e-2);
    assert!(carried.distances.get(0, 8) < 1e-9);
}

#[test]
fn no_request_answers_once_stopped_and_none_is_kept() {
    let (study, cache, progress) = (study(), Cache::default(), Progress::default());
    progress.stop();
    let deformations = AnalysisRequest::DeformationMap(DeformationMapSettings::default());
    for request in [
        deformations,
        classes_request(),
        in_betweens(),
        interval(0),
        transfer(),
        contribution(),
    ] {
        let error = run(&study, &request, &cache, &progress).unwrap_err();
        assert_eq!(error, AnalysisError::Stopped(Stopped), "{request:?}");
    }
    assert!(cache.is_empty());
}

#[test]
fn what_is_not_there_is_named() {
    let (study, cache, progress) = (study(), Cache::default(), Progress::default());
    let ask = |request: AnalysisRequest| {
        let answer = run(&study, &request, &cache, &progress);
        answer.unwrap_err().to_string()
    };
    assert_eq!(ask(interval(9)), "interval 9 of a beat of 8 frames");
    let params = TransportParams::default();
    let request = AnalysisRequest::Transfer {
        from: 0,
        onto: 4,
        params,
    };
    assert_eq!(ask(request), "there is no subject 4 among 4");
}
