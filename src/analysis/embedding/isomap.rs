//! Isomap: the map that keeps the lengths of the shortest ways from neighbour to neighbour.

use rayon::prelude::*;

use crate::analysis::pose_distances::DistanceMatrix;
use crate::numeric::{add_scaled, dot};
use crate::progress::{Progress, Stopped};

use super::moderate::in_moderate_unit;
use super::neighbour_graph::NeighbourGraph;
use super::{Embedding, EmbeddingError, Neighbours, classical_mds};

/// Classical scaling of the lengths of shortest ways along the graph of nearest neighbours.
///
/// Two items are linked if either is among the `neighbours` nearest of the other. Where the graph
/// falls into parts, these are joined by the shortest links that join them all; `parts` says how many
/// there were. See [`Neighbours`] for ties, and [`classical_mds`] for the map, its eigenvalues and
/// orientation.
///
/// `stress` is that against the lengths of ways, which the map keeps, not against `distances`.
/// `reconstruction_error` is √(‖K‖² − Σ λ²) / n, with K = −½ J G² J of the lengths G, its squared entries
/// summed, and λ the eigenvalues of the axes: what the map leaves out of K.
///
/// Source: Tenenbaum, de Silva and Langford (2000), Science 290; the error as in scikit-learn.
///
/// # Errors
/// If stopped, if there are not more items than neighbours, or if eigenvalues do not converge.
pub fn isomap(
    distances: &DistanceMatrix,
    neighbours: usize,
    dimensions: usize,
    progress: &Progress,
) -> Result<Embedding, EmbeddingError> {
    in_moderate_unit(distances, |distances| {
        let nearest = Neighbours::of_distances(distances, neighbours, progress)?;
        isomap_of_neighbours(distances, &nearest, dimensions, progress)
    })
}

/// [`isomap()`] with neighbours that are known; `distances` are asked for only where the graph
/// falls into parts.
///
/// # Errors
/// As [`isomap()`], and if the neighbours are of another number of items.
pub fn isomap_of_neighbours(
    distances: &DistanceMatrix,
    nearest: &Neighbours,
    dimensions: usize,
    progress: &Progress,
) -> Result<Embedding, EmbeddingError> {
    let (ways, parts) = shortest_paths(distances, nearest, progress)?;
    let map = classical_mds(&ways, dimensions, progress)?;
    let kept: f64 = (map.eigenvalues.iter().flatten().take(dimensions))
        // Negative eigenvalues have no axis, so that the map keeps nothing of them.
        .map(|value| value.max(0.0).powi(2))
        .sum();
    let left_out = (centred_norm2(&ways) - kept).max(0.0).sqrt();
    Ok(Embedding {
        neighbours: Some(nearest.count()),
        reconstruction_error: Some(left_out / ways.size() as f64),
        parts: Some(parts),
        ..map
    })
}

/// Lengths of the shortest ways along the graph of nearest neighbours, and the number of parts that it
/// falls into before they are joined.
///
/// # Errors
/// If stopped, or if the neighbours are of another number of items.
pub fn shortest_paths(
    distances: &DistanceMatrix,
    nearest: &Neighbours,
    progress: &Progress,
) -> Result<(DistanceMatrix, usize), EmbeddingError> {
    let items = distances.size();
    let mismatch = EmbeddingError::Points {
        values: nearest.len(),
        items,
    };
    if nearest.len() != items {
        return Err(mismatch);
    }
    let mut graph = NeighbourGraph::new(nearest);
    // Distances between parts would be infinite, and no map could show them.
    let parts = graph.join(distances, progress)?;
    // Near items share most of their shortest paths, so that a group is searched in one sweep.
    let groups = graph.groups();
    progress.expect_steps(groups.len());
    let found = groups
        .par_iter()
        .map_init(
            || graph.traveller(),
            |traveller, group| {
                progress.step()?;
                let lengths = traveller.lengths_from(group);
                let right_of_diagonal = |(lane, &from): (usize, &usize)| -> Vec<f64> {
                    lengths[from + 1..]
                        .iter()
                        .map(|lanes| lanes[lane])
                        .collect()
                };
                Ok(group.iter().enumerate().map(right_of_diagonal).collect())
            },
        )
        .collect::<Result<Vec<Vec<Vec<f64>>>, Stopped>>()?;
    let mut rows = vec![Vec::new(); items];
    for (group, found) in groups.iter().zip(found) {
        for (&from, row) in group.iter().zip(found) {
            rows[from] = row;
        }
    }
    // Lengths are sums of given distances, so they are none only if they overflow.
    let ways = DistanceMatrix::from_upper(items, rows.concat()).ok_or(mismatch)?;
    Ok((ways, parts))
}

