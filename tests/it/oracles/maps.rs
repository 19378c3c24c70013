//! Maps against SciPy and scikit-learn.

use super::*;

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
        most_iterations: 20_000,
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
