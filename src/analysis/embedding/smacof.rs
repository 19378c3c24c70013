//! Stress majorisation: the map whose distances come nearest to the given ones.

use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;
use rayon::prelude::*;

use crate::analysis::pose_distances::DistanceMatrix;
use crate::progress::{Progress, Stopped};

use super::moderate::in_moderate_unit;
use super::orientation::on_principal_axes;
use super::{Embedding, EmbeddingError, classical_mds, kruskal_stress};

/// Settings of stress majorisation; [`SmacofParams::check`] makes them usable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SmacofParams {
    /// Steps after which a start is given up as it is.
    pub max_iterations: usize,
    /// Ends where a step lowers the raw stress by less than this share of it.
    pub tolerance: f64,
    /// Random starts tried beside that from classical scaling; the lowest stress wins.
    pub random_starts: usize,
    /// Seed of the random starts.
    pub seed: u64,
}

impl Default for SmacofParams {
    /// A share of 10⁻⁷ a step leaves coordinates within a thousandth of the map's width of the minimum
    /// on maps of beating hearts: less than a point's radius on screen. No random start: each costs as much as the first, and
    /// the start from classical scaling gives the same map every time; a lower minimum elsewhere is then not looked for.
    fn default() -> Self {
        Self {
            max_iterations: 1000,
            tolerance: 1e-7,
            random_starts: 0,
            seed: 0,
        }
    }
}

/// Settings that have been checked.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CheckedSmacofParams(SmacofParams);

/// Why settings cannot be used.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum SmacofParamError {
    /// The tolerance is no share of the stress.
    #[error("tolerance must be at least 0 and below 1, not {0}")]
    Tolerance(f64),
}

impl SmacofParams {
    /// Checks the settings once; an algorithm takes the checked type only.
    ///
    /// # Errors
    /// If the tolerance is not in 0..1.
    pub fn check(self) -> Result<CheckedSmacofParams, SmacofParamError> {
        if (0.0..1.0).contains(&self.tolerance) {
            Ok(CheckedSmacofParams(self))
        } else {
            Err(SmacofParamError::Tolerance(self.tolerance))
        }
    }
}

/// Map minimising the raw stress Σ (d − δ)² by repeated Guttman transforms.
///
/// X ← (1/n) B(X) X with bᵢⱼ = −δᵢⱼ / dᵢⱼ (0 where items coincide on the map) and rows summing to
/// zero; the stress never rises. Starts from classical scaling and, if asked, from random places. The
/// result is centred on its principal axes, so that its orientation does not depend on the path.
///
/// Source: Borg and Groenen, *Modern Multidimensional Scaling*, 2nd ed., section 8.6, eqs. 8.28–8.29.
///
/// # Errors
/// If stopped, the eigenvalues for the start do not converge, or a coordinate is beyond the largest number.
pub fn smacof(
    distances: &DistanceMatrix,
    dimensions: usize,
    params: &CheckedSmacofParams,
    progress: &Progress,
) -> Result<Embedding, EmbeddingError> {
    in_moderate_unit(distances, |distances| {
        majorised(distances, dimensions, params.0, progress)
    })
}

fn majorised(
    distances: &DistanceMatrix,
    dimensions: usize,
    params: SmacofParams,
    progress: &Progress,
) -> Result<Embedding, EmbeddingError> {
    // The stress has many minima; classical scaling leads to a low one, and to the same every time.
    let start = classical_mds(distances, dimensions, progress)?;
    let blocks = row_blocks(distances.size());
    progress.expect_steps((params.random_starts + 1) * params.max_iterations * blocks.len());
    let majoriser = Majoriser {
        distances,
        dimensions,
        blocks,
        progress,
    };
    let mut best = majoriser.descend(&start.coordinates, &params)?;
    // Places as far apart as the items are, or the first step would only rescale.
    let radius = (distances.upper().iter().map(|d| d * d).sum::<f64>()
        / distances.upper().len().max(1) as f64)
        .sqrt();
    for number in 0..params.random_starts {
        // Each start has a stream of its own, so that asking for more leaves the others as they are.
        let mut random = ChaCha8Rng::seed_from_u64(params.seed);
        random.set_stream(number as u64);
        let places: Vec<f64> = (0..start.coordinates.len())
            .map(|_| radius * random.random_range(-1.0..1.0))
            .collect();
        let other = majoriser.descend(&places, &params)?;
        // Strictly lower, so that ties keep the start that needs no seed.
        if other.raw_stress < best.raw_stress {
            best = other;
        }
    }
    let mut map = Embedding {
        dimensions,
        // The stress does not change under rotation: without this the orientation would be an accident of the
        // descent.
        coordinates: on_principal_axes(best.coordinates, dimensions),
        iterations: Some(best.iterations),
        ..Embedding::default()
    };
    map.stress = kruskal_stress(distances, &map);
    Ok(map)
}

