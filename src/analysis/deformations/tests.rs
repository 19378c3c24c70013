//! Laws of curves, maps and distances of whole deformations.

use std::sync::Arc;

use proptest::prelude::*;

use super::*;
use crate::analysis::embedding::Embedding;
use crate::analysis::pose_distances::{DistanceMatrix, PoseDistances, PoseId};
use crate::mesh::phantom;
use crate::progress::{Progress, Stopped};
use crate::study::{CycleTiming, MeshSequence, Study, Subject, SurfaceKind, SurfaceSequence};
use crate::units::{LengthUnit, Seconds};

mod parts;
mod settings;

/// One subject's way through a plane: a place per frame, at shares of the beat if they are not even.
#[derive(Clone)]
struct Way {
    places: Vec<[f64; 2]>,
    times: Option<Vec<f64>>,
    end_diastole: Option<usize>,
}

fn way(places: impl IntoIterator<Item = [f64; 2]>) -> Way {
    Way {
        places: places.into_iter().collect(),
        times: None,
        end_diastole: None,
    }
}

/// Once round an ellipse, beginning at its right end.
fn ellipse(frames: usize, width: f64, height: f64) -> Way {
    way((0..frames).map(|frame| {
        let angle = std::f64::consts::TAU * frame as f64 / frames as f64;
        [width * angle.cos(), height * angle.sin()]
    }))
}

fn study_of(ways: &[Way]) -> Study {
    let subject = |way: &Way| {
        let frames = vec![phantom::sphere(0, 1.0); way.places.len()];
        let surface = SurfaceSequence::new(SurfaceKind::Cavity, frames).unwrap();
        let sequence = MeshSequence::new(vec![surface]).unwrap();
        let mut subject = Subject::new("a", sequence, LengthUnit::Millimetre);
        subject.timing = CycleTiming {
            frame_times_s: way.times.clone(),
            rr: Some(Seconds(1.0)),
        };
        subject.end_diastole = way.end_diastole;
        Arc::new(subject)
    };
    Study {
        subjects: ways.iter().map(subject).collect(),
        ..Study::default()
    }
}

fn poses_of(ways: &[Way]) -> Vec<PoseId> {
    (ways.iter().enumerate())
        .flat_map(|(subject, way)| {
            (0..way.places.len()).map(move |frame| PoseId { subject, frame })
        })
        .collect()
}

fn map_of(ways: &[Way]) -> Embedding {
    Embedding {
        dimensions: 2,
        coordinates: (ways.iter().flat_map(|way| &way.places))
            .flatten()
            .copied()
            .collect(),
        ..Embedding::default()
    }
}

/// Euclidean distances of all places.
fn distances_of(ways: &[Way]) -> PoseDistances {
    let places: Vec<[f64; 2]> = ways.iter().flat_map(|way| way.places.clone()).collect();
    PoseDistances {
        poses: poses_of(ways),
        distances: DistanceMatrix::of_points(&places.concat(), places.len()).unwrap(),
        left_out: Vec::new(),
    }
}

fn mapped(ways: &[Way], params: DeformationMapParams) -> DeformationMap {
    deformation_map(
        &study_of(ways),
        &poses_of(ways),
        &map_of(ways),
        &params.check().unwrap(),
        &Progress::default(),
    )
    .unwrap()
}

fn between(ways: &[Way]) -> DistanceMatrix {
    let progress = Progress::default();
    deformation_distances(&study_of(ways), &distances_of(ways), &progress)
        .unwrap()
        .distances
}

/// Largest distance of corresponding points.
fn apart(a: &[[f64; 3]], b: &[[f64; 3]]) -> f64 {
    (a.iter().flatten().zip(b.iter().flatten()))
        .map(|(a, b)| (a - b).abs())
        .fold(0.0, f64::max)
}

