//! Classical scaling: the coordinates whose inner products come nearest to those the distances imply.

use rayon::prelude::*;

use crate::analysis::pose_distances::DistanceMatrix;
use crate::numeric::{Eigen, add_scaled, dot, leading_eigen, symmetric_eigen};
use crate::progress::{Progress, Stopped};

use super::moderate::in_moderate_unit;
use super::orientation::oriented;
use super::{Embedding, EmbeddingError, kruskal_stress};

/// Items up to which all eigenvalues are computed (some 40 ms); past it, only the leading ones.
const MAX_FOR_ALL: usize = 512;
/// Parts that a product is shared out in, whatever the number of threads: so bits do not depend on it.
const SHARES: usize = 16;

/// Classical (Torgerson) scaling.
///
/// With B = −½ J D² J, J = 1 − 11ᵀ/n: coordinates are √λₖ vₖ for the largest eigenvalues λ of B;
/// axes with λ ≤ 0 are zero. Exact where distances are Euclidean in `dimensions`; negative eigenvalues
/// tell that they are not Euclidean at all. All eigenvalues are given for up to 512 items;
/// for more those of the axes and the next one, which says what one more axis would hold.
///
/// Axis k has its entry of largest size positive, so that equal distances give the same map.
///
/// Source: Borg and Groenen, *Modern Multidimensional Scaling*, 2nd ed., section 12.1.
///
/// # Errors
/// If stopped, eigenvalues do not converge, or a coordinate is beyond the largest number.
pub fn classical_mds(
    distances: &DistanceMatrix,
    dimensions: usize,
    progress: &Progress,
) -> Result<Embedding, EmbeddingError> {
    in_moderate_unit(distances, |distances| {
        scaled_classically(distances, dimensions, progress)
    })
}

fn scaled_classically(
    distances: &DistanceMatrix,
    dimensions: usize,
    progress: &Progress,
) -> Result<Embedding, EmbeddingError> {
    let items = distances.size();
    progress.step()?;
    // In units of the largest distance: squares of very large or small ones stay representable.
    let unit = distances.upper().iter().fold(0.0_f64, |m, &d| m.max(d));
    let eigen = if unit == 0.0 {
        Eigen {
            values: vec![0.0; items],
            vectors: vec![vec![0.0; items]; dimensions.min(items)],
        }
    } else if items <= MAX_FOR_ALL {
        symmetric_eigen(items, &doubly_centred(distances, unit))?
    } else {
        let centred = CentredSquares::new(distances, unit);
        // One more than the axes: what the next dimension would hold is reported.
        leading_eigen(items, dimensions + 1, |x, out| {
            centred.product(x, out, progress)
        })?
    };
    let mut coordinates = vec![0.0; items * dimensions];
    for (axis, (value, vector)) in eigen.values.iter().zip(&eigen.vectors).enumerate() {
        if axis == dimensions {
            break;
        }
        // Negative eigenvalues have no real coordinates; their axes stay zero.
        let length = unit * value.max(0.0).sqrt();
        for (item, entry) in vector.iter().enumerate() {
            coordinates[item * dimensions + axis] = length * entry;
        }
    }
    let mut map = Embedding {
        dimensions,
        coordinates: oriented(coordinates, dimensions),
        eigenvalues: Some(eigen.values.iter().map(|v| v * unit * unit).collect()),
        ..Embedding::default()
    };
    map.stress = kruskal_stress(distances, &map);
    Ok(map)
}

fn doubly_centred(distances: &DistanceMatrix, unit: f64) -> Vec<f64> {
    let n = distances.size();
    let mut b = vec![0.0; n * n];
    for i in 0..n {
        for (offset, d) in distances.row_right_of_diagonal(i).iter().enumerate() {
            let square = -0.5 * (d / unit).powi(2);
            b[i * n + i + 1 + offset] = square;
            b[(i + 1 + offset) * n + i] = square;
        }
    }
    let means: Vec<f64> = b
        .chunks_exact(n.max(1))
        .map(|row| row.iter().sum::<f64>() / n as f64)
        .collect();
    let mean = means.iter().sum::<f64>() / n as f64;
    for i in 0..n {
        for j in 0..n {
            b[i * n + j] += mean - means[i] - means[j];
        }
    }
    b
}

