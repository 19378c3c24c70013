//! The window's door: state, commands, undo, and the glue between engine, panels and renderer.

mod answers;
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
mod camera_drag;
mod carried;
mod chosen_files;
mod corners;
mod dialogs;
mod differences;
mod document;
mod errors;
mod export;
mod fits;
mod found_verdicts;
mod frame_ui;
mod in_betweens;
mod layout;
mod look;
mod paint;
mod panes;
mod pick_label;
mod pictures;
mod play;
mod saved_views;
mod settings;
mod sheets;
mod shown_heart;
mod stage;
mod start;
mod state;
#[cfg(test)]
mod testing;
mod times;
mod undo;
mod viewport;
mod views;

pub use answers::{Answers, FoundWall};
pub use app::App;
pub use app_options::AppOptions;
pub use background::Background;
pub use bars::*;
pub use carried::{CarriedHeart, CarryingState};
pub use dialogs::{AskPaths, PathQuestion};
pub use differences::PosePair;
pub use document::{CarriedBeat, Document, OpeningReport, StudyRef, Visibility};
pub use in_betweens::BeatInBetweens;
pub use look::{Direction, Look};
pub use play::PlayClock;
pub use sheets::*;
pub use start::{StartError, run_window};
pub use state::{Sheets, State};
pub use undo::{Gesture, History};
