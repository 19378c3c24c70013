//! How the document changes: as one step of undo, and a drag as one step.

use crate::document::document::Document;
use crate::document::state::State;
use crate::document::undo::Gesture;
use crate::study::Revision;

/// What surrounds a command.
#[derive(Clone, Copy, Debug)]
pub struct Moment {
    /// A clock that runs forward.
    pub now_s: f64,
    /// Whether a pointer button is down: changes of one drag are one step of undo.
    pub pointer_held: bool,
    /// A revision that no study has yet, for edits.
    pub fresh_revision: Revision,
}

/// Changes the document as one step of undo; a change that changes nothing leaves no step.
pub fn change(
    state: &mut State,
    moment: &Moment,
    gesture: Option<Gesture>,
    edit: impl FnOnce(&mut Document),
) {
    let before = state.document.clone();
    edit(&mut state.document);
    state.document.end_transport_out_of_sight();
    if state.document != before {
        state
            .history
            .record(before, gesture, moment.pointer_held, moment.now_s);
    }
}
