//! Is a heart abnormal, of which kind, is there an abnormal patch, and how sure is that?
//!
//! Source: V. Taimouri, *Shape Analysis in Shape Space*, 4.4–4.7.

mod checked_classifier;
mod classification;
mod classifier;
mod classifier_file;
mod cohort;
mod design;
mod error;
mod feature;
mod features;
mod learn;
mod logistic;
mod params;
mod result;
mod score;
mod shipped;
mod similarity;
mod subject_thickening;
#[cfg(test)]
mod tests;
#[expect(
    clippy::module_inception,
    reason = "the folder's main function carries the folder's name"
)]
mod verdicts;
mod weighted;
mod whole_heart;

pub use checked_classifier::CheckedClassifier;
pub use classifier_file::{
    ClassifierFeature, ClassifierFile, ClassifierLabel, ClassifierMeshes, ClassifierModel,
    ClassifierOrigin, ClassifierTraining,
};
pub use error::{ClassifierError, LearnError, VerdictError};
pub use feature::{Feature, FeatureUnit};
pub use features::{Features, VerdictInput};
pub use learn::learn;
pub use params::{CheckedVerdictParams, VerdictParamError, VerdictParams};
pub use result::{
    AppliedClassifier, ClassifierQuality, ClassifierSource, Examined, Finding, LabelProbability,
    LabelQuality, NotAssessed, Reason, TrainingSetDistance, Verdict, Verdicts,
};
pub use shipped::built_in_classifier;
pub use subject_thickening::SubjectThickening;
pub use verdicts::{examine, verdicts};
pub use whole_heart::wall_in_doubt;
