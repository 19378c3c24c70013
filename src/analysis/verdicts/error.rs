//! Why there are no verdicts at all.

use crate::progress::Stopped;

/// Why nothing is said of any heart.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum VerdictError {
    /// It was asked to stop.
    #[error(transparent)]
    Stopped(#[from] Stopped),
    /// Thickening and subjects are not of the same hearts.
    #[error("thickening of {hearts} subjects does not belong to {subjects} subjects")]
    Count {
        /// Hearts with thickening, or with the reason why there is none.
        hearts: usize,
        /// Subjects of the study.
        subjects: usize,
    },
}
