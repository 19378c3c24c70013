//! Columns of the table of verdicts.

use super::VerdictRow;
use crate::analysis::verdicts::{Feature, FeatureUnit};
use crate::report::column::{Cell, Column, Named, column};
use crate::report::measures::some;
use crate::report::shared;
use crate::report::table::Row;

const YES_NO: [&str; 2] = ["no", "yes"];

/// The first word for no, the second for yes.
fn word(flag: Option<bool>, words: [&'static str; 2]) -> Cell<'static> {
    flag.map(|flag| words[usize::from(flag)]).into()
}

fn listed(subjects: &[String]) -> Cell<'static> {
    subjects.join(" ").into()
}

/// The column of a feature, whose heading, unit and explanation stand in the table of features.
macro_rules! of_feature {
    ($key:literal, $feature:ident) => {
        described(
            Feature::$feature,
            column($key, Feature::$feature.name(), |row: &Self| {
                row.features.get(Feature::$feature).into()
            }),
        )
    };
}

const fn described(feature: Feature, named: Named<VerdictRow>) -> Column<VerdictRow> {
    let explanation = feature.explanation();
    match feature.unit() {
        FeatureUnit::Share => named.share(explanation),
        FeatureUnit::Ratio => named.plain(explanation),
        FeatureUnit::PoseDistance => named.coordinate(explanation),
        unit @ FeatureUnit::Sizes => named.coordinate(explanation).in_unit(unit.symbol()),
        unit @ (FeatureUnit::LnPt
        | FeatureUnit::Radians
        | FeatureUnit::Millimetres
        | FeatureUnit::MillilitresPerSquareMetre
        | FeatureUnit::GramsPerSquareMetre
        | FeatureUnit::GramsPerMillilitre) => named.plain(explanation).in_unit(unit.symbol()),
    }
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
        .plain("Predicted class, normal or abnormal; empty where the subject is not assessed or no classifier was trained"),
        Self::PROBABILITY,
        column("assessed", "Assessed", |row: &Self| {
            word(Some(row.assessed), YES_NO)
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
            "yes: the probability comes from a trained classifier, that of the labelled subjects or one from a file",
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
        of_feature!("still_share", AkineticShare),
        of_feature!("median_ln_pt", Median),
        of_feature!("spread_ln_pt", Spread),
        of_feature!("relative_spread", RelativeSpread),
        of_feature!("weakest_tenth_ln_pt", TenthPercentile),
        of_feature!("well_ln_pt", Remote),
        of_feature!("reach_ln_pt", UpperRange),
        of_feature!("patch_share", PatchShare),
        of_feature!("patch_confidence", Confidence),
        of_feature!("patch_relative_thickening", PatchThickening),
        of_feature!("patch_compactness", Compactness),
        of_feature!("pose_distance", MeanPoseDistance),
        of_feature!("normal_spread_rad", NormalSpread),
        of_feature!("gap_sizes", MeanPositionDistance),
        column("outside_range", "Outside adult range", |row: &Self| {
            some(&row.outside_range)
        })
        .plain(
            "Measures outside the range of healthy adults, as in subjects.csv: a wall without a \
                     regional finding may still belong to a failing ventricle",
        ),
        of_feature!("ejection_fraction", EjectionFraction),
        of_feature!("edv_index", EdvIndex),
        of_feature!("esv_index", EsvIndex),
        of_feature!("mass_index", MassIndex),
        of_feature!("mass_to_edv", MassToVolume),
        of_feature!("wall_ed_mm", WallEd),
        of_feature!("wall_p95_ed_mm", ThickestEd),
        of_feature!("wall_ratio_ed", ThicknessRatio),
        of_feature!("wall_es_mm", WallEs),
        of_feature!("wall_p95_es_mm", ThickestEs),
        of_feature!("sphericity_ed", SphericityEd),
        of_feature!("sphericity_es", SphericityEs),
        of_feature!("inward_sd", InwardSpread),
        of_feature!("inward_p10", InwardTenth),
        // The key is older than the word; elsewhere a kind is one of metrics or meshes.
        column("kind", "Most probable label", |row: &Self| {
            row.kind.as_deref().into()
        })
        .plain(
            "Label of the study that is most probable, leave-one-out where the subject has one of \
                     them; empty with fewer than three labels to tell",
        ),
        column(
            "kind_probability",
            "Probability of the label",
            |row: &Self| row.kind_probability.into(),
        )
        .share(
            "Probability of that label: one against the rest, calibrated, scaled so that all have the sum 1",
        ),
        column("kind_probabilities", "Labels", |row: &Self| {
            some(&row.kinds)
        })
        .plain("Probabilities of all labels, the most probable first"),
        column("reasons", "Strongest features", |row: &Self| {
            some(&row.reasons)
        })
        .plain(
            "Model features that speak most for the predicted class, with what each adds to the \
                     log odds of abnormal",
        ),
        column("outside_training", "Outside training range", |row: &Self| {
            some(&row.outside_training)
        })
        .plain(
            "Model features outside the range of the training set of the classifier that --rule names; empty \
                     without --rule",
        ),
    ];
}
