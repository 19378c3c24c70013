//! How would a subject move with the motion of another?
//!
//! A deformation M₀, M₁, … is transported to another subject N₀ step after step: the displacement
//! X_i = M_{i+1} − M_i is transported along the geodesic from M_i to N_i, and
//! N_{i+1} = N_i + X̄_i.
//!
//! Source: V. Taimouri, *Shape Analysis in Shape Space*, section 3.3.2.

mod account;
mod beat;
mod cohort;
mod deformation;
mod error;
mod parallel;
mod params;
mod pose_path;

pub use account::{FoundPath, TransportAccount, TransportedPoses, TransportedStep};
pub use beat::{TransportedMotion, sequence_like, transported_motion};
pub use cohort::{MotionOnReference, TransportedCohort, transport_cohort};
pub use deformation::{DeformationTransport, transport_deformation};
pub use error::TransportError;
pub use parallel::{Products, SampledPath, parallel_transport};
pub use params::{
    CheckedTransportParams, CohortTransportParams, Geodesics, Nearness, Reference,
    TransportParamError, TransportParams,
};
pub use pose_path::{PosePath, transport_along};

#[cfg(test)]
mod tests;
