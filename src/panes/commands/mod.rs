//! Everything that the user can ask for: panes push commands, the parts of `app` that are named here apply them.
//!
//! A command, its name, its key and its place in the menus stand in one file; menus, palette and keys read the tables.

mod action;
mod beat;
mod edit;
mod file;
mod map;
mod pane;
mod transport;
mod view;
mod wall;
mod window;
mod work;

use std::sync::LazyLock;

pub use action::{Menu, Row};
pub use beat::BeatCommand;
pub use edit::EditCommand;
pub use file::FileCommand;
pub use map::MapCommand;
pub use pane::Pane;
pub use transport::TransportCommand;
pub use view::ViewCommand;
pub use wall::WallCommand;
pub use window::WindowCommand;
pub use work::WorkCommand;

/// One request of the user.
#[derive(Clone, Debug, PartialEq)]
pub enum Command {
    /// The selected subject and the place in its beat; applied by `app/apply/beat.rs`.
    Beat(BeatCommand),
    /// What is seen, and from where; applied by `app/apply/view.rs`.
    View(ViewCommand),
    /// Metric and maps; applied by `app/apply/map.rs`.
    Map(MapCommand),
    /// The wall and its patches; applied by `app/apply/wall.rs`.
    Wall(WallCommand),
    /// Transported motions and interpolated poses; applied by `app/apply/transport.rs`.
    Transport(TransportCommand),
    /// Undo and redo.
    Edit(EditCommand),
    /// What is opened and exported; applied by `app/apply/window.rs`.
    File(FileCommand),
    /// Work in the background; applied by `app/apply/window.rs`.
    Work(WorkCommand),
    /// Theme, panes, sheets; applied by `app/apply/window.rs`.
    Window(WindowCommand),
}

/// One thing that can be done.
pub type Action = Row<Command>;

/// The actions of commands that need no more than a name, by menu and group; those of panes stand in the table of panes.
pub static ACTIONS: LazyLock<Vec<Action>> = LazyLock::new(|| {
    let mut actions: Vec<Action> = wide(file::ACTIONS, Command::File)
        .chain(wide(edit::ACTIONS, Command::Edit))
        .chain(wide(beat::ACTIONS, Command::Beat))
        .chain(wide(view::ACTIONS, Command::View))
        .chain(wide(wall::ACTIONS, Command::Wall))
        .chain(wide(transport::ACTIONS, Command::Transport))
        .chain(wide(map::ACTIONS, Command::Map))
        .chain(wide(window::ACTIONS, Command::Window))
        .collect();
    // Stable: within a group the order of the tables stays.
    actions.sort_by_key(|action| (action.menu, action.group));
    actions
});

/// The rows of one kind as actions.
fn wide<C: Clone>(rows: &'static [Row<C>], kind: fn(C) -> Command) -> impl Iterator<Item = Action> {
    rows.iter().map(move |row| row.widened(kind))
}
