//! Commands that reach beyond the study: files, background work, panes, sheets.

use std::path::PathBuf;

use crate::app::export::FigureKind;
use crate::app::opened_classifiers::{is_classifier, split_classifier};
use crate::app::saved_views::split_picture;
use crate::app::settings::remember_recent;
use crate::document::Leaving;
use crate::document::state::{Sheets, State};
use crate::engine::OpenSource;
use crate::panes::{FileCommand, WindowCommand, WorkCommand};

use super::effect::Effect;

/// Applies a command about what is opened or exported. Nothing is exported where nothing is open.
pub fn apply_file(state: &mut State, command: FileCommand) -> Option<Effect> {
    let is_open = state.document.selected().is_some();
    match command {
        FileCommand::ChooseFiles => Some(Effect::ChooseFiles),
        FileCommand::ChooseFolder => Some(Effect::ChooseFolder),
        FileCommand::Open(paths) if paths.is_empty() => None,
        FileCommand::Open(mut paths) if is_open && paths.len() == 1 && is_classifier(&paths[0]) => {
            let (rule, then) = (paths.swap_remove(0), None);
            Some(Effect::ReadClassifier { rule, then })
        }
        FileCommand::Open(paths) => {
            let (picture, study) = split_picture(paths.clone());
            match picture {
                // It restores a view, of the study on screen if it is the one of the picture.
                Some(picture) if study.is_empty() => Some(Effect::ReadPicture { picture, study }),
                _ => leave(state, Leaving::Open(OpenSource::Paths(paths))),
            }
        }
        FileCommand::OpenBuiltIn => {
            let source = OpenSource::BuiltIn(state.built_in);
            leave(state, Leaving::Open(source))
        }
        FileCommand::ChooseFilesToAdd => is_open.then_some(Effect::ChooseFilesToAdd),
        FileCommand::ChooseFolderToAdd => is_open.then_some(Effect::ChooseFolderToAdd),
        FileCommand::Add(paths) if !is_open => apply_file(state, FileCommand::Open(paths)),
        FileCommand::Add(paths) => {
            let (rule, subjects) = split_classifier(paths);
            let add = (!subjects.is_empty()).then_some(Effect::Add(subjects));
            with_classifier(rule, add)
        }
        FileCommand::ExportStudy(folder) => {
            is_open.then_some(Effect::ExportStudy { folder, then: None })
        }
        FileCommand::ExportAndLeave => Some(Effect::ExportStudy {
            folder: None,
            then: Some(state.leaving.take()?),
        }),
        FileCommand::Leave => {
            let leaving = state.leaving.take()?;
            left(state, leaving)
        }
        FileCommand::Stay => {
            state.leaving = None;
            None
        }
        FileCommand::FollowLinks => leave(state, Leaving::FollowLinks),
        FileCommand::ReadFirst(id) => {
            state.awaited = Some(id.clone());
            // It may have been read since it was clicked.
            state.select_awaited();
            state.awaited.is_some().then_some(Effect::ReadFirst(id))
        }
        FileCommand::ExportFigure(path) => figure(FigureKind::View, path, is_open),
        FileCommand::ExportPatchFigure(path) => figure(FigureKind::Patch, path, is_open),
        FileCommand::ExportPaneFigure(pane, path) => {
            is_open.then_some(Effect::PaneFigure(pane, path))
        }
        FileCommand::ExportTables(Some(folder)) => Some(Effect::WriteTables(folder)),
        FileCommand::ExportTables(None) => is_open.then_some(Effect::ChooseTables),
        FileCommand::SetFigureLook(look) => {
            state.figure_look = look;
            None
        }
        FileCommand::CompletePath(text) => Some(Effect::CompletePath(text)),
        FileCommand::TakePath { text, replace } => Some(Effect::TakePath { text, replace }),
        FileCommand::CancelPath => Some(Effect::CancelPath),
        FileCommand::Quit => leave(state, Leaving::Quit),
    }
}

/// Leaves the study on screen, unless it has edits that are not exported: then the person at the screen is asked.
fn leave(state: &mut State, leaving: Leaving) -> Option<Effect> {
    if state.is_edited() {
        state.leaving = Some(leaving);
        return None;
    }
    left(state, leaving)
}

fn left(state: &mut State, leaving: Leaving) -> Option<Effect> {
    Some(match leaving {
        Leaving::Quit => Effect::Quit,
        Leaving::FollowLinks => Effect::FollowLinks,
        Leaving::Open(OpenSource::Paths(paths)) => {
            let (rule, paths) = split_classifier(paths);
            let (picture, study) = split_picture(paths);
            let open = match picture {
                Some(picture) => Effect::ReadPicture { picture, study },
                None => {
                    remember_recent(&mut state.recent, &study);
                    Effect::Open(OpenSource::Paths(study))
                }
            };
            return with_classifier(rule, Some(open));
        }
        Leaving::Open(source) => Effect::Open(source),
    })
}

/// What is done with the paths beside a classifier, and with that.
fn with_classifier(rule: Option<PathBuf>, then: Option<Effect>) -> Option<Effect> {
    let Some(rule) = rule else {
        return then;
    };
    let then = then.map(Box::new);
    Some(Effect::ReadClassifier { rule, then })
}

fn figure(kind: FigureKind, path: Option<PathBuf>, is_open: bool) -> Option<Effect> {
    match path {
        Some(path) => Some(Effect::WriteFigure(kind, path)),
        None => is_open.then_some(Effect::ChooseFigure(kind)),
    }
}

/// Applies a command about background work; error cards go by their place.
pub fn apply_work(state: &mut State, command: WorkCommand) -> Option<Effect> {
    match command {
        WorkCommand::Retry(topic) => {
            state.errors.retain(|card| card.retry != Some(topic));
            Some(Effect::Retry(topic))
        }
        WorkCommand::Cancel(topic) => Some(Effect::Stop(topic)),
        WorkCommand::DismissError(index) => {
            if index < state.errors.len() {
                state.errors.remove(index);
            }
            None
        }
    }
}

/// Applies a command about the window itself. Sheets lie over it one at a time.
pub fn apply_window(state: &mut State, command: WindowCommand) -> Option<Effect> {
    let (before, mut sheets) = (state.sheets, Sheets::default());
    match command {
        WindowCommand::SetTheme(theme) => {
            state.theme = theme;
            return Some(Effect::SetTheme(theme));
        }
        WindowCommand::TogglePane(pane) => return Some(Effect::TogglePane(pane)),
        WindowCommand::ShowPane(pane) => return Some(Effect::ShowPane(pane)),
        WindowCommand::ResetLayout => return Some(Effect::ResetLayout),
        WindowCommand::ToggleFullScreen => {
            state.full_screen = !state.full_screen;
            return Some(Effect::SetFullScreen(state.full_screen));
        }
        WindowCommand::TogglePalette => sheets.palette = !before.palette,
        WindowCommand::ToggleShortcuts => sheets.shortcuts = !before.shortcuts,
        WindowCommand::ToggleLoadReport => sheets.load_report = !before.load_report,
        WindowCommand::ToggleFigureSheet => sheets.figure = !before.figure,
        WindowCommand::ToggleAbout => sheets.about = !before.about,
    }
    state.sheets = sheets;
    None
}
