//! Solves with one sparse symmetric positive definite matrix, many times.

use std::sync::Arc;

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::LltRegularization;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, LltRef, SymbolicCholesky, SymmetricOrdering,
    factorize_symbolic_cholesky,
};
use faer::sparse::{SparseColMat, Triplet};
use faer::{Conj, MatMut, Par, Side, Spec};

/// A = L Lᵀ of a sparse matrix, ordered to fill little; one thread, so that bits never differ.
#[derive(Clone, Debug)]
pub struct SparseCholesky {
    size: usize,
    symbolic: Arc<SymbolicCholesky<usize>>,
    values: Arc<[f64]>,
}

/// Why a matrix cannot be factorised.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SparseCholeskyError {
    /// A pivot is zero, negative or not a number.
    #[error("the {size} × {size} matrix is not positive definite")]
    NotPositiveDefinite {
        /// Rows of the matrix.
        size: usize,
    },
    /// An entry lies outside the matrix, or above its diagonal.
    #[error("entry at row {row}, column {column} is not in the lower triangle of {size} rows")]
    Outside {
        /// Row of the entry.
        row: usize,
        /// Column of the entry.
        column: usize,
        /// Rows of the matrix.
        size: usize,
    },
    /// There is not enough memory.
    #[error("no memory for the factors of a {size} × {size} matrix")]
    Memory {
        /// Rows of the matrix.
        size: usize,
    },
}

impl SparseCholesky {
    /// Factorises the symmetric matrix whose lower triangle is the sum of `entries` (row, column,
    /// value).
    ///
    /// # Errors
    /// If the matrix is not positive definite, or an entry is not in the lower triangle.
    pub fn new(size: usize, entries: &[(usize, usize, f64)]) -> Result<Self, SparseCholeskyError> {
        if let Some(&(row, column, _)) =
            (entries.iter()).find(|&&(row, column, _)| row >= size || column > row)
        {
            return Err(SparseCholeskyError::Outside { row, column, size });
        }
        let memory = SparseCholeskyError::Memory { size };
        let triplets: Vec<Triplet<usize, usize, f64>> = entries
            .iter()
            .map(|&(row, column, value)| Triplet::new(row, column, value))
            .collect();
        let matrix =
            SparseColMat::try_new_from_triplets(size, size, &triplets).map_err(|_| memory)?;
        let symbolic = factorize_symbolic_cholesky(
            matrix.symbolic(),
            Side::Lower,
            SymmetricOrdering::Amd,
            CholeskySymbolicParams::default(),
        )
        .map_err(|_| memory)?;
        let mut values = vec![0.0; symbolic.len_val()];
        let scratch = symbolic.factorize_numeric_llt_scratch::<f64>(Par::Seq, Spec::default());
        symbolic
            .factorize_numeric_llt(
                &mut values,
                matrix.as_ref(),
                Side::Lower,
                LltRegularization::default(),
                Par::Seq,
                MemStack::new(&mut MemBuffer::new(scratch)),
                Spec::default(),
            )
            .map_err(|_| SparseCholeskyError::NotPositiveDefinite { size })?;
        if values.iter().any(|value| !value.is_finite()) {
            return Err(SparseCholeskyError::NotPositiveDefinite { size });
        }
        Ok(Self {
            size,
            symbolic: Arc::new(symbolic),
            values: values.into(),
        })
    }

    /// Rows of the matrix.
    pub fn size(&self) -> usize {
        self.size
    }

    /// Entries of L.
    pub fn fill(&self) -> usize {
        self.values.len()
    }

    /// Replaces each column b of length [`Self::size`] by A⁻¹ b; what is left over past the last
    /// whole column stays.
    pub fn solve(&self, columns: &mut [f64]) {
        if self.size == 0 {
            return;
        }
        let count = columns.len() / self.size;
        let whole = &mut columns[..count * self.size];
        let scratch = self.symbolic.solve_in_place_scratch::<f64>(count, Par::Seq);
        LltRef::new(&self.symbolic, &self.values).solve_in_place_with_conj(
            Conj::No,
            MatMut::from_column_major_slice_mut(whole, self.size, count),
            Par::Seq,
            MemStack::new(&mut MemBuffer::new(scratch)),
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The Laplacian of a chain with 1 on its diagonal added: 1D Helmholtz.
    fn chain(size: usize) -> Vec<(usize, usize, f64)> {
        (0..size)
            .flat_map(|i| {
                let below = (i > 0).then(|| (i, i - 1, -1.0));
                [(i, i, 2.0), (i, i, 1.0)].into_iter().chain(below)
            })
            .collect()
    }

    #[test]
    fn a_solution_put_back_gives_the_right_hand_side() {
        let size = 50;
        let factor = SparseCholesky::new(size, &chain(size)).unwrap();
        let right: Vec<f64> = (0..2 * size).map(|i| (1.7 * i as f64).sin()).collect();
        let mut x = right.clone();
        factor.solve(&mut x);
        for (column, b) in x.chunks(size).zip(right.chunks(size)) {
            for i in 0..size {
                let mut sum = 3.0 * column[i];
                if i > 0 {
                    sum -= column[i - 1];
                }
                if i + 1 < size {
                    sum -= column[i + 1];
                }
                assert!((sum - b[i]).abs() < 1e-13);
            }
        }
    }

    #[test]
    fn an_indefinite_matrix_is_refused() {
        let indefinite = [(0, 0, 1.0), (1, 0, 2.0), (1, 1, 1.0)];
        assert_eq!(
            SparseCholesky::new(2, &indefinite).unwrap_err(),
            SparseCholeskyError::NotPositiveDefinite { size: 2 }
        );
        let not_a_number = [(0, 0, f64::NAN)];
        assert!(SparseCholesky::new(1, &not_a_number).is_err());
    }

    #[test]
    fn an_entry_above_the_diagonal_is_refused() {
        assert_eq!(
            SparseCholesky::new(2, &[(0, 1, 1.0)]).unwrap_err(),
            SparseCholeskyError::Outside {
                row: 0,
                column: 1,
                size: 2
            }
        );
    }

    #[test]
    fn no_unknowns_need_no_work() {
        if let Ok(factor) = SparseCholesky::new(0, &[]) {
            factor.solve(&mut []);
        }
    }
}
