//! Commands that reach beyond the study: files, jobs, panes, sheets.

use crate::engine::OpenSource;
use crate::panes::Command;

use super::apply::Effect;
use super::export::FigureKind;
use super::saved_views::is_picture;
use super::settings::remember_recent;
use super::state::State;

/// Carries out a command about files, work or the window itself.
pub fn apply(state: &mut State, command: Command) -> Vec<Effect> {
    let effect = match command {
        Command::ChooseFiles => Effect::ChooseFiles,
        Command::ChooseFolder => Effect::ChooseFolder,
        Command::Open(paths) => {
            if paths.is_empty() {
                return Vec::new();
            }
            if is_picture(&paths) {
                return paths.into_iter().map(Effect::ReadPicture).collect();
            }
            remember_recent(&mut state.recent, &paths);
            Effect::Open(OpenSource::Paths(paths))
        }
        Command::OpenBuiltIn => Effect::Open(OpenSource::BuiltIn(state.built_in)),
        Command::ExportFigure(None)
        | Command::ExportPatchFigure(None)
        | Command::ExportTables(None)
            if state.document.selected().is_none() =>
        {
            return Vec::new();
        }
        Command::ExportFigure(None) => Effect::ChooseFigure(FigureKind::View),
        Command::ExportFigure(Some(path)) => Effect::WriteFigure(FigureKind::View, path),
        Command::ExportPatchFigure(None) => Effect::ChooseFigure(FigureKind::Patch),
        Command::ExportPatchFigure(Some(path)) => Effect::WriteFigure(FigureKind::Patch, path),
        Command::ExportTables(None) => Effect::ChooseTables,
        Command::ExportTables(Some(path)) => Effect::WriteTables(path),
        Command::Retry(kind) => {
            state.errors.retain(|card| card.retry != Some(kind));
            Effect::Retry(kind)
        }
        Command::Cancel(kind) => Effect::Stop(kind),
        Command::SetTheme(theme) => {
            state.theme = theme;
            Effect::SetTheme(theme)
        }
        Command::TogglePane(pane) => Effect::TogglePane(pane),
        Command::ShowPane(pane) => Effect::ShowPane(pane),
        Command::ResetLayout => Effect::ResetLayout,
        Command::ToggleFullScreen => {
            state.full_screen = !state.full_screen;
            Effect::SetFullScreen(state.full_screen)
        }
        Command::Quit => Effect::Quit,
        other => {
            change_sheets(state, &other);
            return Vec::new();
        }
    };
    vec![effect]
}

/// Sheets lie over the window one at a time; error cards go by their place.
fn change_sheets(state: &mut State, command: &Command) {
    let before = state.sheets;
    state.sheets = Default::default();
    match command {
        Command::TogglePalette => state.sheets.palette = !before.palette,
        Command::ToggleShortcuts => state.sheets.shortcuts = !before.shortcuts,
        Command::ToggleLoadReport => state.sheets.load_report = !before.load_report,
        Command::ToggleAbout => state.sheets.about = !before.about,
        Command::DismissError(index) => {
            state.sheets = before;
            if *index < state.errors.len() {
                state.errors.remove(*index);
            }
        }
        _ => state.sheets = before,
    }
}
