//! How far is every pose of every subject from every other?

mod bands;
mod beat_shares;
mod error;
mod known;
mod matrix;
mod pair;
mod params;
mod result;
mod smooth;
mod source;

pub use crate::analysis::alignment::LeftOut;
pub use beat_shares::{BeatShares, beat_shares};
pub use error::PoseDistanceError;
pub use known::KnownDistances;
pub use matrix::{
    ComputedDistances, Needed, pose_distances, pose_distances_knowing, pose_distances_where,
};
pub use pair::{PairError, pair_contributions};
pub use params::{CheckedPoseDistanceParams, PoseDistanceParamError, PoseDistanceParams};
pub use result::{DistanceMatrix, PoseDistances, PoseId};
pub use smooth::smoothed_study;