struct Descent {
    coordinates: Vec<f64>,
    raw_stress: f64,
    iterations: usize,
}

struct Majoriser<'a> {
    distances: &'a DistanceMatrix,
    dimensions: usize,
    blocks: Vec<std::ops::Range<usize>>,
    progress: &'a Progress,
}

impl Majoriser<'_> {
    fn descend(&self, start: &[f64], params: &SmacofParams) -> Result<Descent, Stopped> {
        let items = self.distances.size();
        // Axis by axis, so that the inner loop is a stream.
        let mut axes: Vec<Vec<f64>> = (0..self.dimensions)
            .map(|axis| {
                start
                    .iter()
                    .skip(axis)
                    .step_by(self.dimensions)
                    .copied()
                    .collect()
            })
            .collect();
        let mut last_stress = f64::INFINITY;
        let mut iterations = 0;
        loop {
            let (next, raw_stress) = self.transformed(&axes)?;
            // Also true at zero stress, and where nothing moves any more.
            let settled = last_stress - raw_stress <= params.tolerance * raw_stress;
            // Fewer than two items have no distances to improve.
            if settled || iterations == params.max_iterations || items < 2 {
                let coordinates = (0..items)
                    .flat_map(|item| axes.iter().map(move |axis| axis[item]))
                    .collect();
                return Ok(Descent {
                    coordinates,
                    raw_stress,
                    iterations,
                });
            }
            last_stress = raw_stress;
            axes = next;
            iterations += 1;
        }
    }

    /// The Guttman transform of a map, and the raw stress before it.
    fn transformed(&self, axes: &[Vec<f64>]) -> Result<(Vec<Vec<f64>>, f64), Stopped> {
        let items = self.distances.size();
        let parts: Vec<(Vec<Vec<f64>>, f64)> = self
            .blocks
            .par_iter()
            .map(|rows| {
                self.progress.step()?;
                let mut moved = vec![vec![0.0; items]; self.dimensions];
                let mut stress = 0.0;
                let mut pulls = vec![0.0; items];
                for row in rows.clone() {
                    stress += self.add_row(row, axes, &mut moved, &mut pulls);
                }
                Ok((moved, stress))
            })
            .collect::<Result<_, Stopped>>()?;
        // Summed in the order of the blocks, whoever did them.
        let mut sums = vec![vec![0.0; items]; self.dimensions];
        let mut stress = 0.0;
        for (moved, part) in parts {
            stress += part;
            for (sum, moved) in sums.iter_mut().zip(moved) {
                sum.iter_mut().zip(moved).for_each(|(sum, x)| *sum += x);
            }
        }
        // The Guttman transform with equal weights: V⁺ is 1/n on centred coordinates.
        let share = 1.0 / items.max(1) as f64;
        sums.iter_mut().flatten().for_each(|x| *x *= share);
        Ok((sums, stress))
    }

    /// Adds what the pairs of one row, right of the diagonal, contribute to n times the transform.
    fn add_row(
        &self,
        row: usize,
        axes: &[Vec<f64>],
        moved: &mut [Vec<f64>],
        pulls: &mut [f64],
    ) -> f64 {
        let given = self.distances.row_right_of_diagonal(row);
        let pulls = &mut pulls[..given.len()];
        pulls.fill(0.0);
        for axis in axes {
            let here = axis[row];
            for (square, there) in pulls.iter_mut().zip(&axis[row + 1..]) {
                *square += (here - there) * (here - there);
            }
        }
        let stress = pulls_and_stress(pulls, given);
        for (axis, moved) in axes.iter().zip(moved) {
            let here = axis[row];
            let (before, after) = moved.split_at_mut(row + 1);
            before[row] += pull_all(here, &axis[row + 1..], pulls, after);
        }
        stress
    }
}

