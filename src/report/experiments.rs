//! Tables of the experiments on deformations: noise, transport, interpolation, metrics, pairs of sequences.

use super::column::{Cell, Column, column};
use super::shared;
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
        column("method", "Method", |row: &Self| row.method.into()).plain("Metric and pipeline"),
        shared::noise_family(|row| row.family.into()),
        column("percent", "Level of noise", |row: &Self| row.percent.into())
            .percent("Level of noise, a share of the quantity in percent_of"),
        column("percent_of", "Level relative to", |row: &Self| {
            reference_word(row.reference).into()
        })
        .plain("What the level is a share of: shape or displacement"),
        column("object", "Object", |row: &Self| row.object.into())
            .plain("Kind of object, or all for the mean over objects"),
        column("tau_percent", "Cluster agreement τ", |row: &Self| {
            percent(row.tau)
        })
        .percent(
            "Cluster agreement τ: share of deformations whose cluster stands for their \
                     class",
        ),
        column("standard_error", "Standard error of τ", |row: &Self| {
            row.standard_error.map(percent).into()
        })
        .percent("Standard error of τ over redraws"),
        column("baseline", "Permutation mean of τ", |row: &Self| {
            row.baseline.map(percent).into()
        })
        .percent("Mean of τ over permuted labels"),
        column("published", "Table 3.1", |row: &Self| {
            row.published.map(percent).into()
        })
        .percent("Value of τ in table 3.1 of the text, where it has one"),
    ];
}

/// The column of an accuracy or τ.
macro_rules! share_of {
    ($key:literal, $heading:literal, $what:ident) => {
        column($key, $heading, |row: &Self| percent(row.$what.share))
    };
}

/// The column of its standard error.
macro_rules! error_of {
    ($key:literal, $what:ident) => {
        column($key, "±", |row: &Self| percent(row.$what.standard_error)).percent(ERROR)
    };
}

/// The column of its mean over permuted labels.
macro_rules! permuted {
    ($key:literal, $what:ident) => {
        column($key, "Permutation mean", |row: &Self| {
            percent(row.$what.baseline)
        })
        .percent(PERMUTED)
    };
}

impl Row for ComparisonRow {
    const FILES: &'static [&'static str] = &["metrics.csv"];
    const ROW: &'static str =
        "`experiment metrics`: classification by every metric, a row per level of noise and method";
    const COLUMNS: &'static [Column<Self>] = &[
        column("noise_percent", "Level of noise", |row: &Self| {
            row.percent.into()
        })
        .percent("Level of noise of the copies; 0 for the study itself"),
        shared::method(|row| row.method.into()),
        column("labelled", "Labelled", |row: &Self| row.labelled.into())
            .plain("Number of subjects with a label"),
        column("copies", "Copies", |row: &Self| row.copies.into()).plain("Number of noisy copies"),
        share_of!(
            "nearest_neighbour_percent",
            "Nearest neighbour",
            nearest_neighbour
        )
        .percent("Accuracy of the nearest-neighbour classifier, leave-one-out"),
        error_of!("nearest_neighbour_standard_error", nearest_neighbour),
        permuted!("nearest_neighbour_baseline", nearest_neighbour),
        share_of!(
            "linear_rule_percent",
            "Linear classifier",
            linear_classifier
        )
        .percent("Accuracy of the linear classifier on distances, leave-one-out"),
        error_of!("linear_rule_standard_error", linear_classifier),
        permuted!("linear_rule_baseline", linear_classifier),
        share_of!(
            "plane_rule_percent",
            "Classifier on the 2-D embedding",
            plane_classifier
        )
        .percent("Accuracy of the classifier on the 2-D embedding, leave-one-out"),
        error_of!("plane_rule_standard_error", plane_classifier),
        permuted!("plane_rule_baseline", plane_classifier),
        share_of!("tau_percent", "Cluster agreement τ", tau)
            .percent("Cluster agreement τ: share of subjects whose cluster stands for their class"),
        error_of!("tau_standard_error", tau),
        permuted!("tau_baseline", tau),
    ];
}

const ERROR: &str = "Standard error over copies of the accuracy or τ before it";
const PERMUTED: &str = "Mean of the accuracy or τ before it over permuted labels";

