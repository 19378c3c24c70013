//! Questions for paths: which file or folder is opened or written.

use std::path::PathBuf;
use std::sync::Arc;

use crate::document::state::State;
use crate::engine::Engine;
use crate::panes::Command;

/// What a dialog asks the person at the screen.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PathQuestion {
    /// Files to open.
    OpenFiles,
    /// Folders to open.
    OpenFolders,
    /// The file of a classifier to open.
    OpenClassifier,
    /// A new file for a classifier.
    SaveClassifier,
    /// A new file for a figure.
    SaveFigure {
        /// What the dialog is called.
        title: &'static str,
        /// The name that it proposes.
        suggested: String,
    },
    /// A folder for tables.
    SaveTables,
    /// An empty folder for a study.
    SaveStudy,
}

impl PathQuestion {
    /// What the dialog is called.
    pub fn title(&self) -> &'static str {
        match self {
            Self::OpenFiles => "Open meshes or a study",
            Self::OpenFolders => "Open a folder of meshes",
            Self::OpenClassifier => "Open a classifier",
            Self::SaveClassifier => "Save a classifier trained on the study",
            Self::SaveFigure { title, .. } => title,
            Self::SaveTables => "Save all tables into a folder",
            Self::SaveStudy => "Save the study into an empty folder",
        }
    }

    /// What its button says.
    pub fn verb(&self) -> &'static str {
        match self {
            Self::OpenFiles | Self::OpenFolders | Self::OpenClassifier => "Open",
            Self::SaveFigure { .. } | Self::SaveTables | Self::SaveStudy | Self::SaveClassifier => {
                "Save"
            }
        }
    }

    /// The name that it proposes.
    pub fn suggested(&self) -> &str {
        match self {
            Self::SaveFigure { suggested, .. } => suggested,
            Self::SaveTables => "cardiomorph-tables",
            Self::SaveStudy => "cardiomorph-study",
            Self::SaveClassifier => "classifier.json",
            Self::OpenFiles | Self::OpenFolders | Self::OpenClassifier => "",
        }
    }
}

/// Answers questions about paths: the dialogs of the operating system, or a test. `None` if nothing was chosen.
pub type AskPaths = Arc<dyn Fn(&PathQuestion) -> Option<Vec<PathBuf>> + Send + Sync>;

/// What is done with the paths that were chosen; files to open are a command. What a file will hold is fixed before its
/// place is asked for: while a dialog is open, the window goes on, and another subject may be selected.
pub type Then = Box<dyn FnOnce(&mut State, &mut Engine, Vec<PathBuf>) -> Option<Command>>;
