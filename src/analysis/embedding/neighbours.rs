//! The nearest items of every item: found by comparing every pair.

use rayon::prelude::*;

use crate::analysis::pose_distances::DistanceMatrix;
use crate::progress::{Progress, Stopped};

use super::EmbeddingError;

/// Coordinates from here on are refused: their squares would not be numbers.
const TOO_LARGE: f64 = 1e150;

/// The nearest items of every item, itself left out: by distance, of equally near ones the first.
#[derive(Clone, Debug, PartialEq)]
pub struct Neighbours {
    count: usize,
    indices: Vec<u32>,
    distances: Vec<f64>,
}

impl Neighbours {
    /// Nearest points of each of `items` points, rows of equal length one after the other.
    ///
    /// Every pair is compared, axis by axis in vector instructions: at 2,000 points in space this
    /// takes as long as building a tree and asking it, and it does not depend on the dimension.
    ///
    /// # Errors
    /// If stopped, if the rows are not finite or not of equal length, or if there are not more items than
    /// neighbours.
    pub fn of_points(
        points: &[f64],
        items: usize,
        count: usize,
        progress: &Progress,
    ) -> Result<Self, EmbeddingError> {
        let axes = axes(points, items)?;
        possible(items, count)?;
        progress.expect_steps(items);
        let nearest = (0..items)
            .into_par_iter()
            .map_init(Vec::new, |squares, item| {
                progress.step()?;
                Ok(nearest_of_point(&axes, item, count, squares))
            })
            .collect::<Result<Vec<_>, Stopped>>()?;
        Ok(Self::from_rows(count, nearest))
    }

    /// Nearest items by given distances.
    ///
    /// # Errors
    /// If stopped, or if there are not more items than neighbours.
    pub fn of_distances(
        distances: &DistanceMatrix,
        count: usize,
        progress: &Progress,
    ) -> Result<Self, EmbeddingError> {
        let items = distances.size();
        possible(items, count)?;
        progress.expect_steps(items);
        let nearest = (0..items)
            .into_par_iter()
            .map(|item| {
                progress.step()?;
                let mut nearest = Nearest::new(count);
                for other in (0..items).filter(|&other| other != item) {
                    nearest.offer(distances.get(item, other), other);
                }
                Ok(nearest)
            })
            .collect::<Result<Vec<_>, Stopped>>()?;
        Ok(Self::from_rows(count, nearest))
    }

    /// Neighbours of each item.
    pub fn count(&self) -> usize {
        self.count
    }

    /// Number of items.
    pub fn len(&self) -> usize {
        self.indices.len() / self.count.max(1)
    }

    /// Whether there are no items.
    pub fn is_empty(&self) -> bool {
        self.indices.is_empty()
    }

    /// The nearest items of one, the nearest first.
    pub fn of(&self, item: usize) -> &[u32] {
        &self.indices[item * self.count..][..self.count]
    }

    /// How far they are.
    pub fn distances_of(&self, item: usize) -> &[f64] {
        &self.distances[item * self.count..][..self.count]
    }

    fn from_rows(count: usize, rows: Vec<Nearest>) -> Self {
        let mut indices = Vec::with_capacity(count * rows.len());
        let mut distances = Vec::with_capacity(count * rows.len());
        for row in rows {
            indices.extend(row.indices);
            distances.extend(row.distances);
        }
        Self {
            count,
            indices,
            distances,
        }
    }
}

fn possible(items: usize, count: usize) -> Result<(), EmbeddingError> {
    if count == 0 || count >= items {
        return Err(EmbeddingError::Neighbours {
            neighbours: count,
            items,
        });
    }
    Ok(())
}

/// Points axis by axis, so that distances from one to all others are a stream.
fn axes(points: &[f64], items: usize) -> Result<Vec<Vec<f64>>, EmbeddingError> {
    let width = points.len().checked_div(items).unwrap_or(0);
    // Squares of such numbers overflow.
    let too_large = |x: &f64| x.is_nan() || x.abs() >= TOO_LARGE;
    if width * items != points.len() || points.iter().any(too_large) {
        return Err(EmbeddingError::Points {
            values: points.len(),
            items,
        });
    }
    let along = |axis| points.iter().skip(axis).step_by(width).copied().collect();
    Ok((0..width).map(along).collect())
}

