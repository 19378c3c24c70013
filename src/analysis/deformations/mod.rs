//! Which whole deformations are similar?
//!
//! A deformation is the way of one subject through the space of poses over its beat. On the map of
//! poses it is a curve (x, y), with time as third coordinate (x, y, w t); curves, not poses, are
//! compared and embedded in a plane, one point per subject.
//!
//! Source: V. Taimouri, *Shape Analysis in Shape Space*, section 3.3.4.

mod beats;
mod curve;
mod distances;
mod map;
mod params;
mod result;

pub use curve::resampled;
pub use distances::{DeformationDistances, deformation_distances};
pub use map::{DeformationMapError, FEWEST_DEFORMATIONS, deformation_map};
pub use params::{
    CheckedDeformationMapParams, DeformationMapParams, DeformationParamError, default_neighbours,
};
pub use result::DeformationMap;

#[cfg(test)]
mod tests;
