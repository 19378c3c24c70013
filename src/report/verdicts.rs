//! Verdicts: a row per subject, with what the classifier reads.

use super::column::{Cell, Column, Digits, Unit};
use super::table::Row;
use crate::analysis::verdicts::{ClassifierSource, Feature, Features, Verdict, Verdicts};
use crate::study::Study;

/// What the classifier and the patch detection say of one subject together.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct VerdictRow {
    /// Pseudonym.
    pub subject: String,
    /// What the study says.
    pub label: Option<String>,
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
}

impl VerdictRow {
    /// What the study says.
    pub const LABEL: Column<Self> = Column::plain(
        "label",
        "Label",
        "Label that the study gives the subject; empty without one",
        |row| row.label.clone().into(),
    );
    /// Predicted probability.
    pub const PROBABILITY: Column<Self> = Column::<Self>::new(
        "probability",
        "Predicted probability",
        Unit::Share,
        Digits::Places(0),
        "Predicted probability of class abnormal, leave-one-out where the subject has a label; an uncalibrated \
         score where calibrated is no",
        |row| row.probability.into(),
    ).or_short("Probability");
    /// The verdict in words.
    pub const FINDING: Column<Self> = Column::plain(
        "finding",
        "Verdict",
        "Verdict as the window shows it: no regional abnormality, abnormal patch, global hypokinesia, abnormal without a patch, \
         or not assessed",
        |row| row.finding.into(),
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
                    Ok(verdict) => unassessed.with(study, verdict, verdicts.classifier),
                    Err(reason) => Self {
                        finding: Some("not assessed"),
                        reason: Some(reason.to_string()),
                        ..unassessed
                    },
                }
            })
            .collect()
    }

    fn with(self, study: &Study, verdict: &Verdict, classifier: ClassifierSource) -> Self {
        let names = |others: &[usize]| {
            let subjects = others.iter().filter_map(|&other| study.subjects.get(other));
            subjects.map(|subject| subject.id.clone()).collect()
        };
        Self {
            abnormal: Some(verdict.abnormal),
            probability: Some(verdict.probability),
            finding: Some(verdict.finding.name()),
            calibrated: Some(match classifier {
                ClassifierSource::Cohort { .. } => true,
                ClassifierSource::Uncalibrated { .. } => false,
            }),
            similar_normal: names(&verdict.similar_normal),
            similar_abnormal: names(&verdict.similar_abnormal),
            distance_from_seen: verdict.training_set_distance.map(|near| near.distance),
            usual_distance: verdict.training_set_distance.map(|near| near.median),
            features: verdict.features.clone(),
            ..self
        }
    }
}

const YES_NO: [&str; 2] = ["no", "yes"];

