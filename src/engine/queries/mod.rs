//! One file per analysis: its settings, which are its question, its answer, and what it asks of others.

mod beat_shares;
mod classes;
mod contribution;
mod deformation_map;
mod deformation_parts;
mod estimated_pose;
mod image_preview;
mod image_proposal;
mod image_series;
mod image_walls;
mod interpolated_poses;
mod measures;
mod medial_map;
mod medial_surfaces;
mod motion_transport;
mod pose_distances;
mod pose_map;
mod subject;
#[cfg(test)]
mod tests;
mod thickening;
mod thickness;
mod verdicts;

pub use beat_shares::*;
pub use classes::*;
pub use contribution::*;
pub use deformation_map::*;
pub use deformation_parts::*;
pub use estimated_pose::*;
pub use image_preview::*;
pub use image_proposal::*;
pub use image_series::*;
pub use image_walls::*;
pub use interpolated_poses::*;
pub use measures::*;
pub use medial_map::*;
pub use medial_surfaces::*;
pub use motion_transport::*;
pub use pose_distances::*;
pub use pose_map::*;
pub use subject::*;
pub use thickening::*;
pub use thickness::*;
pub use verdicts::*;
