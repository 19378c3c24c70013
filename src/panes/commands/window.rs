//! Commands about the window itself: theme, panes, sheets.

use super::Command;
use super::action::{Action, CTRL, Menu, NONE, action};
use super::pane::Pane;
use crate::document::ThemeChoice;
use egui::Key;

/// Commands about the window itself: theme, panes, sheets.
#[derive(Clone, Debug, PartialEq)]
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
    /// Show or hide About.
    ToggleAbout,
    /// Full screen or window.
    ToggleFullScreen,
}

/// Those that need no more than a name: one line each, a table is read as a table.
#[rustfmt::skip]
pub(super) static ACTIONS: &[Action] = &[
    action(Menu::File, 1, "Load report", Some((CTRL, Key::L)), Command::Window(WindowCommand::ToggleLoadReport)),
    action(Menu::View, 4, "Theme: system", None, Command::Window(WindowCommand::SetTheme(ThemeChoice::System))),
    action(Menu::View, 4, "Theme: dark", None, Command::Window(WindowCommand::SetTheme(ThemeChoice::Dark))),
    action(Menu::View, 4, "Theme: light", None, Command::Window(WindowCommand::SetTheme(ThemeChoice::Light))),
    action(Menu::View, 5, "Reset layout", None, Command::Window(WindowCommand::ResetLayout)),
    action(Menu::View, 6, "Full screen", Some((NONE, Key::F11)), Command::Window(WindowCommand::ToggleFullScreen)),
    action(Menu::Analysis, 2, "Map of poses", None, Command::Window(WindowCommand::ShowPane(Pane::POSE_MAP))),
    action(Menu::Analysis, 2, "Map of deformations", None, Command::Window(WindowCommand::ShowPane(Pane::DEFORMATION_MAP))),
    action(Menu::Analysis, 2, "Spatiotemporal plot (3D)", None, Command::Window(WindowCommand::ShowPane(Pane::SPATIOTEMPORAL))),
    action(Menu::Analysis, 2, "Medial map", None, Command::Window(WindowCommand::ShowPane(Pane::MEDIAL_MAP))),
    action(Menu::Analysis, 3, "Metric and maps…", None, Command::Window(WindowCommand::ShowPane(Pane::METRIC))),
    action(Menu::Analysis, 3, "Patch table and thresholds", None, Command::Window(WindowCommand::ShowPane(Pane::PATCH))),
    action(Menu::Analysis, 3, "Verdict", None, Command::Window(WindowCommand::ShowPane(Pane::VERDICT))),
    action(Menu::Analysis, 3, "Bull's-eye", None, Command::Window(WindowCommand::ShowPane(Pane::BULLS_EYE))),
    action(Menu::Analysis, 3, "Wall thickness by five methods", None, Command::Window(WindowCommand::ShowPane(Pane::THICKNESS))),
    action(Menu::Help, 0, "Find a command", Some((CTRL, Key::K)), Command::Window(WindowCommand::TogglePalette)),
    action(Menu::Help, 0, "Keyboard shortcuts", Some((NONE, Key::Questionmark)), Command::Window(WindowCommand::ToggleShortcuts)),
    action(Menu::Help, 1, "About Cardiomorph", None, Command::Window(WindowCommand::ToggleAbout)),
];
