//! The window: frame loop, layout, applying of commands, bars, sheets, dialogs and exports.
//!
//! Begin with `app.rs`: `logic` applies commands, takes in what finished and asks the store, then `ui` draws and collects
//! commands. `apply/` does to the state what commands ask for, `background.rs` and `saved_views.rs` take in what was read; `asks.rs` is what is asked for whatever is on screen. What
//! panes show stands in `panes`, what they read in `document`.

#[expect(
    clippy::module_inception,
    reason = "the room's main type carries the room's name"
)]
mod app;
mod app_options;
mod apply;
mod asks;
mod asks_motions;
mod background;
mod bars;
mod chosen_files;
mod corners;
mod dialogs;
mod errors;
mod export;
mod figure_file;
mod first_picture;
mod frame_ui;
mod imports;
mod layout;
mod let_go;
mod opened_classifiers;
mod panes;
mod path_question;
mod plot_export;
mod saved_views;
mod settings;
mod sheets;
mod start;
mod study_by_name;
mod study_export;
mod tab_strip;
mod times;
mod typed_paths;
mod typefaces;
mod window_picture;

pub use app::App;
pub use app_options::AppOptions;
pub use background::Background;
pub use bars::*;
pub use path_question::{AskPaths, PathQuestion};
pub use sheets::*;
pub use start::{StartError, WindowError, run_window};
