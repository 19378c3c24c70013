//! Columns of the table of verdicts.

use super::VerdictRow;
use crate::analysis::verdicts::Feature;
use crate::report::column::{Cell, Column, column};
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
        column("still_share", Feature::AkineticShare.name(), |row: &Self| {
            feature(row, Feature::AkineticShare)
        })
        .share(
            "Share of the wall with thickening below 10 % from end-diastole to end-systole \
                     (akinetic)",
        ),
        column("median_ln_pt", Feature::Median.name(), |row: &Self| {
            feature(row, Feature::Median)
        })
        .plain(
            "Area-weighted median over the wall of ln PT from end-diastole to \
                     end-systole",
        )
        .in_unit("ln PT"),
        column("spread_ln_pt", Feature::Spread.name(), |row: &Self| {
            feature(row, Feature::Spread)
        })
        .plain("Area-weighted standard deviation over the wall of ln PT")
        .in_unit("ln PT"),
        column(
            "relative_spread",
            Feature::RelativeSpread.name(),
            |row: &Self| feature(row, Feature::RelativeSpread),
        )
        .plain(
            "Standard deviation of ln PT over the wall relative to ln PT of the remote \
                     myocardium, which counts as at least ln 1.1",
        ),
        column(
            "weakest_tenth_ln_pt",
            Feature::TenthPercentile.name(),
            |row: &Self| feature(row, Feature::TenthPercentile),
        )
        .plain("Area-weighted 10th percentile over the wall of ln PT")
        .in_unit("ln PT"),
        column("well_ln_pt", Feature::Remote.name(), |row: &Self| {
            feature(row, Feature::Remote)
        })
        .plain("ln PT of the remote myocardium from end-diastole to end-systole")
        .in_unit("ln PT"),
        column("reach_ln_pt", Feature::UpperRange.name(), |row: &Self| {
            feature(row, Feature::UpperRange)
        })
        .plain(
            "ln PT of the remote myocardium plus twice the standard deviation \
                     over the wall",
        )
        .in_unit("ln PT"),
        column("patch_share", Feature::PatchShare.name(), |row: &Self| {
            feature(row, Feature::PatchShare)
        })
        .share("Share of the wall in patches, each weighted by its detection stability"),
        column("patch_confidence", Feature::Confidence.name(), |row: &Self| {
            feature(row, Feature::Confidence)
        })
        .share(
            "Detection stability of the largest patch: share of noise redraws in which it \
                     is detected again; 0 without a patch",
        ),
        column(
            "patch_relative_thickening",
            Feature::PatchThickening.name(),
            |row: &Self| feature(row, Feature::PatchThickening),
        )
        .plain(
            "ln PT of the largest patch relative to that of the remote myocardium; 1 \
                     without a patch",
        ),
        column("patch_compactness", Feature::Compactness.name(), |row: &Self| {
            feature(row, Feature::Compactness)
        })
        .plain(
            "Compactness of the largest patch, 4π × area / perimeter², at most 1; 0 without \
                     a patch",
        ),
        column("pose_distance", Feature::MeanPoseDistance.name(), |row: &Self| {
            feature(row, Feature::MeanPoseDistance)
        })
        .plain(
            "Mean distance between poses in the medial shape space, of the largest patch \
                     or, without one, of all akinetic atoms",
        ),
        column("normal_spread_rad", Feature::NormalSpread.name(), |row: &Self| {
            feature(row, Feature::NormalSpread)
        })
        .plain(
            "Angular standard deviation of the average normal vector (ANV) over the \
                     beat",
        )
        .in_unit("rad"),
        column("gap_sizes", Feature::MeanPositionDistance.name(), |row: &Self| {
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
        column("ejection_fraction", Feature::EjectionFraction.name(), |row: &Self| {
            feature(row, Feature::EjectionFraction)
        })
        .share(
            "Stroke volume over end-diastolic volume",
        ),
        column("edv_index", Feature::EdvIndex.name(), |row: &Self| {
            feature(row, Feature::EdvIndex)
        })
        .plain(
            "End-diastolic volume over body surface (Mosteller); empty without height and weight",
        )
        .in_unit("ml/m²"),
        column("esv_index", Feature::EsvIndex.name(), |row: &Self| {
            feature(row, Feature::EsvIndex)
        })
        .plain(
            "End-systolic volume over body surface; empty without height and weight",
        )
        .in_unit("ml/m²"),
        column("mass_index", Feature::MassIndex.name(), |row: &Self| {
            feature(row, Feature::MassIndex)
        })
        .plain(
            "Mass of the myocardium over body surface; empty without height and weight",
        )
        .in_unit("g/m²"),
        column("mass_to_edv", Feature::MassToVolume.name(), |row: &Self| {
            feature(row, Feature::MassToVolume)
        })
        .plain(
            "Mass of the myocardium over end-diastolic volume",
        )
        .in_unit("g/ml"),
        column("wall_ed_mm", Feature::WallEd.name(), |row: &Self| {
            feature(row, Feature::WallEd)
        })
        .plain(
            "Area-weighted median of wall thickness (diameter of medial spheres) at end-diastole",
        )
        .in_unit("mm"),
        column("wall_p95_ed_mm", Feature::ThickestEd.name(), |row: &Self| {
            feature(row, Feature::ThickestEd)
        })
        .plain(
            "Area-weighted 95th percentile of wall thickness at end-diastole",
        )
        .in_unit("mm"),
        column("wall_ratio_ed", Feature::ThicknessRatio.name(), |row: &Self| {
            feature(row, Feature::ThicknessRatio)
        })
        .plain(
            "95th percentile of wall thickness at end-diastole over its median",
        ),
        column("wall_es_mm", Feature::WallEs.name(), |row: &Self| {
            feature(row, Feature::WallEs)
        })
        .plain(
            "Area-weighted median of wall thickness at end-systole",
        )
        .in_unit("mm"),
        column("wall_p95_es_mm", Feature::ThickestEs.name(), |row: &Self| {
            feature(row, Feature::ThickestEs)
        })
        .plain(
            "Area-weighted 95th percentile of wall thickness at end-systole",
        )
        .in_unit("mm"),
        column("sphericity_ed", Feature::SphericityEd.name(), |row: &Self| {
            feature(row, Feature::SphericityEd)
        })
        .plain(
            "Volume of the cavity at end-diastole over that of a sphere whose diameter is the long axis",
        ),
        column("sphericity_es", Feature::SphericityEs.name(), |row: &Self| {
            feature(row, Feature::SphericityEs)
        })
        .plain(
            "The same at end-systole",
        ),
        column("inward_sd", Feature::InwardSpread.name(), |row: &Self| {
            feature(row, Feature::InwardSpread)
        })
        .plain(
            "Area-weighted standard deviation over the inner surface of its motion towards the centroid from end-diastole to end-systole, over the distance there",
        ),
        column("inward_p10", Feature::InwardTenth.name(), |row: &Self| {
            feature(row, Feature::InwardTenth)
        })
        .plain(
            "Area-weighted 10th percentile of the same motion",
        ),
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
