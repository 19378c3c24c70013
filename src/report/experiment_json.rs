//! Experiments on deformations as one JSON object each; shares are 0 to 1.

use serde_json::{Value, json};

use crate::analysis::experiments::{
    MeanAccuracy, MetricComparison, NoiseDeformationResult, PartnerStudy,
};

use super::experiments::reference_word;
use super::table::json_row;

/// The noise study with its protocol.
pub fn noise_json(result: &NoiseDeformationResult) -> Value {
    let cells = result.cells.iter().map(|cell| {
        json!({
            "method": cell.method,
            "family": cell.family.map(|family| family.name()),
            "percent": cell.percent,
            "percent_of": reference_word(cell.reference),
            "tau": cell.tau,
            "standard_error": cell.standard_error,
            "baseline": cell.baseline,
            "published": cell.published,
        })
    });
    json!({
        "protocol": result.protocol(),
        "redraws": result.params.redraws,
        "seed": result.params.seed,
        "cells": Value::Array(cells.collect()),
    })
}

/// The comparison of metrics, a row per level and method.
pub fn comparison_json(comparison: &MetricComparison) -> Value {
    let accuracy = |mean: MeanAccuracy| {
        json!({
            "accuracy": mean.share,
            "standard_error": mean.standard_error,
            "baseline": mean.baseline,
        })
    };
    let rows = comparison.rows.iter().map(|row| {
        json!({
            "method": row.method,
            "noise_percent": row.percent,
            "copies": row.copies,
            "labelled": row.labelled,
            "nearest_neighbour": accuracy(row.nearest_neighbour),
            "linear_rule": accuracy(row.linear_classifier),
            "plane_rule": accuracy(row.plane_classifier),
            "tau": accuracy(row.tau),
        })
    });
    json!({ "classification": Value::Array(rows.collect()) })
}

/// Ranks of the other sequence of the same patient, as `partners.csv` has them.
pub fn partners_json(study: &PartnerStudy) -> Value {
    let rows = study.rows.iter().map(|row| Value::Object(json_row(row)));
    json!({ "partners": Value::Array(rows.collect()) })
}
