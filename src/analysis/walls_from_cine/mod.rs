//! Walls from cine MR: where do endocardium and epicardium lie in bright-blood short-axis images, given three points that
//! somebody marked?
//!
//! Begin with [`segment_cine`]. In each slice and at each instant both surfaces are closed paths of least cost in polar
//! coordinates, found by dynamic programming; neighbours in time and along the axis pull at each other. No part of it is trained.

mod beat;
mod closed_path;
mod coherence;
mod edits;
mod endocardium;
mod epicardium;
mod error;
mod outline;
mod params;
mod polar;
mod segment;
mod slices;
#[cfg(test)]
mod tests;
mod tones;
mod valve_plane;

pub use error::CineError;
pub use params::{CheckedCineParams, CineParams, CineParamsError};
pub use segment::{CineSegmentation, segment_cine};
