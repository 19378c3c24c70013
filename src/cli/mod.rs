//! The headless door: one file per command, sharing requests, engine and writers with the window.

mod analyze;
mod args;
mod demo;
mod embed;
mod figure;
mod info;
mod input;
mod measure;
mod metric;
mod outcome;
mod print;
mod run;
mod tables;
mod unseen;
mod words;
mod work;

pub use args::{Door, chosen_door};
pub use run::run;
pub use unseen::run_unseen;
