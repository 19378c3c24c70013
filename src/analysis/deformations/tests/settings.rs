//! Both orders, both axes, uneven times and every setting count.

use super::*;

#[test]
fn the_order_of_two_deformations_changes_no_distance() {
    let (a, b) = (ellipse(5, 2.0, 1.0), ellipse(8, 1.0, 1.5));
    let there = between(&[a.clone(), b.clone()]).get(0, 1);
    let back = between(&[b, a]).get(0, 1);
    assert!(
        there > 0.1 && (there - back).abs() < 1e-12,
        "{there} {back}"
    );
}

#[test]
fn the_weight_of_time_is_that_of_both_axes_together() {
    // The mean squares of the axes are 16 / 2 and 1 / 2.
    let ways = [(); 4].map(|()| ellipse(8, 4.0, 1.0));
    let map = mapped(&ways, DeformationMapParams::default());
    let expected = (8.5 / (63.0 / 768.0_f64)).sqrt();
    assert!((map.time_weight.unwrap() - expected).abs() < 1e-12);
}

#[test]
fn uneven_times_go_on_past_the_end_of_the_recording() {
    let mut begins = ellipse(4, 2.0, 1.0);
    begins.times = Some(vec![0.0, 0.1, 0.3, 0.6]);
    // The same beat, recorded from its third frame on.
    let mut later = begins.clone();
    later.places.rotate_left(2);
    later.times = Some(vec![0.0, 0.3, 0.7, 0.8]);
    later.end_diastole = Some(2);
    let ways = [begins, later, ellipse(4, 1.0, 1.0), ellipse(4, 2.0, 2.0)];
    assert!(between(&ways).get(0, 1) < 1e-7);
    let map = mapped(&ways, DeformationMapParams::default());
    assert!(apart(&map.curves[0], &map.curves[1]) < 1e-12);
}

#[test]
fn after_the_last_frame_a_beat_is_on_its_way_to_the_first() {
    let ways = [ellipse(4, 1.0, 1.0), ellipse(4, 1.0, 1.0)];
    let beats = beats::beats(&study_of(&ways), &poses_of(&ways));
    let between = beats[1].at(0.875);
    assert_eq!((between.from, between.to, between.share), (7, 4, 0.5));
}

#[test]
fn samples_and_regularisation_are_those_asked_for() {
    let ways: Vec<Way> = (0..6)
        .map(|i| {
            ellipse(
                8,
                2.0 + 0.3 * f64::from(i),
                1.0 + 0.2 * f64::from(i * i % 5),
            )
        })
        .collect();
    let with = |samples, regularisation| {
        let params = DeformationMapParams {
            samples,
            regularisation,
            ..DeformationMapParams::default()
        };
        mapped(&ways, params)
    };
    let (few, stiff) = (with(17, 1e-4), with(17, 0.5));
    assert!(few.curves.iter().all(|curve| curve.len() == 17));
    assert_ne!(few.embedding.coordinates, stiff.embedding.coordinates);
}

#[test]
fn neighbours_grow_with_the_cohort_and_never_exceed_it() {
    assert_eq!(
        [0, 1, 3, 4, 20, 23, 100].map(params::neighbours_of_curves),
        [0, 0, 2, 3, 10, 12, 50]
    );
    assert_eq!(
        [0, 1, 4, 23, 80, 100, 120, 900].map(default_neighbours),
        [0, 0, 3, 8, 8, 10, 12, 12]
    );
    let ways = vec![ellipse(6, 2.0, 1.0); 4];
    let asked = DeformationMapParams {
        neighbours: Some(30),
        ..DeformationMapParams::default()
    };
    assert_eq!(mapped(&ways, asked).embedding.neighbours, Some(3));
}
