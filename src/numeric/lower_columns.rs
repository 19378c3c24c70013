//! A large sparse symmetric matrix, as the lower triangle of it that is needed.

/// The lower triangle of a symmetric matrix, column by column, diagonal entries included.
#[derive(Clone, Debug, PartialEq)]
pub struct LowerCsc {
    /// Where each column starts in the other two, and where the last one ends.
    pub starts: Vec<usize>,
    /// Rows of entries, ascending in each column; the first one is the diagonal's.
    pub rows: Vec<usize>,
    /// Entries.
    pub values: Vec<f64>,
}

impl LowerCsc {
    /// Columns of the matrix.
    pub fn size(&self) -> usize {
        self.starts.len().saturating_sub(1)
    }

    /// Whether columns follow one another, start on the diagonal and ascend.
    pub(super) fn sound(&self) -> bool {
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
