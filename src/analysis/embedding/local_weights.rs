//! Every item as a mean of its neighbours: the weights that describe its neighbourhood.

use rayon::prelude::*;

use crate::numeric::{factorise_positive, solve_positive};
use crate::progress::{Progress, Stopped};

use super::lle_params::CheckedLleParams;
use super::{EmbeddingError, Neighbours};

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
        })
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

    proptest! {
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
