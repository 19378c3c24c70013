//! Tests of preparation: known answers, laws, damage, stop.
#![allow(clippy::unwrap_used, clippy::panic)] // A test that fails here says so.

mod phantom;
mod roads;
mod settings;
mod stages;
