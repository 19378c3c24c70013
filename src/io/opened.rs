//! What opening paths brings: a study of all that could be read, and one error for each that could not.

use std::path::PathBuf;

use crate::study::{Notice, Study};

/// A file or subject that could not be opened; the rest goes on.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{reason}: {}", path.display())]
pub struct OpenError {
    /// Subject it would have been, if known.
    pub subject: Option<String>,
    /// The file or folder.
    pub path: PathBuf,
    /// Line or byte, and what is wrong.
    pub reason: String,
}

/// The outcome of opening.
#[derive(Clone, Debug, Default)]
pub struct Opened {
    /// All subjects that could be read; none if nothing could.
    pub study: Study,
    /// One for each thing that could not be read.
    pub errors: Vec<OpenError>,
    /// What was assumed about the study as a whole.
    pub notices: Vec<Notice>,
}
