//! The classifier that ships with the program, for studies with too few labels to train one on.

use std::sync::LazyLock;

use super::checked_classifier::CheckedClassifier;
use super::classifier_file::ClassifierFile;
use super::error::ClassifierError;

/// The text of its file; `assets/classifiers/SOURCE.md` tells how it was made, and why it reads what it reads.
const TEXT: &str = include_str!("../../../assets/classifiers/built-in.json");

/// The classifier that ships with the program, read as any other.
///
/// # Errors
/// If its file is not one of this version: a test excludes that.
pub fn built_in_classifier() -> Result<&'static CheckedClassifier, ClassifierError> {
    static RULE: LazyLock<Result<CheckedClassifier, ClassifierError>> =
        LazyLock::new(|| ClassifierFile::read(TEXT)?.check("built-in"));
    RULE.as_ref().map_err(Clone::clone)
}
