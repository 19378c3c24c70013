//! Classes that are apart, that are not, and damaged input.

use proptest::prelude::*;

use super::*;

fn params(permutations: u32) -> CheckedClassesParams {
    ClassesParams {
        permutations,
        ..ClassesParams::default()
    }
    .check()
    .unwrap()
}

fn of_points(points: &[f64]) -> (DistanceMatrix, Embedding) {
    let distances = DistanceMatrix::of_points(points, points.len() / 2).unwrap();
    let plane = Embedding {
        dimensions: 2,
        coordinates: points.to_vec(),
        ..Embedding::default()
    };
    (distances, plane)
}

/// Points spread evenly in a square, those of every second row shifted.
fn square(rows: usize, shift: f64) -> Vec<f64> {
    (0..rows)
        .map(|i| (i as f64, if i % 2 == 0 { 0.0 } else { shift }))
        .flat_map(|(t, shift)| {
            [
                (0.754_877_666 * t).fract() + shift,
                (0.569_840_291 * t).fract(),
            ]
        })
        .collect()
}

fn alternating(rows: usize) -> Vec<Option<&'static str>> {
    (0..rows)
        .map(|i| Some(["normal", "abnormal"][i % 2]))
        .collect()
}

fn all(classes: &Classes) -> [Accuracy; 4] {
    [
        classes.tau.unwrap(),
        classes.nearest_neighbour.unwrap(),
        classes.linear_classifier.unwrap(),
        classes.plane_classifier.unwrap(),
    ]
}

#[test]
fn classes_that_are_far_apart_are_separated_by_every_criterion() {
    let (distances, plane) = of_points(&square(24, 5.0));
    let labels = alternating(24);
    let classes = classify(
        &distances,
        &plane,
        &labels,
        &params(500),
        &Progress::default(),
    )
    .unwrap();
    assert_eq!(classes.names, ["abnormal", "normal"]);
    assert_eq!(classes.of_row[..2], [Some(1), Some(0)]);
    assert_eq!(classes.class_of_cluster, [Some(1), Some(0)]);
    assert_eq!(classes.confusion, [[0, 12], [12, 0]]);
    for accuracy in all(&classes) {
        assert_eq!((accuracy.correct, accuracy.of), (24, 24));
        assert_eq!(accuracy.share(), 1.0);
        assert!(accuracy.p_value < 0.01, "{accuracy:?}");
        assert!((0.3..0.7).contains(&accuracy.baseline), "{accuracy:?}");
    }
}

#[test]
fn classes_that_are_not_apart_are_told_no_better_than_by_chance() {
    let (distances, plane) = of_points(&square(60, 0.0));
    // Labels that have nothing to do with places.
    let mut labels: Vec<_> = alternating(60);
    labels.shuffle(&mut ChaCha8Rng::seed_from_u64(5));
    let classes = classify(
        &distances,
        &plane,
        &labels,
        &params(500),
        &Progress::default(),
    )
    .unwrap();
    for accuracy in all(&classes) {
        assert!(accuracy.p_value > 0.02, "{accuracy:?}");
        assert!((accuracy.share() - accuracy.baseline).abs() < 0.2);
    }
    // The best match of clusters with two even classes is right more than half the time.
    assert!(classes.tau.unwrap().baseline > 0.5);
}

#[test]
fn rows_without_a_label_are_clustered_and_not_counted() {
    let (distances, plane) = of_points(&square(24, 5.0));
    let mut labels = alternating(24);
    labels[3] = None;
    labels[8] = None;
    let classes = classify(
        &distances,
        &plane,
        &labels,
        &params(50),
        &Progress::default(),
    )
    .unwrap();
    assert_eq!(classes.clustering.clusters.len(), 24);
    assert!(all(&classes).iter().all(|a| (a.correct, a.of) == (22, 22)));
}

