//! Solves with one sparse symmetric positive definite matrix, many times.

use std::sync::Arc;

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::LltRegularization;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, LltRef, SymbolicCholesky, SymmetricOrdering,
    factorize_symbolic_cholesky,
};
use faer::sparse::{SparseColMat, SparseColMatRef, SymbolicSparseColMatRef, Triplet};
use faer::{Conj, MatMut, Par, Side, Spec};

use super::LowerCsc;

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
    /// Columns do not follow one another, start on the diagonal and ascend.
    #[error("columns of a {size} × {size} matrix do not ascend from its diagonal")]
    Columns {
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
        Self::of_triangle(size, matrix.as_ref())
    }

    /// Factorises the matrix with `shift` added to its diagonal: A + σ1.
    ///
    /// Not stoppable: some 30 ms for 2,000 rows with 150 entries each.
    ///
    /// # Errors
    /// If the shifted matrix is not positive definite to working precision, or `matrix` breaks
    /// what [`LowerCsc`] says of itself.
    pub fn shifted(matrix: &LowerCsc, shift: f64) -> Result<Self, SparseCholeskyError> {
        let size = matrix.size();
        if !matrix.sound() {
            return Err(SparseCholeskyError::Columns { size });
        }
        let mut values = matrix.values.clone();
        for &start in &matrix.starts[..size] {
            values[start] += shift;
        }
        let pattern =
            SymbolicSparseColMatRef::new_checked(size, size, &matrix.starts, None, &matrix.rows);
        Self::of_triangle(size, SparseColMatRef::new(pattern, &values))
    }

    fn of_triangle(
        size: usize,
        matrix: SparseColMatRef<'_, usize, f64>,
    ) -> Result<Self, SparseCholeskyError> {
        let memory = SparseCholeskyError::Memory { size };
        let not_positive = SparseCholeskyError::NotPositiveDefinite { size };
        if matrix.val().iter().any(|value| !value.is_finite()) {
            return Err(not_positive);
        }
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
                matrix,
                Side::Lower,
                LltRegularization::default(),
                Par::Seq,
                MemStack::new(&mut MemBuffer::new(scratch)),
                Spec::default(),
            )
            .map_err(|_| not_positive)?;
        if values.iter().any(|value| !value.is_finite()) {
            return Err(not_positive);
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
        let factor = SparseCholesky::new(0, &[]).unwrap();
        assert_eq!((factor.size(), factor.fill()), (0, 0));
        let mut left_over = [1.0, 2.0];
        factor.solve(&mut left_over);
        assert_eq!(left_over, [1.0, 2.0]);
    }

    /// Second difference with fixed ends, times the distance of the ends.
    fn path(size: usize) -> LowerCsc {
        let (mut starts, mut rows, mut values) = (vec![0], Vec::new(), Vec::new());
        for column in 0..size {
            rows.push(column);
            values.push(2.0);
            if column + 1 < size {
                rows.push(column + 1);
                values.push(-1.0);
            }
            starts.push(rows.len());
        }
        LowerCsc {
            starts,
            rows,
            values,
        }
    }

    #[test]
    fn a_loaded_string_hangs_as_the_text_book_says() {
        let factor = SparseCholesky::shifted(&path(99), 0.0).unwrap();
        let mut sag = vec![1.0; 99];
        factor.solve(&mut sag);
        for (i, sag) in sag.iter().enumerate() {
            let at = (i + 1) as f64;
            assert!((sag - at * (100.0 - at) / 2.0).abs() < 1e-9);
        }
    }

    #[test]
    fn a_shift_is_added_to_the_diagonal_only() {
        let factor = SparseCholesky::shifted(&path(2), 1.0).unwrap();
        let mut x = vec![8.0, 0.0];
        factor.solve(&mut x);
        assert!((x[0] - 3.0).abs() < 1e-14 && (x[1] - 1.0).abs() < 1e-14);
    }

    #[test]
    fn a_matrix_that_is_not_positive_or_not_sound_is_refused() {
        let not_positive = SparseCholeskyError::NotPositiveDefinite { size: 5 };
        let refused = |matrix: &LowerCsc, shift| SparseCholesky::shifted(matrix, shift).err();
        assert_eq!(refused(&path(5), -4.0), Some(not_positive));
        let mut broken = path(5);
        broken.values[3] = f64::NAN;
        assert_eq!(refused(&broken, 0.0), Some(not_positive));
        let mut broken = path(5);
        broken.rows[1] = 9;
        let error = SparseCholeskyError::Columns { size: 5 };
        assert_eq!(refused(&broken, 0.0), Some(error));
    }
}
