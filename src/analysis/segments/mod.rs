//! Where on the ventricle is it? The long axis, the 17 AHA segments, and the bull's-eye.
//!
//! Source: Cerqueira et al. (2002), Circulation 105(4), 539–542.

mod bulls_eye;
mod error;
mod long_axis;
mod means;
mod of_subject;
mod places;
mod segment;
#[cfg(test)]
mod tests;
mod thickening;

pub use bulls_eye::{
    FlatMap, RING_RADII, flat_map, height_at, plot_point, plot_radius, ring, segment_on_plot,
};
pub use error::SegmentError;
pub use long_axis::LongAxis;
pub use means::{level_means, segment_means};
pub use of_subject::{inner_places, long_axis};
pub use places::{CAP_SHARE, Places, Polar, level, places, polar, segment};
pub use segment::{Level, Segment};
pub use thickening::{GroupThickening, level_thickening, segment_thickening};
