//! Verdicts: a row per subject, with what the classifier reads.

use super::column::{Cell, Column, column};
use super::measures::{SubjectRow, some};
use super::shared;
use super::table::Row;
use crate::analysis::measures::SubjectMeasures;
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
        "Predicted probability of class abnormal, leave-one-out where the subject has a label; an \
                 uncalibrated score where calibrated is no",
    )
    .or_short("Probability");
    /// The verdict in words.
    pub const FINDING: Column<Self> = column("finding", "Verdict", |row: &Self| row.finding.into())
        .plain(
            "Verdict as the window shows it: no regional abnormality, abnormal patch, global \
                     hypokinesia, abnormal without a patch, or not assessed",
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

    /// The same rows with what is unusual about the measures, one of each subject in the order of the study.
    pub fn with_measures(rows: Vec<Self>, measures: &[SubjectMeasures]) -> Vec<Self> {
        let mut rows = rows;
        for (row, measured) in rows.iter_mut().zip(measures) {
            row.outside_range = SubjectRow::new(String::new(), None, measured).outside_range;
        }
        rows
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

/// The first word for no, the second for yes.
fn word(flag: Option<bool>, words: [&'static str; 2]) -> Cell<'static> {
    flag.map(|flag| words[usize::from(flag)]).into()
}

fn listed(subjects: &[String]) -> Cell<'static> {
    subjects.join(" ").into()
}

fn feature(row: &VerdictRow, feature: Feature) -> Cell<'static> {
    row.features.get(feature).into()
}

impl Row for VerdictRow {
    const FILES: &'static [&'static str] = &["verdicts.csv"];
    const ROW: &'static str = "Verdicts, a row per subject";
    const COLUMNS: &'static [Column<Self>] = &[
        shared::subject(|row| (&row.subject).into()),
        Self::LABEL,
        column("verdict", "Class", |row: &Self| {
            word(row.abnormal, ["normal", "abnormal"])
        })
        .plain("Predicted class, normal or abnormal; empty where the subject is not assessed"),
        Self::PROBABILITY,
        column("assessed", "Assessed", |row: &Self| {
            word(Some(row.abnormal.is_some()), YES_NO)
        })
        .plain("yes, or no where no verdict is possible"),
        column("reason", "Reason", |row: &Self| {
            row.reason.as_deref().into()
        })
        .plain("Why the subject is not assessed"),
        Self::FINDING,
        column("calibrated", "Calibrated", |row: &Self| {
            word(row.calibrated, YES_NO)
        })
        .plain(
            "yes if the probability comes from a classifier trained on the labelled subjects; \
                 no for default thresholds",
        ),
        column("alike_normal", "Most similar normal", |row: &Self| {
            listed(&row.similar_normal)
        })
        .plain("Most similar subjects with a normal label, nearest first"),
        column("alike_abnormal", "Most similar abnormal", |row: &Self| {
            listed(&row.similar_abnormal)
        })
        .plain("Most similar subjects with an abnormal label, nearest first"),
        column(
            "distance_from_seen",
            "Distance to training set",
            |row: &Self| row.distance_from_seen.into(),
        )
        .plain(
            "Distance to the nearest subject of the training set, in standard deviations of \
                     the model features",
        ),
        column(
            "usual_distance",
            "Median distance in training set",
            |row: &Self| row.usual_distance.into(),
        )
        .plain(
            "Median over the training set of the distance to its nearest other subject, in \
                     standard deviations of the model features",
        ),
        column("still_share", "Akinetic region", |row: &Self| {
            feature(row, Feature::AkineticShare)
        })
        .share(
            "Share of the wall with thickening below 10 % from end-diastole to end-systole \
                     (akinetic)",
        ),
        column("median_ln_pt", "Median thickening", |row: &Self| {
            feature(row, Feature::Median)
        })
        .plain(
            "Area-weighted median over the wall of ln PT from end-diastole to \
                     end-systole",
        )
        .in_unit("ln PT"),
        column("spread_ln_pt", "SD of thickening", |row: &Self| {
            feature(row, Feature::Spread)
        })
        .plain("Area-weighted standard deviation over the wall of ln PT")
        .in_unit("ln PT"),
        column(
            "relative_spread",
            "Thickening heterogeneity",
            |row: &Self| feature(row, Feature::RelativeSpread),
        )
        .plain(
            "Standard deviation of ln PT over the wall relative to ln PT of the remote \
                     myocardium, which counts as at least ln 1.1",
        ),
        column(
            "weakest_tenth_ln_pt",
            "10th percentile of thickening",
            |row: &Self| feature(row, Feature::TenthPercentile),
        )
        .plain("Area-weighted 10th percentile over the wall of ln PT")
        .in_unit("ln PT"),
        column("well_ln_pt", "Remote thickening", |row: &Self| {
            feature(row, Feature::Remote)
        })
        .plain("ln PT of the remote myocardium from end-diastole to end-systole")
        .in_unit("ln PT"),
        column("reach_ln_pt", "Upper range of thickening", |row: &Self| {
            feature(row, Feature::UpperRange)
        })
        .plain(
            "ln PT of the remote myocardium plus twice the standard deviation \
                     over the wall",
        )
        .in_unit("ln PT"),
        column("patch_share", "Wall in patches", |row: &Self| {
            feature(row, Feature::PatchShare)
        })
        .share("Share of the wall in patches, each weighted by its detection stability"),
        column("patch_confidence", "Detection stability", |row: &Self| {
            feature(row, Feature::Confidence)
        })
        .share(
            "Detection stability of the largest patch: share of noise redraws in which it \
                     is detected again; 0 without a patch",
        ),
        column(
            "patch_relative_thickening",
            "Ratio of patch to remote thickening",
            |row: &Self| feature(row, Feature::PatchThickening),
        )
        .plain(
            "ln PT of the largest patch relative to that of the remote myocardium; 1 \
                     without a patch",
        ),
        column("patch_compactness", "Compactness", |row: &Self| {
            feature(row, Feature::Compactness)
        })
        .plain(
            "Compactness of the largest patch, 4π × area / perimeter², at most 1; 0 without \
                     a patch",
        ),
        column("pose_distance", "Mean pose distance", |row: &Self| {
            feature(row, Feature::MeanPoseDistance)
        })
        .plain(
            "Mean distance between poses in the medial shape space, of the largest patch \
                     or, without one, of all akinetic atoms",
        ),
        column("normal_spread_rad", "Angular SD of ANV", |row: &Self| {
            feature(row, Feature::NormalSpread)
        })
        .plain(
            "Angular standard deviation of the average normal vector (ANV) over the \
                     beat",
        )
        .in_unit("rad"),
        column("gap_sizes", "Distance of MP", |row: &Self| {
            feature(row, Feature::MeanPositionDistance)
        })
        .coordinate(
            "Mean distance of the mean position \
                     (MP) from the medial surface, relative to the size of the medial surface",
        )
        .in_unit("× size"),
        column("outside_range", "Outside adult range", |row: &Self| {
            some(&row.outside_range)
        })
        .plain(
            "Measures outside the range of healthy adults, as in subjects.csv: a wall without a \
                     regional finding may still belong to a failing ventricle",
        ),
    ];
}

#[cfg(test)]
mod tests;
