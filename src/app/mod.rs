//! The window's door: state, commands, undo, and the glue between engine, panels and renderer.

mod app;
mod start;

pub use app::{App, AppOptions};
pub use start::{StartError, run_window};
