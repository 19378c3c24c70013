//! Undo and redo.

use super::action::{CTRL, Menu, Row, SHIFT, row};
use egui::Key;

/// Undo and redo.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum EditCommand {
    /// Undo the last change of state.
    Undo,
    /// Take the last undo back.
    Redo,
}

/// Those that need no more than a name: one line each, a table is read as a table.
#[rustfmt::skip]
pub(super) static ACTIONS: &[Row<EditCommand>] = &[
    row(Menu::Edit, 0, "Undo", Some((CTRL, Key::Z)), EditCommand::Undo),
    row(Menu::Edit, 0, "Redo", Some((CTRL.plus(SHIFT), Key::Z)), EditCommand::Redo),
];
