//! Why there are no verdicts at all.

use crate::progress::Stopped;

/// Why there are no verdicts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum VerdictError {
    /// It was asked to stop.
    #[error("{0}")]
    Stopped(#[from] Stopped),
    /// Thickening and subjects are not of the same subjects.
    #[error("thickening of {examined} subjects does not belong to {subjects} subjects")]
    Count {
        /// Subjects with thickening, or with the reason why there is none.
        examined: usize,
        /// Subjects of the study.
        subjects: usize,
    },
}
