//! Tables of the experiment on medial surfaces: noise, and detection of patches of known place.

use super::column::{Cell, Column};
use super::experiments::{percent, percentage};
use super::table::Row;
use crate::analysis::experiments::{LocalisationRow, MeanAndError, MedialNoiseCell};

impl Row for MedialNoiseCell {
    const FILES: &'static [&'static str] = &["noise_medial.csv"];
    const ROW: &'static str = "`experiment noise-medial`: classification of medial surfaces under noise, a row per method and condition";
    const COLUMNS: &'static [Column<Self>] = &[
        Column::plain("method", "Method", "How surfaces are classified", |row| {
            row.method.name().into()
        }),
        Column::plain(
            "family",
            "Noise",
            "Distribution of the noise, or clean",
            |row| row.family.map_or("clean", |family| family.name()).into(),
        ),
        percentage(
            "percent",
            "Level of noise",
            "Variance of the noise as a share of the variance of the clean values",
            |row| row.percent.into(),
        ),
        percentage(
            "tau_percent",
            "Accuracy",
            "Share of surfaces that are classified correctly (τ for clusters)",
            |row| percent(row.tau),
        ),
        percentage(
            "standard_error",
            "Standard error of the accuracy",
            "Standard error of the accuracy over redraws",
            |row| percent(row.standard_error),
        ),
        percentage(
            "baseline",
            "Permutation mean of the accuracy",
            "Mean accuracy over permuted labels",
            |row| percent(row.baseline),
        ),
        percentage(
            "specificity_percent",
            "Specificity",
            "Share of surfaces without a patch that are classified as normal",
            |row| percent(row.specificity),
        ),
        percentage(
            "sensitivity_percent",
            "Sensitivity",
            "Share of surfaces with a patch that are classified as abnormal",
            |row| percent(row.sensitivity),
        ),
        percentage(
            "published",
            "Table 4.2",
            "Accuracy in table 4.2 of the text, where it has one",
            |row| row.published.map(percent).into(),
        ),
    ];
}

const ERROR: &str = "Standard error over redraws of the value in the column before";

impl Row for LocalisationRow {
    const FILES: &'static [&'static str] = &["localisation.csv"];
    const ROW: &'static str = "`experiment noise-medial`: detection of patches of known position, a row per number and size of patches and \
         condition; empty where nothing is measured";
    const COLUMNS: &'static [Column<Self>] = &[
        Column::plain(
            "patches",
            "Patches",
            "Number of true patches of each surface",
            |row| row.patches.into(),
        ),
        percentage(
            "patch_percent",
            "Size of each patch",
            "Area of each patch as a share of the surface",
            |row| percent(row.share),
        ),
        Column::plain(
            "family",
            "Noise",
            "Distribution of the noise, or clean",
            |row| row.family.map_or("clean", |family| family.name()).into(),
        ),
        percentage(
            "percent",
            "Level of noise",
            "Variance of the noise as a share of the variance of the clean values",
            |row| row.percent.into(),
        ),
        Column::plain("sheets", "Surfaces", "Number of surfaces", |row| {
            row.sheets.into()
        }),
        percentage(
            "found_percent",
            "Patches detected",
            "Share of true patches that are detected",
            |row| mean(row.found, 100.0),
        ),
        percentage("found_percent_standard_error", "±", ERROR, |row| {
            error(row.found, 100.0)
        }),
        Column::plain(
            "false_patches",
            "False positives",
            "False positive patches per surface",
            |row| mean(Some(row.false_patches), 1.0),
        ),
        Column::plain("false_patches_standard_error", "±", ERROR, |row| {
            error(Some(row.false_patches), 1.0)
        }),
        Column::plain(
            "dice",
            "Dice",
            "Dice overlap of detected and true patch",
            |row| mean(row.dice, 1.0),
        ),
        Column::plain("dice_standard_error", "±", ERROR, |row| {
            error(row.dice, 1.0)
        }),
        Column::plain(
            "centroid_mm",
            "Distance of centroids",
            "Distance in mm between the centroids of detected and true patch",
            |row| mean(row.centroid_mm, 1.0),
        ),
        Column::plain("centroid_mm_standard_error", "±", ERROR, |row| {
            error(row.centroid_mm, 1.0)
        }),
        percentage(
            "segments_agreeing_percent",
            "Segments that agree",
            "Segments of both the detected and the true patch, as a share of those of either (Jaccard index)",
            |row| mean(row.segments, 100.0),
        ),
        percentage(
            "segments_agreeing_percent_standard_error",
            "±",
            ERROR,
            |row| error(row.segments, 100.0),
        ),
        percentage(
            "main_segment_percent",
            "Main segment agrees",
            "Share of detected patches whose main segment is one of the true patch",
            |row| mean(row.main_segment, 100.0),
        ),
        percentage("main_segment_percent_standard_error", "±", ERROR, |row| {
            error(row.main_segment, 100.0)
        }),
        percentage(
            "gap_of_all_percent",
            "Distance of MP",
            "Distance of the mean position (MP) of all akinetic atoms from the medial surface, as a share of its size",
            |row| row.gaps_percent[0].map(rounded).into(),
        ),
        percentage(
            "gap_of_patch_percent",
            "Distance of MP of the patch",
            "Distance of the mean position (MP) of the largest patch from the medial surface, as a share of its size",
            |row| row.gaps_percent[1].map(rounded).into(),
        ),
        Column::plain(
            "normal_spread_of_all_rad",
            "Angular SD of ANV",
            "Angular standard deviation in rad of the average normal vector (ANV) of all akinetic atoms",
            |row| row.normal_spreads_rad[0].map(rounded).into(),
        ),
        Column::plain(
            "normal_spread_of_patch_rad",
            "Angular SD of ANV of the patch",
            "Angular standard deviation in rad of the average normal vector (ANV) of the largest patch",
            |row| row.normal_spreads_rad[1].map(rounded).into(),
        ),
    ];
}

fn mean(value: Option<MeanAndError>, scale: f64) -> Cell {
    value.map(|(mean, _)| rounded(scale * mean)).into()
}

fn error(value: Option<MeanAndError>, scale: f64) -> Cell {
    value.map(|(_, error)| rounded(scale * error)).into()
}

/// To a thousandth.
fn rounded(value: f64) -> f64 {
    (value * 1e3).round() / 1e3
}
