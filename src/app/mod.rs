//! The window's door: state, commands, undo, and the glue between engine, panels and renderer.

#[expect(
    clippy::module_inception,
    reason = "the room's main type carries the room's name"
)]
mod app;
mod apply;
mod asks;
mod asks_beats;
mod background;
mod bars;
mod camera_drag;
mod corners;
mod dialogs;
mod errors;
mod export;
mod fits;
mod frame_ui;
mod layout;
mod paint;
mod panes;
mod pick_label;
mod pictures;
mod places;
mod saved_views;
mod settings;
mod sheets;
mod shown_heart;
mod start;
mod times;
mod viewport;
mod views;

pub use app::{App, AppOptions};
pub use background::Background;
pub use bars::*;
pub use dialogs::{AskPaths, PathQuestion};
pub use sheets::*;
pub use start::{StartError, run_window};
