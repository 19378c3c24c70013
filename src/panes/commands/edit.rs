//! Undo and redo.

use super::Command;
use super::action::{Action, CTRL, Menu, SHIFT, action};
use egui::Key;

/// Undo and redo.
#[derive(Clone, Debug, PartialEq)]
pub enum EditCommand {
    /// Undo the last change of state.
    Undo,
    /// Take the last undo back.
    Redo,
}

/// Those that need no more than a name: one line each, a table is read as a table.
#[rustfmt::skip]
pub(super) static ACTIONS: &[Action] = &[
    action(Menu::Edit, 0, "Undo", Some((CTRL, Key::Z)), Command::Edit(EditCommand::Undo)),
    action(Menu::Edit, 0, "Redo", Some((CTRL.plus(SHIFT), Key::Z)), Command::Edit(EditCommand::Redo)),
];
