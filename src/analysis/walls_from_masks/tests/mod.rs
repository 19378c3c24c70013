//! Tests of walls from masks: known answers, laws, damage, stop.
#![allow(clippy::unwrap_used, clippy::panic)] // A test that fails here says so.

mod damage;
mod known;
mod laws;
mod phantom;
mod shifts;
mod turned;
