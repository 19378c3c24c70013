//! The nearest face that faces a direction: cylinders and cones of normals around faces, four at a time.

mod bounds;
mod build;
mod faces;
mod node;
mod plan;
mod scaled_coordinates;
mod search;
mod triangle;

pub(super) use faces::{FacesOfPose, Facing, Nearest};
pub(super) use plan::TreePlan;
pub(super) use search::FaceTree;
