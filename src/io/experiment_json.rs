//! Experiments as one JSON object each; shares are in 0 to 1.

use serde_json::{Value, json};

use crate::analysis::experiments::{
    MetricComparison, NoiseDeformationResult, PartnerStudy, RuleShare,
};

use super::experiment_csv::reference_word;

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
    let rule = |rule: RuleShare| {
        json!({
            "accuracy": rule.share,
            "standard_error": rule.standard_error,
            "baseline": rule.baseline,
        })
    };
    let rows = comparison.rows.iter().map(|row| {
        json!({
            "method": row.method,
            "noise_percent": row.percent,
            "copies": row.copies,
            "labelled": row.labelled,
            "nearest_neighbour": rule(row.nearest_neighbour),
            "linear_rule": rule(row.linear_rule),
            "plane_rule": rule(row.plane_rule),
            "tau": rule(row.tau),
        })
    });
    json!({ "classification": Value::Array(rows.collect()) })
}

/// The study of partners, a row per way of carrying and method.
pub fn partners_json(study: &PartnerStudy) -> Value {
    let rows = study.rows.iter().map(|row| {
        let ranks = &row.ranks;
        json!({
            "transfer": row.transport,
            "method": row.method,
            "pairs": ranks.pairs,
            "nearer_than_median": ranks.nearer_than_median,
            "nearest": ranks.nearest,
            "mean_rank": ranks.mean_rank,
            "nearest_by_chance": ranks.nearest_by_chance,
            "mean_rank_by_chance": ranks.mean_rank_by_chance,
            "mean_distance": ranks.mean_distance,
        })
    });
    json!({ "partners": Value::Array(rows.collect()) })
}
