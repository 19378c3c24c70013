//! How far points lie from a surface.

use rayon::prelude::*;

use crate::mesh::{ClosestPoint, Point3};

/// Distances of points from a surface, in the unit of the coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceFit {
    /// Their mean.
    pub mean: f64,
    /// Their 95th percentile, interpolated linearly between the two distances around it.
    pub p95: f64,
    /// The greatest.
    pub greatest: f64,
}

impl SurfaceFit {
    /// Of distances in any order; `None` without any or with one that is no finite number.
    pub fn of_distances(distances: &[f64]) -> Option<Self> {
        let mut sorted = distances.to_vec();
        sorted.sort_unstable_by(f64::total_cmp);
        let greatest = *sorted.last()?;
        if !sorted.iter().all(|distance| distance.is_finite()) {
            return None;
        }
        let place = 0.95 * (sorted.len() - 1) as f64;
        let (below, share) = (place.floor() as usize, place.fract());
        let above = (below + 1).min(sorted.len() - 1);
        Some(Self {
            mean: distances.iter().sum::<f64>() / distances.len() as f64,
            p95: sorted[below] + share * (sorted[above] - sorted[below]),
            greatest,
        })
    }
}

/// The distance of each point from a surface.
pub fn distances_to(surface: &ClosestPoint, points: &[Point3]) -> Vec<f64> {
    points
        .par_iter()
        .map(|&point| surface.distance(point))
        .collect()
}
