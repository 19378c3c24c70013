//! The vectors on items that are most nearly the mean of themselves over neighbours.

use rayon::prelude::*;

use crate::numeric::{LowerCsc, SparseCholesky, leading_eigen, symmetric_eigen};
use crate::progress::{Progress, Stopped};

use super::{EmbeddingError, LocalWeights};

/// Items up to which all eigenvectors are computed, some 3 ms; past it only those asked for.
const MAX_FOR_ALL: usize = 160;
/// Shift of the factorised matrix over its largest diagonal entry: some hundred times what
/// round-off leaves of the eigenvalue zero, and a thousandth of the least other ones seen (10⁻⁹).
const SHIFT: f64 = 1e-13;
/// How much larger the shift becomes where a matrix is still not positive definite with it.
const MORE_SHIFT: f64 = 100.0;

/// The `count` orthonormal vectors v with the least |v − W v|² and mean zero, and these numbers, ascending.
///
/// They are eigenvectors of M = (1 − W)ᵀ(1 − W) on the complement of the constant vector. For many items
/// they are the leading ones of (M + σ)⁻¹ there, by sparse Cholesky factors and Lanczos iteration;
/// σ changes how fast that goes, not what is found. Within the space found, values are taken from
/// (1 − W) v, without squaring: so they keep the digits that M loses to round-off.
pub(super) fn bottom_eigenvectors(
    weights: &LocalWeights,
    count: usize,
    progress: &Progress,
) -> Result<(Vec<f64>, Vec<Vec<f64>>), EmbeddingError> {
    let size = weights.neighbours().len();
    let columns = normal_matrix(weights, progress)?;
    // A full decomposition grows with the cube of the size, Lanczos steps with the number of entries.
    let vectors = if size <= MAX_FOR_ALL {
        by_whole_decomposition(&columns, count)?
    } else {
        by_shifted_inverse(&columns, count, progress)?
    };
    // Both routes leave vectors that are accurate as a space and not one by one.
    settled(weights, &vectors)
}

/// M = (1 − W)ᵀ(1 − W), its lower triangle.
fn normal_matrix(weights: &LocalWeights, progress: &Progress) -> Result<LowerCsc, Stopped> {
    let neighbours = weights.neighbours();
    let size = neighbours.len();
    // Who names an item as a neighbour, ascending.
    let mut named_by: Vec<Vec<(usize, f64)>> = vec![Vec::new(); size];
    for item in 0..size {
        for (&other, weight) in neighbours.of(item).iter().zip(weights.of(item)) {
            named_by[other as usize].push((item, -weight));
        }
    }
    let columns = (0..size)
        .into_par_iter()
        .map_init(
            || vec![0.0; size],
            |sums, column| {
                progress.step()?;
                let mut rows = vec![column];
                let mut add = |row: usize, value: f64| {
                    if row >= column {
                        if sums[row] == 0.0 {
                            rows.push(row);
                        }
                        sums[row] += value;
                    }
                };
                for &(item, factor) in named_by[column].iter().chain([&(column, 1.0)]) {
                    add(item, factor);
                    for (&other, weight) in neighbours.of(item).iter().zip(weights.of(item)) {
                        add(other as usize, -factor * weight);
                    }
                }
                // A sum that passed through zero has its row twice.
                rows.sort_unstable();
                rows.dedup();
                let values: Vec<f64> = rows.iter().map(|&row| sums[row]).collect();
                rows.iter().for_each(|&row| sums[row] = 0.0);
                Ok((rows, values))
            },
        )
        .collect::<Result<Vec<_>, Stopped>>()?;
    let mut matrix = LowerCsc {
        starts: vec![0],
        rows: Vec::new(),
        values: Vec::new(),
    };
    for (rows, values) in columns {
        matrix.rows.extend(rows);
        matrix.values.extend(values);
        matrix.starts.push(matrix.rows.len());
    }
    Ok(matrix)
}

fn largest_diagonal(matrix: &LowerCsc) -> f64 {
    let diagonal = matrix.starts[..matrix.size()].iter();
    diagonal.fold(0.0, |m, &start| matrix.values[start].max(m))
}

fn by_whole_decomposition(
    matrix: &LowerCsc,
    count: usize,
) -> Result<Vec<Vec<f64>>, EmbeddingError> {
    let size = matrix.size();
    // The constant vector is moved to the other end of the spectrum.
    let away = 2.0
        * (0..size)
            .map(|i| matrix.values[matrix.starts[i]])
            .sum::<f64>()
        / size as f64;
    let mut dense = vec![away; size * size];
    for column in 0..size {
        for at in matrix.starts[column]..matrix.starts[column + 1] {
            dense[matrix.rows[at] * size + column] += matrix.values[at];
        }
    }
    let mut eigen = symmetric_eigen(size, &dense)?;
    let least = eigen.vectors.split_off(size - count);
    Ok(least.into_iter().rev().collect())
}

