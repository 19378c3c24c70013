//! Which rigid motion or similarity maps one pose onto another?
//!
//! For corresponding points, in closed form; reflections are never used. Sizes are made
//! comparable by one isotropic scale per sequence, see [`SizeScale`].

mod comparable;
mod covariance;
mod generalised;
mod procrustes;
mod size;

pub use comparable::{Comparable, LeftOut, comparable_subjects};
pub use covariance::{cross_covariance, rotation_from_covariance};
pub use generalised::{align_poses, align_sequences};
pub use procrustes::{AlignmentError, RigidMotion, Similarity, rigid_motion, similarity};
pub use size::{SizeScale, principal_box_sides};
