//! The bars above and below the tiles.

mod menu_bar;
pub(crate) mod menu_view;
mod status_bar;
pub(crate) mod status_view;
mod time_bar;
mod time_view;

pub use menu_bar::{MenuBarView, menu_bar_ui};
pub use status_bar::{StatusBarView, StatusJob, status_bar_ui};
pub use time_bar::{TimeBarView, time_bar_ui};
pub use time_view::time_bar_view;
