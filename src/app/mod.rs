//! The window's door: state, commands, undo, and the glue between engine, panels and renderer.

#[expect(
    clippy::module_inception,
    reason = "the room's main type carries the room's name"
)]
mod app;
mod app_options;
mod apply;
mod asks;
mod asks_beats;
mod background;
mod bars;
mod chosen_files;
mod corners;
mod dialogs;
mod errors;
mod export;
mod frame_ui;
mod layout;
mod panes;
mod saved_views;
mod settings;
mod sheets;
mod start;
mod times;

pub use app::App;
pub use app_options::AppOptions;
pub use background::Background;
pub use bars::*;
pub use dialogs::{AskPaths, PathQuestion};
pub use sheets::*;
pub use start::{StartError, run_window};
