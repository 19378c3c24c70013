//! Background work on the medial map: asked for while its pane is seen, taken in when it is done.

use std::collections::HashSet;
use std::sync::Arc;

use crate::engine::{AnalysisRequest, Engine, MedialMapParams, Showing, WorkKind};
use crate::ui::Pane;

use super::state::{Fresh, State};

/// What of the window is looked at: work for panes that nobody sees waits.
#[derive(Clone, Debug, Default)]
pub struct Seen {
    /// Panes in front of other tabs.
    pub panes: HashSet<Pane>,
    /// Whether something may be dragged.
    pub pointer_held: bool,
}

/// The map that the state asks for.
pub fn wanted_map(state: &State) -> AnalysisRequest {
    AnalysisRequest::MedialMap(MedialMapParams {
        thickening: state.document.thickening,
        method: state.document.map.method,
    })
}

/// Asks for the map if its pane is seen; free if it is there or under way. While a threshold is dragged the map before
/// stays: each step of the drag would stop the one before.
pub fn request(state: &State, engine: &mut Engine, seen: &Seen) {
    let begun = !matches!(engine.showing(WorkKind::MedialMap), Showing::Nothing);
    if seen.panes.contains(&Pane::MedialMap) && !(begun && seen.pointer_held) {
        engine.request(state.document.study(), wanted_map(state));
    }
}

/// Takes in a new map.
pub fn take(state: &mut State, engine: &Engine) {
    let Showing::Ready(outcome) = engine.showing(WorkKind::MedialMap) else {
        return;
    };
    let Some(value) = outcome.medial_map() else {
        return;
    };
    let taken = state.results.medial_map.as_ref();
    if taken.is_some_and(|fresh| Arc::ptr_eq(&fresh.value, value)) {
        return;
    }
    state.results.medial_map = Some(Fresh {
        revision: state.document.study().revision,
        opening: state.document.study.opening,
        value: Arc::clone(value),
    });
}
