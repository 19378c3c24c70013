//! A classifier that travels, as its file has it: trained on one study, applied to subjects of another; it holds no subject.

use serde::{Deserialize, Serialize};

use super::error::ClassifierError;

/// What a file of a rule calls itself.
pub(super) const FORMAT: &str = "cardiomorph rule";
/// Version of the form of a rule; others are refused.
pub(super) const VERSION: u32 = 1;

/// A classifier with its training figures and the ranges of what it has seen.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ClassifierFile {
    /// Says that it is a rule.
    pub format: String,
    /// Of this form.
    pub version: u32,
    /// Where it comes from; files of before have none of it.
    #[serde(default)]
    pub origin: ClassifierOrigin,
    /// What it was trained on, and how good it is, leave-one-out.
    pub training: ClassifierTraining,
    /// The meshes that it was trained on.
    pub meshes: ClassifierMeshes,
    /// What it reads, in the order of all weights: some or all of
    /// [`Feature::MODEL_FEATURES`](super::Feature::MODEL_FEATURES), in their order.
    pub features: Vec<ClassifierFeature>,
    /// How far its training subjects lie from their mean, in standard deviations of a feature: the quantiles 0, 5 … 100 %.
    pub distances: Vec<f64>,
    /// Abnormal against normal.
    pub abnormal: ClassifierModel,
    /// One label against the rest, for each that could be told; empty with fewer than three.
    #[serde(rename = "kinds")]
    pub labels: Vec<ClassifierLabel>,
}

/// Where a rule comes from.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ClassifierOrigin {
    /// Name of the study.
    pub study: String,
    /// Labels that count as normal there.
    pub normal: Vec<String>,
    /// And as abnormal.
    pub abnormal: Vec<String>,
    /// The program that trained it, with its version.
    pub program: String,
    /// What its maker says of it.
    pub note: String,
}

/// Training figures, leave-one-out.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ClassifierTraining {
    /// Subjects of class normal.
    pub normal: usize,
    /// Of class abnormal.
    pub abnormal: usize,
    /// Share of them that is classified correctly.
    pub accuracy: Option<f64>,
    /// Area under the ROC curve.
    pub auc: Option<f64>,
    /// Normal subjects classified as abnormal.
    pub false_positives: Option<usize>,
    /// Abnormal subjects classified as normal.
    pub false_negatives: Option<usize>,
    /// Share whose most probable label is their own.
    #[serde(rename = "kind_accuracy")]
    pub label_accuracy: Option<f64>,
}

/// The meshes of a training set.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ClassifierMeshes {
    /// Whether they are those of walls, with an inner and an outer side, and not of cavities alone.
    pub walls: bool,
    /// Least and greatest number of vertices of a subject.
    pub vertices: [usize; 2],
    /// Least and greatest number of poses.
    pub poses: [usize; 2],
}

/// One feature, and how it is brought to a common scale.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ClassifierFeature {
    /// In words.
    pub name: String,
    /// What it is counted in; empty for a ratio.
    pub unit: String,
    /// Least and greatest value in the training set; null where no subject had one.
    pub range: Option<[f64; 2]>,
    /// What stands in where it is not known; null where no subject had one.
    pub median: Option<f64>,
    /// Mean over the training set, which is subtracted to standardise a value.
    pub mean: f64,
    /// Standard deviation over the training set, by which the difference from the mean is divided.
    pub deviation: f64,
    /// Mean and deviation of the flag of its absence, 0 or 1, if there is one.
    pub absence: Option<[f64; 2]>,
}

/// Log odds = intercept + Σ weight × standardised feature + Σ weight × standardised flag; probability =
/// 1 / (1 + exp(−slope × log odds − shift)).
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ClassifierModel {
    /// Penalty on squared weights that was chosen.
    pub penalty: f64,
    /// Intercept.
    pub intercept: f64,
    /// One per feature.
    pub weights: Vec<f64>,
    /// One per feature that has a flag of absence, in their order.
    pub absence_weights: Vec<f64>,
    /// Slope of the calibration.
    pub slope: f64,
    /// Shift of the calibration.
    pub shift: f64,
}

/// The model of one label.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ClassifierLabel {
    /// The label.
    pub label: String,
    /// It against the rest.
    pub model: ClassifierModel,
}

impl ClassifierFile {
    /// A rule from the text of its file.
    ///
    /// # Errors
    /// Why the text is none, with line and column.
    pub fn read(text: &str) -> Result<Self, ClassifierError> {
        serde_json::from_str(text).map_err(|error| ClassifierError::Text(error.to_string()))
    }
}
