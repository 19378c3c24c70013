//! How well a map keeps the distances.

use rayon::prelude::*;

use crate::analysis::pose_distances::DistanceMatrix;

use super::Embedding;

/// Σ (d − δ)² over pairs, δ the given distances and d those on the map; `None` if the map has
/// another number of items.
pub fn raw_stress(distances: &DistanceMatrix, map: &Embedding) -> Option<f64> {
    let items = distances.size();
    if map.coordinates.len() != items * map.dimensions {
        return None;
    }
    // One sum a row keeps round-off at that of a row, and bits apart from the number of threads.
    let rows: Vec<f64> = (0..items)
        .into_par_iter()
        .map(|i| {
            let here = map.point(i);
            (distances.row_right_of_diagonal(i).iter().enumerate())
                .map(|(offset, given)| {
                    let there = map.point(i + 1 + offset);
                    let square: f64 = here.iter().zip(there).map(|(a, b)| (a - b).powi(2)).sum();
                    (square.sqrt() - given).powi(2)
                })
                .sum()
        })
        .collect();
    Some(rows.iter().sum())
}

/// Stress that Kruskal calls good.
pub const GOOD_STRESS: f64 = 0.05;
/// Stress that he calls fair.
pub const FAIR_STRESS: f64 = 0.1;
/// Stress that he calls poor.
pub const POOR_STRESS: f64 = 0.2;

/// Kruskal's stress 1, √(Σ (d − δ)² / Σ δ²) over pairs: 0 is perfect; [`GOOD_STRESS`], [`FAIR_STRESS`] and [`POOR_STRESS`] say
/// what else it means, by the table of the same source. 0 where all items coincide on both.
///
/// The denominator holds the given distances, as in scikit-learn; Kruskal's d there differs by a
/// factor √(1 − stress²) at a minimum.
///
/// Source: Kruskal (1964), Psychometrika 29(1), section 3.
pub fn kruskal_stress(distances: &DistanceMatrix, map: &Embedding) -> Option<f64> {
    let raw = raw_stress(distances, map)?;
    let scale: f64 = distances.upper().iter().map(|d| d * d).sum();
    // All distances zero and kept: no stress, instead of zero over zero.
    Some(if raw == 0.0 {
        0.0
    } else {
        (raw / scale).sqrt()
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stress_is_that_of_a_hand_made_triangle() {
        let distances = DistanceMatrix::from_upper(3, vec![3.0, 4.0, 6.0]).unwrap();
        let map = Embedding {
            dimensions: 2,
            coordinates: vec![0.0, 0.0, 3.0, 0.0, 0.0, 4.0],
            ..Embedding::default()
        };
        assert!((raw_stress(&distances, &map).unwrap() - 1.0).abs() < 1e-14);
        let stress = kruskal_stress(&distances, &map).unwrap();
        assert!((stress - (1.0_f64 / 61.0).sqrt()).abs() < 1e-14);
        let other = DistanceMatrix::from_upper(2, vec![1.0]).unwrap();
        assert_eq!(raw_stress(&other, &map), None);
    }
}
