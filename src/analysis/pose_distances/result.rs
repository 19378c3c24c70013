//! A symmetric matrix of distances and the poses its rows stand for.

use crate::analysis::alignment::LeftOut;
use crate::numeric::moderate_unit;

/// One pose: a subject of the study at a frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct PoseId {
    /// Index into the study's subjects.
    pub subject: usize,
    /// Frame of its sequence.
    pub frame: usize,
}

/// Symmetric distances, zero on the diagonal; the upper triangle is stored row by row.
#[derive(Clone, Debug, PartialEq)]
pub struct DistanceMatrix {
    size: usize,
    upper: Vec<f64>,
}

impl DistanceMatrix {
    /// From d₀₁, d₀₂, …, d₁₂, …: n(n−1)/2 values. `None` if the count is another, or a distance
    /// is negative or not finite.
    pub fn from_upper(size: usize, upper: Vec<f64>) -> Option<Self> {
        let fits = upper.len() == size * size.saturating_sub(1) / 2;
        // A distance that is not a number would be passed on by every map.
        let distances = upper.iter().all(|d| d.is_finite() && *d >= 0.0);
        (fits && distances).then_some(Self { size, upper })
    }

    /// Of `size` items, from the distance of any two, i < j. `None` if one is negative or not finite.
    pub fn of_pairs(size: usize, distance: impl Fn(usize, usize) -> f64) -> Option<Self> {
        let distance = &distance;
        let upper = (0..size).flat_map(|i| (i + 1..size).map(move |j| distance(i, j)));
        Self::from_upper(size, upper.collect())
    }

    /// Euclidean distances of `items` points, rows of equal length one after the other. `None` if one
    /// is not finite.
    pub fn of_points(points: &[f64], items: usize) -> Option<Self> {
        let width = points.len() / items.max(1);
        let row = |i: usize| &points[i * width..][..width];
        // Squares of very large or small steps are no numbers; in this unit they are.
        let unit = moderate_unit(points.iter().fold(0.0, |most, x| x.abs().max(most)));
        Self::of_pairs(items, |i, j| {
            let steps = row(i).iter().zip(row(j));
            let squares = steps.map(|(a, b)| (a / unit - b / unit).powi(2));
            unit * squares.sum::<f64>().sqrt()
        })
    }

    /// No rows.
    pub fn empty() -> Self {
        Self {
            size: 0,
            upper: Vec::new(),
        }
    }

    /// d(i, i+1), d(i, i+2), …: what row `i` holds to the right of the diagonal.
    pub fn row_right_of_diagonal(&self, i: usize) -> &[f64] {
        &self.upper[i * self.size - i * (i + 1) / 2..][..self.size - i - 1]
    }

    /// Number of rows.
    pub fn size(&self) -> usize {
        self.size
    }

    /// d₀₁, d₀₂, …, d₁₂, …
    pub fn upper(&self) -> &[f64] {
        &self.upper
    }

    /// Distance of items `i` and `j`, both below `size`.
    pub fn get(&self, i: usize, j: usize) -> f64 {
        let (low, high) = (i.min(j), i.max(j));
        if low == high {
            return 0.0;
        }
        // Rows before `low` hold (size−1) + (size−2) + … entries.
        self.upper[low * self.size - low * (low + 1) / 2 + high - low - 1]
    }
}

/// Distances of all poses of all subjects in correspondence.
#[derive(Clone, Debug, PartialEq)]
pub struct PoseDistances {
    /// What each row stands for: by subject, then by frame.
    pub poses: Vec<PoseId>,
    /// The distances; without unit where the metric is scale-free.
    pub distances: DistanceMatrix,
    /// Subjects that do not correspond with the largest group.
    pub left_out: Vec<LeftOut>,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn entries_come_back_from_both_sides_of_the_diagonal() {
        let matrix = DistanceMatrix::from_upper(4, vec![1.0, 2.0, 3.0, 4.0, 5.0, 6.0]).unwrap();
        assert_eq!(matrix.get(0, 3), 3.0);
        assert_eq!(matrix.get(2, 1), 4.0);
        assert_eq!(matrix.get(3, 2), 6.0);
        assert_eq!(matrix.get(2, 2), 0.0);
        assert_eq!(matrix.row_right_of_diagonal(1), [4.0, 5.0]);
        assert!(matrix.row_right_of_diagonal(3).is_empty());
        assert!(DistanceMatrix::from_upper(4, vec![0.0; 5]).is_none());
        assert!(DistanceMatrix::from_upper(2, vec![f64::NAN]).is_none());
        assert!(DistanceMatrix::from_upper(2, vec![-1.0]).is_none());
    }

    #[test]
    fn distances_of_points_are_those_of_pythagoras_in_the_order_of_rows() {
        let points = [0.0, 0.0, 3.0, 4.0, 3.0, 0.0];
        let matrix = DistanceMatrix::of_points(&points, 3).unwrap();
        assert_eq!(matrix.upper(), [5.0, 3.0, 4.0]);
        let named = DistanceMatrix::of_pairs(3, |i, j| (10 * i + j) as f64).unwrap();
        assert_eq!(named.upper(), [1.0, 2.0, 12.0]);
        assert_eq!(
            DistanceMatrix::of_points(&[], 0),
            Some(DistanceMatrix::empty())
        );
        assert!(DistanceMatrix::of_points(&[0.0, f64::NAN], 2).is_none());
    }
}
