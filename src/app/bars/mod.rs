//! The bars above and below the tiles.

pub(crate) mod action_states;
mod menu_bar;
mod menu_lines;
mod status_bar;
pub(crate) mod status_view;
mod time_bar;
mod time_view;

pub use {menu_bar::*, status_bar::*, time_bar::*, time_view::*};
