//! Commands that reach beyond the study: files, background work, panes, sheets.

use std::path::PathBuf;

use crate::app::export::FigureKind;
use crate::app::saved_views::split_picture;
use crate::app::settings::remember_recent;
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
        FileCommand::Open(paths) => {
            let (picture, paths) = split_picture(paths);
            if let Some(picture) = picture {
                let study = paths;
                return Some(Effect::ReadPicture { picture, study });
            }
            remember_recent(&mut state.recent, &paths);
            Some(Effect::Open(OpenSource::Paths(paths)))
        }
        FileCommand::FollowLinks => Some(Effect::FollowLinks),
        FileCommand::OpenBuiltIn => Some(Effect::Open(OpenSource::BuiltIn(state.built_in))),
        FileCommand::ReadFirst(id) => {
            state.awaited = Some(id.clone());
            // It may have been read since it was clicked.
            state.select_awaited();
            state.awaited.is_some().then_some(Effect::ReadFirst(id))
        }
        FileCommand::ExportFigure(path) => figure(FigureKind::View, path, is_open),
        FileCommand::ExportPatchFigure(path) => figure(FigureKind::Patch, path, is_open),
        FileCommand::ExportTables(Some(folder)) => Some(Effect::WriteTables(folder)),
        FileCommand::ExportTables(None) => is_open.then_some(Effect::ChooseTables),
        FileCommand::SetFigureLook(look) => {
            state.figure_look = look;
            None
        }
        FileCommand::CompletePath(text) => Some(Effect::CompletePath(text)),
        FileCommand::TakePath { text, replace } => Some(Effect::TakePath { text, replace }),
        FileCommand::CancelPath => Some(Effect::CancelPath),
        FileCommand::Quit => Some(Effect::Quit),
    }
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
