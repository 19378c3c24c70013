//! Is there an abnormal patch, and how sure is that?
//!
//! Source: V. Taimouri, *Shape Analysis in Shape Space*, 4.4–4.7.

mod classifier;
mod cohort;
mod error;
mod features;
mod logistic;
mod params;
mod result;
mod score;
mod similarity;
#[cfg(test)]
mod tests;
#[expect(
    clippy::module_inception,
    reason = "the room's main function carries the room's name"
)]
mod verdicts;

pub use error::VerdictError;
pub use features::{Feature, Features, VerdictInput};
pub use params::{CheckedVerdictParams, VerdictParamError, VerdictParams};
pub use result::{
    ClassifierQuality, ClassifierSource, Examined, Finding, NotAssessed, TrainingSetDistance,
    Verdict, Verdicts,
};
pub use verdicts::{examine, verdicts, wall_in_doubt};