/// Σ Kᵢⱼ², K = J S J the doubly centred S = −½ G²: with row means mᵢ of S and their mean m it is
/// Σ Sᵢⱼ² − 2 n Σ mᵢ² + n² m².
fn centred_norm2(ways: &DistanceMatrix) -> f64 {
    let n = ways.size();
    let (mut sums, mut norm2) = (vec![0.0; n], 0.0);
    for i in 0..n {
        let row: Vec<f64> = (ways.row_right_of_diagonal(i).iter())
            .map(|way| -0.5 * way * way)
            .collect();
        norm2 += 2.0 * dot(&row, &row);
        sums[i] += row.iter().sum::<f64>();
        add_scaled(&mut sums[i + 1..], 1.0, &row);
    }
    let total: f64 = sums.iter().sum();
    norm2 - 2.0 / n as f64 * dot(&sums, &sums) + (total / n as f64).powi(2)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn of_points(points: &[[f64; 2]]) -> DistanceMatrix {
        DistanceMatrix::of_points(&points.concat(), points.len()).unwrap()
    }

    fn arc(items: u32) -> Vec<[f64; 2]> {
        (0..items)
            .map(|i| 1.5 * std::f64::consts::PI * f64::from(i) / f64::from(items - 1))
            .map(|t| [t.cos(), t.sin()])
            .collect()
    }

    #[test]
    fn an_arc_is_unrolled_to_its_length_ever_more_exactly() {
        // The error is that of a polygon: it falls with the square of the number of items.
        for (items, error) in [(40, 1e-3), (600, 5e-6)] {
            let map = isomap(&of_points(&arc(items)), 2, 2, &Progress::default()).unwrap();
            let last = items as usize - 1;
            let length = (map.point(0)[0] - map.point(last)[0]).abs();
            let arc = 1.5 * std::f64::consts::PI;
            assert!((length / arc - 1.0).abs() < error, "{items}: {length}");
            assert!(map.stress.unwrap() < error);
            assert_eq!((map.neighbours, map.parts), (Some(2), Some(1)));
        }
    }

    #[test]
    fn with_all_items_as_neighbours_it_is_classical_scaling() {
        let distances = of_points(&arc(30));
        let map = isomap(&distances, 29, 2, &Progress::default()).unwrap();
        let classical = classical_mds(&distances, 2, &Progress::default()).unwrap();
        assert_eq!(map.coordinates, classical.coordinates);
    }

    #[test]
    fn what_one_axis_leaves_out_of_a_plane_is_the_second_eigenvalue() {
        let points = arc(30);
        let map = isomap(&of_points(&points), 29, 1, &Progress::default()).unwrap();
        let second = map.eigenvalues.unwrap()[1];
        let left_out = map.reconstruction_error.unwrap();
        assert!(second > 1.0 && (left_out - second / 30.0).abs() < 1e-12);
    }

    #[test]
    fn parts_are_joined_by_their_shortest_link_and_counted() {
        let line: Vec<[f64; 2]> = [0.0, 1.0, 2.0, 7.0, 8.0, 9.0, 20.0, 21.0]
            .map(|x| [x, 0.0])
            .to_vec();
        let distances = of_points(&line);
        let nearest = Neighbours::of_distances(&distances, 1, &Progress::default()).unwrap();
        let (ways, parts) = shortest_paths(&distances, &nearest, &Progress::default()).unwrap();
        assert_eq!(parts, 3);
        // All links lie on the line, so every way is as long as the distance.
        for (way, distance) in ways.upper().iter().zip(distances.upper()) {
            assert!((way - distance).abs() < 1e-12);
        }
    }

    #[test]
    fn damage_is_refused_and_items_that_coincide_stay_finite() {
        let progress = Progress::default();
        let error = Err(EmbeddingError::Neighbours {
            neighbours: 3,
            items: 3,
        });
        let zero = DistanceMatrix::from_upper(3, vec![0.0; 3]).unwrap();
        assert_eq!(isomap(&zero, 3, 2, &progress), error);
        assert!(isomap(&DistanceMatrix::empty(), 1, 2, &progress).is_err());
        let map = isomap(&zero, 1, 2, &progress).unwrap();
        assert_eq!(map.coordinates, [0.0; 6]);
        let huge = DistanceMatrix::from_upper(3, vec![1e308, 1e308, 1e307]).unwrap();
        assert!(isomap(&huge, 1, 2, &progress).is_ok_and(|map| !map.is_empty()));
    }

    #[test]
    fn a_stopped_map_says_so() {
        let progress = Progress::default();
        progress.stop();
        let stopped = isomap(&of_points(&arc(60)), 3, 2, &progress);
        assert_eq!(stopped, Err(EmbeddingError::Stopped(Stopped)));
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(32))]

        #[test]
        fn ways_are_those_of_floyd_and_warshall(
            points in prop::collection::vec([-1.0_f64..1.0, -1.0_f64..1.0], 8..40),
            count in 1_usize..6,
        ) {
            let n = points.len();
            let distances = of_points(&points);
            let nearest = Neighbours::of_distances(&distances, count, &Progress::default()).unwrap();
            let (ways, parts) = shortest_paths(&distances, &nearest, &Progress::default()).unwrap();
            prop_assume!(parts == 1);
            let mut table = vec![f64::INFINITY; n * n];
            for i in 0..n {
                table[i * n + i] = 0.0;
                for &j in nearest.of(i) {
                    let j = j as usize;
                    table[i * n + j] = distances.get(i, j);
                    table[j * n + i] = distances.get(i, j);
                }
            }
            for k in 0..n {
                for i in 0..n {
                    for j in 0..n {
                        let by = table[i * n + k] + table[k * n + j];
                        table[i * n + j] = table[i * n + j].min(by);
                    }
                }
            }
            for i in 0..n {
                for j in 0..n {
                    prop_assert!((ways.get(i, j) - table[i * n + j]).abs() < 1e-12);
                }
            }
        }

        #[test]
        fn permuting_items_permutes_the_map(
            points in prop::collection::vec([-1.0_f64..1.0, -1.0_f64..1.0], 12..40),
            turn in 1_usize..11,
        ) {
            let n = points.len();
            let from = |i: usize| (i + turn) % n;
            let permuted: Vec<[f64; 2]> = (0..n).map(|i| points[from(i)]).collect();
            let progress = Progress::default();
            let a = isomap(&of_points(&points), 5, 2, &progress).unwrap();
            let b = isomap(&of_points(&permuted), 5, 2, &progress).unwrap();
            for i in 0..n {
                for j in 0..i {
                    let far = |m: &Embedding, i: usize, j: usize| {
                        (m.point(i)[0] - m.point(j)[0]).hypot(m.point(i)[1] - m.point(j)[1])
                    };
                    prop_assert!((far(&b, i, j) - far(&a, from(i), from(j))).abs() < 1e-7);
                }
            }
        }
    }
}