/// −½ J D² J as an operator. Only the squares right of the diagonal are kept: a product is as fast as
/// memory gives them.
struct CentredSquares {
    items: usize,
    upper: Vec<f64>,
}

impl CentredSquares {
    fn new(distances: &DistanceMatrix, unit: f64) -> Self {
        Self {
            items: distances.size(),
            upper: (distances.upper().par_iter())
                .map(|d| (d / unit).powi(2))
                .collect(),
        }
    }

    fn product(&self, x: &[f64], out: &mut [f64], progress: &Progress) -> Result<(), Stopped> {
        let n = self.items as f64;
        let mean = x.iter().sum::<f64>() / n;
        // Centred on the way in and out, the centred matrix itself is never formed.
        let centred: Vec<f64> = x.iter().map(|x| x - mean).collect();
        // A fixed number of shares, not one per thread: sums in another order would be other bits.
        let shares: Vec<Vec<f64>> = (0..SHARES)
            .into_par_iter()
            .map(|share| self.share_of_product(share, &centred))
            .collect();
        out.fill(0.0);
        for share in shares {
            add_scaled(out, -0.5, &share);
        }
        let mean = out.iter().sum::<f64>() / n;
        out.iter_mut().for_each(|out| *out -= mean);
        progress.step()
    }

    /// What every [`SHARES`]th row, from `share` on, gives: as a row, and as the column that it also is.
    fn share_of_product(&self, share: usize, x: &[f64]) -> Vec<f64> {
        let n = self.items;
        let mut sums = vec![0.0; n];
        // Every sixteenth row: long rows at the top and short ones below are shared out evenly.
        for i in (share..n).step_by(SHARES) {
            let row = &self.upper[i * n - i * (i + 1) / 2..][..n - i - 1];
            sums[i] += dot(row, &x[i + 1..]);
            add_scaled(&mut sums[i + 1..], x[i], row);
        }
        sums
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn distances_of(points: &[[f64; 2]]) -> DistanceMatrix {
        DistanceMatrix::of_points(&points.concat(), points.len()).unwrap()
    }

    fn spiral(count: u32) -> Vec<[f64; 2]> {
        (0..count)
            .map(|i| f64::from(i) * 0.1)
            .map(|t| [t * t.cos(), 0.5 * t * t.sin()])
            .collect()
    }

    #[test]
    fn distances_in_the_plane_are_kept_exactly_by_either_route() {
        for count in [3, 60, 700] {
            let distances = distances_of(&spiral(count));
            let map = classical_mds(&distances, 2, &Progress::default()).unwrap();
            assert!(map.stress.unwrap() < 1e-9, "{count}: {:?}", map.stress);
            let values = map.eigenvalues.unwrap();
            assert_eq!(values.len(), if count <= 512 { count as usize } else { 3 });
            assert!(values[1] > 0.0 && values[2].abs() < 1e-12 * values[0]);
        }
    }

    #[test]
    fn more_dimensions_than_there_are_stay_zero() {
        let distances = distances_of(&[[0.0, 0.0], [3.0, 4.0]]);
        let map = classical_mds(&distances, 3, &Progress::default()).unwrap();
        assert!((map.point(0)[0] - map.point(1)[0]).abs() - 5.0 < 1e-12);
        assert!(map.point(0)[1..].iter().all(|x| x.abs() < 1e-7));
        let none = DistanceMatrix::empty();
        assert!(
            classical_mds(&none, 2, &Progress::default())
                .unwrap()
                .is_empty()
        );
    }

    #[test]
    fn items_that_coincide_lie_at_the_origin() {
        let distances = DistanceMatrix::from_upper(3, vec![0.0; 3]).unwrap();
        let map = classical_mds(&distances, 2, &Progress::default()).unwrap();
        assert_eq!(map.coordinates, [0.0; 6]);
    }

    #[test]
    fn a_stopped_map_says_so() {
        let progress = Progress::default();
        progress.stop();
        let stopped = classical_mds(&distances_of(&spiral(700)), 2, &progress);
        assert_eq!(stopped, Err(EmbeddingError::Stopped(Stopped)));
    }
}
