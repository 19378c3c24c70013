//! The medial map: a point is a step of the cycle, as the akinetic region of the wall has it.

mod figure;
mod header;
pub(crate) mod spec;
#[cfg(test)]
mod tests;
pub(crate) mod view;
mod words;

pub use {header::*, words::*};
