//! The pose map: a point is a subject at a frame, similar poses lie near each other.

mod header;
mod map;
pub(crate) mod spec;
#[cfg(test)]
mod tests;
pub(crate) mod view;

pub use {header::*, map::*};
