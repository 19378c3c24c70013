//! How far is every pose of every heart from every other?

mod params;
mod result;

pub use params::PoseDistanceParams;
pub use result::{DistanceMatrix, LeftOut, PoseDistances, PoseId};
