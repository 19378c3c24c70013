//! Solutions with a large sparse symmetric matrix, made once and asked for often.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, LltRef, SymbolicCholesky, SymmetricOrdering,
    factorize_symbolic_cholesky,
};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Conj, MatMut, Par, Side, Spec};

/// The lower triangle of a symmetric matrix, column by column, diagonal entries included.
#[derive(Clone, Debug, PartialEq)]
pub struct LowerColumns {
    /// Where each column starts in the other two, and where the last one ends.
    pub starts: Vec<usize>,
    /// Rows of entries, ascending in each column; the first one is the diagonal's.
    pub rows: Vec<usize>,
    /// Entries.
    pub values: Vec<f64>,
}

impl LowerColumns {
    /// Columns of the matrix.
    pub fn size(&self) -> usize {
        self.starts.len().saturating_sub(1)
    }

    /// Whether columns follow one another, start on the diagonal and ascend.
    fn sound(&self) -> bool {
        let size = self.size();
        let ends = self.starts.first() == Some(&0)
            && self.starts.last() == Some(&self.rows.len())
            && self.rows.len() == self.values.len();
        ends && (0..size).all(|column| {
            let (start, end) = (self.starts[column], self.starts[column + 1]);
            start < end
                && end <= self.rows.len()
                && self.rows[start] == column
                && self.rows[end - 1] < size
                && self.rows[start..end].is_sorted_by(|a, b| a < b)
        })
    }
}

/// The matrix has no Cholesky factor: it is not positive definite, or not a matrix at all.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("a matrix of {size} rows is not positive definite")]
pub struct NotPositive {
    /// Rows of the matrix.
    pub size: usize,
}

/// A factorised sparse positive definite matrix.
pub struct SparseInverse {
    symbolic: SymbolicCholesky<usize>,
    factor: Vec<f64>,
    scratch: MemBuffer,
}

impl SparseInverse {
    /// Factorises the matrix with `shift` added to its diagonal: P (A + σI) Pᵀ = L Lᵀ, P from
    /// approximate minimum degree, by `faer`.
    ///
    /// One thread, so that the bits do not depend on how many there are. Not stoppable: some 30 ms
    /// for 2,000 rows with 150 entries each.
    ///
    /// # Errors
    /// If the shifted matrix is not positive definite to working precision, or `matrix` breaks
    /// what [`LowerColumns`] says of itself.
    pub fn new(matrix: &LowerColumns, shift: f64) -> Result<Self, NotPositive> {
        let size = matrix.size();
        let error = NotPositive { size };
        if !matrix.sound() || matrix.values.iter().any(|value| !value.is_finite()) {
            return Err(error);
        }
        let mut values = matrix.values.clone();
        for &start in &matrix.starts[..size] {
            values[start] += shift;
        }
        let pattern =
            SymbolicSparseColMatRef::new_checked(size, size, &matrix.starts, None, &matrix.rows);
        let symbolic = factorize_symbolic_cholesky(
            pattern,
            Side::Lower,
            SymmetricOrdering::Amd,
            CholeskySymbolicParams::default(),
        )
        .map_err(|_| error)?;
        let mut factor = vec![0.0; symbolic.len_val()];
        let wanted = symbolic.factorize_numeric_llt_scratch::<f64>(Par::Seq, Spec::default());
        symbolic
            .factorize_numeric_llt(
                &mut factor,
                SparseColMatRef::new(pattern, &values),
                Side::Lower,
                Default::default(),
                Par::Seq,
                MemStack::new(&mut MemBuffer::new(wanted)),
                Spec::default(),
            )
            .map_err(|_| error)?;
        let scratch = MemBuffer::new(symbolic.solve_in_place_scratch::<f64>(1, Par::Seq));
        Ok(Self {
            symbolic,
            factor,
            scratch,
        })
    }

    /// Replaces b by (A + σI)⁻¹ b; its length must be the number of rows.
    pub fn solve(&mut self, b: &mut [f64]) {
        let rows = b.len();
        LltRef::new(&self.symbolic, &self.factor).solve_in_place_with_conj(
            Conj::No,
            MatMut::from_column_major_slice_mut(b, rows, 1),
            Par::Seq,
            MemStack::new(&mut self.scratch),
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Second difference with fixed ends, times the distance of the ends.
    fn path(size: usize) -> LowerColumns {
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
        LowerColumns {
            starts,
            rows,
            values,
        }
    }

    #[test]
    fn a_loaded_string_hangs_as_the_text_book_says() {
        let mut inverse = SparseInverse::new(&path(99), 0.0).unwrap();
        let mut sag = vec![1.0; 99];
        inverse.solve(&mut sag);
        for (i, sag) in sag.iter().enumerate() {
            let at = (i + 1) as f64;
            assert!((sag - at * (100.0 - at) / 2.0).abs() < 1e-9);
        }
    }

    #[test]
    fn a_shift_is_added_to_the_diagonal_only() {
        let mut inverse = SparseInverse::new(&path(2), 1.0).unwrap();
        let mut x = vec![8.0, 0.0];
        inverse.solve(&mut x);
        assert!((x[0] - 3.0).abs() < 1e-14 && (x[1] - 1.0).abs() < 1e-14);
    }

    #[test]
    fn a_matrix_that_is_not_positive_or_not_sound_is_refused() {
        let error = NotPositive { size: 5 };
        assert_eq!(SparseInverse::new(&path(5), -4.0).err(), Some(error));
        let mut broken = path(5);
        broken.values[3] = f64::NAN;
        assert_eq!(SparseInverse::new(&broken, 0.0).err(), Some(error));
        let mut broken = path(5);
        broken.rows[1] = 9;
        assert_eq!(SparseInverse::new(&broken, 0.0).err(), Some(error));
    }
}
