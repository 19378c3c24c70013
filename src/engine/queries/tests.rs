//! Every question: what it is made of, what is found again, what a stop leaves.

use std::sync::Arc;

use super::*;
use crate::analysis::classification::ClassesParams;
use crate::analysis::deformations::{
    Comparison, DeformationMap, DeformationMapParams, PartWeights,
};
use crate::analysis::embedding::MapMethod;
use crate::analysis::geodesics::GeodesicParams;
use crate::analysis::metrics::{MetricKind, MetricParams};
use crate::analysis::pose_distances::{PoseDistanceParams, PoseDistances, PoseId};
use crate::analysis::thickening::ThickeningSettings;
use crate::analysis::transport::{CohortTransportParams, TransportParams};
use crate::engine::store::{Interrupted, Query, Store, StoreOptions};
use crate::progress::Progress;
use crate::study::built_in::{BuiltInParams, cohort};
use crate::study::{Revision, Study, Subject};
use crate::units::Seconds;

mod copies;
mod estimated;
mod settings;
mod stops;

pub(super) fn store() -> Store {
    Store::start(StoreOptions::default()).unwrap()
}

/// The answer to a question.
pub(super) fn ask<Q: Query>(store: &Store, study: &Arc<Study>, query: &Q) -> Arc<Q::Answer> {
    match store.answer(study, query, &Progress::default()) {
        Ok(answer) => answer,
        Err(why) => panic!("{query:?}: {why:?}"),
    }
}

/// The error of a question that has no answer.
pub(super) fn refusal<Q: Query>(store: &Store, study: &Arc<Study>, query: &Q) -> String {
    match store.answer(study, query, &Progress::default()) {
        Ok(_) => panic!("{query:?} has an answer"),
        Err(Interrupted::Stopped) => "stopped".to_owned(),
        Err(Interrupted::Failed(failure)) => failure.to_string(),
    }
}

/// Whether a question that is stopped from the beginning has no answer, and none is kept.
pub(super) fn is_stopped<Q: Query>(store: &Store, study: &Arc<Study>, query: &Q) -> bool {
    let progress = Progress::default();
    progress.stop();
    let answer = store.answer(study, query, &progress);
    matches!(answer, Err(Interrupted::Stopped)) && store.known(study, query).is_none()
}

fn study() -> Arc<Study> {
    of_cohort(|whole| whole[..4].to_vec())
}

fn of_cohort(choose: impl Fn(&[Arc<Subject>]) -> Vec<Arc<Subject>>) -> Arc<Study> {
    let params = BuiltInParams {
        vertices: 200,
        ..BuiltInParams::default()
    };
    let whole = cohort(&params).unwrap().study;
    Arc::new(Study {
        subjects: choose(&whole.subjects),
        revision: Revision(7),
        ..whole
    })
}

fn map(method: MapMethod) -> PoseMapQuery {
    PoseMapQuery {
        method,
        ..PoseMapQuery::default()
    }
}

#[test]
fn another_method_of_mapping_computes_no_distance_again() {
    let (study, store) = (study(), store());
    let first = ask(&store, &study, &map(MapMethod::ClassicalMds));
    let second = ask(&store, &study, &map(MapMethod::Smacof));
    assert!(Arc::ptr_eq(&first.distances, &second.distances));
    assert_ne!(first.embedding, second.embedding);
    assert_eq!(first.embedding.len(), 32);
}

#[test]
fn the_same_question_brings_the_same_answer_back() {
    let (study, store) = (study(), store());
    let first = ask(&store, &study, &MeasuresQuery);
    assert!(Arc::ptr_eq(&first, &ask(&store, &study, &MeasuresQuery)));
    let edited = Arc::new(Study {
        revision: Revision(8),
        ..Study::clone(&study)
    });
    assert!(!Arc::ptr_eq(&first, &ask(&store, &edited, &MeasuresQuery)));
}

#[test]
fn settings_out_of_range_are_an_answer_in_words() {
    let mut params = PoseDistanceParams::default();
    params.metric.lambda = -1.0;
    let message = refusal(&store(), &study(), &PoseDistancesQuery(params));
    assert!(message.contains("-1"), "{message}");
}

#[test]
fn settings_read_as_a_person_would_say_them() {
    assert_eq!(
        PoseMapQuery::default().parameters(),
        "displacement, smoothed over 0.1 √area, SMACOF"
    );
    assert_eq!(
        metric_words(&MetricParams::of(MetricKind::QuasiConformal)),
        "quasi-conformal, additive form, μ = 0.125, scale-invariant corner terms, λ = 0.25"
    );
    let angles = MetricParams::of(MetricKind::AnglePreserving);
    assert!(!metric_words(&angles).contains('μ'));
}

