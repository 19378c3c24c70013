//! One thing that can be done, with its name, menu and key: menus, palette and the sheet of keys read the tables of actions.

use egui::{Key, KeyboardShortcut, Modifiers};

/// A menu of the bar; also the group in the sheet of shortcuts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Menu {
    /// Opening and leaving.
    File,
    /// Undo and selection.
    Edit,
    /// What is seen, and from where.
    View,
    /// Playback and analyses.
    Analysis,
    /// What leaves the program.
    Export,
    /// How it is used.
    Help,
}

impl Menu {
    /// All menus in the order of the bar.
    pub const ALL: [Self; 6] = [
        Self::File,
        Self::Edit,
        Self::View,
        Self::Analysis,
        Self::Export,
        Self::Help,
    ];

    /// The title in the menu bar.
    pub fn name(self) -> &'static str {
        match self {
            Self::File => "File",
            Self::Edit => "Edit",
            Self::View => "View",
            Self::Analysis => "Analysis",
            Self::Export => "Export",
            Self::Help => "Help",
        }
    }
}

/// One thing that can be done, by a command of the kind `C`.
#[derive(Clone, Debug)]
pub struct Row<C> {
    /// Sentence case; ends in `…` when it asks for more.
    pub name: &'static str,
    /// The menu that lists it.
    pub menu: Menu,
    /// Groups of a menu are divided by a line.
    pub group: u8,
    /// The key that does it.
    pub shortcut: Option<KeyboardShortcut>,
    /// What it does.
    pub command: C,
}

impl<C: Clone> Row<C> {
    /// The same row with its command as one of a wider kind.
    pub(super) fn widened<D: From<C>>(&self) -> Row<D> {
        Row {
            name: self.name,
            menu: self.menu,
            group: self.group,
            shortcut: self.shortcut,
            command: self.command.clone().into(),
        }
    }
}

pub(super) const NONE: Modifiers = Modifiers::NONE;
pub(super) const CTRL: Modifiers = Modifiers::COMMAND;
pub(super) const SHIFT: Modifiers = Modifiers::SHIFT;

/// A row of a table of actions.
pub const fn row<C>(
    menu: Menu,
    group: u8,
    name: &'static str,
    shortcut: Option<(Modifiers, Key)>,
    command: C,
) -> Row<C> {
    let shortcut = match shortcut {
        Some((modifiers, key)) => Some(KeyboardShortcut::new(modifiers, key)),
        None => None,
    };
    Row {
        name,
        menu,
        group,
        shortcut,
        command,
    }
}
