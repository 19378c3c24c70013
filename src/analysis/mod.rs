//! Questions asked of a study, one folder each: pure, stoppable, seeded.

pub mod alignment;
pub mod embedding;
pub mod experiments;
pub mod measures;
pub mod metrics;
pub mod pose_distances;
