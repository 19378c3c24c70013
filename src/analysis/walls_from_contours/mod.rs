//! Masks from contours: which voxels lie within the outlines that were drawn in the slices of an image?
//!
//! Begin with [`masks_of_contours`]; [`stack_of_contours`] gives the grid of contours that come without an image. Where a beat has outlines of the epicardium at end-diastole alone, as in most studies that
//! were drawn for volumes, [`with_epicardium`] adds the others first.

mod coverage;
mod epicardium;
mod error;
mod masks;
mod placing;
mod radii;
mod stack;
#[cfg(test)]
mod tests;

pub use epicardium::{WithEpicardium, with_epicardium};
pub use error::{ContourError, ContourName};
pub use masks::masks_of_contours;
pub use stack::stack_of_contours;
