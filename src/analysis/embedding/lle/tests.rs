//! Known answers, laws and damage of the locally linear map.

use proptest::prelude::*;

use super::*;
use crate::analysis::embedding::{LleParamError, LleParams};
use crate::progress::Stopped;

fn params(neighbours: usize, dimensions: usize) -> CheckedLleParams {
    LleParams {
        neighbours,
        dimensions,
        ..LleParams::default()
    }
    .check()
    .unwrap()
}

/// Points on a rolled-up sheet; the place along the sheet and across it.
fn roll(items: usize) -> (Vec<f64>, Vec<[f64; 2]>) {
    let places: Vec<[f64; 2]> = (0..items)
        .map(|i| (i as f64 + 0.5) / items as f64)
        .map(|t| {
            [
                3.0 + 6.0 * t,
                (t * items as f64 * 0.618_033_988_749_895).fract() * 6.0,
            ]
        })
        .collect();
    let points = places
        .iter()
        .flat_map(|[t, y]| [t * t.cos(), *y, t * t.sin()])
        .collect();
    (points, places)
}

fn correlation(a: &[f64], b: &[f64]) -> f64 {
    let mean = |x: &[f64]| x.iter().sum::<f64>() / x.len() as f64;
    let (ma, mb) = (mean(a), mean(b));
    let sum = |f: &dyn Fn(f64, f64) -> f64| -> f64 {
        a.iter().zip(b).map(|(a, b)| f(a - ma, b - mb)).sum()
    };
    sum(&|a, b| a * b) / (sum(&|a, _| a * a) * sum(&|_, b| b * b)).sqrt()
}

#[test]
fn a_rolled_sheet_is_laid_flat_by_either_route() {
    for items in [150, 900] {
        let (points, places) = roll(items);
        let map = lle(&points, items, &params(10, 2), &Progress::default()).unwrap();
        let along: Vec<f64> = places.iter().map(|[t, _]| t * t).collect();
        let first: Vec<f64> = (0..items).map(|i| map.point(i)[0]).collect();
        let found = correlation(&first, &along).abs();
        assert!(found > 0.95, "{items}: {found}");
        assert_eq!(map.neighbours, Some(10));
        assert_eq!(map.parts, Some(1));
    }
}

#[test]
fn columns_are_orthonormal_and_centred_and_the_error_is_the_sum_of_eigenvalues() {
    for items in [60, 400] {
        let (points, _) = roll(items);
        let map = lle(&points, items, &params(8, 3), &Progress::default()).unwrap();
        for a in 0..3 {
            let sum: f64 = (0..items).map(|i| map.point(i)[a]).sum();
            assert!(sum.abs() < 1e-6, "{items}: {sum}");
            for b in 0..3 {
                let product: f64 = (0..items).map(|i| map.point(i)[a] * map.point(i)[b]).sum();
                let expected = f64::from(u8::from(a == b));
                assert!((product - expected).abs() < 1e-8, "{items}: {product}");
            }
        }
        let values = map.eigenvalues.unwrap();
        assert!(values.is_sorted());
        assert_eq!(map.reconstruction_error, Some(values.iter().sum()));
    }
}

#[test]
fn groups_that_do_not_see_each_other_get_more_neighbours() {
    let (near, _) = roll(20);
    let far: Vec<f64> = near.iter().map(|x| x + 100.0).collect();
    let points = [near, far].concat();
    let map = lle(&points, 40, &params(4, 2), &Progress::default()).unwrap();
    assert_eq!(map.parts, Some(2));
    assert!(map.neighbours.unwrap() >= 20);
    assert!(map.coordinates.iter().all(|x| x.is_finite()));
}

#[test]
fn damage_is_refused_with_numbers() {
    let progress = Progress::default();
    let line = [0.0, 1.0, 2.0, 3.0];
    assert_eq!(
        lle(&line, 4, &params(4, 1), &progress),
        Err(EmbeddingError::Neighbours {
            neighbours: 4,
            items: 4
        })
    );
    assert_eq!(
        lle(&line, 4, &params(2, 4), &progress),
        Err(EmbeddingError::Dimensions {
            dimensions: 4,
            items: 4
        })
    );
    assert!(lle(&[0.0, 1.0, f64::NAN, 3.0], 4, &params(2, 1), &progress).is_err());
    assert!(lle(&[], 0, &params(2, 1), &progress).is_err());
    let none = LleParams {
        neighbours: 0,
        ..LleParams::default()
    };
    assert_eq!(none.check(), Err(LleParamError::Neighbours));
    for regularisation in [0.0, -1.0, 2.0, f64::NAN] {
        let wrong = LleParams {
            regularisation,
            ..LleParams::default()
        };
        assert!(matches!(
            wrong.check(),
            Err(LleParamError::Regularisation(_))
        ));
    }
}

#[test]
fn items_that_all_coincide_still_have_a_map() {
    for items in [12, 300] {
        let points = vec![2.0; 3 * items];
        let map = lle(&points, items, &params(3, 2), &Progress::default()).unwrap();
        assert!(map.coordinates.iter().all(|x| x.is_finite()));
    }
}

#[test]
fn a_stopped_map_says_so() {
    let progress = Progress::default();
    progress.stop();
    let (points, _) = roll(300);
    let stopped = lle(&points, 300, &params(8, 2), &progress);
    assert_eq!(stopped, Err(EmbeddingError::Stopped(Stopped)));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn permuting_items_permutes_the_map(seed in 0_usize..1000) {
        let items = 70;
        let (points, _) = roll(items);
        // Steps that share no factor with 70 visit every item once.
        let step = [3, 9, 11, 13, 17, 19, 23, 27][seed % 8];
        let from = |i: usize| (i * step + seed) % items;
        let permuted: Vec<f64> = (0..items)
            .flat_map(|i| points[3 * from(i)..][..3].to_vec())
            .collect();
        let map = lle(&points, items, &params(9, 2), &Progress::default()).unwrap();
        let other = lle(&permuted, items, &params(9, 2), &Progress::default()).unwrap();
        for i in 0..items {
            for (a, b) in other.point(i).iter().zip(map.point(from(i))) {
                prop_assert!((a.abs() - b.abs()).abs() < 1e-6);
            }
        }
    }
}
