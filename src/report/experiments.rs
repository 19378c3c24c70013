//! Tables of the experiments on deformations: noise, transport, interpolation, metrics, pairs of sequences.

use super::column::{Cell, Column, Digits, Unit};
use super::table::Row;
use crate::analysis::experiments::{
    ComparisonRow, InterpolationCase, NoiseDeformationResult, NoiseReference, PartnerRow,
    TransportCase,
};

/// Cluster agreement τ of one method under one condition.
#[derive(Clone, Debug, PartialEq)]
pub struct NoiseRow {
    /// What is compared.
    pub method: &'static str,
    /// Distribution of the noise.
    pub family: &'static str,
    /// Its level in percent.
    pub percent: f64,
    /// What the level is a share of.
    pub reference: NoiseReference,
    /// The object, or "all" for the mean over objects.
    pub object: &'static str,
    /// The agreement, 0 to 1.
    pub tau: f64,
    /// Its standard error; means over objects alone have one.
    pub standard_error: Option<f64>,
    /// The permutation mean.
    pub baseline: Option<f64>,
    /// The value of table 3.1.
    pub published: Option<f64>,
}

impl NoiseRow {
    /// The mean over objects of every cell, and below it each object.
    pub fn of_result(result: &NoiseDeformationResult) -> Vec<Self> {
        let cells = result.cells.iter();
        cells
            .flat_map(|cell| {
                let mean = Self {
                    method: cell.method,
                    family: cell.family.map_or("clean", |family| family.name()),
                    percent: cell.percent,
                    reference: cell.reference,
                    object: "all",
                    tau: cell.tau,
                    standard_error: Some(cell.standard_error),
                    baseline: Some(cell.baseline),
                    published: cell.published,
                };
                let objects = cell.by_object.iter().map({
                    let mean = mean.clone();
                    move |(object, tau)| Self {
                        object: object.name(),
                        tau: *tau,
                        standard_error: None,
                        baseline: None,
                        published: None,
                        ..mean.clone()
                    }
                });
                std::iter::once(mean).chain(objects)
            })
            .collect()
    }
}

impl Row for NoiseRow {
    const FILES: &'static [&'static str] = &["noise.csv"];
    const ROW: &'static str = "`experiment noise-deformation`: cluster agreement under noise, a row per method, condition and object";
    const COLUMNS: &'static [Column<Self>] = &[
        METHOD,
        Column::plain(
            "family",
            "Noise",
            "Distribution of the noise, or clean",
            |row| row.family.into(),
        ),
        percentage(
            "percent",
            "Level of noise",
            "Level of noise, a share of the quantity in percent_of",
            |row| row.percent.into(),
        ),
        Column::plain(
            "percent_of",
            "Level relative to",
            "What the level is a share of: shape or displacement",
            |row| reference_word(row.reference).into(),
        ),
        Column::plain(
            "object",
            "Object",
            "Kind of object, or all for the mean over objects",
            |row| row.object.into(),
        ),
        percentage(
            "tau_percent",
            "Cluster agreement τ",
            "Cluster agreement τ: share of deformations whose cluster stands for their class",
            |row| percent(row.tau),
        ),
        percentage(
            "standard_error",
            "Standard error of τ",
            "Standard error of τ over redraws",
            |row| row.standard_error.map(percent).into(),
        ),
        percentage(
            "baseline",
            "Permutation mean of τ",
            "Mean of τ over permuted labels",
            |row| row.baseline.map(percent).into(),
        ),
        percentage(
            "published",
            "Table 3.1",
            "Value of τ in table 3.1 of the text, where it has one",
            |row| row.published.map(percent).into(),
        ),
    ];
}

const METHOD: Column<NoiseRow> = Column::plain("method", "Method", "Metric and pipeline", |row| {
    row.method.into()
});