#[test]
fn points_stand_at_equal_steps_along_the_chords() {
    let corner = [[0.0, 0.0, 0.0], [3.0, 0.0, 0.0], [3.0, 0.0, 1.0]];
    let points = resampled(&corner, 5);
    let expected = [
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [2.0, 0.0, 0.0],
        [3.0, 0.0, 0.0],
        [3.0, 0.0, 1.0],
    ];
    assert!(apart(&points, &expected) < 1e-15, "{points:?}");
}

#[test]
fn a_curve_that_stays_where_it_is_gives_that_place() {
    assert_eq!(
        resampled(&[[1.0, 2.0, 3.0]; 4], 3),
        vec![[1.0, 2.0, 3.0]; 3]
    );
    assert_eq!(resampled(&[[1.0, 2.0, 3.0]], 2), vec![[1.0, 2.0, 3.0]; 2]);
    assert!(resampled(&[], 3).is_empty());
    // Two frames at one place make a chord without length.
    let paused = [
        [0.0; 3],
        [0.0; 3],
        [2.0, 0.0, 0.0],
        [2.0, 0.0, 0.0],
        [4.0, 0.0, 0.0],
    ];
    assert_eq!(
        resampled(&paused, 3),
        [[0.0; 3], [2.0, 0.0, 0.0], [4.0, 0.0, 0.0]]
    );
}

proptest! {
    #[test]
    fn steps_along_any_curve_are_equally_long(
        curve in prop::collection::vec(prop::array::uniform3(-10.0..10.0_f64), 2..12),
        samples in 2..50_usize,
    ) {
        let points = resampled(&curve, samples);
        prop_assert_eq!(points.len(), samples);
        prop_assert!(apart(&points[..1], &curve[..1]) < 1e-12);
        prop_assert!(apart(&points[samples - 1..], &curve[curve.len() - 1..]) < 1e-12);
        // A chord between two points is never longer than the way between them.
        let length = |curve: &[[f64; 3]]| -> Vec<f64> {
            let step = |pair: &[[f64; 3]]| {
                (0..3).map(|k| (pair[0][k] - pair[1][k]).powi(2)).sum::<f64>().sqrt()
            };
            curve.windows(2).map(step).collect()
        };
        let whole: f64 = length(&curve).iter().sum();
        let most = whole / (samples - 1) as f64;
        prop_assert!(length(&points).iter().all(|step| *step <= most * (1.0 + 1e-9)));
    }
}

#[test]
fn one_way_at_another_speed_differs_only_by_its_time() {
    let steady = ellipse(16, 2.0, 1.0);
    let mut hurried = steady.clone();
    hurried.times = Some((0..16).map(|i| (f64::from(i) / 16.0).powi(2)).collect());
    let ways = [
        steady,
        hurried,
        ellipse(16, 1.0, 2.0),
        ellipse(16, 1.0, 1.0),
    ];
    let without_time = mapped(
        &ways,
        DeformationMapParams {
            time_weight: Some(0.0),
            ..DeformationMapParams::default()
        },
    );
    assert!(apart(&without_time.curves[0], &without_time.curves[1]) < 1e-12);
    assert!(apart(&without_time.curves[0], &without_time.curves[2]) > 0.5);
    let with_time = mapped(&ways, DeformationMapParams::default());
    assert!(apart(&with_time.curves[0], &with_time.curves[1]) > 0.1);
}