impl Row for VerdictRow {
    const FILES: &'static [&'static str] = &["verdicts.csv"];
    const ROW: &'static str = "Verdicts, a row per subject";
    const COLUMNS: &'static [Column<Self>] = &[
        Column::plain("subject", "Subject", "Pseudonym of the subject", |row| {
            (&row.subject).into()
        }),
        Self::LABEL,
        Column::plain(
            "verdict",
            "Class",
            "Predicted class, normal or abnormal; empty where the subject is not assessed",
            |row| {
                row.abnormal
                    .map(|abnormal| ["normal", "abnormal"][usize::from(abnormal)])
                    .into()
            },
        ),
        Self::PROBABILITY,
        Column::plain(
            "assessed",
            "Assessed",
            "yes, or no where no verdict is possible",
            |row| YES_NO[usize::from(row.abnormal.is_some())].into(),
        ),
        Column::plain(
            "reason",
            "Reason",
            "Why the subject is not assessed",
            |row| row.reason.clone().into(),
        ),
        Self::FINDING,
        Column::plain(
            "calibrated",
            "Calibrated",
            "yes if the probability comes from a classifier trained on the labelled subjects; no for default \
             thresholds",
            |row| {
                row.calibrated
                    .map(|calibrated| YES_NO[usize::from(calibrated)])
                    .into()
            },
        ),
        Column::plain(
            "alike_normal",
            "Most similar normal",
            "Most similar subjects with a normal label, nearest first",
            |row| row.similar_normal.join(" ").into(),
        ),
        Column::plain(
            "alike_abnormal",
            "Most similar abnormal",
            "Most similar subjects with an abnormal label, nearest first",
            |row| row.similar_abnormal.join(" ").into(),
        ),
        distance(
            "distance_from_seen",
            "Distance to training set",
            "Distance to the nearest subject of the training set, in standard deviations of the model features",
            |row| row.distance_from_seen.into(),
        ),
        distance(
            "usual_distance",
            "Median distance in training set",
            "Median over the training set of the distance to its nearest other subject, in standard deviations of the model features",
            |row| row.usual_distance.into(),
        ),
        share(
            "still_share",
            "Akinetic region",
            "Share of the wall with thickening below 10 % from end-diastole to end-systole (akinetic)",
            |row| row.features.get(Feature::AkineticShare).into(),
        ),
        ln_pt(
            "median_ln_pt",
            "Median thickening",
            "Area-weighted median over the wall of ln PT from end-diastole to end-systole",
            |row| row.features.get(Feature::Median).into(),
        ),
        ln_pt(
            "spread_ln_pt",
            "SD of thickening",
            "Area-weighted standard deviation over the wall of ln PT",
            |row| row.features.get(Feature::Spread).into(),
        ),
        distance(
            "relative_spread",
            "Thickening heterogeneity",
            "Standard deviation of ln PT over the wall relative to ln PT of the remote myocardium, which counts as at least ln 1.1",
            |row| row.features.get(Feature::RelativeSpread).into(),
        ),
        ln_pt(
            "weakest_tenth_ln_pt",
            "10th percentile of thickening",
            "Area-weighted 10th percentile over the wall of ln PT",
            |row| row.features.get(Feature::TenthPercentile).into(),
        ),
        ln_pt(
            "well_ln_pt",
            "Remote thickening",
            "ln PT of the remote myocardium from end-diastole to end-systole",
            |row| row.features.get(Feature::Remote).into(),
        ),
        ln_pt(
            "reach_ln_pt",
            "Upper range of thickening",
            "ln PT of the remote myocardium plus twice the standard deviation over the wall",
            |row| row.features.get(Feature::UpperRange).into(),
        ),
        share(
            "patch_share",
            "Wall in patches",
            "Share of the wall in patches, each weighted by its detection stability",
            |row| row.features.get(Feature::PatchShare).into(),
        ),
        share(
            "patch_confidence",
            "Detection stability",
            "Detection stability of the largest patch: share of noise redraws in which it is detected again; 0 without a patch",
            |row| row.features.get(Feature::Confidence).into(),
        ),
        distance(
            "patch_relative_thickening",
            "Ratio of patch to remote thickening",
            "ln PT of the largest patch relative to that of the remote myocardium; 1 without a patch",
            |row| row.features.get(Feature::PatchThickening).into(),
        ),
        distance(
            "patch_compactness",
            "Compactness",
            "Compactness of the largest patch, 4π × area / perimeter², at most 1; 0 without a patch",
            |row| row.features.get(Feature::Compactness).into(),
        ),
        distance(
            "pose_distance",
            "Mean pose distance",
            "Mean distance between poses in the medial shape space, of the largest patch or, without one, of all akinetic atoms",
            |row| row.features.get(Feature::MeanPoseDistance).into(),
        ),
        Column::new(
            "normal_spread_rad",
            "Angular SD of ANV",
            Unit::Symbol("rad"),
            Digits::Places(2),
            "Angular standard deviation of the average normal vector (ANV) over the beat",
            |row| row.features.get(Feature::NormalSpread).into(),
        ),
        Column::new(
            "gap_sizes",
            "Distance of MP",
            Unit::Symbol("× size"),
            Digits::Places(3),
            "Mean distance of the mean position (MP) from the medial surface, relative to the size of the medial surface",
            |row| row.features.get(Feature::MeanPositionDistance).into(),
        ),
    ];
}

const fn share(
    key: &'static str,
    heading: &'static str,
    explanation: &'static str,
    cell: fn(&VerdictRow) -> Cell,
) -> Column<VerdictRow> {
    Column::new(
        key,
        heading,
        Unit::Share,
        Digits::Places(0),
        explanation,
        cell,
    )
}

const fn ln_pt(
    key: &'static str,
    heading: &'static str,
    explanation: &'static str,
    cell: fn(&VerdictRow) -> Cell,
) -> Column<VerdictRow> {
    let unit = Unit::Symbol("ln PT");
    Column::new(key, heading, unit, Digits::Places(2), explanation, cell)
}

/// Distances and ratios without a unit.
const fn distance(
    key: &'static str,
    heading: &'static str,
    explanation: &'static str,
    cell: fn(&VerdictRow) -> Cell,
) -> Column<VerdictRow> {
    Column::plain(key, heading, explanation, cell)
}

#[cfg(test)]
mod tests;
