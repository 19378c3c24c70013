//! Distances that an edit leaves as they were are not computed again, and no bit depends on that.

use std::sync::Arc;

use super::tests::{beat, subject};
use super::*;
use crate::analysis::pose_distances::{ComputedDistances, PoseDistanceParams};
use crate::analysis::transport::{CohortTransportParams, Reference};
use crate::mesh::TriMesh;
use crate::study::{ShapeKey, Subject};

fn study(subjects: &[Arc<Subject>]) -> Study {
    Study {
        subjects: subjects.to_vec(),
        ..Study::default()
    }
}

fn hearts() -> Vec<Arc<Subject>> {
    vec![
        subject("a", beat(40.0, 0.3, 5)),
        subject("b", beat(50.0, 0.1, 4)),
        subject("c", beat(45.0, 0.5, 3)),
    ]
}

fn transported_to(reference: Reference) -> PoseDistanceParams {
    PoseDistanceParams {
        transport: Some(CohortTransportParams {
            reference,
            in_betweens: 0,
            ..CohortTransportParams::default()
        }),
        ..PoseDistanceParams::default()
    }
}

fn computed(
    study: &Study,
    params: PoseDistanceParams,
    before: Option<(&Study, &ComputedDistances)>,
) -> ComputedDistances {
    let shapes: Vec<ShapeKey> = before
        .iter()
        .flat_map(|(study, _)| study.subjects.iter().map(|s| s.shape_key()))
        .collect();
    let known = before.map(|(_, computed)| KnownDistances {
        shapes: &shapes,
        distances: &computed.distances,
    });
    let params = params.check().unwrap();
    pose_distances_knowing(study, &params, known.as_ref(), &Progress::default()).unwrap()
}

/// Pairs computed for `after` when `before` is known; the answer must be that of a fresh start.
fn new_pairs(before: &Study, after: &Study, params: PoseDistanceParams) -> usize {
    let first = computed(before, params, None);
    let second = computed(after, params, Some((before, &first)));
    let fresh = computed(after, params, None);
    assert_eq!(second.distances, fresh.distances);
    let poses = fresh.distances.poses.len();
    assert_eq!(fresh.new_pairs, poses * (poses - 1) / 2);
    second.new_pairs
}

fn edited(subjects: &[Arc<Subject>], index: usize, edit: impl FnOnce(&mut Subject)) -> Study {
    let mut study = study(subjects);
    let mut subject = Subject::clone(&study.subjects[index]);
    edit(&mut subject);
    study.subjects[index] = Arc::new(subject);
    study
}

#[test]
fn one_more_subject_costs_its_own_rows() {
    let hearts = hearts();
    let plain = PoseDistanceParams::default();
    // 3 poses against 9 and among each other.
    assert_eq!(new_pairs(&study(&hearts[..2]), &study(&hearts), plain), 30);
    // The same in the middle: the order of the others stays.
    let two = study(&[Arc::clone(&hearts[0]), Arc::clone(&hearts[2])]);
    assert_eq!(new_pairs(&two, &study(&hearts), plain), 4 * 8 + 6);
    assert_eq!(new_pairs(&study(&hearts), &two, plain), 0);
}

#[test]
fn an_edited_label_costs_nothing_and_an_edited_end_diastole_its_rows() {
    let hearts = hearts();
    let plain = PoseDistanceParams::default();
    let labelled = edited(&hearts, 1, |subject| {
        subject.label = Some("MINF".to_owned());
    });
    assert_eq!(new_pairs(&study(&hearts), &labelled, plain), 0);
    let restated = edited(&hearts, 1, |subject| subject.end_diastole = Some(2));
    assert_eq!(new_pairs(&study(&hearts), &restated, plain), 4 * 8 + 6);
}

#[test]
fn pairs_in_another_order_are_computed_anew() {
    let hearts = hearts();
    let turned = study(&[Arc::clone(&hearts[1]), Arc::clone(&hearts[0])]);
    let plain = PoseDistanceParams::default();
    assert_eq!(new_pairs(&study(&hearts[..2]), &turned, plain), 20);
}

#[test]
fn after_a_transfer_distances_are_kept_while_the_reference_is_the_same() {
    let hearts = hearts();
    let (two, three) = (study(&hearts[..2]), study(&hearts));
    let onto_first = transported_to(Reference::Subject(0));
    assert_eq!(new_pairs(&two, &three, onto_first), 30);
    // The mean of three is not that of two.
    assert_eq!(new_pairs(&two, &three, transported_to(Reference::Mean)), 66);
    let labelled = edited(&hearts, 1, |subject| {
        subject.label = Some("MINF".to_owned());
    });
    for params in [onto_first, transported_to(Reference::Mean)] {
        assert_eq!(new_pairs(&three, &labelled, params), 0);
    }
    let restated = edited(&hearts, 0, |subject| subject.end_diastole = Some(1));
    assert_eq!(new_pairs(&three, &restated, onto_first), 66);
}

#[test]
fn one_motion_of_two_hearts_is_no_distance_after_a_transfer() {
    // Two shapes, each moved by one field of displacements.
    let rest = beat(40.0, 0.0, 1).remove(0);
    let other = beat(40.0, 0.4, 3).remove(1);
    let grown = |mesh: &TriMesh, by: f64| {
        let points: Vec<_> = mesh.vertices().iter().map(|p| p * by).collect();
        TriMesh::new(points, Arc::clone(mesh.faces())).unwrap()
    };
    let moved = |mesh: &TriMesh| vec![mesh.clone(), grown(mesh, 1.1)];
    let study = study(&[subject("a", moved(&rest)), subject("b", moved(&other))]);
    let plain = computed(&study, PoseDistanceParams::default(), None).distances;
    let transported = computed(&study, transported_to(Reference::Subject(0)), None).distances;
    // At end-diastole all are the reference.
    assert!(plain.distances.get(0, 2) > 1e-2);
    assert!(transported.distances.get(0, 2) < 1e-12);
    assert!(transported.distances.get(1, 3) < 0.3 * plain.distances.get(1, 3));
}

#[test]
fn a_reference_that_is_not_there_is_said() {
    let study = study(&hearts());
    let params = transported_to(Reference::Subject(7)).check().unwrap();
    let error = pose_distances(&study, &params, &Progress::default()).unwrap_err();
    assert!(error.to_string().contains("subject 7 of 3"), "{error}");
}

#[test]
fn a_stopped_transfer_says_so() {
    let progress = Progress::default();
    progress.stop();
    let params = transported_to(Reference::Mean).check().unwrap();
    let stopped = pose_distances(&study(&hearts()), &params, &progress);
    assert_eq!(stopped, Err(PoseDistanceError::Stopped(Stopped)));
}