/// Entries done side by side: whole vector registers, and sums that need not wait for each other.
const LANES: usize = 8;

/// A distance on the map that is as good as none: δ over it times the offset, zero, is zero.
const NO_DISTANCE: f64 = 1e-150;

/// Turns squared distances into δ / d, and returns Σ (d − δ)².
///
/// Without a branch, and not inlined: so the loop stays one of vector instructions.
#[inline(never)]
fn pulls_and_stress(squares: &mut [f64], given: &[f64]) -> f64 {
    let (squares, last_squares) = squares.as_chunks_mut::<LANES>();
    let (given, last_given) = given.as_chunks::<LANES>();
    let mut lanes = [0.0; LANES];
    for (squares, given) in squares.iter_mut().zip(given) {
        let distances = squares.map(f64::sqrt);
        for lane in 0..LANES {
            let miss = distances[lane] - given[lane];
            lanes[lane] += miss * miss;
            squares[lane] = given[lane] / distances[lane].max(NO_DISTANCE);
        }
    }
    let mut stress = lanes.iter().sum::<f64>();
    for (square, given) in last_squares.iter_mut().zip(last_given) {
        let distance = square.sqrt();
        stress += (distance - given) * (distance - given);
        *square = given / distance.max(NO_DISTANCE);
    }
    stress
}

/// Moves items at `there` against their pulls, and returns the sum that moves the item at `here`.
#[inline(never)]
fn pull_all(here: f64, there: &[f64], pulls: &[f64], moved: &mut [f64]) -> f64 {
    let (there, last_there) = there.as_chunks::<LANES>();
    let (pulls, last_pulls) = pulls.as_chunks::<LANES>();
    let (moved, last_moved) = moved.as_chunks_mut::<LANES>();
    let mut lanes = [0.0; LANES];
    for ((there, pulls), moved) in there.iter().zip(pulls).zip(moved) {
        for lane in 0..LANES {
            let pulled = pulls[lane] * (here - there[lane]);
            lanes[lane] += pulled;
            moved[lane] -= pulled;
        }
    }
    let mut sum = lanes.iter().sum::<f64>();
    for ((there, pull), moved) in last_there.iter().zip(last_pulls).zip(last_moved) {
        let pulled = pull * (here - there);
        sum += pulled;
        *moved -= pulled;
    }
    sum
}

/// Pairs in a block of rows: some 6 ms of work. Smaller blocks lose more than they gain: a step
/// waits for its slowest thread, and 100 steps at 2,000 items took 0.66 s on one thread and 2.1 s on
/// two of a busy machine with two cores.
const PAIRS_A_BLOCK: usize = 2_000_000;
/// More blocks would cost more in sums than they gain.
const MAX_BLOCKS: usize = 64;

/// Rows in blocks of about as many pairs; depends on the number of items alone.
fn row_blocks(items: usize) -> Vec<std::ops::Range<usize>> {
    let pairs = items * items.saturating_sub(1) / 2;
    // Not by threads: sums in another order would be other bits.
    let wanted = PAIRS_A_BLOCK.max(pairs.div_ceil(MAX_BLOCKS));
    let mut blocks = Vec::new();
    let (mut first, mut gathered) = (0, 0);
    for row in 0..items {
        gathered += items - row - 1;
        if gathered >= wanted || row + 1 == items {
            blocks.push(first..row + 1);
            (first, gathered) = (row + 1, 0);
        }
    }
    blocks
}

#[cfg(test)]
mod tests;