#[test]
fn a_time_that_all_curves_share_counts_after_resampling_and_not_before() {
    // Both go once to the right and back; the second is fast where the first is slow.
    let slow_start = way([[0.0, 0.0], [0.1, 0.0], [1.0, 0.0], [0.1, 0.0]]);
    let fast_start = way([[0.0, 0.0], [0.9, 0.0], [1.0, 0.0], [0.9, 0.0]]);
    let ways = [
        slow_start,
        fast_start,
        ellipse(4, 1.0, 1.0),
        ellipse(4, 2.0, 1.0),
    ];
    let squared = |a: &[[f64; 3]], b: &[[f64; 3]]| -> f64 {
        (a.iter().flatten().zip(b.iter().flatten()))
            .map(|(a, b)| (a - b).powi(2))
            .sum()
    };
    let stamped = |weight: f64, way: &Way| -> Vec<[f64; 3]> {
        let frames = way.places.len() as f64;
        (way.places.iter().zip(0..))
            .map(|(place, frame)| [place[0], place[1], weight * f64::from(frame) / frames])
            .collect()
    };
    let by_frame = |weight: f64| squared(&stamped(weight, &ways[0]), &stamped(weight, &ways[1]));
    assert_eq!(by_frame(0.0), by_frame(5.0), "finding 5 of the reading");
    let by_length = |weight: f64| {
        let params = DeformationMapParams {
            time_weight: Some(weight),
            ..DeformationMapParams::default()
        };
        let map = mapped(&ways, params);
        squared(&map.curves[0], &map.curves[1])
    };
    assert!(by_length(0.0) < 1e-24, "the ways are the same line");
    assert!(by_length(1.0) > 0.1, "{}", by_length(1.0));
}

#[test]
fn place_and_time_spread_alike_unless_a_weight_is_typed() {
    // Radii 2 and 3: the mean square radius is (4 + 9) / 2; 8 even times have variance 63 / 768.
    let ways = [
        ellipse(8, 2.0, 2.0),
        ellipse(8, 3.0, 3.0),
        ellipse(8, 2.0, 2.0),
        ellipse(8, 3.0, 3.0),
    ];
    let map = mapped(&ways, DeformationMapParams::default());
    let expected = (6.5 / (63.0 / 768.0_f64)).sqrt();
    assert!((map.time_weight.unwrap() - expected).abs() < 1e-12);
    assert_eq!(map.subjects, [0, 1, 2, 3]);
    // A beat ends where it began, one whole beat later.
    let curve = &map.curves[0];
    assert_eq!(curve.len(), 64);
    assert!((curve[63][2] - map.time_weight.unwrap()).abs() < 1e-12);
    assert!((curve[63][0] - curve[0][0]).abs() < 1e-12);
}

#[test]
fn deformations_of_two_kinds_lie_apart_in_the_plane() {
    let mut ways = Vec::new();
    for i in 0..8 {
        let size = 1.0 + 0.01 * f64::from(i);
        ways.push(ellipse(12, 2.0 * size, 1.0));
        ways.push(ellipse(12, 1.0, 2.0 * size));
    }
    let params = DeformationMapParams {
        neighbours: Some(10),
        ..DeformationMapParams::default()
    };
    let map = mapped(&ways, params);
    assert_eq!(map.embedding.len(), 16);
    assert_eq!(map.embedding.neighbours, Some(10));
    assert!(map.embedding.reconstruction_error.is_some());
    let gap = |i: usize, j: usize| {
        let (a, b) = (map.embedding.point(i), map.embedding.point(j));
        (a[0] - b[0]).hypot(a[1] - b[1])
    };
    for i in 0..16 {
        let nearest = (0..16)
            .filter(|j| *j != i)
            .min_by(|a, b| gap(i, *a).total_cmp(&gap(i, *b)));
        assert_eq!(nearest.unwrap() % 2, i % 2, "of {i}");
    }
}

#[test]
fn deformations_at_a_constant_distance_are_that_far_apart() {
    let here = ellipse(8, 2.0, 1.0);
    let mut there = here.clone();
    for place in &mut there.places {
        place[0] += 3.0;
        place[1] -= 4.0;
    }
    let matrix = between(&[here.clone(), there, here]);
    assert!((matrix.get(0, 1) - 5.0).abs() < 1e-12);
    assert!(matrix.get(0, 2) < 1e-12);
}

