//! Which map lays one surface onto another: rigid, of similar shape, or bent at landmarks?
//!
//! Rigid motion and similarity of corresponding points are those of `alignment`; here are weights, correspondences that are
//! searched for (ICP), and thin-plate splines.

mod fit;
mod icp;
mod thin_plate_spline;
mod weighted;

pub use fit::{SurfaceFit, distances_to};
pub use icp::{CheckedIcpParams, Icp, IcpError, IcpParams, icp, point_target};
pub use thin_plate_spline::{ThinPlateSpline, ThinPlateSplineError};
pub use weighted::{WeightsError, weighted_rigid_motion};

#[cfg(test)]
mod tests;
