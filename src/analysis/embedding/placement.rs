//! Where does a new item lie on a classical map that stays as it is?

use crate::analysis::pose_distances::DistanceMatrix;

use super::{Embedding, EmbeddingError};

/// Place of a new item on the classical map of others, from its distances to them.
///
/// With the coordinates Y, the eigenvalues λ and the mean b of each row of squared distances,
/// yₖ = Σᵢ yᵢₖ (bᵢ − δᵢ²) / (2 λₖ): exact where all distances are Euclidean in the dimensions of the map. Axes
/// with λ ≤ 0 give 0.
///
/// Source: Gower (1968), Biometrika 55(3), eq. 10.
///
/// # Errors
/// If map, distances and new distances are not of the same items, if the map has no eigenvalues, or if a
/// distance is not finite.
pub fn placed_classically(
    distances: &DistanceMatrix,
    map: &Embedding,
    to_items: &[f64],
) -> Result<Vec<f64>, EmbeddingError> {
    let items = distances.size();
    let error = EmbeddingError::Points {
        values: to_items.len(),
        items,
    };
    let values = map.eigenvalues.as_deref().ok_or(error)?;
    let fits = map.len() == items && to_items.len() == items;
    if !fits || to_items.iter().any(|d| !d.is_finite()) {
        return Err(error);
    }
    let pulls: Vec<f64> = (0..items)
        .map(|i| {
            let row = (0..items).map(|j| distances.get(i, j).powi(2));
            // Gower’s formula: the means of all rows together cancel, since coordinates sum to zero.
            row.sum::<f64>() / items as f64 - to_items[i].powi(2)
        })
        .collect();
    Ok((0..map.dimensions)
        .map(|axis| {
            let along: f64 = (pulls.iter().enumerate())
                .map(|(item, pull)| pull * map.point(item)[axis])
                .sum();
            match values.get(axis) {
                // An axis without extent has no place to give.
                Some(&value) if value > 0.0 => along / (2.0 * value),
                _ => 0.0,
            }
        })
        .collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::embedding::classical_mds;
    use crate::progress::Progress;

    fn of(points: &[[f64; 2]]) -> DistanceMatrix {
        DistanceMatrix::of_points(&points.concat(), points.len()).unwrap()
    }

    #[test]
    fn a_new_item_keeps_its_distances_to_all_others_in_the_plane() {
        let points = [[0.0, 0.0], [4.0, 1.0], [1.0, 3.0], [-2.0, 1.0], [2.0, -5.0]];
        let distances = of(&points);
        let map = classical_mds(&distances, 2, &Progress::default()).unwrap();
        let to_items = points.map(|[x, y]| (x - 3.0).hypot(y - 2.5));
        let place = placed_classically(&distances, &map, &to_items).unwrap();
        for (item, given) in to_items.iter().enumerate() {
            let there = map.point(item);
            let found = (place[0] - there[0]).hypot(place[1] - there[1]);
            assert!((found - given).abs() < 1e-12, "{found}, not {given}");
        }
    }

    #[test]
    fn an_item_of_the_map_is_placed_onto_itself() {
        let distances = of(&[[0.0, 0.0], [4.0, 1.0], [1.0, 3.0], [-2.0, 1.0]]);
        let map = classical_mds(&distances, 2, &Progress::default()).unwrap();
        let row: Vec<f64> = (0..4).map(|j| distances.get(2, j)).collect();
        let place = placed_classically(&distances, &map, &row).unwrap();
        for (x, y) in place.iter().zip(map.point(2)) {
            assert!((x - y).abs() < 1e-12);
        }
    }

    #[test]
    fn what_does_not_fit_is_refused() {
        let distances = of(&[[0.0, 0.0], [1.0, 0.0]]);
        let map = classical_mds(&distances, 2, &Progress::default()).unwrap();
        assert!(placed_classically(&distances, &map, &[1.0]).is_err());
        assert!(placed_classically(&distances, &map, &[1.0, f64::NAN]).is_err());
        let bare = Embedding {
            eigenvalues: None,
            ..map
        };
        assert!(placed_classically(&distances, &bare, &[1.0, 1.0]).is_err());
    }
}
