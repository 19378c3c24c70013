//! Cardiomorph analyses how a left ventricle moves. The page below says what each module holds and where to begin.
#![doc = include_str!("ARCHITECTURE.md")]

pub mod numeric;
pub mod progress;
pub mod units;

pub mod analysis;
pub mod app;
pub mod cli;
pub mod document;
pub mod engine;
pub mod image;
pub mod io;
pub mod mesh;
pub mod panes;
pub mod picture;
pub mod render;
pub mod report;
pub mod study;
pub mod ui;
