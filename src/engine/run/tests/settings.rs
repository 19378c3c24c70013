//! Every setting of a request reaches the analysis: answers are those of the analysis asked directly.

use super::*;
use crate::analysis::metrics::{MetricKind, MetricParams};
use crate::analysis::transport::{Nearness, transported_motion};

/// Settings that are none of those the program starts with.
fn other_distances() -> PoseDistanceParams {
    PoseDistanceParams {
        metric: MetricParams {
            kind: MetricKind::Rigid,
            ..MetricParams::default()
        },
        smoothing: 0.0,
        ..PoseDistanceParams::default()
    }
}

fn other_deformations() -> DeformationMapSettings {
    DeformationMapSettings {
        poses: PoseMapParams {
            distances: other_distances(),
            method: MapMethod::ClassicalMds,
        },
        map: DeformationMapParams {
            time_weight: Some(0.3),
            samples: 20,
            ..DeformationMapParams::default()
        },
    }
}

/// Two classes, before them a heart that corresponds with none: rows are not subjects.
fn with_a_stranger() -> Study {
    let mut study = two_classes();
    let params = BuiltInParams {
        vertices: 300,
        ..BuiltInParams::default()
    };
    let stranger = cohort(&params).unwrap().study.subjects[0].clone();
    study.subjects.insert(0, stranger);
    study
}

#[test]
fn a_map_of_deformations_is_made_with_all_of_its_settings() {
    let (study, cache, progress) = (study(), Cache::default(), Progress::default());
    let settings = other_deformations();
    let request = AnalysisRequest::DeformationMap(settings);
    let outcome = run(&study, &request, &cache, &progress).unwrap();
    let checked = settings.poses.distances.check().unwrap();
    let poses = pose_distances_knowing(&study, &checked, None, &progress)
        .unwrap()
        .distances;
    let map = embed(&poses.distances, MapMethod::ClassicalMds, 2, &progress).unwrap();
    let params = settings.map.check().unwrap();
    let expected = deformation_map(&study, &poses.poses, &map, &params, &progress).unwrap();
    assert_eq!(**outcome.deformation_map().unwrap(), expected);
}

#[test]
fn classes_are_told_with_their_own_distances_settings_and_labels() {
    let (study, cache, progress) = (with_a_stranger(), Cache::default(), Progress::default());
    let settings = ClassesSettings {
        deformations: other_deformations(),
        classes: ClassesParams {
            permutations: 30,
            seed: 5,
            ..ClassesParams::default()
        },
    };
    let outcome = run(
        &study,
        &AnalysisRequest::Classes(settings),
        &cache,
        &progress,
    )
    .unwrap();
    let map = AnalysisRequest::DeformationMap(settings.deformations);
    let map = run(&study, &map, &cache, &progress).unwrap();
    let poses = AnalysisRequest::PoseDistances(other_distances());
    let poses = run(&study, &poses, &cache, &progress).unwrap();
    let whole = deformation_distances(&study, poses.pose_distances().unwrap(), &progress).unwrap();
    assert_eq!(whole.subjects, (1..11).collect::<Vec<_>>());
    let labels: Vec<Option<&str>> = (study.subjects[1..].iter())
        .map(|subject| subject.label.as_deref())
        .collect();
    let map = map.deformation_map().unwrap();
    let checked = settings.classes.check().unwrap();
    let expected = classify(
        &whole.distances,
        &map.embedding,
        &labels,
        &checked,
        &progress,
    );
    assert_eq!(**outcome.classes().unwrap(), expected.unwrap());
}

#[test]
fn a_beat_is_carried_with_the_settings_of_its_request() {
    let (study, cache, progress) = (study(), Cache::default(), Progress::default());
    let params = TransportParams {
        in_betweens: 0,
        nearness: Nearness::Coordinates,
        ..TransportParams::default()
    };
    let request = AnalysisRequest::Transfer {
        from: 3,
        onto: 0,
        params,
    };
    let outcome = run(&study, &request, &cache, &progress).unwrap();
    let (from, onto) = (&study.subjects[3], &study.subjects[0]);
    let checked = params.check().unwrap();
    let expected = transported_motion(from, onto, &checked, &progress).unwrap();
    assert_eq!(**outcome.transfer().unwrap(), expected);
}

#[test]
fn shares_of_faces_are_those_of_the_metric_and_of_both_hearts_as_they_are() {
    let (study, cache, progress) = (study(), Cache::default(), Progress::default());
    let AnalysisRequest::Contribution { a, b, .. } = contribution() else {
        panic!("another request");
    };
    let distances = other_distances();
    let request = AnalysisRequest::Contribution { a, b, distances };
    let ask = |study: &Study| {
        let outcome = run(study, &request, &cache, &progress).unwrap();
        Arc::clone(outcome.contribution().unwrap())
    };
    let shares = ask(&study);
    let poses = AnalysisRequest::PoseDistances(distances);
    let poses = run(&study, &poses, &cache, &progress).unwrap();
    let poses = poses.pose_distances().unwrap();
    let [i, j] = [a, b].map(|id| poses.poses.iter().position(|pose| *pose == id).unwrap());
    let squared = poses.distances.get(i, j).powi(2);
    assert!((shares.iter().sum::<f64>() - squared).abs() < 1e-9 * squared);
    let restated = edited(&study, b.subject, |subject| subject.end_diastole = Some(1));
    assert!(!Arc::ptr_eq(&shares, &ask(&restated)));
}