impl Row for ComparisonRow {
    const FILES: &'static [&'static str] = &["metrics.csv"];
    const ROW: &'static str =
        "`experiment metrics`: classification by every metric, a row per level of noise and method";
    const COLUMNS: &'static [Column<Self>] = &[
        percentage(
            "noise_percent",
            "Level of noise",
            "Level of noise of the copies; 0 for the study itself",
            |row| row.percent.into(),
        ),
        Column::plain("method", "Method", "Metric and form", |row| {
            row.method.into()
        }),
        Column::plain(
            "labelled",
            "Labelled",
            "Number of subjects with a label",
            |row| row.labelled.into(),
        ),
        Column::plain("copies", "Copies", "Number of noisy copies", |row| {
            row.copies.into()
        }),
        percentage(
            "nearest_neighbour_percent",
            "Nearest neighbour",
            "Accuracy of the nearest-neighbour classifier, leave-one-out",
            |row| percent(row.nearest_neighbour.share),
        ),
        percentage("nearest_neighbour_standard_error", "±", ERROR, |row| {
            percent(row.nearest_neighbour.standard_error)
        }),
        percentage(
            "nearest_neighbour_baseline",
            "Permutation mean",
            PERMUTED,
            |row| percent(row.nearest_neighbour.baseline),
        ),
        percentage(
            "linear_rule_percent",
            "Linear classifier",
            "Accuracy of the linear classifier on distances, leave-one-out",
            |row| percent(row.linear_classifier.share),
        ),
        percentage("linear_rule_standard_error", "±", ERROR, |row| {
            percent(row.linear_classifier.standard_error)
        }),
        percentage(
            "linear_rule_baseline",
            "Permutation mean",
            PERMUTED,
            |row| percent(row.linear_classifier.baseline),
        ),
        percentage(
            "plane_rule_percent",
            "Classifier on the 2-D embedding",
            "Accuracy of the classifier on the 2-D embedding, leave-one-out",
            |row| percent(row.plane_classifier.share),
        ),
        percentage("plane_rule_standard_error", "±", ERROR, |row| {
            percent(row.plane_classifier.standard_error)
        }),
        percentage("plane_rule_baseline", "Permutation mean", PERMUTED, |row| {
            percent(row.plane_classifier.baseline)
        }),
        percentage(
            "tau_percent",
            "Cluster agreement τ",
            "Cluster agreement τ: share of subjects whose cluster stands for their class",
            |row| percent(row.tau.share),
        ),
        percentage("tau_standard_error", "±", ERROR, |row| {
            percent(row.tau.standard_error)
        }),
        percentage("tau_baseline", "Permutation mean", PERMUTED, |row| {
            percent(row.tau.baseline)
        }),
    ];
}

const ERROR: &str = "Standard error over copies of the accuracy or τ before it";
const PERMUTED: &str = "Mean of the accuracy or τ before it over permuted labels";

impl Row for PartnerRow {
    const FILES: &'static [&'static str] = &["partners.csv"];
    const ROW: &'static str = "`experiment partners`: rank of the other sequence of the same patient, a row per transport and method";
    const COLUMNS: &'static [Column<Self>] = &[
        Column::plain(
            "transfer",
            "Transport",
            "How motions are transported before they are compared",
            |row| row.transport.into(),
        ),
        Column::plain("method", "Method", "Metric and form", |row| {
            row.method.into()
        }),
        Column::plain(
            "pairs",
            "Sequences",
            "Number of sequences with a partner: another sequence of the same patient",
            |row| row.ranks.pairs.into(),
        ),
        Column::plain(
            "nearer_than_median",
            "Nearer than the median",
            "Number of sequences whose partner is nearer than the median of all others",
            |row| row.ranks.nearer_than_median.into(),
        ),
        Column::plain(
            "nearest",
            "Nearest",
            "Number of sequences whose partner is the nearest of all others",
            |row| row.ranks.nearest.into(),
        ),
        Column::plain(
            "mean_rank",
            "Mean rank",
            "Mean rank of the partner among all others by distance, from 1",
            |row| row.ranks.mean_rank.into(),
        ),
        Column::plain(
            "nearest_by_chance",
            "Nearest, random order",
            "Expected number of such sequences if distances were in random order",
            |row| row.ranks.nearest_by_chance.into(),
        ),
        Column::plain(
            "mean_rank_by_chance",
            "Mean rank, random order",
            "Expected mean rank if distances were in random order",
            |row| row.ranks.mean_rank_by_chance.into(),
        ),
        Column::plain(
            "mean_distance",
            "Mean distance",
            "Mean distance to the partner, relative to the median distance to all others",
            |row| row.ranks.mean_distance.into(),
        ),
    ];
}

