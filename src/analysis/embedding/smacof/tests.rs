//! What stress majorisation must do.

use proptest::prelude::*;

use super::*;
use crate::analysis::embedding::raw_stress;

fn distances(points: &[[f64; 3]]) -> DistanceMatrix {
    DistanceMatrix::of_points(&points.concat(), points.len()).unwrap()
}

fn cloud(items: u32, flat: f64) -> Vec<[f64; 3]> {
    (0..items)
        .map(f64::from)
        .map(|i| {
            [
                (i * 0.7).sin() * 3.0,
                (i * 1.3).cos() * 2.0,
                flat * (i * 2.9).sin(),
            ]
        })
        .collect()
}

fn map_with(params: SmacofParams, matrix: &DistanceMatrix) -> Embedding {
    smacof(matrix, 2, &params.check().unwrap(), &Progress::default()).unwrap()
}

#[test]
fn distances_in_the_plane_are_kept_exactly() {
    let map = map_with(SmacofParams::default(), &distances(&cloud(30, 0.0)));
    assert!(map.stress.unwrap() < 1e-7);
}

#[test]
fn random_starts_never_make_the_map_worse_and_are_repeatable() {
    let matrix = distances(&cloud(25, 2.0));
    let alone = map_with(SmacofParams::default(), &matrix);
    let params = SmacofParams {
        random_starts: 5,
        seed: 7,
        ..SmacofParams::default()
    };
    let best = map_with(params, &matrix);
    assert!(best.stress.unwrap() <= alone.stress.unwrap() * (1.0 + 1e-12));
    assert_eq!(best, map_with(params, &matrix));
}

#[test]
fn the_number_of_threads_changes_no_bit() {
    let matrix = distances(&cloud(2_100, 2.0));
    let params = SmacofParams {
        max_iterations: 2,
        ..SmacofParams::default()
    };
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        pool.unwrap().install(|| map_with(params, &matrix))
    };
    assert!(row_blocks(2_100).len() > 1);
    assert_eq!(with(1), with(3));
}

#[test]
fn items_that_coincide_stay_finite() {
    let matrix = DistanceMatrix::from_upper(4, vec![0.0, 0.0, 1.0, 0.0, 1.0, 1.0]).unwrap();
    let map = map_with(SmacofParams::default(), &matrix);
    assert!(map.coordinates.iter().all(|x| x.is_finite()));
    for items in 0..3_usize {
        let upper = vec![1.0; items * items.saturating_sub(1) / 2];
        let few = DistanceMatrix::from_upper(items, upper).unwrap();
        assert_eq!(map_with(SmacofParams::default(), &few).len(), items);
    }
}

#[test]
fn a_tolerance_that_is_no_share_is_refused() {
    let params = SmacofParams {
        tolerance: f64::NAN,
        ..SmacofParams::default()
    };
    assert!(params.check().is_err());
}

#[test]
fn a_stopped_map_says_so() {
    let progress = Progress::default();
    progress.stop();
    let stopped = smacof(
        &distances(&cloud(9, 1.0)),
        2,
        &CheckedSmacofParams::default(),
        &progress,
    );
    assert_eq!(stopped, Err(EmbeddingError::Stopped(Stopped)));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]
    #[test]
    fn a_step_never_raises_the_stress(upper in prop::collection::vec(0.0..5.0_f64, 45)) {
        let matrix = DistanceMatrix::from_upper(10, upper).unwrap();
        let mut last = f64::INFINITY;
        for max_iterations in 0..12 {
            let params = SmacofParams { max_iterations, tolerance: 0.0, ..SmacofParams::default() };
            let stress = raw_stress(&matrix, &map_with(params, &matrix)).unwrap();
            prop_assert!(stress <= last * (1.0 + 1e-12));
            last = stress;
        }
    }

    #[test]
    fn renumbering_the_items_renumbers_the_map(shift in 1..29_usize) {
        let points = cloud(30, 2.0);
        let mut renumbered = points.clone();
        renumbered.rotate_left(shift);
        let params = SmacofParams { tolerance: 1e-13, max_iterations: 20_000, ..SmacofParams::default() };
        let map = map_with(params, &distances(&points));
        let other = map_with(params, &distances(&renumbered));
        for item in 0..30 {
            let place = (item + 30 - shift) % 30;
            for axis in 0..2 {
                let (x, y) = (map.point(item)[axis], other.point(place)[axis]);
                prop_assert!((x.abs() - y.abs()).abs() < 1e-4, "{x} {y}");
            }
        }
    }
}
