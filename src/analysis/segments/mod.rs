//! Where on the ventricle is it? The long axis, the 17 AHA segments, and the bull's-eye.
//!
//! Source: Cerqueira et al. (2002), Circulation 105(4), 539–542.

mod error;
mod long_axis;
mod means;
mod places;
mod segment;

pub use error::SegmentError;
pub use long_axis::LongAxis;
pub use means::{level_means, segment_means, vertex_areas};
pub use places::{CAP_SHARE, Places, Polar, level, places, polar, segment};
pub use segment::{Level, Segment};
