//! The spatiotemporal plot: poses by the two axes of their map and the share of the cycle, seen from
//! any side.

mod axes;
mod eye;
mod phase_plane;
mod plot;
pub(crate) mod spec;
#[cfg(test)]
mod tests;

pub use plot::*;
