//! From images to a subject of the cohort, step by step, and the same for many studies at once.
//!
//! Begin with `current.rs`: whose images they are, and by which settings. `view.rs` lists the steps, a file `step_….rs` draws
//! each; `tools.rs` is what a click into a slice does; `batch.rs` the table of all images. `spec.rs` has the two panes.

pub(crate) mod batch;
pub(crate) mod controls;
pub(crate) mod current;
pub(crate) mod facts;
pub(crate) mod spec;
mod step_images;
mod step_orientation;
mod step_tissue;
mod step_walls;
#[cfg(test)]
mod tests;
pub(crate) mod tools;
mod view;