fn nearest_of_point(
    axes: &[Vec<f64>],
    item: usize,
    count: usize,
    squares: &mut Vec<f64>,
) -> Nearest {
    squares.clear();
    squares.resize(axes.first().map_or(0, Vec::len), 0.0);
    for axis in axes {
        let here = axis[item];
        for (square, there) in squares.iter_mut().zip(axis) {
            let step = here - there;
            *square += step * step;
        }
    }
    // Never nearer than any.
    squares[item] = f64::INFINITY;
    let mut nearest = Nearest::new(count);
    for (other, &square) in squares.iter().enumerate() {
        nearest.offer(square, other);
    }
    nearest.rooted()
}

/// The nearest so far, ascending.
struct Nearest {
    count: usize,
    indices: Vec<u32>,
    distances: Vec<f64>,
}

impl Nearest {
    fn new(count: usize) -> Self {
        Self {
            count,
            indices: Vec::with_capacity(count + 1),
            distances: Vec::with_capacity(count + 1),
        }
    }

    /// Takes an item in if it is nearer than the farthest; to be offered in the order of indices.
    #[inline]
    fn offer(&mut self, distance: f64, index: usize) {
        if self.indices.len() == self.count
            // Not `>`: of equal distances the item that was offered first stays.
            && self.distances.last().is_some_and(|last| distance >= *last)
        {
            return;
        }
        // Behind equals, so that ties are in the order of the items.
        let place = self.distances.partition_point(|known| *known <= distance);
        self.distances.insert(place, distance);
        self.indices.insert(place, index as u32);
        self.distances.truncate(self.count);
        self.indices.truncate(self.count);
    }

    /// Distances from their squares.
    fn rooted(mut self) -> Self {
        self.distances.iter_mut().for_each(|d| *d = d.sqrt());
        self
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn of(points: &[f64], items: usize, count: usize) -> Neighbours {
        Neighbours::of_points(points, items, count, &Progress::default()).unwrap()
    }

    #[test]
    fn neighbours_on_a_line_are_those_beside_and_the_first_of_equals() {
        let found = of(&[0.0, 1.0, 2.0, 4.0], 4, 2);
        assert_eq!(found.of(0), [1, 2]);
        assert_eq!(found.of(1), [0, 2]);
        assert_eq!(found.of(2), [1, 0]);
        assert_eq!(found.of(3), [2, 1]);
        assert_eq!(found.distances_of(3), [2.0, 3.0]);
        let upper = vec![1.0, 2.0, 4.0, 1.0, 3.0, 2.0];
        let matrix = DistanceMatrix::from_upper(4, upper).unwrap();
        let by_distances = Neighbours::of_distances(&matrix, 2, &Progress::default());
        assert_eq!(by_distances, Ok(found));
    }

    #[test]
    fn as_many_neighbours_as_items_are_refused() {
        let progress = Progress::default();
        for count in [0, 3] {
            let error = Err(EmbeddingError::Neighbours {
                neighbours: count,
                items: 3,
            });
            let points = [0.0, 1.0, 2.0];
            assert_eq!(Neighbours::of_points(&points, 3, count, &progress), error);
            let matrix = DistanceMatrix::from_upper(3, vec![1.0; 3]).unwrap();
            assert_eq!(Neighbours::of_distances(&matrix, count, &progress), error);
        }
        for wrong in [f64::NAN, f64::INFINITY, 1e200] {
            assert!(Neighbours::of_points(&[0.0, wrong], 2, 1, &progress).is_err());
        }
        assert!(Neighbours::of_points(&[0.0; 5], 2, 1, &progress).is_err());
        assert!(Neighbours::of_points(&[], 0, 1, &progress).is_err());
    }

    #[test]
    fn a_search_that_is_stopped_says_so() {
        let progress = Progress::default();
        progress.stop();
        let stopped = Neighbours::of_points(&[0.0, 1.0], 2, 1, &progress);
        assert_eq!(stopped, Err(EmbeddingError::Stopped(Stopped)));
    }

    proptest! {
        #[test]
        fn no_item_left_out_is_nearer_than_one_taken_in(
            points in prop::collection::vec(-1.0_f64..1.0, 20..60),
        ) {
            let items = points.len() / 2;
            let found = of(&points[..2 * items], items, 4);
            let far = |a: usize, b: usize| {
                let (a, b) = (&points[2 * a..], &points[2 * b..]);
                ((a[0] - b[0]).powi(2) + (a[1] - b[1]).powi(2)).sqrt()
            };
            for item in 0..items {
                let farthest = found.distances_of(item)[3];
                let taken = found.of(item);
                prop_assert!(!taken.contains(&(item as u32)));
                for other in (0..items).filter(|&o| o != item && !taken.contains(&(o as u32))) {
                    prop_assert!(far(item, other) >= farthest);
                }
            }
        }
    }
}
