//! The largest eigenvalues of a large symmetric operator, stoppable at every product.

use crate::progress::Stopped;

use super::{Eigen, EigenDiverged, add_scaled, dot, symmetric_eigen};

/// Why there are no leading eigenvalues.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum LeadingEigenError {
    /// The products were stopped.
    #[error("{0}")]
    Stopped(#[from] Stopped),
    /// The small problem inside did not converge.
    #[error(transparent)]
    Diverged(#[from] EigenDiverged),
}

/// Residual over the largest Ritz value at which a pair counts as found: far below what a map
/// shows, and some hundred times above what round-off of products with 10⁴ terms leaves.
const RESIDUAL: f64 = 1e-12;
/// Products after which the answer is taken as it is.
const MAX_PRODUCTS: usize = 300;

/// The `count` algebraically largest eigenvalues of a symmetric operator on vectors of `size`.
///
/// Lanczos iteration with full reorthogonalisation from a fixed start vector: with V the
/// orthonormal Krylov basis, A V = V T + β v eᵀ; eigenpairs (θ, y) of the small tridiagonal T give
/// eigenpairs (θ, V y) of A with residual β |y_last|. `product(x, out)` writes A x.
///
/// Where the Krylov space closes before enough is found, as it does at multiple eigenvalues, the
/// iteration goes on from another start vector outside of it.
///
/// Source: Golub and Van Loan, *Matrix Computations*, 4th ed., section 10.1.
///
/// # Errors
/// If `product` was stopped, or its values are not finite.
pub fn leading_eigen(
    size: usize,
    count: usize,
    mut product: impl FnMut(&[f64], &mut [f64]) -> Result<(), Stopped>,
) -> Result<Eigen, LeadingEigenError> {
    let count = count.min(size);
    if count == 0 {
        return Ok(Eigen {
            values: Vec::new(),
            vectors: Vec::new(),
        });
    }
    let mut basis: Vec<Vec<f64>> = vec![start_vector(size, 0)];
    let (mut diagonal, mut beside) = (Vec::new(), Vec::new());
    let mut next = vec![0.0; size];
    let most = MAX_PRODUCTS.max(count + 1).min(size);
    let mut restarts = 0;
    loop {
        let newest = basis.len() - 1;
        product(&basis[newest], &mut next)?;
        diagonal.push(dot(&basis[newest], &next));
        let scale = diagonal.iter().fold(0.0_f64, |m, d: &f64| m.max(d.abs()));
        let mut length = orthogonalise_against(&basis, &mut next);
        let steps = diagonal.len();
        let invariant = length <= f64::EPSILON * scale * (size as f64).sqrt();
        if steps >= most || (steps >= count && (invariant || steps.is_multiple_of(5))) {
            let small = symmetric_eigen(steps, &tridiagonal(&diagonal, &beside))?;
            let found = small.vectors[..count.min(steps)]
                .iter()
                .all(|y| length * y[steps - 1].abs() <= RESIDUAL * scale);
            if steps >= most || (found && !invariant) || (invariant && restarts >= count) {
                return Ok(ritz_vectors(&small, &basis, count));
            }
        }
        if invariant {
            // The space found so far is closed: go on outside of it, for multiple eigenvalues.
            restarts += 1;
            next = start_vector(size, restarts);
            length = 0.0;
            let outside = orthogonalise_against(&basis, &mut next);
            next.iter_mut().for_each(|x| *x /= outside);
        } else {
            next.iter_mut().for_each(|x| *x /= length);
        }
        beside.push(length);
        basis.push(next.clone());
    }
}

/// Takes out what lies along the basis, and returns the length of the rest.
fn orthogonalise_against(basis: &[Vec<f64>], vector: &mut [f64]) -> f64 {
    // Twice is enough (Parlett): the second pass removes what round-off left of the first.
    for _ in 0..2 {
        for member in basis {
            let along = dot(member, vector);
            add_scaled(vector, -along, member);
        }
    }
    dot(vector, vector).sqrt()
}

/// Eigenvectors of the operator from those of the small tridiagonal matrix.
fn ritz_vectors(small: &Eigen, basis: &[Vec<f64>], count: usize) -> Eigen {
    let vectors = small.vectors[..count].iter().map(|weights| {
        let mut vector = vec![0.0; basis.first().map_or(0, Vec::len)];
        for (&weight, member) in weights.iter().zip(basis) {
            add_scaled(&mut vector, weight, member);
        }
        let length = dot(&vector, &vector).sqrt();
        vector.iter_mut().for_each(|x| *x /= length);
        vector
    });
    Eigen {
        vectors: vectors.collect(),
        values: small.values[..count].to_vec(),
    }
}

fn tridiagonal(diagonal: &[f64], beside: &[f64]) -> Vec<f64> {
    let n = diagonal.len();
    let mut matrix = vec![0.0; n * n];
    for i in 0..n {
        matrix[i * n + i] = diagonal[i];
        if i + 1 < n {
            matrix[i * n + i + 1] = beside[i];
            matrix[(i + 1) * n + i] = beside[i];
        }
    }
    matrix
}

/// Entries that look random and are always the same (a Weyl sequence), length 1.
fn start_vector(size: usize, restart: usize) -> Vec<f64> {
    let golden = 0.618_033_988_749_894_9;
    let mut vector: Vec<f64> = (0..size)
        .map(|i| ((i + 1 + restart * size) as f64 * golden).fract() - 0.5)
        .map(|x| x + 0.1 * (x * 37.0).sin())
        .collect();
    let length = dot(&vector, &vector).sqrt();
    vector.iter_mut().for_each(|x| *x /= length);
    vector
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn leading_values_are_those_of_the_whole_decomposition() {
        let n = 120;
        let matrix: Vec<f64> = (0..n * n)
            .map(|at| {
                let (i, j) = ((at / n) as f64, (at % n) as f64);
                (-((i - j) / 9.0).powi(2)).exp() + (0.3 * i).sin() * (0.3 * j).sin()
            })
            .collect();
        let whole = symmetric_eigen(n, &matrix).unwrap();
        let leading = leading_eigen(n, 4, |x, out| {
            for (row, out) in matrix.chunks_exact(n).zip(out) {
                *out = dot(row, x);
            }
            Ok(())
        })
        .unwrap();
        for k in 0..4 {
            assert!((leading.values[k] - whole.values[k]).abs() < 1e-10 * whole.values[0]);
            assert!((dot(&leading.vectors[k], &whole.vectors[k]).abs() - 1.0).abs() < 1e-10);
        }
    }

    #[test]
    fn a_matrix_of_low_rank_ends_early() {
        let eigen = leading_eigen(30, 2, |x, out| {
            let sum: f64 = x.iter().sum();
            out.fill(sum);
            Ok(())
        })
        .unwrap();
        assert!((eigen.values[0] - 30.0).abs() < 1e-12);
    }

    #[test]
    fn a_multiple_eigenvalue_is_found_as_often_as_asked_for() {
        let eigen = leading_eigen(40, 3, |x, out| {
            let mean = x.iter().sum::<f64>() / 40.0;
            out.iter_mut()
                .zip(x)
                .for_each(|(out, x)| *out = 2.0 * (x - mean));
            Ok(())
        })
        .unwrap();
        assert!(eigen.values.iter().all(|value| (value - 2.0).abs() < 1e-12));
        assert!(dot(&eigen.vectors[0], &eigen.vectors[2]).abs() < 1e-12);
    }

    #[test]
    fn a_stopped_product_stops_the_iteration() {
        let stopped = leading_eigen(5, 2, |_, _| Err(Stopped));
        assert_eq!(stopped, Err(LeadingEigenError::Stopped(Stopped)));
    }
}
