//! Verdicts: a row per subject, with what the classifier reads.

use super::column::{Column, column};
use super::measures::SubjectRow;
use super::shared;
use crate::analysis::measures::SubjectMeasures;
use crate::analysis::verdicts::{Features, Verdict, Verdicts};
use crate::study::Study;

/// What the classifier and the patch detection say of one subject together.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct VerdictRow {
    /// Pseudonym.
    pub subject: String,
    /// What the study says.
    pub label: Option<String>,
    /// Whether there is a verdict.
    pub assessed: bool,
    /// Whether it is classified as abnormal; `None` where it is not assessed.
    pub abnormal: Option<bool>,
    /// Predicted probability of class abnormal.
    pub probability: Option<f64>,
    /// Why it is not assessed.
    pub reason: Option<String>,
    /// The verdict in words.
    pub finding: Option<&'static str>,
    /// Whether the probability is calibrated on the labelled subjects.
    pub calibrated: Option<bool>,
    /// The most similar subjects with a normal label, nearest first.
    pub similar_normal: Vec<String>,
    /// And with an abnormal label.
    pub similar_abnormal: Vec<String>,
    /// Distance to the nearest subject of the training set.
    pub distance_from_seen: Option<f64>,
    /// Median of the same distance within the training set.
    pub usual_distance: Option<f64>,
    /// What the classifier reads, and further features.
    pub features: Features,
    /// The most probable label of the study.
    pub kind: Option<String>,
    /// And its probability.
    pub kind_probability: Option<f64>,
    /// Probabilities of all labels that could be told, the most probable first.
    pub kinds: String,
    /// The features that speak most for the class.
    pub reasons: String,
    /// Model features outside the range that a rule has seen.
    pub outside_training: String,
    /// Measures of the subject outside the range of healthy adults, which no verdict on regions says.
    pub outside_range: String,
}

impl VerdictRow {
    /// What the study says.
    pub const LABEL: Column<Self> = shared::label(|row| row.label.as_deref().into());
    /// Predicted probability.
    pub const PROBABILITY: Column<Self> = column(
        "probability",
        "Predicted probability",
        |row: &Self| row.probability.into(),
    )
    .share(
        "Predicted probability of class abnormal, leave-one-out where the classifier was trained on the subject",
    )
    .or_short("Probability");
    /// The verdict in words.
    pub const FINDING: Column<Self> = column("finding", "Verdict", |row: &Self| row.finding.into())
        .plain(
            "Verdict as the window shows it: no regional abnormality, abnormal patch, global \
                     hypokinesia, abnormal without a patch, normal or abnormal, wall not assessed, or not assessed",
        );

    /// One row per subject of the study.
    pub fn of_study(study: &Study, verdicts: &Verdicts) -> Vec<Self> {
        let subjects = study.subjects.iter().zip(&verdicts.subjects);
        subjects
            .map(|(subject, assessed)| {
                let unassessed = Self {
                    subject: subject.id.clone(),
                    label: subject.label.clone(),
                    ..Self::default()
                };
                match assessed {
                    Ok(verdict) => unassessed.with(study, verdict),
                    Err(reason) => Self {
                        finding: Some("not assessed"),
                        reason: Some(reason.to_string()),
                        ..unassessed
                    },
                }
            })
            .collect()
    }

    /// The same rows with what is unusual about the measures, one of each subject in the order of the study.
    pub fn with_measures(rows: Vec<Self>, measures: &[SubjectMeasures]) -> Vec<Self> {
        let mut rows = rows;
        for (row, measured) in rows.iter_mut().zip(measures) {
            row.outside_range = SubjectRow::new(String::new(), None, measured).outside_range;
        }
        rows
    }

    fn with(self, study: &Study, verdict: &Verdict) -> Self {
        let names = |others: &[usize]| {
            let subjects = others.iter().filter_map(|&other| study.subjects.get(other));
            subjects.map(|subject| subject.id.clone()).collect()
        };
        let outside: Vec<&str> = (verdict.outside.iter())
            .map(|feature| feature.name())
            .collect();
        let kinds = (verdict.labels.iter())
            .map(|label| format!("{} {:.3}", label.label, label.probability))
            .collect::<Vec<_>>();
        let reasons = (verdict.reasons.iter())
            .map(|reason| format!("{} {:+.2}", reason.feature.name(), reason.log_odds))
            .collect::<Vec<_>>();
        Self {
            assessed: true,
            abnormal: Some(verdict.abnormal),
            probability: Some(verdict.probability),
            finding: Some(verdict.words()),
            calibrated: Some(true),
            kind: verdict.labels.first().map(|label| label.label.clone()),
            kind_probability: verdict.labels.first().map(|label| label.probability),
            kinds: kinds.join("; "),
            reasons: reasons.join("; "),
            outside_training: outside.join("; "),
            similar_normal: names(&verdict.similar_normal),
            similar_abnormal: names(&verdict.similar_abnormal),
            distance_from_seen: verdict.training_set_distance.map(|near| near.distance),
            usual_distance: verdict.training_set_distance.map(|near| near.median),
            features: verdict.features.clone(),
            ..self
        }
    }
}

mod columns;
#[cfg(test)]
mod tests;
