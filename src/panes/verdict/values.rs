//! What the pane of the verdict shows, as plain values.

use crate::panes::verdict_marks::VerdictMark;
use crate::panes::work_state::WorkState;

/// The verdict on one subject, in words and numbers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct VerdictReport {
    /// The verdict as a shape.
    pub mark: VerdictMark,
    /// "Abnormal patch · 31 % of the LV".
    pub heading: String,
    /// What that means; for a subject that is not assessed, why.
    pub sentence: String,
    /// Predicted probability of class abnormal, in `0..=1`; `None` where it is not assessed.
    pub probability: Option<f64>,
    /// Labels of the study with the probability that it is the subject's, the most probable first; empty
    /// without one.
    pub labels: Vec<(String, String)>,
    /// The features that speak most for the class, in words; empty without any.
    pub reasons: String,
    /// Which classifier it is from: leave-one-out, trained on others, a file, the built-in one.
    pub source: &'static str,
    /// Distance to the training set; `None` without one.
    pub training_distance: Option<TrainingDistance>,
    /// The features.
    pub evidence: Vec<EvidenceRow>,
    /// The most similar subjects of class normal and of class abnormal, nearest first.
    pub similar: [Vec<SimilarSubject>; 2],
}

/// Distance of a subject to the training subjects.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TrainingDistance {
    /// In a sentence.
    pub words: String,
    /// Whether it is outside the training distribution.
    pub outside: bool,
}

/// One feature of a subject beside those of the normal subjects.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct EvidenceRow {
    /// "Akinetic region".
    pub name: &'static str,
    /// What it is, for the hover.
    pub what: &'static str,
    /// With its unit; "no value" where there is none.
    pub value: String,
    /// Range of the normal subjects, with the unit; empty where there are none.
    pub normal: String,
    /// Position of the value in the range of all subjects, in `0..=1`.
    pub place: Option<f32>,
    /// Range of the normal subjects on the same scale.
    pub band: Option<[f32; 2]>,
    /// Whether the classifier uses it.
    pub model_feature: bool,
}

/// A subject similar to the selected one.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SimilarSubject {
    /// Index into the study's subjects.
    pub subject: usize,
    /// Pseudonym.
    pub id: String,
    /// Label of the study.
    pub label: String,
    /// Its verdict: "patch 31 %".
    pub verdict: String,
}

/// How the classifier was trained, and its accuracy.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ClassifierReport {
    /// "Logistic classifier, trained on 9 normal and 14 abnormal subjects …".
    pub source: String,
    /// Accuracy, area under the curve, errors.
    pub results: Vec<ClassifierResult>,
}

/// A measure of the quality of a classifier with its permutation test.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ClassifierResult {
    /// "Accuracy (leave-one-out)".
    pub name: &'static str,
    /// What it is, for the hover.
    pub what: &'static str,
    /// "22 of 23".
    pub value: String,
    /// "permutation mean 11.6 · p 0.005"; empty without a test.
    pub permutation_test: String,
}

/// What the pane shows.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct VerdictPanelView<'a> {
    /// The selected subject.
    pub subject: Option<&'a str>,
    /// State of the classification; what is shown may belong to the previous thresholds.
    pub state: WorkState,
    /// Its verdict; `None` while there is none.
    pub verdict: Option<VerdictReport>,
    /// The classifier; `None` while there is none.
    pub classifier: Option<ClassifierReport>,
}
