//! The experiment on medial surfaces as one JSON object; shares are 0 to 1.

use serde_json::{Value, json};

use crate::analysis::experiments::{LocalisationRow, MeanAndError, MedialNoiseResult};

/// Both parts with the protocol of the first.
pub fn noise_medial_json(result: &MedialNoiseResult, rows: &[LocalisationRow]) -> Value {
    let cells = result.cells.iter().map(|cell| {
        json!({
            "method": cell.method.name(),
            "family": cell.family.map(|family| family.name()),
            "percent": cell.percent,
            "tau": cell.tau,
            "standard_error": cell.standard_error,
            "baseline": cell.baseline,
            "specificity": cell.specificity,
            "sensitivity": cell.sensitivity,
            "published": cell.published,
        })
    });
    json!({
        "protocol": result.protocol(),
        "redraws": result.params.redraws,
        "seed": result.params.seed,
        "cells": Value::Array(cells.collect()),
        "localisation": Value::Array(rows.iter().map(place).collect()),
    })
}

fn place(row: &LocalisationRow) -> Value {
    let mean = |value: Option<MeanAndError>| value.map(|(mean, _)| mean);
    let error = |value: Option<MeanAndError>| value.map(|(_, error)| error);
    json!({
        "patches": row.patches,
        "patch_share": row.share,
        "family": row.family.map(|family| family.name()),
        "percent": row.percent,
        "sheets": row.sheets,
        "found": mean(row.found),
        "found_standard_error": error(row.found),
        "false_patches": row.false_patches.0,
        "dice": mean(row.dice),
        "dice_standard_error": error(row.dice),
        "centroid_mm": mean(row.centroid_mm),
        "centroid_mm_standard_error": error(row.centroid_mm),
        "segments_agreeing": mean(row.segments),
        "main_segment": mean(row.main_segment),
    })
}
