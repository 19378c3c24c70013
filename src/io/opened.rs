//! What opening paths brings: a study of all that could be read, and one error for each that could not.

use std::path::PathBuf;
use std::sync::Arc;

use super::ImageSeries;
use crate::study::{Notice, SequenceId, Study};

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

/// What an error of frames ends with whose vertices do not correspond.
pub(super) const NOT_IN_CORRESPONDENCE: &str =
    "; the command register (Register… in the window) gives all frames one mesh";

impl OpenError {
    /// Whether the frames were read, but their vertices do not correspond: a template can be laid onto them.
    pub fn is_without_correspondence(&self) -> bool {
        self.reason.ends_with(NOT_IN_CORRESPONDENCE)
    }
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
    /// Images that were read, with or without subjects made of them; together within [`Limits`](super::Limits).
    pub images: Vec<OpenedImages>,
}

/// The images of one subject: the series that were found together.
#[derive(Clone, Debug)]
pub struct OpenedImages {
    /// Pseudonym: that of the subject, if there is one.
    pub id: String,
    /// The series, at least one; that of which walls are made, or can be expected, comes first.
    pub series: Vec<Arc<ImageSeries>>,
    /// What was left out, and why.
    pub notices: Vec<Notice>,
    /// The surfaces that were made of the first series; `None` where somebody must say more before any are.
    pub made: Option<SequenceId>,
}

impl OpenedImages {
    /// Bytes of all voxels.
    pub fn bytes(&self) -> u64 {
        let of = |series: &Arc<ImageSeries>| {
            let volumes = series.image.volumes().iter();
            volumes
                .map(|volume| size_of_val(&**volume) as u64)
                .sum::<u64>()
        };
        self.series.iter().map(of).sum()
    }
}
