//! The images of a subject in three slices that cross at one point, with the outlines of its surfaces over them.
//!
//! Begin with `view.rs`, which lays out the slices. `plane.rs` says how a slice lies on the screen, `texture.rs` makes its
//! picture, `section.rs` cuts surfaces with it, `slice.rs` draws one slice and hears what is done in it.

mod contour_drag;
pub(crate) mod grey;
mod overlays;
pub(crate) mod plane;
pub(crate) mod section;
mod slice;
pub(crate) mod spec;
mod surface;
#[cfg(test)]
mod tests;
mod texture;
pub(crate) mod view;
