//! Which way round a map lies: always the same way.

use crate::numeric::symmetric_eigen;

/// Turns axes so that the entry of largest size is positive, the first of equal ones.
pub(super) fn oriented(mut coordinates: Vec<f64>, dimensions: usize) -> Vec<f64> {
    for axis in 0..dimensions {
        let along = || coordinates.iter().skip(axis).step_by(dimensions);
        let largest = along().fold(0.0_f64, |m, x| m.max(x.abs()));
        // Entries that differ by round-off count as equal, lest round-off turn the axis.
        let leading = along().find(|x| x.abs() >= largest * (1.0 - 1e-9));
        if leading.is_some_and(|&x| x < 0.0) {
            let entries = coordinates.iter_mut().skip(axis).step_by(dimensions);
            entries.for_each(|x| *x = -*x);
        }
    }
    coordinates
}

/// Centres points and turns them onto their principal axes, the longest first.
pub(super) fn on_principal_axes(mut coordinates: Vec<f64>, dimensions: usize) -> Vec<f64> {
    let items = coordinates.len() / dimensions.max(1);
    if items == 0 {
        return coordinates;
    }
    centre(&mut coordinates, dimensions);
    let scatter = cross_products(&coordinates, dimensions);
    // A map that cannot be turned is still a map.
    let Ok(eigen) = symmetric_eigen(dimensions, &scatter) else {
        return coordinates;
    };
    let turned = coordinates
        .chunks_exact(dimensions)
        .flat_map(|point| {
            let along = |axis: &Vec<f64>| axis.iter().zip(point).map(|(a, x)| a * x).sum::<f64>();
            eigen.vectors.iter().map(along).collect::<Vec<f64>>()
        })
        .collect();
    oriented(turned, dimensions)
}

/// Moves the mean to the origin.
fn centre(coordinates: &mut [f64], dimensions: usize) {
    let items = (coordinates.len() / dimensions.max(1)).max(1);
    let means: Vec<f64> = (0..dimensions)
        .map(|axis| {
            let sum: f64 = coordinates.iter().skip(axis).step_by(dimensions).sum();
            sum / items as f64
        })
        .collect();
    for point in coordinates.chunks_exact_mut(dimensions.max(1)) {
        for (x, mean) in point.iter_mut().zip(&means) {
            *x -= mean;
        }
    }
}

/// XᵀX, row by row.
fn cross_products(x: &[f64], dimensions: usize) -> Vec<f64> {
    let mut products = vec![0.0; dimensions * dimensions];
    let width = dimensions.max(1);
    for point in x.chunks_exact(width) {
        for (row, a) in point.iter().enumerate() {
            for (column, b) in point.iter().enumerate() {
                products[row * dimensions + column] += a * b;
            }
        }
    }
    products
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_longest_axis_comes_first_and_its_farthest_item_is_positive() {
        let turned = on_principal_axes(vec![0.0, -9.0, 0.0, 1.0, 0.5, 2.0, -0.5, 2.0], 2);
        assert!(turned[0] > 0.0);
        assert!((turned[0] - 8.0).abs() < 1e-12);
    }
}
