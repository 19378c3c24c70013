//! The cohort that ships inside: 23 beating left ventricles of a model of our own, with their ground truth.
//!
//! The model is a thick wall that moves without changing its volume (`motion`), shaped as a
//! truncated prolate spheroid with a flattened septal side (`shape`), sampled by triangles that
//! correspond between layers, frames and subjects (`grid`), ill in places where it is known to be
//! (`patch`), and varied between subjects in ranges of published populations (`design`).

mod cohort;
mod design;
mod grid;
mod motion;
mod params;
mod patch;
mod segments;
mod shape;
#[cfg(test)]
mod tests;
mod timing;
mod truth;

pub use cohort::{BUILT_IN_NAME, BuiltInCohort, cohort};
pub use grid::{GridPoint, WallGrid};
pub use params::{BuiltInError, BuiltInParams, FRAMES, MAX_VERTICES};
pub use truth::{Abnormality, GroundTruth, SurfaceTruth};
