//! Every item as a mean of its neighbours: the weights that describe its neighbourhood.

use rayon::prelude::*;

use crate::numeric::{factorise_positive, solve_positive};
use crate::progress::{Progress, Stopped};

use super::lle_params::CheckedLleParams;
use super::{Embedding, EmbeddingError, Neighbours};

/// For every item the weights, summing to 1, with which its neighbours come nearest to it.
///
/// With G the Gram matrix of the neighbours seen from the item, Gⱼₗ = (xⱼ − x)·(xₗ − x), weights solve
/// (G + ρ tr G · 1) w = (1, …, 1)ᵀ, scaled to the sum 1; ρ is the regularisation. It makes the answer
/// the only one where there are more neighbours than dimensions. Where all neighbours coincide with
/// the item they count the same.
///
/// Source: Saul and Roweis (2003), JMLR 4, section 3 and appendix A; ρ tr G as in scikit-learn.
#[derive(Clone, Debug, PartialEq)]
pub struct LocalWeights {
    neighbours: Neighbours,
    weights: Vec<f64>,
    regularisation: f64,
}

impl LocalWeights {
    /// Weights of `items` points, rows of equal length one after the other.
    ///
    /// # Errors
    /// As [`Neighbours::of_points`].
    pub fn of_points(
        points: &[f64],
        items: usize,
        params: &CheckedLleParams,
        progress: &Progress,
    ) -> Result<Self, EmbeddingError> {
        let neighbours = Neighbours::of_points(points, items, params.0.neighbours, progress)?;
        Ok(Self::of_neighbours(
            points,
            neighbours,
            params.0.regularisation,
            progress,
        )?)
    }

    /// Weights for neighbours of these points that have been found.
    pub(super) fn of_neighbours(
        points: &[f64],
        neighbours: Neighbours,
        regularisation: f64,
        progress: &Progress,
    ) -> Result<Self, Stopped> {
        let count = neighbours.count();
        let mut weights = vec![0.0; neighbours.len() * count];
        let local = Local {
            points,
            width: points.len() / neighbours.len().max(1),
            regularisation,
        };
        progress.expect_steps(neighbours.len());
        weights
            .par_chunks_mut(count)
            .enumerate()
            .try_for_each_init(Scratch::default, |scratch, (item, weights)| {
                local.solve(local.row(item), neighbours.of(item), weights, scratch);
                progress.step()
            })?;
        Ok(Self {
            neighbours,
            weights,
            regularisation,
        })
    }

    /// The same with items appended: `points` holds the rows of before, unchanged, and those of new
    /// items. Weights are solved for only where neighbours changed; also returns those rows.
    ///
    /// The result is that of [`LocalWeights::of_points`], bit for bit.
    ///
    /// # Errors
    /// As [`Neighbours::with_more_points`].
    pub fn with_more_points(
        &self,
        points: &[f64],
        items: usize,
        progress: &Progress,
    ) -> Result<(Self, Vec<usize>), EmbeddingError> {
        let (neighbours, changed) = self.neighbours.with_more_points(points, items, progress)?;
        let count = neighbours.count();
        let mut weights = self.weights.clone();
        weights.resize(items * count, 0.0);
        let local = Local {
            points,
            width: points.len() / items.max(1),
            regularisation: self.regularisation,
        };
        let mut scratch = Scratch::default();
        // Weights of the others cannot change: they depend on their own neighbours alone.
        for &item in &changed {
            progress.check()?;
            let weights = &mut weights[item * count..][..count];
            local.solve(local.row(item), neighbours.of(item), weights, &mut scratch);
        }
        let more = Self {
            neighbours,
            weights,
            regularisation: self.regularisation,
        };
        Ok((more, changed))
    }

    /// The neighbours that weights are of.
    pub fn neighbours(&self) -> &Neighbours {
        &self.neighbours
    }

