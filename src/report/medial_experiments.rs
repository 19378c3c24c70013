//! Tables of the experiment on medial surfaces: noise, and detection of patches of known place.

use super::column::{Cell, Column, column};
use super::experiments::percent;
use super::shared;
use super::table::Row;
use crate::analysis::experiments::{LocalisationRow, MeanAndError, MedialNoiseCell};

impl Row for MedialNoiseCell {
    const FILES: &'static [&'static str] = &["noise_medial.csv"];
    const ROW: &'static str = "`experiment noise-medial`: classification of medial surfaces under noise, a row per method and condition";
    const COLUMNS: &'static [Column<Self>] = &[
        column("method", "Method", |row: &Self| row.method.name().into())
            .plain("How surfaces are classified"),
        shared::noise_family(|row| row.family.map_or("clean", |family| family.name()).into()),
        noise_level(|row| row.percent.into()),
        column("tau_percent", "Accuracy", |row: &Self| percent(row.tau))
            .percent("Share of surfaces that are classified correctly (τ for clusters)"),
        column(
            "standard_error",
            "Standard error of the accuracy",
            |row: &Self| percent(row.standard_error),
        )
        .percent("Standard error of the accuracy over redraws"),
        column(
            "baseline",
            "Permutation mean of the accuracy",
            |row: &Self| percent(row.baseline),
        )
        .percent("Mean accuracy over permuted labels"),
        column("specificity_percent", "Specificity", |row: &Self| {
            percent(row.specificity)
        })
        .percent("Share of surfaces without a patch that are classified as normal"),
        column("sensitivity_percent", "Sensitivity", |row: &Self| {
            percent(row.sensitivity)
        })
        .percent("Share of surfaces with a patch that are classified as abnormal"),
        column("published", "Table 4.2", |row: &Self| {
            row.published.map(percent).into()
        })
        .percent("Accuracy in table 4.2 of the text, where it has one"),
    ];
}

const ERROR: &str = "Standard error over redraws of the value in the column before";

impl Row for LocalisationRow {
    const FILES: &'static [&'static str] = &["localisation.csv"];
    const ROW: &'static str = "`experiment noise-medial`: detection of patches of known position, a row per number and size of patches and \
         condition; empty where nothing is measured";
    const COLUMNS: &'static [Column<Self>] = &[
        column("patches", "Patches", |row: &Self| row.patches.into())
            .plain("Number of true patches of each surface"),
        column("patch_percent", "Size of each patch", |row: &Self| {
            percent(row.share)
        })
        .percent("Area of each patch as a share of the surface"),
        shared::noise_family(|row| row.family.map_or("clean", |family| family.name()).into()),
        noise_level(|row| row.percent.into()),
        column("sheets", "Surfaces", |row: &Self| row.sheets.into()).plain("Number of surfaces"),
        column("found_percent", "Patches detected", |row: &Self| {
            mean(row.found, 100.0)
        })
        .percent("Share of true patches that are detected"),
        column("found_percent_standard_error", "±", |row: &Self| {
            error(row.found, 100.0)
        })
        .percent(ERROR),
        column("false_patches", "False positives", |row: &Self| {
            mean(Some(row.false_patches), 1.0)
        })
        .plain("False positive patches per surface"),
        column("false_patches_standard_error", "±", |row: &Self| {
            error(Some(row.false_patches), 1.0)
        })
        .plain(ERROR),
        column("dice", "Dice", |row: &Self| mean(row.dice, 1.0))
            .plain("Dice overlap of detected and true patch"),
        column("dice_standard_error", "±", |row: &Self| {
            error(row.dice, 1.0)
        })
        .plain(ERROR),
        column("centroid_mm", "Distance of centroids", |row: &Self| {
            mean(row.centroid_mm, 1.0)
        })
        .plain("Distance in mm between the centroids of detected and true patch"),
        column("centroid_mm_standard_error", "±", |row: &Self| {
            error(row.centroid_mm, 1.0)
        })
        .plain(ERROR),
        column(
            "segments_agreeing_percent",
            "Segments that agree",
            |row: &Self| mean(row.segments, 100.0),
        )
        .percent(
            "Segments of both the detected and the true patch, as a share of those of \
                     either (Jaccard index)",
        ),
        column(
            "segments_agreeing_percent_standard_error",
            "±",
            |row: &Self| error(row.segments, 100.0),
        )
        .percent(ERROR),
        column(
            "main_segment_percent",
            "Main segment agrees",
            |row: &Self| mean(row.main_segment, 100.0),
        )
        .percent("Share of detected patches whose main segment is one of the true patch"),
        column("main_segment_percent_standard_error", "±", |row: &Self| {
            error(row.main_segment, 100.0)
        })
        .percent(ERROR),
        column("gap_of_all_percent", "Distance of MP", |row: &Self| {
            row.gaps_percent[0].map(rounded).into()
        })
        .percent(
            "Distance of the mean position (MP) of all akinetic atoms from the medial \
                     surface, as a share of its size",
        ),
        column(
            "gap_of_patch_percent",
            "Distance of MP of the patch",
            |row: &Self| row.gaps_percent[1].map(rounded).into(),
        )
        .percent(
            "Distance of the mean position (MP) of the largest patch from the medial \
                     surface, as a share of its size",
        ),
        column(
            "normal_spread_of_all_rad",
            "Angular SD of ANV",
            |row: &Self| row.normal_spreads_rad[0].map(rounded).into(),
        )
        .plain(
            "Angular standard deviation in rad of the average normal vector (ANV) of all \
                     akinetic atoms",
        ),
        column(
            "normal_spread_of_patch_rad",
            "Angular SD of ANV of the patch",
            |row: &Self| row.normal_spreads_rad[1].map(rounded).into(),
        )
        .plain(
            "Angular standard deviation in rad of the average normal vector (ANV) of the \
                     largest patch",
        ),
    ];
}

/// Level of noise, relative to what it is added to.
const fn noise_level<R>(cell: fn(&R) -> Cell<'_>) -> Column<R> {
    column("percent", "Level of noise", cell)
        .percent("Variance of the noise as a share of the variance of the clean values")
}

fn mean(value: Option<MeanAndError>, scale: f64) -> Cell<'static> {
    value.map(|(mean, _)| rounded(scale * mean)).into()
}

fn error(value: Option<MeanAndError>, scale: f64) -> Cell<'static> {
    value.map(|(_, error)| rounded(scale * error)).into()
}

/// To a thousandth.
fn rounded(value: f64) -> f64 {
    (value * 1e3).round() / 1e3
}
