//! Commands about files: what is opened and what is exported.

use super::action::{CTRL, Menu, NONE, Row, SHIFT, row};
use super::pane::Pane;
use crate::picture::figure::FigureLook;
use egui::Key;
use std::path::PathBuf;

/// Commands about files: what is opened and what is exported.
#[derive(Clone, Debug, PartialEq)]
pub enum FileCommand {
    /// Ask for files to open.
    ChooseFiles,
    /// Ask for a folder to open.
    ChooseFolder,
    /// Open these.
    Open(Vec<PathBuf>),
    /// Open what was opened last once more, with links that lead out of it.
    FollowLinks,
    /// Ask for files whose subjects are added to the study.
    ChooseFilesToAdd,
    /// Ask for a folder whose subjects are added to the study.
    ChooseFolderToAdd,
    /// Add the subjects of these to the study.
    Add(Vec<PathBuf>),
    /// Open the cohort that ships inside.
    OpenBuiltIn,
    /// Read this subject of the study that is being read before the others, and select it then.
    ReadFirst(String),
    /// Write a figure of the 3D view; `None` asks where.
    ExportFigure(Option<PathBuf>),
    /// Write the figure of the patch: heart, bull's-eye, table, verdict; `None` asks where.
    ExportPatchFigure(Option<PathBuf>),
    /// Write what a pane shows as a figure; `None` asks where.
    ExportPaneFigure(Pane, Option<PathBuf>),
    /// Write all tables; `None` asks where.
    ExportTables(Option<PathBuf>),
    /// How figures look from now on.
    SetFigureLook(FigureLook),
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
    /// Write the study with its edits, to be opened again; `None` asks where.
    ExportStudy(Option<PathBuf>),
    /// Leave a study with edits that are not exported.
    Leave,
    /// Export the study, then leave it for what was asked.
    ExportAndLeave,
    /// Stay with it.
    Stay,
    /// Leave the program.
    Quit,
}

/// Those that need no more than a name: one line each, a table is read as a table.
#[rustfmt::skip]
pub(super) static ACTIONS: &[Row<FileCommand>] = &[
    row(Menu::File, 0, "Open files…", Some((CTRL, Key::O)), FileCommand::ChooseFiles),
    row(Menu::File, 0, "Open folder…", Some((CTRL.plus(SHIFT), Key::O)), FileCommand::ChooseFolder),
    row(Menu::File, 0, "Open the built-in cohort", None, FileCommand::OpenBuiltIn),
    row(Menu::File, 1, "Open again, following links", None, FileCommand::FollowLinks),
    row(Menu::File, 1, "Add files to the study…", None, FileCommand::ChooseFilesToAdd),
    row(Menu::File, 1, "Add folder to the study…", None, FileCommand::ChooseFolderToAdd),
    row(Menu::File, 3, "Quit", Some((CTRL, Key::Q)), FileCommand::Quit),
    row(Menu::Export, 0, "Patch figure…", Some((NONE, Key::F2)), FileCommand::ExportPatchFigure(None)),
    row(Menu::Export, 0, "Figure of the 3D view…", Some((SHIFT, Key::F2)), FileCommand::ExportFigure(None)),
    row(Menu::Export, 0, "Tables…", Some((CTRL, Key::E)), FileCommand::ExportTables(None)),
    row(Menu::Export, 0, "Study…", Some((CTRL, Key::S)), FileCommand::ExportStudy(None)),
];
