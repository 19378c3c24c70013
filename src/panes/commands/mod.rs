//! Everything that the user can ask for: panes push commands, the parts of `app` that are named here apply them.
//!
//! A command, its name, its key and its place in the menus stand in one file; menus, palette and keys read the tables.

mod action;
mod classifier;
mod edit;
mod file;
mod images;
mod import;
mod map;
mod pane;
mod playback;
mod select;
mod transport;
mod view;
mod wall;
mod window;
mod work;

use std::sync::LazyLock;

pub use {action::*, edit::*, file::*, images::*, import::*, map::*, pane::*};
pub use {
    classifier::*, playback::*, select::*, transport::*, view::*, wall::*, window::*, work::*,
};

/// One request of the user.
#[derive(Clone, Debug, PartialEq)]
pub enum Command {
    /// Which subjects are shown; applied by `app/apply/select.rs`.
    Select(SelectCommand),
    /// The place in the cycle, and playing; applied by `app/apply/playback.rs`.
    Playback(PlaybackCommand),
    /// What is seen, and from where; applied by `app/apply/view.rs`.
    View(ViewCommand),
    /// The images of the study; applied by `app/apply/images.rs`.
    Images(ImagesCommand),
    /// The import of images; applied by `app/apply/import.rs`.
    Import(ImportCommand),
    /// Metric and maps; applied by `app/apply/map.rs`.
    Map(MapCommand),
    /// The wall and its patches; applied by `app/apply/wall.rs`.
    Wall(WallCommand),
    /// The classifier from a file; applied by `app/apply/rule.rs`.
    Classifier(ClassifierCommand),
    /// Transported motions and interpolated poses; applied by `app/apply/transport.rs`.
    Transport(TransportCommand),
    /// Undo, redo, and edits of the study; applied by `app/apply/edit.rs`.
    Edit(EditCommand),
    /// What is opened and exported; applied by `app/apply/window.rs`.
    File(FileCommand),
    /// Work in the background; applied by `app/apply/window.rs`.
    Work(WorkCommand),
    /// Theme, panes, sheets; applied by `app/apply/window.rs`.
    Window(WindowCommand),
}

macro_rules! kinds {
    ($($kind:ident($command:ident)),*) => {
        $(impl From<$command> for Command {
            fn from(command: $command) -> Self {
                Self::$kind(command)
            }
        })*
    };
}

#[rustfmt::skip]
kinds!(
    Select(SelectCommand), Playback(PlaybackCommand), View(ViewCommand), Images(ImagesCommand), Import(ImportCommand), Map(MapCommand), Wall(WallCommand), Classifier(ClassifierCommand),
    Transport(TransportCommand),
    Edit(EditCommand), File(FileCommand), Work(WorkCommand), Window(WindowCommand)
);

/// One thing that can be done.
pub type Action = Row<Command>;

/// The actions of commands that need no more than a name, by menu and group; those of panes stand in the table of panes.
pub static ACTIONS: LazyLock<Vec<Action>> = LazyLock::new(|| {
    let mut actions: Vec<Action> = wide(file::ACTIONS)
        .chain(wide(edit::ACTIONS))
        .chain(wide(select::ACTIONS))
        .chain(wide(playback::ACTIONS))
        .chain(wide(view::ACTIONS))
        .chain(wide(wall::ACTIONS))
        .chain(wide(images::ACTIONS))
        .chain(wide(import::ACTIONS))
        .chain(wide(classifier::ACTIONS))
        .chain(wide(transport::ACTIONS))
        .chain(of_metrics().map(|row| row.widened()))
        .chain(wide(map::ACTIONS))
        .chain(wide(window::ACTIONS))
        .collect();
    // Stable: within a group the order of the tables stays.
    actions.sort_by_key(|action| (action.menu, action.group));
    actions
});

/// The action of a command.
pub fn action_of(command: &Command) -> Option<&'static Action> {
    ACTIONS.iter().find(|action| action.command == *command)
}

/// The rows of one kind as actions.
fn wide<C: Clone>(rows: &'static [Row<C>]) -> impl Iterator<Item = Action>
where
    Command: From<C>,
{
    rows.iter().map(Row::widened)
}
