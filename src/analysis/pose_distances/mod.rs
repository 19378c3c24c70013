//! How far is every pose of every heart from every other?

mod matrix;
mod params;
mod result;

pub use crate::analysis::alignment::LeftOut;
pub use matrix::pose_distances;
pub use params::{CheckedPoseDistanceParams, PoseDistanceParams};
pub use result::{DistanceMatrix, PoseDistances, PoseId};