    /// Weights of the neighbours of one item, in the order of [`Neighbours::of`].
    pub fn of(&self, item: usize) -> &[f64] {
        let count = self.neighbours.count();
        &self.weights[item * count..][..count]
    }

    /// Where a new point lies on a map of these points: the mean, with its own weights, of where its
    /// nearest items lie. The map stays as it is.
    ///
    /// `points` are those that the weights were made of. An item of the map is put near its place,
    /// not onto it: its neighbours place it, itself left out.
    ///
    /// Source: Saul and Roweis (2003), JMLR 4, section 6.1.
    ///
    /// # Errors
    /// If `points`, `map` and `point` do not fit one another, or a coordinate is not finite.
    pub fn placed(
        &self,
        points: &[f64],
        map: &Embedding,
        point: &[f64],
    ) -> Result<Vec<f64>, EmbeddingError> {
        let items = self.neighbours.len();
        let width = points.len() / items.max(1);
        if point.len() != width || points.len() != width * items || map.len() != items {
            let values = points.len() + point.len();
            return Err(EmbeddingError::Points { values, items });
        }
        let with_new = [points, point].concat();
        let (neighbours, _) =
            self.neighbours
                .with_more_points(&with_new, items + 1, &Progress::default())?;
        let nearest = neighbours.of(items);
        let mut weights = vec![0.0; nearest.len()];
        let local = Local {
            points,
            width,
            regularisation: self.regularisation,
        };
        local.solve(point, nearest, &mut weights, &mut Scratch::default());
        let mut place = vec![0.0; map.dimensions];
        for (&item, weight) in nearest.iter().zip(&weights) {
            for (x, y) in place.iter_mut().zip(map.point(item as usize)) {
                *x += weight * y;
            }
        }
        Ok(place)
    }
}

/// Where local problems are posed.
struct Local<'a> {
    points: &'a [f64],
    width: usize,
    regularisation: f64,
}

/// What one local problem needs, kept from one to the next.
#[derive(Default)]
struct Scratch {
    steps: Vec<f64>,
    gram: Vec<f64>,
}

