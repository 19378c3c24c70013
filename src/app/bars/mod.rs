//! The bars above and below the tiles.

mod menu_bar;
mod menu_lines;
pub(crate) mod menu_view;
mod status_bar;
pub(crate) mod status_view;
mod time_bar;
mod time_view;

pub use {menu_bar::*, status_bar::*, time_bar::*, time_view::*};
