//! How does the method stand noise, and does it do on known deformations what it should?

mod error;
mod motions;
mod noise;
mod objects;
mod synthetic;
#[cfg(test)]
mod tests;

pub use error::ExperimentError;
pub use motions::Motion;
pub use noise::{NoiseFamily, NoiseReference, coordinate_variance, noise_sigma};
pub use objects::{Fineness, ObjectKind, Solid, object};
pub use synthetic::{
    Deformation, Noise, SyntheticCohort, SyntheticParams, noisy, synthetic_cohort,
};