#[test]
fn frames_at_other_times_on_the_same_way_change_no_distance() {
    // The same triangle, with the corners only and with points on its sides, each at its time.
    let corners = way([[0.0, 0.0], [3.0, 0.0], [0.0, 3.0]]);
    let mut finer = way([[0.0, 0.0], [1.0, 0.0], [3.0, 0.0], [2.0, 1.0], [0.0, 3.0]]);
    finer.times = Some(vec![0.0, 1.0 / 9.0, 1.0 / 3.0, 4.0 / 9.0, 2.0 / 3.0]);
    let mut aside = finer.clone();
    aside.places.iter_mut().for_each(|place| place[1] += 2.0);
    let matrix = between(&[corners, finer, aside]);
    assert!(matrix.get(0, 1) < 1e-7, "{}", matrix.get(0, 1));
    assert!((matrix.get(0, 2) - 2.0).abs() < 1e-12);
}

#[test]
fn beats_are_compared_from_end_diastole_on() {
    let begins = ellipse(8, 2.0, 1.0);
    let mut recorded_later = begins.clone();
    recorded_later.places.rotate_right(3);
    let shifted = between(&[begins.clone(), recorded_later.clone()]);
    assert!(shifted.get(0, 1) > 0.5);
    recorded_later.end_diastole = Some(3);
    let ways = [
        begins,
        recorded_later,
        ellipse(8, 1.0, 1.0),
        ellipse(8, 1.0, 2.0),
    ];
    assert!(between(&ways).get(0, 1) < 1e-12);
    let map = mapped(&ways, DeformationMapParams::default());
    assert!(apart(&map.curves[0], &map.curves[1]) < 1e-12);
}

#[test]
fn times_that_make_no_beat_are_taken_as_even() {
    let even = ellipse(6, 2.0, 1.0);
    let mut odd = even.clone();
    odd.times = Some(vec![0.0, 0.5, 0.2, 0.3, 0.9, 0.1]);
    assert!(between(&[even, odd]).get(0, 1) < 1e-12);
}

#[test]
fn what_makes_no_map_is_said_with_its_numbers() {
    let ways = vec![ellipse(6, 2.0, 1.0); 3];
    let params = DeformationMapParams::default().check().unwrap();
    let ask = |poses: &[PoseId], map: &Embedding| {
        let progress = Progress::default();
        deformation_map(&study_of(&ways), poses, map, &params, &progress).unwrap_err()
    };
    let few = ask(&poses_of(&ways), &map_of(&ways));
    assert_eq!(few, DeformationMapError::TooFew { deformations: 3 });
    let words = "a deformation map needs at least 4 subjects, and there are 3";
    assert_eq!(few.to_string(), words);
    let other = ask(&poses_of(&ways), &map_of(&ways[..1]));
    assert_eq!(other.to_string(), "a map of 6 poses was given for 18 poses");
    let wrong = |params: DeformationMapParams| params.check().unwrap_err().to_string();
    let default = DeformationMapParams::default;
    let weight = DeformationMapParams {
        time_weight: Some(f64::NAN),
        ..default()
    };
    let samples = DeformationMapParams {
        samples: 1,
        ..default()
    };
    let regularisation = DeformationMapParams {
        regularisation: -0.5,
        ..default()
    };
    let neighbours = DeformationMapParams {
        neighbours: Some(0),
        ..default()
    };
    for (params, number) in [
        (weight, "NaN"),
        (samples, "not 1"),
        (regularisation, "-0.5"),
        (neighbours, "at least 1"),
    ] {
        assert!(wrong(params).contains(number), "{}", wrong(params));
    }
}

#[test]
fn no_poses_have_no_distances() {
    assert_eq!(between(&[]).size(), 0);
}

#[test]
fn a_stopped_map_and_stopped_distances_say_so() {
    let progress = Progress::default();
    progress.stop();
    let ways = vec![ellipse(6, 2.0, 1.0); 4];
    let study = study_of(&ways);
    let params = DeformationMapParams::default().check().unwrap();
    let map = deformation_map(&study, &poses_of(&ways), &map_of(&ways), &params, &progress);
    assert_eq!(map, Err(DeformationMapError::Stopped(Stopped)));
    let distances = deformation_distances(&study, &distances_of(&ways), &progress);
    assert_eq!(distances, Err(Stopped));
}
