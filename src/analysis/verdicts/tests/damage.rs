//! Laws, damage and "stop" on the same cohort.

use nalgebra::Rotation3;

use super::{assessed, classified, cohort, ill, input, measured, study};
use crate::analysis::verdicts::*;
use crate::mesh::{Point3, Vector3};
use crate::progress::{Progress, Stopped};

#[test]
fn hearts_of_another_study_are_refused() {
    let (hearts, labels) = cohort();
    let inputs: Vec<_> = hearts.iter().map(input).collect();
    let params = VerdictParams::default().check().unwrap();
    let found = verdicts(
        &study(&labels[1..]),
        &inputs,
        &params,
        None,
        &Progress::default(),
    );
    assert_eq!(
        found,
        Err(VerdictError::Count {
            examined: 17,
            subjects: 16
        })
    );
    let empty = verdicts(&study(&[]), &[], &params, None, &Progress::default()).unwrap();
    assert!(empty.subjects.is_empty());
}

#[test]
fn a_stopped_run_says_so() {
    let (hearts, labels) = cohort();
    let inputs: Vec<_> = hearts.iter().map(input).collect();
    let progress = Progress::default();
    progress.stop();
    let params = VerdictParams::default().check().unwrap();
    let found = verdicts(&study(&labels), &inputs, &params, None, &progress);
    assert_eq!(found, Err(VerdictError::Stopped(Stopped)));
}

#[test]
fn the_number_of_threads_changes_no_bit() {
    let (hearts, labels) = cohort();
    let with = |threads| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        pool.install(|| classified(&hearts, &labels))
    };
    assert_eq!(with(1), with(3));
}

#[test]
fn the_order_of_subjects_changes_no_verdict() {
    let (mut hearts, mut labels) = cohort();
    let first = classified(&hearts, &labels);
    hearts.rotate_left(5);
    labels.rotate_left(5);
    let turned = classified(&hearts, &labels);
    let count = hearts.len();
    for index in 0..count {
        let [a, b] = [
            assessed(&first, (index + 5) % count),
            assessed(&turned, index),
        ];
        assert!((a.probability - b.probability).abs() < 1e-6);
        assert_eq!(a.finding, b.finding);
        let back =
            |others: &[usize]| -> Vec<usize> { others.iter().map(|i| (i + 5) % count).collect() };
        assert_eq!(back(&b.similar_normal), a.similar_normal);
    }
    assert_eq!(first.quality.unwrap().auc, turned.quality.unwrap().auc);
}

#[test]
fn place_turn_and_scale_of_coordinates_change_no_feature() {
    let (beat, found) = ill(2);
    let turn = Rotation3::from_scaled_axis(Vector3::new(0.4, -1.0, 2.0));
    let mut moved = beat.clone();
    for frame in &mut moved.frames {
        for atom in &mut frame.atoms {
            atom.position = Point3::from(turn * atom.position.coords * 0.1) + Vector3::repeat(7.0);
            atom.radius *= 0.1;
            atom.spokes = atom.spokes.map(|spoke| turn * spoke);
        }
        frame
            .normals
            .iter_mut()
            .for_each(|normal| *normal = turn * *normal);
    }
    let features = [(beat, found), measured(moved)].map(|heart| input(&heart).unwrap().features);
    for feature in Feature::ALL {
        let [a, b] = [0, 1].map(|subject: usize| features[subject].get(feature));
        // Thickness is a length.
        let is_length = feature.unit() == FeatureUnit::Millimetres;
        let (Some(a), Some(b), false) = (a, b, is_length) else {
            continue;
        };
        // The subject's size is the largest side of an upright box, which turns do change.
        let most = if matches!(
            feature,
            Feature::MeanPositionDistance | Feature::MeanPoseDistance
        ) {
            0.05
        } else {
            1e-9
        };
        assert!((a - b).abs() < most, "{}: {a} {b}", feature.name());
    }
}

#[test]
fn settings_out_of_range_are_refused() {
    let default = VerdictParams::default();
    for params in [
        VerdictParams {
            min_labelled: 2,
            ..default
        },
        VerdictParams {
            min_wall_volume: 1.5,
            ..default
        },
        VerdictParams {
            permutations: 0,
            ..default
        },
    ] {
        assert!(params.check().is_err(), "{params:?}");
    }
}