fn by_shifted_inverse(
    matrix: &LowerCsc,
    count: usize,
    progress: &Progress,
) -> Result<Vec<Vec<f64>>, EmbeddingError> {
    let size = matrix.size();
    // M is singular, so that it cannot be inverted without a shift; this one is at round-off.
    let mut shift = SHIFT * largest_diagonal(matrix);
    let factor = loop {
        progress.step()?;
        match SparseCholesky::shifted(matrix, shift) {
            Ok(factor) => break factor,
            // A shift of this size is sure to suffice, but where something is not a number.
            Err(_) if shift > largest_diagonal(matrix) || !shift.is_finite() => {
                return Err(crate::numeric::EigenDiverged { size }.into());
            }
            Err(_) => shift *= MORE_SHIFT,
        }
    };
    let eigen = leading_eigen(size, count, |x, out| {
        out.copy_from_slice(x);
        // The constant vector has eigenvalue 0 and would be the first one found; rounding brings it back each time.
        centre(out);
        factor.solve(out);
        centre(out);
        progress.step()
    })?;
    Ok(eigen.vectors)
}

fn centre(x: &mut [f64]) {
    let mean = x.iter().sum::<f64>() / x.len() as f64;
    x.iter_mut().for_each(|x| *x -= mean);
}

/// Turns vectors within the space they span so that their images under 1 − W are orthogonal.
fn settled(
    weights: &LocalWeights,
    vectors: &[Vec<f64>],
) -> Result<(Vec<f64>, Vec<Vec<f64>>), EmbeddingError> {
    let count = vectors.len();
    // From (I − W) v itself: of M = (I − W)ᵀ(I − W) small eigenvalues would be round-off.
    let images: Vec<Vec<f64>> = vectors.iter().map(|v| residual(weights, v)).collect();
    let mut products = vec![0.0; count * count];
    for i in 0..count {
        for j in 0..count {
            products[i * count + j] = images[i].iter().zip(&images[j]).map(|(a, b)| a * b).sum();
        }
    }
    let eigen = symmetric_eigen(count, &products)?;
    let turned = eigen.vectors.iter().rev().map(|turn| {
        let mut sum = vec![0.0; weights.neighbours().len()];
        for (part, vector) in turn.iter().zip(vectors) {
            sum.iter_mut().zip(vector).for_each(|(s, x)| *s += part * x);
        }
        sum
    });
    let vectors = turned.collect();
    let values = eigen.values.iter().rev().map(|value| value.max(0.0));
    Ok((values.collect(), vectors))
}

/// v − W v.
fn residual(weights: &LocalWeights, v: &[f64]) -> Vec<f64> {
    let neighbours = weights.neighbours();
    (v.iter().enumerate())
        .map(|(item, here)| {
            let mean: f64 = (neighbours.of(item).iter().zip(weights.of(item)))
                .map(|(&other, weight)| weight * v[other as usize])
                .sum();
            here - mean
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::embedding::LleParams;

    fn weights(items: u32) -> LocalWeights {
        let points: Vec<f64> = (0..items)
            .map(|i| 0.754_877_666 * f64::from(i))
            .flat_map(|t| [t.fract(), (1.324_717_957 * t).fract()])
            .collect();
        let params = LleParams {
            neighbours: 7,
            ..LleParams::default()
        };
        let params = params.check().unwrap();
        LocalWeights::of_points(&points, items as usize, &params, &Progress::default()).unwrap()
    }

    #[test]
    fn both_routes_find_the_same_space() {
        let weights = weights(150);
        let matrix = normal_matrix(&weights, &Progress::default()).unwrap();
        let whole = by_whole_decomposition(&matrix, 3).unwrap();
        let iterated = by_shifted_inverse(&matrix, 3, &Progress::default()).unwrap();
        let (a, va) = settled(&weights, &whole).unwrap();
        let (b, vb) = settled(&weights, &iterated).unwrap();
        for k in 0..3 {
            assert!((a[k] - b[k]).abs() < 1e-9 * a[k], "{} {}", a[k], b[k]);
            let along: f64 = va[k].iter().zip(&vb[k]).map(|(a, b)| a * b).sum();
            assert!((along.abs() - 1.0).abs() < 1e-9);
        }
    }

    #[test]
    fn the_matrix_is_that_of_the_definition() {
        let weights = weights(30);
        let matrix = normal_matrix(&weights, &Progress::default()).unwrap();
        let unit = |at: usize| {
            let mut v = vec![0.0; 30];
            v[at] = 1.0;
            residual(&weights, &v)
        };
        for column in 0..30 {
            let image = unit(column);
            let range = matrix.starts[column]..matrix.starts[column + 1];
            let entries: std::collections::HashMap<usize, f64> = range
                .map(|at| (matrix.rows[at], matrix.values[at]))
                .collect();
            for row in column..30 {
                let expected: f64 = unit(row).iter().zip(&image).map(|(a, b)| a * b).sum();
                let found = entries.get(&row).copied().unwrap_or(0.0);
                assert!((found - expected).abs() < 1e-14);
            }
        }
    }
}
