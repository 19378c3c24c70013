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
    action(Menu::View, 5, "Pane: cohort", None, Command::Window(WindowCommand::TogglePane(Pane::Cohort))),
    action(Menu::View, 5, "Pane: activity", None, Command::Window(WindowCommand::TogglePane(Pane::Activity))),
    action(Menu::View, 5, "Pane: poses", None, Command::Window(WindowCommand::TogglePane(Pane::PoseMap))),
    action(Menu::View, 5, "Pane: deformations", None, Command::Window(WindowCommand::TogglePane(Pane::DeformationMap))),
    action(Menu::View, 5, "Pane: spatiotemporal plot", None, Command::Window(WindowCommand::TogglePane(Pane::SpaceTime))),
    action(Menu::View, 5, "Pane: medial map", None, Command::Window(WindowCommand::TogglePane(Pane::MedialMap))),
    action(Menu::View, 5, "Pane: metric", None, Command::Window(WindowCommand::TogglePane(Pane::Metric))),
    action(Menu::View, 5, "Pane: volume", None, Command::Window(WindowCommand::TogglePane(Pane::Curves))),
    action(Menu::View, 5, "Pane: measures", None, Command::Window(WindowCommand::TogglePane(Pane::Measures))),
    action(Menu::View, 5, "Pane: patch", None, Command::Window(WindowCommand::TogglePane(Pane::Patch))),
    action(Menu::View, 5, "Pane: verdict", None, Command::Window(WindowCommand::TogglePane(Pane::Verdict))),
    action(Menu::View, 5, "Pane: bull's-eye", None, Command::Window(WindowCommand::TogglePane(Pane::BullsEye))),
    action(Menu::View, 5, "Pane: thickness", None, Command::Window(WindowCommand::TogglePane(Pane::Thickness))),
    action(Menu::View, 5, "Reset layout", None, Command::Window(WindowCommand::ResetLayout)),
    action(Menu::View, 6, "Full screen", Some((NONE, Key::F11)), Command::Window(WindowCommand::ToggleFullScreen)),
    action(Menu::Analysis, 2, "Map of poses", None, Command::Window(WindowCommand::ShowPane(Pane::PoseMap))),
    action(Menu::Analysis, 2, "Map of deformations", None, Command::Window(WindowCommand::ShowPane(Pane::DeformationMap))),
    action(Menu::Analysis, 2, "Spatiotemporal plot (3D)", None, Command::Window(WindowCommand::ShowPane(Pane::SpaceTime))),
    action(Menu::Analysis, 2, "Medial map", None, Command::Window(WindowCommand::ShowPane(Pane::MedialMap))),
    action(Menu::Analysis, 3, "Metric and maps…", None, Command::Window(WindowCommand::ShowPane(Pane::Metric))),
    action(Menu::Analysis, 3, "Patch table and thresholds", None, Command::Window(WindowCommand::ShowPane(Pane::Patch))),
    action(Menu::Analysis, 3, "Verdict", None, Command::Window(WindowCommand::ShowPane(Pane::Verdict))),
    action(Menu::Analysis, 3, "Bull's-eye", None, Command::Window(WindowCommand::ShowPane(Pane::BullsEye))),
    action(Menu::Analysis, 3, "Wall thickness by five methods", None, Command::Window(WindowCommand::ShowPane(Pane::Thickness))),
    action(Menu::Help, 0, "Find a command", Some((CTRL, Key::K)), Command::Window(WindowCommand::TogglePalette)),
    action(Menu::Help, 0, "Keyboard shortcuts", Some((NONE, Key::Questionmark)), Command::Window(WindowCommand::ToggleShortcuts)),
    action(Menu::Help, 1, "About Cardiomorph", None, Command::Window(WindowCommand::ToggleAbout)),
];
