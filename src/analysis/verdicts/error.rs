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

/// Why no rule could be learnt.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum LearnError {
    /// As of verdicts.
    #[error(transparent)]
    Verdicts(#[from] VerdictError),
    /// Too few subjects with a label that counts could be assessed.
    #[error(
        "{normal} normal and {abnormal} abnormal subjects can be assessed; a rule needs {least} of each"
    )]
    TooFew {
        /// Assessed subjects with a normal label.
        normal: usize,
        /// And with an abnormal one.
        abnormal: usize,
        /// What is needed of each.
        least: usize,
    },
}

/// Why a rule cannot be applied.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum RuleError {
    /// It is none, or of another version.
    #[error("version {version} of “{format}” is not a rule that this version reads")]
    Form {
        /// What it calls itself.
        format: String,
        /// Its version.
        version: u32,
    },
    /// It reads other features.
    #[error("it reads other features than this version has")]
    Features,
    /// Numbers are missing, infinite, or divide by zero.
    #[error("its numbers are not those of a classifier")]
    Numbers,
}
