//! How does the method stand noise, and does it do on known deformations what it should?

mod comparison;
mod error;
mod interpolation_experiment;
mod localisation;
mod medial_methods;
#[cfg(test)]
mod medial_tests;
mod motions;
mod noise;
mod noise_medial;
mod noise_medial_params;
mod noise_medial_result;
mod noise_params;
mod noise_result;
mod noise_study;
mod noisy;
mod objects;
mod one_motion;
mod partners;
mod pipeline;
mod sheet_mesh;
mod sheet_patches;
mod sheets;
mod synthetic;
#[cfg(test)]
mod tests;
mod transport_experiment;

pub use comparison::{
    ComparisonRow, MeanAccuracy, MetricComparison, MetricComparisonParams, metric_comparison,
};
pub use error::ExperimentError;
pub use interpolation_experiment::{
    InterpolationCase, InterpolationExperiment, InterpolationExperimentParams,
    interpolation_experiment,
};
pub use localisation::{LocalisationParams, LocalisationRow, MeanAndError, localisation};
pub use medial_methods::MedialMethod;
pub use motions::Motion;
pub use noise::{NoiseFamily, NoiseReference, coordinate_variance, noise_sigma};
pub use noise_medial::noise_medial;
pub use noise_medial_params::MedialNoiseParams;
pub use noise_medial_result::{MedialNoiseCell, MedialNoiseResult, published_medial_tau};
pub use noise_params::NoiseDeformationParams;
pub use noise_result::{NoiseCell, NoiseDeformationResult, published_tau};
pub use noise_study::noise_deformation;
pub use noisy::{Noise, noisy_study};
pub use objects::{Fineness, ObjectKind, Solid, object};
pub use partners::{
    PartnerParams, PartnerRanks, PartnerRow, PartnerStudy, TransportOption, partner_study,
    patient_of,
};
pub use pipeline::Method;
pub use sheets::{Sheet, SheetParams, sheet};
pub use synthetic::{Deformation, SyntheticCohort, SyntheticParams, synthetic_cohort};
pub use transport_experiment::{
    TransportCase, TransportExperiment, TransportExperimentParams, transport_experiment,
};
