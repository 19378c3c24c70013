//! Commands about the window itself: theme, panes, sheets.

use super::action::{CTRL, Menu, NONE, Row, row};
use super::pane::Pane;
use crate::document::ThemeChoice;
use egui::Key;

/// Commands about the window itself: theme, panes, sheets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum WindowCommand {
    /// Light or dark.
    SetTheme(ThemeChoice),
    /// Show or hide a tile.
    TogglePane(Pane),
    /// Open a tile, or bring it before other tabs.
    ShowPane(Pane),
    /// All tiles where they were.
    ResetLayout,
    /// Show or hide the command palette.
    TogglePalette,
    /// Show or hide the sheet of shortcuts.
    ToggleShortcuts,
    /// Show or hide the load report.
    ToggleLoadReport,
    /// Show or hide the sheet for the look of figures.
    ToggleFigureSheet,
    /// Show or hide About.
    ToggleAbout,
    /// Full screen or window.
    ToggleFullScreen,
}

/// Those that need no more than a name: one line each, a table is read as a table.
#[rustfmt::skip]
pub(super) static ACTIONS: &[Row<WindowCommand>] = &[
    row(Menu::File, 2, "Load report", Some((CTRL, Key::L)), WindowCommand::ToggleLoadReport),
    row(Menu::Export, 1, "Figure settings…", Some((CTRL, Key::F2)), WindowCommand::ToggleFigureSheet),
    row(Menu::View, 4, "Theme: system", None, WindowCommand::SetTheme(ThemeChoice::System)),
    row(Menu::View, 4, "Theme: dark", None, WindowCommand::SetTheme(ThemeChoice::Dark)),
    row(Menu::View, 4, "Theme: light", None, WindowCommand::SetTheme(ThemeChoice::Light)),
    row(Menu::View, 5, "Reset layout", None, WindowCommand::ResetLayout),
    row(Menu::View, 6, "Full screen", Some((NONE, Key::F11)), WindowCommand::ToggleFullScreen),
    row(Menu::Help, 0, "Find a command", Some((CTRL, Key::K)), WindowCommand::TogglePalette),
    row(Menu::Help, 0, "Keyboard shortcuts", Some((NONE, Key::Questionmark)), WindowCommand::ToggleShortcuts),
    row(Menu::Help, 1, "About Cardiomorph", None, WindowCommand::ToggleAbout),
];
