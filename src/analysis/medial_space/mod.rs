//! How far apart are two medial surfaces, or two poses of one subject?
//!
//! Source: V. Taimouri, *Shape Analysis in Shape Space*, 4.3 and 4.5.

mod atom;
mod mean;
mod pose;
mod sphere;
mod spokes;
mod surface;
#[cfg(test)]
mod tests;

pub use atom::{
    AtomAction, AtomDifference, AtomLog, AtomNorm, AtomTangent, atom_between, atom_distance,
    atom_exp, atom_log, atom_log_pole,
};
pub use mean::{frechet_mean, mean_direction};
pub use pose::{
    AkineticAtom, PoseDescriptor, RatioForm, pose_descriptor, pose_distance, spoke_angle_rad,
};
pub use sphere::{Log, PoleLog, angle, between, exp, exp_pole, log, log_pole};
pub use spokes::spokes_from_gradient;
pub use surface::{
    MedialDistance, MedialSpaceError, interpolate, mean_atom, mean_atoms, mean_radius,
    medial_distance,
};
