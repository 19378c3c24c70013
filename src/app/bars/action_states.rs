//! When actions are disabled or ticked, for menus, the palette and keys: prepared from state and layout.

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
