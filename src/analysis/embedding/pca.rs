//! Principal components: the map of points that keeps most of their variance.

use crate::numeric::{moderate_unit, symmetric_eigen};
use crate::progress::Progress;

use super::moderate::back_in;
use super::orientation::oriented;
use super::{Embedding, EmbeddingError};

/// Scores of points on their first principal components.
///
/// `points` holds `items` rows one after the other. Eigenvalues are the variances along the components,
/// Σ (score)² / (n − 1), descending. Computed from whichever is smaller of Xᵀ X and X Xᵀ, X centred; axes
/// point to the item with the largest score.
///
/// The one linear baseline here. Where distances are those between points, classical scaling is the same
/// map; so a matrix of distances needs no method of its own. Factor analysis, which the text names beside
/// it, no kept crate has; independent components, which `linfa-ica` has, say which axes are independent and
/// not where items lie: their plane is this one, sheared.
///
/// Source: Jolliffe, *Principal Component Analysis*, 2nd ed., sections 3.1 and 3.5.
///
/// # Errors
/// If stopped, or `points` does not make rows of finite numbers.
pub fn pca(
    points: &[f64],
    items: usize,
    dimensions: usize,
    progress: &Progress,
) -> Result<Embedding, EmbeddingError> {
    let wrong = EmbeddingError::Points {
        values: points.len(),
        items,
    };
    let width = points.len().checked_div(items).unwrap_or(0);
    if width * items != points.len() || points.iter().any(|x| !x.is_finite()) {
        return Err(wrong);
    }
    let unit = moderate_unit(points.iter().fold(0.0, |most, x| x.abs().max(most)));
    if unit == 1.0 {
        return components(points, items, width, dimensions, progress);
    }
    let moderate: Vec<f64> = points.iter().map(|x| x / unit).collect();
    back_in(
        unit,
        components(&moderate, items, width, dimensions, progress)?,
    )
}

fn components(
    points: &[f64],
    items: usize,
    width: usize,
    dimensions: usize,
    progress: &Progress,
) -> Result<Embedding, EmbeddingError> {
    let centred = centred(points, items, width);
    // Of XXᵀ and XᵀX the smaller one; both have the same eigenvalues but for zeros.
    let by_items = items <= width;
    let size = items.min(width);
    let mut products = vec![0.0; size * size];
    progress.expect_steps(size);
    for i in 0..size {
        progress.step()?;
        for j in 0..=i {
            let product = if by_items {
                (centred[i * width..][..width].iter())
                    .zip(&centred[j * width..][..width])
                    .map(|(a, b)| a * b)
                    .sum()
            } else {
                (0..items)
                    .map(|row| centred[row * width + i] * centred[row * width + j])
                    .sum()
            };
            products[i * size + j] = product;
            products[j * size + i] = product;
        }
    }
    let eigen = symmetric_eigen(size, &products)?;
    let mut coordinates = vec![0.0; items * dimensions];
    for (axis, (value, vector)) in eigen.values.iter().zip(&eigen.vectors).enumerate() {
        if axis == dimensions {
            break;
        }
        for item in 0..items {
            coordinates[item * dimensions + axis] = if by_items {
                value.max(0.0).sqrt() * vector[item]
            } else {
                let row = &centred[item * width..][..width];
                row.iter().zip(vector).map(|(x, v)| x * v).sum()
            };
        }
    }
    // Variance over n − 1, since the mean is estimated from the same items.
    let degrees = items.saturating_sub(1).max(1) as f64;
    Ok(Embedding {
        dimensions,
        coordinates: oriented(coordinates, dimensions),
        eigenvalues: Some(eigen.values.iter().map(|v| v.max(0.0) / degrees).collect()),
        ..Embedding::default()
    })
}

fn centred(points: &[f64], items: usize, width: usize) -> Vec<f64> {
    let mut centred = points.to_vec();
    for column in 0..width {
        let mean = (0..items)
            .map(|row| points[row * width + column])
            .sum::<f64>()
            / items as f64;
        for row in 0..items {
            centred[row * width + column] -= mean;
        }
    }
    centred
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Points on a tilted plane in space, more spread along one direction.
    fn plane(items: u32) -> Vec<f64> {
        (0..items)
            .flat_map(|i| {
                let (u, v) = (f64::from(i), (f64::from(i) * 1.7).sin());
                [u + v, 2.0 * u - v, 5.0 + 0.5 * u]
            })
            .collect()
    }

    #[test]
    fn two_components_keep_all_distances_on_a_plane() {
        for items in [2, 30] {
            let points = plane(items);
            let map = pca(&points, items as usize, 2, &Progress::default()).unwrap();
            let far = |a: &[f64], b: &[f64]| -> f64 {
                a.iter()
                    .zip(b)
                    .map(|(a, b)| (a - b).powi(2))
                    .sum::<f64>()
                    .sqrt()
            };
            let given = far(&points[..3], &points[points.len() - 3..]);
            let kept = far(map.point(0), map.point(items as usize - 1));
            assert!((given - kept).abs() < 1e-10 * given);
        }
    }

    #[test]
    fn eigenvalues_are_the_variances_of_the_scores() {
        let map = pca(&plane(20), 20, 2, &Progress::default()).unwrap();
        let variance = (0..20).map(|i| map.point(i)[0].powi(2)).sum::<f64>() / 19.0;
        assert!((variance - map.eigenvalues.unwrap()[0]).abs() < 1e-10 * variance);
    }

    #[test]
    fn ragged_rows_and_numbers_that_are_none_are_refused() {
        let ragged = pca(&[1.0, 2.0, 3.0], 2, 1, &Progress::default());
        assert_eq!(
            ragged,
            Err(EmbeddingError::Points {
                values: 3,
                items: 2
            })
        );
        assert!(pca(&[f64::NAN, 1.0], 2, 1, &Progress::default()).is_err());
        assert!(pca(&[], 0, 2, &Progress::default()).unwrap().is_empty());
    }
}
