//! Maps of very large or very small distances: computed in a unit in which their squares are numbers.

use crate::analysis::pose_distances::DistanceMatrix;
use crate::numeric::moderate_unit;

use super::{Embedding, EmbeddingError};

/// The map of distances, made in a unit in which their squares neither overflow nor vanish, and given in theirs.
///
/// # Errors
/// As `map`, and if a coordinate is beyond the largest number.
pub(super) fn in_moderate_unit(
    distances: &DistanceMatrix,
    map: impl FnOnce(&DistanceMatrix) -> Result<Embedding, EmbeddingError>,
) -> Result<Embedding, EmbeddingError> {
    let unit = moderate_unit(distances.upper().iter().fold(0.0, |most, d| d.max(most)));
    if unit == 1.0 {
        return map(distances);
    }
    let moderate = distances.upper().iter().map(|d| d / unit).collect();
    let moderate =
        DistanceMatrix::from_upper(distances.size(), moderate).ok_or(EmbeddingError::TooLarge)?;
    back_in(unit, map(&moderate)?)
}

/// A map whose items were divided by `unit`, in the unit of the items. Eigenvalues and errors count squares of
/// distances; where those are no numbers there are none.
///
/// # Errors
/// If a coordinate is beyond the largest number.
pub(super) fn back_in(unit: f64, mut map: Embedding) -> Result<Embedding, EmbeddingError> {
    if unit == 1.0 {
        return Ok(map);
    }
    map.coordinates.iter_mut().for_each(|x| *x *= unit);
    if map.coordinates.iter().any(|x| !x.is_finite()) {
        return Err(EmbeddingError::TooLarge);
    }
    let squared = |value: f64| Some(value * unit * unit).filter(|_| (unit * unit).is_normal());
    map.eigenvalues = (map.eigenvalues)
        .and_then(|values| {
            values
                .into_iter()
                .map(squared)
                .collect::<Option<Vec<f64>>>()
        })
        .filter(|values| values.iter().all(|value| value.is_finite()));
    map.reconstruction_error = (map.reconstruction_error)
        .and_then(squared)
        .filter(|error| error.is_finite());
    Ok(map)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::embedding::{
        CheckedLleParams, LleParams, MapMethod, classical_mds, embed, isomap, lle, pca, smacof,
    };
    use crate::progress::Progress;

    fn points(unit: f64) -> Vec<f64> {
        (0..20)
            .map(f64::from)
            .flat_map(|i| {
                [
                    (0.7 * i).sin() * 3.0,
                    (1.3 * i).cos() * 2.0,
                    (2.9 * i).sin(),
                ]
            })
            .map(|x| x * unit)
            .collect()
    }

    /// Powers of two, so that equal shapes are equal bit for bit.
    const UNITS: [i32; 4] = [-900, -300, 300, 900];

    #[test]
    fn maps_of_huge_and_tiny_distances_are_those_of_moderate_ones() {
        let progress = Progress::default();
        let of = |unit: f64| DistanceMatrix::of_points(&points(unit), 20).unwrap();
        let methods = [
            MapMethod::ClassicalMds,
            MapMethod::Smacof,
            MapMethod::Isomap { neighbours: 5 },
        ];
        for method in methods {
            let expected = embed(&of(1.0), method, 2, &progress).unwrap();
            for power in UNITS {
                let unit = 2.0_f64.powi(power);
                let map = embed(&of(unit), method, 2, &progress).unwrap();
                assert_eq!(map.stress, expected.stress, "{method:?} {power}");
                for (x, y) in map.coordinates.iter().zip(&expected.coordinates) {
                    assert!((x / unit - y).abs() < 1e-12, "{method:?} {power}: {x} {y}");
                }
                let finite =
                    |values: &Option<Vec<f64>>| values.iter().flatten().all(|v| v.is_finite());
                assert!(finite(&map.eigenvalues));
            }
        }
    }

    #[test]
    fn components_and_neighbourhoods_do_not_change_with_the_unit() {
        let progress = Progress::default();
        let params = LleParams {
            neighbours: 6,
            ..LleParams::default()
        }
        .check()
        .unwrap();
        let parts = |unit: f64| {
            let points = points(unit);
            let components = pca(&points, 20, 2, &progress).unwrap();
            (components, lle(&points, 20, &params, &progress).unwrap())
        };
        let (components, local) = parts(1.0);
        for power in UNITS {
            let unit = 2.0_f64.powi(power);
            let (huge, again) = parts(unit);
            assert_eq!(again.coordinates, local.coordinates);
            for (x, y) in huge.coordinates.iter().zip(&components.coordinates) {
                assert!((x / unit - y).abs() < 1e-12);
            }
        }
        let _: CheckedLleParams = params;
    }

    #[test]
    fn distances_of_1e200_make_a_triangle_of_1e200() {
        let far = DistanceMatrix::from_upper(3, vec![1e200; 3]).unwrap();
        let progress = Progress::default();
        for map in [
            smacof(&far, 2, &Default::default(), &progress).unwrap(),
            classical_mds(&far, 2, &progress).unwrap(),
        ] {
            let [a, b] = [map.point(0), map.point(1)];
            let apart = (a[0] - b[0]).hypot(a[1] - b[1]);
            assert!((apart / 1e200 - 1.0).abs() < 1e-6, "{apart:e}");
            assert!(map.stress.unwrap() < 1e-6);
            assert_eq!(map.eigenvalues, None);
        }
    }

    #[test]
    fn a_way_longer_than_any_number_is_an_error_and_no_infinity() {
        let chain = DistanceMatrix::of_pairs(4, |i, j| 0.5e308 * (j - i) as f64).unwrap();
        let map = isomap(&chain, 1, 1, &Progress::default()).unwrap();
        assert!(map.coordinates.iter().all(|x| x.is_finite()));
        let bent = DistanceMatrix::from_upper(3, vec![1.5e308, 1.6e308, 1.5e308]).unwrap();
        let map = isomap(&bent, 1, 1, &Progress::default());
        assert!(map.is_ok_and(|map| map.coordinates.iter().all(|x| x.is_finite())));
        let grown = Embedding {
            dimensions: 1,
            coordinates: vec![4.0],
            ..Embedding::default()
        };
        assert_eq!(
            back_in(2.0_f64.powi(1023), grown),
            Err(EmbeddingError::TooLarge)
        );
    }
}
