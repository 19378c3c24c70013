//! What menus and the palette must know to grey and tick their lines.

use crate::app::layout::Layout;
use crate::document::state::State;
use crate::panes::{ActionState, PANES};

/// Which actions can be done now and which switches are on.
pub fn action_state<'a>(state: &'a State, layout: &Layout) -> ActionState<'a> {
    let panes = PANES.iter().map(|spec| spec.pane);
    ActionState {
        state,
        hidden_panes: panes.filter(|pane| !layout.is_open(*pane)).collect(),
    }
}
