//! The headless door: one file per command, sharing requests, engine and writers with the window.

mod analyze;
mod analyze_pictures;
mod args;
mod corresponding;
mod demo;
mod embed;
mod experiment;
mod experiment_args;
mod experiment_files;
mod experiment_medial;
mod figure;
mod figure_args;
mod info;
mod input;
mod interpolate;
mod letters;
mod limit_options;
mod map_options;
mod measure;
mod medial;
mod metric;
mod metric_options;
mod outcome;
mod patch_options;
mod print;
mod run;
mod runtime_folder;
mod tables;
mod transfer;
mod unseen;
mod words;
mod work;

pub use args::{Door, chosen_door};
pub use run::{end_of_window, print_columns, run};
pub use runtime_folder::ensure_runtime_folder;
pub use unseen::run_unseen;
