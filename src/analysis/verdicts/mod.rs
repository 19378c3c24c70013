//! Is a heart abnormal, of which kind, is there an abnormal patch, and how sure is that?
//!
//! Source: V. Taimouri, *Shape Analysis in Shape Space*, 4.4–4.7.

mod checked_rule;
mod classification;
mod classifier;
mod cohort;
mod design;
mod error;
mod feature;
mod features;
mod learn;
mod logistic;
mod params;
mod result;
mod rule;
mod score;
mod shipped;
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

pub use checked_rule::CheckedRule;
pub use error::{LearnError, RuleError, VerdictError};
pub use feature::{Feature, FeatureUnit};
pub use features::{Features, VerdictInput};
pub use learn::learn;
pub use params::{CheckedVerdictParams, VerdictParamError, VerdictParams};
pub use result::{
    ClassifierQuality, ClassifierSource, Examined, Finding, Kind, KindQuality, NotAssessed, Reason,
    RuleSource, TrainingSetDistance, Verdict, Verdicts,
};
pub use rule::{Rule, RuleFeature, RuleKind, RuleMeshes, RuleModel, RuleOrigin, RuleTraining};
pub use shipped::built_in_rule;
pub use verdicts::{examine, verdicts};
pub use whole_heart::wall_in_doubt;
