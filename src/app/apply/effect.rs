//! What a command asks for beyond the state: files, jobs, the window itself.

use std::path::PathBuf;
use std::sync::Arc;

use crate::analysis::preparation::Preparation;
use crate::app::export::FigureKind;
use crate::document::{Leaving, ThemeChoice};
use crate::engine::{OpenSource, Topic};
use crate::panes::Pane;

/// What must be done outside the state.
#[derive(Clone, Debug, PartialEq)]
pub enum Effect {
    /// Ask for files.
    ChooseFiles,
    /// Ask for a folder.
    ChooseFolder,
    /// Ask for files to add to the study.
    ChooseFilesToAdd,
    /// Ask for a folder to add to the study.
    ChooseFolderToAdd,
    /// Add the subjects of these to the study.
    Add(Vec<PathBuf>),
    /// Write the study as files; asks where if `None`.
    ExportStudy {
        /// Where.
        folder: Option<PathBuf>,
        /// What it is left for once it is written.
        then: Option<Leaving>,
    },
    /// Put the walls that were made of these images by these settings into the study.
    AddWalls(Vec<(usize, Arc<Preparation>)>),
    /// Ask where a picture goes.
    ChooseFigure(FigureKind),
    /// Write what a pane shows; asks where if `None`.
    PaneFigure(Pane, Option<PathBuf>),
    /// Ask where tables go.
    ChooseTables,
    /// Read or make a study.
    Open(OpenSource),
    /// Read a subject of the study that is being read before the others.
    ReadFirst(String),
    /// Read the study that was opened last once more, with links that lead out of it.
    FollowLinks,
    /// Write a picture.
    WriteFigure(FigureKind, PathBuf),
    /// Read the view that a picture carries, and open the study that was named with it.
    ReadPicture {
        /// The picture.
        picture: PathBuf,
        /// Files and folders of its study; none where only the picture was named.
        study: Vec<PathBuf>,
    },
    /// Ask for the file of a classifier.
    ChooseClassifier,
    /// Read a classifier, for the study on screen or for the one that is opened.
    ReadClassifier {
        /// Its file.
        rule: PathBuf,
        /// What else was named with it.
        then: Option<Box<Effect>>,
    },
    /// Train a classifier on the study and write it; asks where if `None`.
    ExportClassifier(Option<PathBuf>),
    /// Complete a path that is typed.
    CompletePath(String),
    /// Take a path that was typed.
    TakePath {
        /// The path.
        text: String,
        /// Whether what lies there is replaced.
        replace: bool,
    },
    /// Give up typing a path.
    CancelPath,
    /// Write all tables.
    WriteTables(PathBuf),
    /// Stop background work.
    Stop(Topic),
    /// Begin stopped or failed work again.
    Retry(Topic),
    /// Light or dark.
    SetTheme(ThemeChoice),
    /// Show or hide a tile.
    TogglePane(Pane),
    /// Open a tile, or bring it before other tabs.
    ShowPane(Pane),
    /// Put all tiles back.
    ResetLayout,
    /// Full screen or window.
    SetFullScreen(bool),
    /// Close the window.
    Quit,
}
