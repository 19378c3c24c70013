//! Which way round a map lies: always the same way, or as the map before it.

use crate::numeric::symmetric_eigen;

use super::Embedding;

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
    let scatter = cross_products(&coordinates, &coordinates, dimensions);
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

impl Embedding {
    /// This map turned, mirrored and shifted, not scaled, to lie as near as it can to a map of the
    /// same items: so that a map on screen keeps its orientation when it is computed anew.
    ///
    /// With X, Y the centred coordinates and XᵀY = U S Vᵀ: X ↦ X U Vᵀ + mean of Y. `None` where the
    /// maps have another number of items or dimensions.
    ///
    /// Source: Borg and Groenen, *Modern Multidimensional Scaling*, 2nd ed., section 20.2.
    pub fn procrustes_to(&self, previous: &Self) -> Option<Self> {
        let d = self.dimensions;
        if d != previous.dimensions || self.coordinates.len() != previous.coordinates.len() {
            return None;
        }
        let (mut x, mut y) = (self.coordinates.clone(), previous.coordinates.clone());
        centre(&mut x, d);
        let means = centre(&mut y, d);
        let products = nalgebra::DMatrix::from_row_slice(d, d, &cross_products(&x, &y, d));
        let svd = products.svd(true, true);
        // Reflections are allowed here: a map has no handedness.
        let turn = svd.u? * svd.v_t?;
        let coordinates = x
            .chunks_exact(d.max(1))
            .flat_map(|point| {
                let turn = &turn;
                let means = &means;
                (0..d).map(move |axis| {
                    (0..d).map(|k| point[k] * turn[(k, axis)]).sum::<f64>() + means[axis]
                })
            })
            .collect();
        Some(Self {
            coordinates,
            ..self.clone()
        })
    }
}

/// Moves the mean to the origin and returns where it was.
fn centre(coordinates: &mut [f64], dimensions: usize) -> Vec<f64> {
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
    means
}

/// XᵀY, row by row.
fn cross_products(x: &[f64], y: &[f64], dimensions: usize) -> Vec<f64> {
    let mut products = vec![0.0; dimensions * dimensions];
    let width = dimensions.max(1);
    for (p, q) in x.chunks_exact(width).zip(y.chunks_exact(width)) {
        for (row, a) in p.iter().enumerate() {
            for (column, b) in q.iter().enumerate() {
                products[row * dimensions + column] += a * b;
            }
        }
    }
    products
}

#[cfg(test)]
mod tests {
    use super::*;

    fn map(coordinates: Vec<f64>) -> Embedding {
        Embedding {
            dimensions: 2,
            coordinates,
            ..Embedding::default()
        }
    }

    #[test]
    fn a_turned_mirrored_and_shifted_map_comes_back() {
        let before = map(vec![0.0, 0.0, 4.0, 0.0, 0.0, 1.0, 2.0, 3.0]);
        let (sin, cos) = 0.8_f64.sin_cos();
        let moved = before
            .coordinates
            .chunks_exact(2)
            .flat_map(|p| [cos * p[0] + sin * p[1] + 7.0, sin * p[0] - cos * p[1] - 1.0])
            .collect();
        let back = map(moved).procrustes_to(&before).unwrap();
        for (x, y) in back.coordinates.iter().zip(&before.coordinates) {
            assert!((x - y).abs() < 1e-12);
        }
        assert!(map(vec![0.0; 4]).procrustes_to(&before).is_none());
    }

    #[test]
    fn the_longest_axis_comes_first_and_its_farthest_item_is_positive() {
        let turned = on_principal_axes(vec![0.0, -9.0, 0.0, 1.0, 0.5, 2.0, -0.5, 2.0], 2);
        assert!(turned[0] > 0.0);
        assert!((turned[0] - 8.0).abs() < 1e-12);
    }
}
