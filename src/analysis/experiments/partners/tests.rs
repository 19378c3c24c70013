//! Partners are found where they are, and nowhere else.

use std::sync::Arc;

use super::*;
use crate::analysis::experiments::{SyntheticParams, synthetic_cohort};
use crate::analysis::pose_distances::DistanceMatrix;
use crate::mesh::Point3;
use crate::progress::Stopped;
use crate::study::{MeshSequence, Subject};

/// Twelve deformations of four classes; the id of each by its place.
fn study(id: impl Fn(usize) -> String) -> Study {
    let params = SyntheticParams {
        per_class: 3,
        ..SyntheticParams::default()
    };
    let mut study = synthetic_cohort(&params).unwrap().study().unwrap();
    for (index, subject) in study.subjects.iter_mut().enumerate() {
        *subject = Arc::new(Subject {
            id: id(index),
            ..(**subject).clone()
        });
    }
    study
}

/// The default and plain displacement, as they are.
fn quick() -> PartnerParams {
    let all = PartnerParams::all_metrics(CohortTransportParams::default());
    PartnerParams {
        methods: vec![all.methods[0], all.methods[8]],
        transport_options: all.transport_options[..1].to_vec(),
        untransported: Vec::new(),
    }
}

fn found(study: &Study, params: &PartnerParams) -> Vec<PartnerRow> {
    let found = partner_study(study, params, &Progress::default());
    found.unwrap().rows
}

#[test]
fn members_of_one_class_named_as_one_patient_are_nearest() {
    // Three of each class: two partners each, nine others.
    let rows = found(&study(|i| format!("P{}_{}", i / 3, i % 3)), &quick());
    assert_eq!(rows.len(), 2);
    for row in rows {
        let ranks = row.ranks;
        assert_eq!((ranks.pairs, ranks.nearest), (24, 24), "{row:?}");
        assert_eq!(ranks.nearer_than_median, 24);
        assert_eq!(ranks.mean_rank, 1.0);
        assert!((ranks.nearest_by_chance - 2.4).abs() < 1e-12);
        assert!((ranks.mean_rank_by_chance - 5.5).abs() < 1e-12);
    }
}

#[test]
fn members_of_other_classes_named_as_one_patient_are_far() {
    // Patient i has one deformation of each class; those of its own class are others.
    let rows = found(&study(|i| format!("P{}_{}", i % 3, i / 3)), &quick());
    for row in rows {
        assert_eq!((row.ranks.pairs, row.ranks.nearest), (36, 0), "{row:?}");
        assert!(row.ranks.mean_rank > 3.0, "{row:?}");
    }
}

#[test]
fn ranks_are_those_counted_by_hand() {
    // a1 a2 b1 b2 c: a2 is the second of a1, a1 the first of a2, b2 ties with c for b1.
    let upper = vec![2.0, 1.0, 3.0, 4.0, 5.0, 5.0, 6.0, 7.0, 7.0, 9.0];
    let whole = DeformationDistances {
        subjects: (0..5).collect(),
        distances: DistanceMatrix::from_upper(5, upper).unwrap(),
    };
    let ranks = ranked(&["a_1", "a_2", "b_1", "b_2", "c"], &whole);
    // a1: 2 among 1, 3, 4. a2: 2 among 5, 5, 6. b1: 7 among 1, 5, 7. b2: 7 among 3, 5, 9.
    assert_eq!((ranks.pairs, ranks.nearest), (4, 1));
    assert_eq!(ranks.nearer_than_median, 2);
    assert!((ranks.mean_rank - (2.0 + 1.0 + 4.0 + 3.0) / 4.0).abs() < 1e-12);
    assert!((ranks.nearest_by_chance - 1.0).abs() < 1e-12);
    assert!((ranks.mean_rank_by_chance - 2.5).abs() < 1e-12);
    assert!((ranks.mean_distance - 4.9).abs() < 1e-12);
}

#[test]
fn a_patient_is_what_stands_before_the_last_underscore() {
    assert_eq!(patient_of("Patient000151_rest"), Some("Patient000151"));
    assert_eq!(patient_of("a_b_2"), Some("a_b"));
    assert_eq!(patient_of("N01"), None);
    assert_eq!(patient_of("_rest"), None);
}

#[test]
fn a_study_without_partners_or_without_others_is_refused_with_the_reason() {
    let progress = Progress::default();
    let none = partner_study(&study(|i| format!("H{i}_0")), &quick(), &progress).unwrap_err();
    assert_eq!(none, ExperimentError::NoPartners { sequences: 12 });
    assert!(none.to_string().contains("P7_stress"), "{none}");
    let one = partner_study(&study(|i| format!("heart_{i}")), &quick(), &progress).unwrap_err();
    assert!(one.to_string().contains("one patient, heart"), "{one}");
    let empty = partner_study(&Study::default(), &quick(), &progress).unwrap_err();
    assert_eq!(empty, ExperimentError::NoPartners { sequences: 0 });
}

#[test]
fn hearts_that_move_alike_are_at_one_motion_wherever_they_lie() {
    let study = study(|i| format!("P{}_{}", i / 3, i % 3));
    let alike = one_motion_study(&study).unwrap();
    let (first, last) = (&alike.subjects[0].sequence, &alike.subjects[11].sequence);
    let pose = |s: &MeshSequence, frame: usize| s.pose(frame).unwrap();
    let own = pose(&study.subjects[11].sequence, 0);
    let gap = |a: &[Point3], b: &[Point3]| {
        (a.iter().zip(b)).fold(0.0_f64, |m, (p, q)| m.max((p - q).norm()))
    };
    assert!(gap(&pose(last, 0), &own) < 1e-12);
    assert!(gap(&pose(first, 2), &pose(&study.subjects[0].sequence, 2)) < 1e-12);
    let path = |s| -> f64 {
        let (a, b) = (pose(s, 0), pose(s, 2));
        (a.iter().zip(&b))
            .map(|(p, q)| (p - q).norm_squared())
            .sum()
    };
    let scales = |study: &Study| -> Vec<f64> {
        let (members, _) = comparable_subjects(study);
        members.iter().map(|m| m.scale.largest_side).collect()
    };
    let of = scales(&study);
    let ratio = path(last) / path(first) * (of[0] / of[11]).powi(2);
    assert!((ratio - 1.0).abs() < 1e-9, "{ratio}");
}

#[test]
fn partners_are_ranked_the_same_by_any_number_of_threads_and_stop_at_once() {
    let study = study(|i| format!("P{}_{}", i / 3, i % 3));
    let mut params = PartnerParams::all_metrics(CohortTransportParams::default());
    params.methods.truncate(1);
    params.transport_options.remove(1);
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
        let pool = pool.build().unwrap();
        pool.install(|| partner_study(&study, &params, &Progress::default()))
    };
    let one = on(1).unwrap();
    // Deformations stand once, whatever the transport.
    assert_eq!(one.rows.len(), 4 + 5);
    assert_eq!(one, on(3).unwrap());
    let progress = Progress::default();
    progress.stop();
    let stopped = partner_study(&study, &params, &progress).unwrap_err();
    assert_eq!(stopped, ExperimentError::Stopped(Stopped));
}
