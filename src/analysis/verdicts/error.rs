//! Why there are no verdicts at all.

use crate::progress::Stopped;

/// Why there are no verdicts.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum VerdictError {
    /// It was asked to stop.
    #[error("{0}")]
    Stopped(#[from] Stopped),
    /// The classifier that ships with the program cannot be read.
    #[error("the built-in classifier cannot be used: {0}")]
    BuiltIn(#[from] ClassifierError),
    /// Thickening and subjects are not of the same subjects.
    #[error("thickening of {examined} subjects does not belong to {subjects} subjects")]
    Count {
        /// Subjects with thickening, or with the reason why there is none.
        examined: usize,
        /// Subjects of the study.
        subjects: usize,
    },
}

/// Why no classifier could be trained.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
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
    /// Nothing to read was named.
    #[error("a classifier reads at least one model feature")]
    NoFeatures,
}

/// Why a rule cannot be applied.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum ClassifierError {
    /// Its text is that of none.
    #[error("{0}")]
    Text(String),
    /// It is none, or of another version.
    #[error("version {version} of “{format}” is not a rule that this version reads")]
    Form {
        /// What it calls itself.
        format: String,
        /// Its version.
        version: u32,
    },
    /// It reads a feature that is none of this program's, or in another unit.
    #[error("it reads a feature that this version does not have: {0}")]
    Feature(String),
    /// It reads none, or not in the order of this program.
    #[error("its features are none, or not in the order of the program")]
    Order,
    /// Numbers are missing, infinite, or divide by zero.
    #[error("its numbers are not those of a classifier")]
    Numbers,
}
