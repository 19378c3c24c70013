//! Classifiers as files: what `learn` and the window write, and what they read.

use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};

use crate::analysis::verdicts::{CheckedClassifier, ClassifierFile};
use crate::engine::export::ExportFile;
use crate::report::pretty_json;

/// Largest file that is read as a rule: one of a hundred labels takes a twentieth.
const MAX_BYTES: u64 = 4 << 20;

/// A rule from its file, called as the file is.
///
/// # Errors
/// If the file cannot be read, is none, or of another version: why, in which line, and which file.
pub fn read_classifier(path: &Path) -> Result<CheckedClassifier, String> {
    let why = |error: &dyn std::fmt::Display| {
        format!(
            "cannot use the classifier file: {error}: {}",
            path.display()
        )
    };
    let mut text = String::new();
    File::open(path)
        .and_then(|file| file.take(MAX_BYTES).read_to_string(&mut text))
        .map_err(|error| why(&error))?;
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    let rule = ClassifierFile::read(&text).and_then(|rule| rule.check(&name));
    rule.map_err(|error| why(&error))
}

/// The file of a rule.
///
/// # Errors
/// If it cannot be written as JSON.
pub fn classifier_file(
    rule: &ClassifierFile,
    path: PathBuf,
) -> Result<ExportFile, serde_json::Error> {
    let text = pretty_json(&serde_json::to_value(rule)?)?;
    Ok(ExportFile {
        path,
        bytes: text.into_bytes().into(),
    })
}