#[test]
fn one_class_or_none_is_clustered_only() {
    let (distances, plane) = of_points(&square(10, 5.0));
    for labels in [vec![None; 10], vec![Some("normal"); 10]] {
        let classes = classify(
            &distances,
            &plane,
            &labels,
            &params(50),
            &Progress::default(),
        )
        .unwrap();
        assert_eq!(classes.tau, None);
        assert_eq!(classes.plane_classifier, None);
        assert_eq!(classes.clustering.clusters[..4], [0, 1, 0, 1]);
    }
    let nothing = classify(
        &DistanceMatrix::empty(),
        &Embedding {
            dimensions: 2,
            ..Embedding::default()
        },
        &[],
        &params(50),
        &Progress::default(),
    );
    assert_eq!(nothing, Ok(Classes::default()));
}

#[test]
fn two_cases_of_two_classes_have_an_answer() {
    let (distances, plane) = of_points(&[0.0, 0.0, 1.0, 1.0]);
    let labels = [Some("a"), Some("b")];
    let classes = classify(
        &distances,
        &plane,
        &labels,
        &params(50),
        &Progress::default(),
    )
    .unwrap();
    let [tau, nearest, linear, in_plane] = all(&classes);
    assert_eq!(tau.correct, 2);
    assert_eq!(tau.p_value, 1.0);
    assert_eq!(
        [nearest.correct, linear.correct, in_plane.correct],
        [0, 0, 0]
    );
}

#[test]
fn damage_is_refused_with_numbers() {
    let (distances, mut plane) = of_points(&square(6, 1.0));
    let labels = alternating(6);
    let of = |plane: &Embedding, labels: &[Option<&str>]| {
        classify(&distances, plane, labels, &params(10), &Progress::default())
    };
    assert_eq!(
        of(&plane, &labels[1..]),
        Err(ClassifyError::Rows {
            distances: 6,
            plane: 6,
            labels: 5
        })
    );
    plane.coordinates[7] = f64::NAN;
    assert_eq!(
        of(&plane, &labels),
        Err(ClassifyError::NotFinite { row: 3, axis: 1 })
    );
    let wrong = |change: fn(&mut ClassesParams)| {
        let mut params = ClassesParams::default();
        change(&mut params);
        params.check()
    };
    assert_eq!(
        wrong(|p| p.clusters = Some(0)),
        Err(ClassesParamError::Clusters)
    );
    assert_eq!(wrong(|p| p.restarts = 0), Err(ClassesParamError::Restarts));
    assert_eq!(
        wrong(|p| p.permutations = 0),
        Err(ClassesParamError::Permutations)
    );
    for shrinkage in [0.0, 1.5] {
        let params = ClassesParams {
            shrinkage,
            ..ClassesParams::default()
        };
        assert_eq!(params.check(), Err(ClassesParamError::Shrinkage(shrinkage)));
    }
}

#[test]
fn an_answer_that_is_stopped_says_so() {
    let progress = Progress::default();
    progress.stop();
    let (distances, plane) = of_points(&square(24, 5.0));
    let stopped = classify(
        &distances,
        &plane,
        &alternating(24),
        &params(500),
        &progress,
    );
    assert_eq!(stopped, Err(ClassifyError::Stopped(Stopped)));
}

#[test]
fn the_number_of_threads_changes_no_bit() {
    let (distances, plane) = of_points(&square(30, 0.4));
    let with = |threads| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        pool.install(|| {
            classify(
                &distances,
                &plane,
                &alternating(30),
                &params(200),
                &Progress::default(),
            )
        })
    };
    assert_eq!(with(1), with(4));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(16))]

    #[test]
    fn the_order_of_rows_changes_no_right_answer(turn in 1_usize..23, shift in 0.0_f64..2.0) {
        let points = square(24, shift);
        let labels = alternating(24);
        let from = |i: usize| (i + turn) % 24;
        let turned: Vec<f64> = (0..24).flat_map(|i| points[2 * from(i)..][..2].to_vec()).collect();
        let turned_labels: Vec<_> = (0..24).map(|i| labels[from(i)]).collect();
        let (distances, plane) = of_points(&points);
        let a = classify(&distances, &plane, &labels, &params(1), &Progress::default()).unwrap();
        let (distances, plane) = of_points(&turned);
        let b =
            classify(&distances, &plane, &turned_labels, &params(1), &Progress::default()).unwrap();
        for (a, b) in all(&a)[1..].iter().zip(&all(&b)[1..]) {
            prop_assert_eq!(a.correct, b.correct);
        }
    }
}
