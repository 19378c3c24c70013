//! Every setting of a question reaches the analysis: answers are those of the analysis asked directly.

use super::*;
use crate::analysis::classification::classify;
use crate::analysis::deformations::{
    PartParams, deformation_distances, deformation_map, map_of_parts, part_distances,
};
use crate::analysis::embedding::embed;
use crate::analysis::pose_distances::pose_distances_knowing;
use crate::analysis::transport::{Nearness, transported_motion};

/// Settings that are none of those the program starts with.
fn other_distances() -> PoseDistanceParams {
    PoseDistanceParams {
        metric: MetricParams::of(MetricKind::Isometric),
        smoothing: 0.0,
        ..PoseDistanceParams::default()
    }
}

fn other_deformations() -> DeformationMapQuery {
    DeformationMapQuery {
        poses: PoseMapQuery {
            distances: other_distances(),
            method: MapMethod::ClassicalMds,
        },
        map: DeformationMapParams {
            comparison: Comparison::Poses,
            time_weight: Some(0.3),
            samples: 20,
            ..DeformationMapParams::default()
        },
    }
}

/// Two classes, before them a heart that corresponds with none: rows are not subjects.
fn with_a_stranger() -> Arc<Study> {
    let mut study = Study::clone(&two_classes());
    let params = BuiltInParams {
        vertices: 300,
        ..BuiltInParams::default()
    };
    let stranger = cohort(&params).unwrap().study.subjects[0].clone();
    study.subjects.insert(0, stranger);
    Arc::new(study)
}

#[test]
fn a_map_of_deformations_is_made_with_all_of_its_settings() {
    let (study, progress) = (study(), Progress::default());
    let settings = other_deformations();
    let found = ask(&store(), &study, &settings);
    let checked = settings.poses.distances.check().unwrap();
    let poses = pose_distances_knowing(&study, &checked, None, &progress)
        .unwrap()
        .distances;
    let map = embed(&poses.distances, MapMethod::ClassicalMds, 2, &progress).unwrap();
    let params = settings.map.check().unwrap();
    let expected = deformation_map(&study, &poses.poses, &map, &params, &progress).unwrap();
    assert_eq!(*found, expected);
}

#[test]
fn parts_of_distances_are_those_of_all_settings() {
    let (study, progress) = (study(), Progress::default());
    let weights = PartWeights {
        deformation: 2.0,
        shape: 0.5,
    };
    let settings = DeformationMapQuery {
        map: DeformationMapParams {
            comparison: Comparison::Parts(weights),
            smoothing: 0.05,
            ..DeformationMapParams::default()
        },
        ..other_deformations()
    };
    let found = ask(&store(), &study, &settings);
    let params = PartParams {
        metric: other_distances().metric,
        transport: CohortTransportParams::default(),
        smoothing: 0.05,
        shape_smoothing: 0.0,
    };
    let parts = part_distances(&study, &params.check().unwrap(), &progress).unwrap();
    let checked = settings.map.check().unwrap();
    let expected = map_of_parts(&Arc::new(parts), weights, &checked, &progress);
    assert_eq!(*found, expected.unwrap());
}

#[test]
fn another_weight_of_a_part_maps_anew_what_was_compared_once() {
    let (study, store) = (study(), store());
    let with = |comparison| DeformationMapQuery {
        map: DeformationMapParams {
            comparison,
            ..DeformationMapParams::default()
        },
        ..DeformationMapQuery::default()
    };
    let alone = ask(&store, &study, &with(Comparison::default()));
    let both = ask(&store, &study, &with(Comparison::Parts(PartWeights::BOTH)));
    let [alone, both] = [alone, both].map(|map| map.parts.clone().unwrap());
    assert!(Arc::ptr_eq(&alone.parts, &both.parts));
    assert_ne!(alone.distances, both.distances);
    assert_eq!(store.answers::<DeformationPartsQuery>(), 1);
    assert_eq!(
        store.answers::<PoseDistancesQuery>(),
        0,
        "poses are not asked for"
    );
}

#[test]
fn classes_are_classified_with_their_own_distances_settings_and_labels() {
    let (study, store, progress) = (with_a_stranger(), store(), Progress::default());
    let settings = ClassesQuery {
        deformations: other_deformations(),
        classes: ClassesParams {
            permutations: 30,
            seed: 5,
            ..ClassesParams::default()
        },
        ..ClassesQuery::default()
    };
    let found = ask(&store, &study, &settings);
    let map = ask(&store, &study, &settings.deformations);
    let poses = ask(&store, &study, &PoseDistancesQuery(other_distances()));
    let whole = deformation_distances(&study, &poses, &progress).unwrap();
    assert_eq!(whole.subjects, (1..11).collect::<Vec<_>>());
    let labels: Vec<Option<&str>> = (study.subjects[1..].iter())
        .map(|subject| subject.label.as_deref())
        .collect();
    let checked = settings.classes.check().unwrap();
    let expected = classify(
        &whole.distances,
        &map.embedding,
        &labels,
        &checked,
        &progress,
    );
    assert_eq!(*found, expected.unwrap());
}

#[test]
fn a_motion_is_transported_with_the_settings_of_its_question() {
    let study = study();
    let params = TransportParams {
        interpolated_poses: 0,
        nearness: Nearness::Coordinates,
        ..TransportParams::default()
    };
    let query = MotionTransportQuery {
        params,
        ..transfer()
    };
    let found = ask(&store(), &study, &query);
    let (from, onto) = (&study.subjects[3], &study.subjects[0]);
    let checked = params.check().unwrap();
    let expected = transported_motion(from, onto, &checked, &Progress::default())
        .unwrap()
        .sequence;
    assert_eq!(found.sequence, expected);
}

#[test]
fn shares_of_faces_are_those_of_the_metric_and_of_both_hearts_as_they_are() {
    let (study, store) = (study(), store());
    let distances = other_distances();
    let query = ContributionQuery {
        distances,
        ..contribution()
    };
    let shares = ask(&store, &study, &query);
    let poses = ask(&store, &study, &PoseDistancesQuery(distances));
    let [i, j] =
        [query.a, query.b].map(|id| poses.poses.iter().position(|pose| *pose == id).unwrap());
    let squared = poses.distances.get(i, j).powi(2);
    assert!((shares.iter().sum::<f64>() - squared).abs() < 1e-9 * squared);
    let restated = edited(&study, query.b.subject, |subject| {
        subject.end_diastole = Some(1);
    });
    assert!(!Arc::ptr_eq(&shares, &ask(&store, &restated, &query)));
}
