//! The pose map: a point is a subject at a frame, similar poses lie near each other.

mod header;
mod map;
pub(crate) mod spec;
#[cfg(test)]
mod tests;
pub(crate) mod view;

pub use header::{pose_map_choosers_ui, pose_map_header_ui};
pub use map::{POSE_MAP, PoseMapView, pose_map_note, pose_map_ui};
