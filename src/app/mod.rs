//! The window's door: state, commands, undo, and the glue between engine, panels and renderer.

#[expect(
    clippy::module_inception,
    reason = "the room's main type carries the room's name"
)]
mod app;
mod apply;
mod apply_beat;
mod apply_carry;
#[cfg(test)]
mod apply_tests;
mod apply_view;
mod apply_wall;
mod apply_window;
mod background;
mod background_beats;
mod background_medial;
mod background_thickness;
mod background_walls;
mod camera_drag;
mod carried;
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
mod map_orientation;
mod medial_pictures;
mod morph;
mod paint;
mod panes;
mod pick_label;
mod pictures;
mod play;
mod saved_views;
mod settings;
mod shown_heart;
mod stage;
mod start;
mod state;
#[cfg(test)]
mod testing;
mod thickness_store;
mod times;
mod undo;
mod viewport;
mod views;
mod walls;

pub use app::{App, AppOptions};
pub use background::Background;
pub use carried::{CarriedHeart, CarryingState};
pub use dialogs::{AskPaths, PathQuestion};
pub use differences::{DifferenceStore, PosePair};
pub use document::{CarriedBeat, Document, OpeningReport, StudyRef, Visibility};
pub use found_verdicts::{VerdictKey, VerdictStore};
pub use in_betweens::{InBetweenStore, InBetweens};
pub use look::{Direction, Look};
pub use play::PlayClock;
pub use start::{StartError, run_window};
pub use state::{Fresh, Results, Sheets, State};
pub use undo::{Gesture, History};
pub use walls::{FoundWall, WallStore};
