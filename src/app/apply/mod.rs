//! The one place where commands change the state: a file for each kind of command.

mod change;
mod classifier;
mod edit;
mod effect;
mod images;
mod import;
mod map;
mod playback;
mod select;
#[cfg(test)]
mod tests;
mod transport;
mod view;
mod wall;
mod window;

pub use change::{Moment, change};
pub use effect::Effect;
pub use playback::advance;
pub use wall::is_usable;

use crate::panes::{Command, EditCommand};

use crate::document::document::Document;
use crate::document::state::State;

/// Applies one command; what reaches beyond the state comes back as effects.
pub fn apply(state: &mut State, command: Command, moment: &Moment) -> Vec<Effect> {
    // An estimated pose is looked at and no more: whatever is asked for concerns the subjects themselves.
    state.estimate_at = None;
    let listing = state.document.study.listing;
    let effects = applied(state, command, moment);
    if state.document.study.listing != listing {
        state.leave_listing();
    }
    effects
}

fn applied(state: &mut State, command: Command, moment: &Moment) -> Vec<Effect> {
    match command {
        Command::Edit(EditCommand::Undo) => {
            let step = state.history.undo(&state.document);
            restore(state, step, "Undone");
        }
        Command::Edit(EditCommand::Redo) => {
            let step = state.history.redo(&state.document);
            restore(state, step, "Done again");
        }
        Command::Edit(command) => return Vec::from_iter(edit::apply(state, command, moment)),
        Command::Select(command) => select::apply(state, command, moment),
        Command::Playback(command) => playback::apply(state, command, moment),
        Command::View(command) => view::apply(state, command, moment),
        Command::Images(command) => images::apply(state, command, moment),
        Command::Import(command) => return Vec::from_iter(import::apply(state, command, moment)),
        Command::Map(command) => map::apply(state, command, moment),
        Command::Wall(command) => wall::apply(state, command, moment),
        Command::Classifier(command) => {
            return Vec::from_iter(classifier::apply(state, command, moment));
        }
        Command::Transport(command) => return transport::apply(state, command, moment),
        Command::File(command) => return Vec::from_iter(window::apply_file(state, command)),
        Command::Work(command) => return Vec::from_iter(window::apply_work(state, command)),
        Command::Window(command) => return Vec::from_iter(window::apply_window(state, command)),
    }
    Vec::new()
}

fn restore(state: &mut State, step: Option<Document>, done: &str) {
    if let Some(document) = step {
        // What the last command said holds no more.
        state.message = done.to_owned();
        state.document = document;
        state.play.playing = false;
        // Coordinates may count in another unit.
        state.picked = None;
    }
}