/// The first five hearts and the last five: normal ones and patients.
fn two_classes() -> Arc<Study> {
    of_cohort(|whole| [&whole[..5], &whole[whole.len() - 5..]].concat())
}

/// The same study after an edit of one subject.
pub(super) fn edited(study: &Study, index: usize, edit: impl FnOnce(&mut Subject)) -> Arc<Study> {
    let mut subject = Subject::clone(&study.subjects[index]);
    edit(&mut subject);
    Arc::new(study.with_subject(index, subject, Revision(study.revision.0 + 1)))
}

fn classes() -> ClassesQuery {
    ClassesQuery {
        classes: ClassesParams {
            permutations: 50,
            ..ClassesParams::default()
        },
        ..ClassesQuery::default()
    }
}

fn few_interpolated_poses() -> GeodesicParams {
    GeodesicParams {
        interpolated_poses: 1,
        max_iterations: 3,
        ..GeodesicParams::default()
    }
}

fn interpolated_poses() -> InterpolatedPosesQuery {
    InterpolatedPosesQuery {
        subject: 1,
        params: few_interpolated_poses(),
        looked_at: LookedAt::default(),
    }
}

fn interval(interval: usize) -> IntervalQuery {
    IntervalQuery {
        subject: 1,
        interval,
        params: few_interpolated_poses(),
    }
}

fn contribution() -> ContributionQuery {
    let pose = |subject| PoseId { subject, frame: 3 };
    ContributionQuery {
        a: pose(0),
        b: pose(2),
        distances: PoseDistanceParams::default(),
    }
}

fn transfer() -> MotionTransportQuery {
    MotionTransportQuery {
        from: 3,
        onto: 0,
        params: TransportParams {
            interpolated_poses: 0,
            ..TransportParams::default()
        },
    }
}

#[test]
fn deformations_are_mapped_from_the_map_of_poses_that_is_there() {
    let (study, store) = (study(), store());
    let settings = DeformationMapQuery {
        map: DeformationMapParams {
            comparison: Comparison::Poses,
            ..DeformationMapParams::default()
        },
        ..DeformationMapQuery::default()
    };
    let poses = ask(&store, &study, &settings.poses);
    let map = ask(&store, &study, &settings);
    assert_eq!(map.subjects, [0, 1, 2, 3]);
    assert_eq!(map.embedding.len(), 4);
    let begin = map.curves[2][0];
    assert_eq!(poses.embedding.point(16), [begin[0], begin[1]]);
    let heavier = DeformationMapQuery {
        map: DeformationMapParams {
            time_weight: map.time_weight.map(|weight| 2.0 * weight),
            ..settings.map
        },
        ..settings
    };
    ask(&store, &study, &heavier);
    let kept = [
        store.answers::<PoseDistancesQuery>(),
        store.answers::<PoseMapQuery>(),
        store.answers::<DeformationMapQuery>(),
    ];
    assert_eq!(kept, [1, 1, 2], "only the last step anew");
}

#[test]
fn classes_are_classified_on_the_rows_of_the_deformation_map() {
    let (study, store) = (two_classes(), store());
    let found = ask(&store, &study, &classes());
    assert_eq!(found.of_row.len(), 10);
    assert_eq!(found.names.len(), 2);
    assert_eq!(found.nearest_neighbour.unwrap().of, 10);
    // A label taken away is one case less, and no distance is computed for that.
    let relabelled = edited(&study, 0, |subject| subject.label = None);
    let again = ask(&store, &relabelled, &classes());
    assert_eq!(again.nearest_neighbour.unwrap().of, 9);
    assert_eq!(store.answers::<DeformationPartsQuery>(), 1);
}

#[test]
fn a_motion_has_interpolated_poses_in_every_interval_and_the_last_runs_into_the_first() {
    let (study, store) = (study(), store());
    let paths = ask(&store, &study, &interpolated_poses());
    let sequence = &study.subjects[1].sequence;
    assert_eq!(paths.len(), sequence.frame_count());
    let last = paths.last().unwrap();
    assert_eq!(last.poses.len(), 3);
    assert_eq!(
        last.poses[0],
        sequence.pose(sequence.frame_count() - 1).unwrap()
    );
    assert_eq!(last.poses[2], sequence.pose(0).unwrap());
    assert!(Arc::ptr_eq(&ask(&store, &study, &interval(2)), &paths[2]));
}

