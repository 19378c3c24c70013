//! The pose map: a point is a subject at a frame, similar poses lie near each other.

mod figure;
mod header;
pub(crate) mod spec;
#[cfg(test)]
mod tests;
pub(crate) mod view;
mod words;

pub use {header::*, words::*};