impl Row for TransportCase {
    const FILES: &'static [&'static str] = &["transfer.csv"];
    const ROW: &'static str = "`experiment noise-deformation`: parallel transport of synthetic deformations, a row per deformation";
    const COLUMNS: &'static [Column<Self>] = &[
        Column::plain("source", "Source", "Object that is deformed", |row| {
            row.object.name().into()
        }),
        Column::plain(
            "target",
            "Target",
            "Object that the deformation is transported onto",
            |row| row.target.into(),
        ),
        Column::plain("motion", "Motion", "Kind of deformation", |row| {
            row.motion.name().into()
        }),
        Column::plain(
            "relative_error",
            "Relative error",
            "Difference from the true deformation of the target, relative to it",
            |row| row.relative_error.into(),
        ),
        Column::plain(
            "cosine",
            "Cosine",
            "Cosine between transported and true deformation",
            |row| row.cosine.into(),
        ),
        Column::plain(
            "norm_ratio",
            "Norm ratio",
            "Norm of the transported deformation relative to that of the true one",
            |row| row.norm_ratio.into(),
        ),
        Column::plain(
            "flipped_faces",
            "Flipped faces",
            "Number of faces whose normal the transported deformation reverses",
            |row| row.flipped_faces.into(),
        ),
        Column::plain(
            "followed",
            "Reproduced",
            "true if the cosine is at least 0.9, the norm within a third of the true one and no face flipped",
            |row| Cell::Word(if row.followed { "true" } else { "false" }),
        ),
    ];
}

impl Row for InterpolationCase {
    const FILES: &'static [&'static str] = &["interpolation.csv"];
    const ROW: &'static str = "`experiment noise-deformation`: interpolated (geodesic) poses, a row per object and motion";
    const COLUMNS: &'static [Column<Self>] = &[
        Column::plain("object", "Object", "Kind of object", |row| {
            row.object.name().into()
        }),
        Column::plain("motion", "Motion", "Kind of deformation", |row| {
            row.motion.name().into()
        }),
        Column::plain(
            "energy_over_linear",
            "Energy ratio",
            "Energy of the path relative to that of linear interpolation",
            |row| row.energy_ratio.into(),
        ),
        Column::plain(
            "longest_over_shortest_step",
            "Step ratio",
            "Longest step of the path relative to the shortest",
            |row| row.step_ratio.into(),
        ),
        Column::plain(
            "least_volume_ratio",
            "Minimum volume ratio",
            "Minimum over the path of volume relative to its linear interpolation between the ends",
            |row| row.volume_ratios[0].into(),
        ),
        Column::plain(
            "greatest_volume_ratio",
            "Maximum volume ratio",
            "Maximum over the path of volume relative to its linear interpolation between the ends",
            |row| row.volume_ratios[1].into(),
        ),
        Column::plain(
            "midpoint_error",
            "Midpoint error",
            "Distance of the middle pose from the true one, relative to the motion",
            |row| row.midpoint_error.into(),
        ),
        Column::plain(
            "self_intersections",
            "Self-intersections",
            "Number of pairs of faces that intersect",
            |row| row.self_intersections.into(),
        ),
    ];
}

/// The word for what a level is a share of.
pub(super) fn reference_word(reference: NoiseReference) -> &'static str {
    match reference {
        NoiseReference::Shape => "shape",
        NoiseReference::Displacement => "displacement",
    }
}

/// A column in percent.
pub(super) const fn percentage<R>(
    key: &'static str,
    heading: &'static str,
    explanation: &'static str,
    cell: fn(&R) -> Cell,
) -> Column<R> {
    Column::new(
        key,
        heading,
        Unit::Percent,
        Digits::Places(1),
        explanation,
        cell,
    )
}

/// A share in percent, to a hundredth.
pub(super) fn percent(share: f64) -> Cell {
    ((share * 1e4).round() / 100.0).into()
}
