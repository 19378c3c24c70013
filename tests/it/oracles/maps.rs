//! Maps against SciPy and scikit-learn.

use super::*;
use cardiomorph::analysis::embedding::{
    LleParams, LocalWeights, Neighbours, isomap, lle, shortest_paths,
};

fn curves() -> (Case, DistanceMatrix) {
    let case = Case::load("embed", "mds_curves40");
    let square = case.numbers("inputs", "D");
    let upper = (0..40)
        .flat_map(|i| square[40 * i + i + 1..40 * (i + 1)].to_vec())
        .collect();
    (case, DistanceMatrix::from_upper(40, upper).unwrap())
}

/// What `scipy.spatial.procrustes` calls disparity: both maps centred and of size 1, one turned,
/// mirrored and scaled onto the other; the squared difference left.
fn disparity(map: &Embedding, expected: &[f64]) -> f64 {
    let unit = |coordinates: &[f64]| {
        let d = map.dimensions;
        let n = coordinates.len() / d;
        let mut matrix = nalgebra::DMatrix::from_row_slice(n, d, coordinates);
        for mut column in matrix.column_iter_mut() {
            let mean = column.mean();
            column.add_scalar_mut(-mean);
        }
        let norm = matrix.norm();
        matrix / norm
    };
    let (a, b) = (unit(&map.coordinates), unit(expected));
    let svd = (a.transpose() * &b).svd(true, true);
    let fitted = &a * (svd.u.unwrap() * svd.v_t.unwrap()) * svd.singular_values.sum();
    (fitted - b).norm_squared()
}

#[test]
fn classical_scaling_agrees_with_scipy() {
    let (case, distances) = curves();
    for (dimensions, key) in [(2, "classical_2d"), (3, "classical_3d")] {
        let map = classical_mds(&distances, dimensions, &Progress::default()).unwrap();
        let apart = disparity(&map, &case.numbers("expected", key));
        assert!(apart <= 1e-10, "{key}: {apart}");
        let found = map.eigenvalues.unwrap();
        for (found, expected) in found
            .iter()
            .zip(case.numbers("expected", "classical_eigenvalues"))
        {
            assert!((found - expected).abs() <= 3.013e-9);
        }
    }
}

#[test]
fn stress_majorisation_agrees_with_scikit_learn() {
    let (case, distances) = curves();
    let params = SmacofParams {
        max_iterations: 20_000,
        tolerance: 1e-14,
        ..SmacofParams::default()
    };
    let map = smacof(
        &distances,
        2,
        &params.check().unwrap(),
        &Progress::default(),
    )
    .unwrap();
    let raw = raw_stress(&distances, &map).unwrap();
    assert!(
        raw <= 1.0005 * case.number("smacof_stress_from_classical"),
        "{raw}"
    );
    close(
        "stress 1",
        map.stress.unwrap(),
        case.number("normalised_stress1"),
        5e-4,
    );
    let apart = disparity(&map, &case.numbers("expected", "smacof_from_classical"));
    assert!(apart <= 1e-5, "{apart}");
    let many = SmacofParams {
        random_starts: 8,
        ..params
    };
    let best = smacof(&distances, 2, &many.check().unwrap(), &Progress::default()).unwrap();
    let raw = raw_stress(&distances, &best).unwrap();
    assert!(
        raw <= 1.02 * case.number("smacof_best_stress_of_21_starts"),
        "{raw}"
    );
}

#[test]
fn the_map_of_the_window_is_within_the_stress_of_scikit_learn() {
    let (case, distances) = curves();
    let map = embed(&distances, MapMethod::Smacof, 2, &Progress::default()).unwrap();
    let raw = raw_stress(&distances, &map).unwrap();
    assert!(
        raw <= 1.0005 * case.number("smacof_stress_from_classical"),
        "{raw}"
    );
}

/// Points of a case, row by row, with their number, and the distances between them.
fn points(case: &Case) -> (Vec<f64>, usize, DistanceMatrix) {
    let points = case.numbers("inputs", "points");
    let items = case.value["inputs"]["points"]["shape"][0].as_u64().unwrap() as usize;
    let distances = DistanceMatrix::of_points(&points, items).unwrap();
    (points, items, distances)
}

#[test]
fn isomap_agrees_with_scikit_learn() {
    let case = Case::load("embed", "isomap_swiss300_k8");
    let (_, items, distances) = points(&case);
    let progress = Progress::default();
    let nearest = Neighbours::of_distances(&distances, 8, &progress).unwrap();
    let (ways, parts) = shortest_paths(&distances, &nearest, &progress).unwrap();
    assert_eq!(parts, 1);
    for (j, expected) in case.numbers("expected", "geodesic_row0").iter().enumerate() {
        assert!((ways.get(0, j) - expected).abs() <= 1e-9);
    }
    let sum = 2.0 * ways.upper().iter().sum::<f64>();
    close("sum", sum, case.number("geodesic_sum"), 1e-10);
    let longest = ways.upper().iter().fold(0.0_f64, |m, w| m.max(*w));
    close("longest", longest, case.number("geodesic_max"), 1e-10);
    let map = isomap(&distances, 8, 2, &progress).unwrap();
    assert_eq!(map.len(), items);
    let apart = disparity(&map, &case.numbers("expected", "embedding"));
    assert!(apart <= 1e-8, "{apart}");
    let values = map.eigenvalues.unwrap();
    for (found, expected) in values
        .iter()
        .zip(case.numbers("expected", "top2_eigenvalues"))
    {
        close("eigenvalue", *found, expected, 1e-8);
    }
    let expected = case.number("reconstruction_error");
    close("error", map.reconstruction_error.unwrap(), expected, 1e-8);
}

#[test]
fn locally_linear_maps_agree_with_numpy_and_scikit_learn() {
    for (name, neighbours) in [
        ("lle_swiss300_k12_reg0.001", 12),
        ("lle_curves40_k16_reg0.001", 16),
    ] {
        let case = Case::load("embed", name);
        let (points, items, _) = points(&case);
        let with = |dimensions| {
            let params = LleParams {
                neighbours,
                regularisation: 1e-3,
                dimensions,
            };
            params.check().unwrap()
        };
        let progress = Progress::default();
        let weights = LocalWeights::of_points(&points, items, &with(2), &progress).unwrap();
        let mut row: Vec<(f64, f64)> = (weights.neighbours().of(0).iter().zip(weights.of(0)))
            .map(|(&other, &weight)| (f64::from(other), weight))
            .collect();
        row.sort_by(|a, b| a.0.total_cmp(&b.0));
        let expected = (case.numbers("expected", "neighbours_row0").into_iter())
            .zip(case.numbers("expected", "weights_row0"));
        for ((other, weight), (expected_other, expected)) in row.iter().zip(expected) {
            assert_eq!(*other, expected_other);
            assert!((weight - expected).abs() <= 1e-8);
        }
        let map = lle(&points, items, &with(2), &progress).unwrap();
        for key in ["embedding", "sklearn_embedding"] {
            let apart = disparity(&map, &case.numbers("expected", key));
            assert!(apart <= 1e-6, "{name} {key}: {apart}");
        }
        let error = case.number("sklearn_reconstruction_error");
        close(name, map.reconstruction_error.unwrap(), error, 1e-5);
        assert_eq!(map.neighbours, Some(neighbours));
        let four = lle(&points, items, &with(4), &progress).unwrap();
        let expected = case.numbers("expected", "eigenvalues_bottom5");
        for (found, expected) in four.eigenvalues.unwrap().iter().zip(&expected[1..]) {
            close(name, *found, *expected, 1e-5);
        }
    }
}