impl Row for PartnerRow {
    const FILES: &'static [&'static str] = &["partners.csv"];
    const ROW: &'static str = "`experiment partners`: rank of the other sequence of the same patient, a row per transport and method";
    const COLUMNS: &'static [Column<Self>] = &[
        column("transfer", "Transport", |row: &Self| row.transport.into())
            .plain("How motions are transported before they are compared"),
        shared::method(|row| row.method.into()),
        column("pairs", "Sequences", |row: &Self| row.ranks.pairs.into())
            .plain("Number of sequences with a partner: another sequence of the same patient"),
        column(
            "nearer_than_median",
            "Nearer than the median",
            |row: &Self| row.ranks.nearer_than_median.into(),
        )
        .plain("Number of sequences whose partner is nearer than the median of all others"),
        column("nearest", "Nearest", |row: &Self| row.ranks.nearest.into())
            .plain("Number of sequences whose partner is the nearest of all others"),
        column("mean_rank", "Mean rank", |row: &Self| {
            row.ranks.mean_rank.into()
        })
        .plain("Mean rank of the partner among all others by distance, from 1"),
        column(
            "nearest_by_chance",
            "Nearest, random order",
            |row: &Self| row.ranks.nearest_by_chance.into(),
        )
        .plain("Expected number of such sequences if distances were in random order"),
        column(
            "mean_rank_by_chance",
            "Mean rank, random order",
            |row: &Self| row.ranks.mean_rank_by_chance.into(),
        )
        .plain("Expected mean rank if distances were in random order"),
        column("mean_distance", "Mean distance", |row: &Self| {
            row.ranks.mean_distance.into()
        })
        .plain("Mean distance of any two sequences, of the same patient or not"),
    ];
}

impl Row for TransportCase {
    const FILES: &'static [&'static str] = &["transfer.csv"];
    const ROW: &'static str = "`experiment noise-deformation`: parallel transport of synthetic deformations, a row per deformation";
    const COLUMNS: &'static [Column<Self>] = &[
        column("source", "Source", |row: &Self| row.object.name().into())
            .plain("Object that is deformed"),
        column("target", "Target", |row: &Self| row.target.into())
            .plain("Object that the deformation is transported onto"),
        shared::motion(|row| row.motion.name().into()),
        column("relative_error", "Relative error", |row: &Self| {
            row.relative_error.into()
        })
        .plain("Difference from the true deformation of the target, relative to it"),
        column("cosine", "Cosine", |row: &Self| row.cosine.into())
            .plain("Cosine between transported and true deformation"),
        column("norm_ratio", "Norm ratio", |row: &Self| {
            row.norm_ratio.into()
        })
        .plain("Norm of the transported deformation relative to that of the true one"),
        column("flipped_faces", "Flipped faces", |row: &Self| {
            row.flipped_faces.into()
        })
        .plain("Number of faces whose normal the transported deformation reverses"),
        column("followed", "Reproduced", |row: &Self| {
            (if row.followed { "true" } else { "false" }).into()
        })
        .plain(
            "true if the cosine is at least 0.9, the norm within a third of the true one \
                     and no face flipped",
        ),
    ];
}

impl Row for InterpolationCase {
    const FILES: &'static [&'static str] = &["interpolation.csv"];
    const ROW: &'static str = "`experiment noise-deformation`: interpolated (geodesic) poses, a row per object and motion";
    const COLUMNS: &'static [Column<Self>] = &[
        shared::object(|row| row.object.name().into()),
        shared::motion(|row| row.motion.name().into()),
        column("energy_over_linear", "Energy ratio", |row: &Self| {
            row.energy_ratio.into()
        })
        .plain("Energy of the path relative to that of linear interpolation"),
        column("longest_over_shortest_step", "Step ratio", |row: &Self| {
            row.step_ratio.into()
        })
        .plain("Longest step of the path relative to the shortest"),
        column(
            "least_volume_ratio",
            "Minimum volume ratio",
            |row: &Self| row.volume_ratios[0].into(),
        )
        .plain(
            "Minimum over the path of volume relative to its linear interpolation between the ends",
        ),
        column(
            "greatest_volume_ratio",
            "Maximum volume ratio",
            |row: &Self| row.volume_ratios[1].into(),
        )
        .plain(
            "Maximum over the path of volume relative to its linear interpolation between the ends",
        ),
        column("midpoint_error", "Midpoint error", |row: &Self| {
            row.midpoint_error.into()
        })
        .plain("Distance of the middle pose from the true one, relative to the motion"),
        column("self_intersections", "Self-intersections", |row: &Self| {
            row.self_intersections.into()
        })
        .plain("Number of pairs of faces that intersect"),
    ];
}

/// The word for what a level is a share of.
pub(super) fn reference_word(reference: NoiseReference) -> &'static str {
    match reference {
        NoiseReference::Shape => "shape",
        NoiseReference::Displacement => "displacement",
    }
}

/// A share in percent, to a hundredth.
pub(super) fn percent(share: f64) -> Cell<'static> {
    ((share * 1e4).round() / 100.0).into()
}