impl Local<'_> {
    fn row(&self, item: usize) -> &[f64] {
        &self.points[item * self.width..][..self.width]
    }

    fn solve(&self, here: &[f64], nearest: &[u32], weights: &mut [f64], scratch: &mut Scratch) {
        let k = nearest.len();
        let Scratch { steps, gram } = scratch;
        steps.clear();
        for &other in nearest {
            let there = self.row(other as usize);
            steps.extend(there.iter().zip(here).map(|(there, here)| there - here));
        }
        gram.clear();
        gram.resize(k * k, 0.0);
        for i in 0..k {
            let a = &steps[i * self.width..][..self.width];
            for j in 0..=i {
                let b = &steps[j * self.width..][..self.width];
                gram[i * k + j] = a.iter().zip(b).map(|(a, b)| a * b).sum();
            }
        }
        let trace: f64 = (0..k).map(|i| gram[i * k + i]).sum();
        // Weights do not change with the unit of length; in this one nothing over- or underflows.
        let unit = if trace > 0.0 { 1.0 / trace } else { 1.0 };
        gram.iter_mut().for_each(|entry| *entry *= unit);
        // With more neighbours than dimensions the Gram matrix is singular.
        for i in 0..k {
            gram[i * k + i] += self.regularisation;
        }
        weights.fill(1.0);
        // Positive definite by the regularisation, far above round-off.
        factorise_positive(gram, k);
        solve_positive(gram, weights);
        // Scaled to the sum 1, weights do not change when all points are shifted.
        let sum: f64 = weights.iter().sum();
        weights.iter_mut().for_each(|weight| *weight /= sum);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::embedding::LleParams;
    use proptest::prelude::*;

    fn params(neighbours: usize, regularisation: f64) -> CheckedLleParams {
        LleParams {
            neighbours,
            regularisation,
            ..LleParams::default()
        }
        .check()
        .unwrap()
    }

    fn of(points: &[f64], items: usize, params: &CheckedLleParams) -> LocalWeights {
        LocalWeights::of_points(points, items, params, &Progress::default()).unwrap()
    }

    #[test]
    fn the_middle_of_a_segment_is_the_even_mean_of_its_ends() {
        let weights = of(&[0.0, 1.0, 2.0], 3, &params(2, 1e-9));
        assert!((weights.of(1)[0] - 0.5).abs() < 1e-12);
        // An end lies beyond both: 2 · the near one − 1 · the far one.
        assert!((weights.of(0)[0] - 2.0).abs() < 1e-6);
        assert!((weights.of(0)[1] + 1.0).abs() < 1e-6);
    }

    #[test]
    fn items_that_coincide_count_the_same() {
        let weights = of(&[1.0; 8], 4, &params(3, 1e-3));
        for item in 0..4 {
            assert!(
                weights
                    .of(item)
                    .iter()
                    .all(|w| (w - 1.0 / 3.0).abs() < 1e-15)
            );
        }
    }

    #[test]
    fn a_new_point_between_items_is_placed_between_them() {
        let grid: Vec<f64> = (0..25)
            .flat_map(|i| [f64::from(i % 5), f64::from(i / 5)])
            .collect();
        let weights = of(&grid, 25, &params(4, 1e-6));
        let map = Embedding {
            dimensions: 1,
            coordinates: grid.chunks(2).map(|p| 3.0 * p[0] - p[1] + 7.0).collect(),
            ..Embedding::default()
        };
        let place = weights.placed(&grid, &map, &[1.5, 2.5]).unwrap();
        assert!((place[0] - (4.5 - 2.5 + 7.0)).abs() < 1e-5);
        assert!(weights.placed(&grid, &map, &[1.5]).is_err());
        assert!(weights.placed(&grid, &map, &[1.5, f64::NAN]).is_err());
    }

    proptest! {
        #[test]
        fn adding_items_solves_only_where_neighbours_change_and_gives_the_same_bits(
            points in prop::collection::vec(-1.0_f64..1.0, 60..150),
            added in 1_usize..4,
        ) {
            let items = points.len() / 3;
            let points = &points[..3 * items];
            let params = params(5, 1e-3);
            let before = items - added;
            let known = of(&points[..3 * before], before, &params);
            let (more, solved) =
                known.with_more_points(points, items, &Progress::default()).unwrap();
            prop_assert_eq!(&more, &of(points, items, &params));
            prop_assert!(solved.len() >= added);
            for item in (0..before).filter(|item| !solved.contains(item)) {
                prop_assert_eq!(known.neighbours().of(item), more.neighbours().of(item));
            }
        }

        #[test]
        fn weights_sum_to_one_and_ignore_motions_and_size(
            points in prop::collection::vec(-1.0_f64..1.0, 40..60),
            turn in 0.0_f64..6.0,
            size in 0.1_f64..10.0,
        ) {
            let items = points.len() / 2;
            let points = &points[..2 * items];
            let (sin, cos) = turn.sin_cos();
            let moved: Vec<f64> = points
                .chunks(2)
                .flat_map(|p| [size * (cos * p[0] - sin * p[1]) + 3.0, size * (sin * p[0] + cos * p[1])])
                .collect();
            let params = params(6, 1e-3);
            let (a, b) = (of(points, items, &params), of(&moved, items, &params));
            prop_assume!((0..items).all(|i| a.neighbours().of(i) == b.neighbours().of(i)));
            for item in 0..items {
                prop_assert!((a.of(item).iter().sum::<f64>() - 1.0).abs() < 1e-12);
                for (a, b) in a.of(item).iter().zip(b.of(item)) {
                    prop_assert!((a - b).abs() < 1e-8 * a.abs().max(1.0));
                }
            }
        }
    }
}
