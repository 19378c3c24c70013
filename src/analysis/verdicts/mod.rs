//! Is a heart abnormal, of which kind, is there an abnormal patch, and how sure is that?
//!
//! Source: V. Taimouri, *Shape Analysis in Shape Space*, 4.4–4.7.

mod classification;
mod classifier;
mod cohort;
mod design;
mod error;
mod feature;
mod features;
mod logistic;
mod params;
mod result;
mod rule;
mod score;
mod similarity;
#[cfg(test)]
mod tests;
#[expect(
    clippy::module_inception,
    reason = "the folder's main function carries the folder's name"
)]
mod verdicts;
mod weighted;
mod whole_heart;

pub use error::{LearnError, RuleError, VerdictError};
pub use feature::{Feature, FeatureUnit};
pub use features::{Features, VerdictInput};
pub use params::{CheckedVerdictParams, VerdictParamError, VerdictParams};
pub use result::{
    ClassifierQuality, ClassifierSource, Examined, Finding, Kind, KindQuality, NotAssessed, Reason,
    TrainingSetDistance, Verdict, Verdicts,
};
pub use rule::{
    CheckedRule, Rule, RuleFeature, RuleKind, RuleMeshes, RuleModel, RuleTraining, learn,
};
pub use verdicts::{examine, verdicts, verdicts_by_rule};
pub use whole_heart::wall_in_doubt;
