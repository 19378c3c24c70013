//! The bars above and below the tiles.

mod menu_bar;
mod status_bar;
mod time_bar;

pub use menu_bar::{MenuBarView, menu_bar_ui};
pub use status_bar::{StatusBarView, StatusJob, status_bar_ui};
pub use time_bar::{TimeBarView, time_bar_ui};