#[test]
fn the_interval_looked_at_is_found_first() {
    let (study, store) = (study(), store());
    let query = interpolated_poses();
    query.looked_at.set(5);
    store.ask(&study, &query);
    while store.answers::<IntervalQuery>() == 0 {
        std::thread::yield_now();
    }
    store.end_frame();
    store.end_frame();
    let known = |i: usize| store.known(&study, &interval(i)).is_some();
    assert_eq!([5, 4].map(known), [true, false]);
    // What was done stays.
    while store.busy() {
        std::thread::yield_now();
    }
    let done = store.answers::<IntervalQuery>();
    assert!((1..8).contains(&done), "{done}");
}

#[test]
fn what_depends_on_shapes_alone_survives_an_edited_label() {
    let (study, store) = (study(), store());
    let (path, beat) = (
        ask(&store, &study, &interval(0)),
        ask(&store, &study, &transfer()),
    );
    let poses = ask(&store, &study, &map(MapMethod::ClassicalMds));
    let labelled = edited(&study, 1, |subject| subject.label = Some("MINF".to_owned()));
    assert!(Arc::ptr_eq(&path, &ask(&store, &labelled, &interval(0))));
    assert!(Arc::ptr_eq(&beat, &ask(&store, &labelled, &transfer())));
    let again = ask(&store, &labelled, &map(MapMethod::ClassicalMds));
    assert!(Arc::ptr_eq(&poses, &again));
    let restated = edited(&study, 0, |subject| subject.end_diastole = Some(1));
    assert!(!Arc::ptr_eq(&beat, &ask(&store, &restated, &transfer())));
}

#[test]
fn a_transported_motion_begins_as_the_heart_that_it_moves() {
    let (study, store) = (study(), store());
    let motion = ask(&store, &study, &transfer());
    let beat = &motion.sequence;
    let (from, onto) = (&study.subjects[3].sequence, &study.subjects[0].sequence);
    assert_eq!(beat.frame_count(), from.frame_count());
    assert_eq!(beat.pose(0), onto.pose(0));
    assert_ne!(beat.pose(3), onto.pose(3));
    assert_eq!(beat.correspondence(), onto.correspondence());
}

#[test]
fn shares_of_faces_sum_to_the_squared_distance_of_the_matrix() {
    let (study, store) = (study(), store());
    let params = PoseDistanceParams::default();
    let distances: Arc<PoseDistances> = ask(&store, &study, &PoseDistancesQuery(params));
    let [a, b] = [3, 21].map(|row| distances.poses[row]);
    let query = ContributionQuery {
        a,
        b,
        distances: params,
    };
    let shares = ask(&store, &study, &query);
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
    let (study, store) = (study(), store());
    let distances = |transfer: Option<CohortTransportParams>| {
        let params = PoseDistanceParams {
            transport: transfer,
            ..PoseDistanceParams::default()
        };
        ask(&store, &study, &PoseDistancesQuery(params))
    };
    let straight = CohortTransportParams {
        interpolated_poses: 0,
        ..CohortTransportParams::default()
    };
    let (plain, transported) = (distances(None), distances(Some(straight)));
    assert_eq!(plain.poses, transported.poses);
    // End-diastole of all hearts is one pose then.
    assert!(plain.distances.get(0, 8) > 1e-2);
    assert!(transported.distances.get(0, 8) < 1e-9);
}

#[test]
fn times_of_frames_are_read_by_deformations_and_not_by_walls() {
    let (study, store) = (study(), store());
    let (wall, map) = (
        WallThickeningQuery {
            subject: 1,
            settings: ThickeningSettings::default(),
        },
        DeformationMapQuery::default(),
    );
    let before = (ask(&store, &study, &wall), ask(&store, &study, &map));
    let later = edited(&study, 1, |subject| {
        subject.timing.frame_times_s = Some(vec![0.0, 0.1, 0.2, 0.3, 0.5, 0.6, 0.7, 0.8]);
        subject.timing.rr = Some(Seconds(1.0));
    });
    let after = (ask(&store, &later, &wall), ask(&store, &later, &map));
    assert!(Arc::ptr_eq(&before.0, &after.0));
    let apart = |map: &DeformationMap| map.parts.as_ref().unwrap().parts.deformation.get(0, 1);
    assert_ne!(apart(&before.1), apart(&after.1));
}

#[test]
fn what_is_not_there_is_named() {
    let (study, store) = (study(), store());
    let message = refusal(&store, &study, &interval(9));
    assert_eq!(message, "there is no interval 9 in a sequence of 8 frames");
    let query = MotionTransportQuery {
        from: 0,
        onto: 4,
        params: TransportParams::default(),
    };
    let message = refusal(&store, &study, &query);
    assert_eq!(message, "there is no subject 4 among 4");
    let nobody = InterpolatedPosesQuery {
        subject: 4,
        ..interpolated_poses()
    };
    assert_eq!(refusal(&store, &study, &nobody), message);
}
