//! Thickening of every heart in the summary of an analysis.

use serde_json::{Value, json};

use crate::analysis::medial::MedialParams;
use crate::analysis::medial_space::RatioForm;
use crate::analysis::thickening::{Extent, HalfBeat, Patch, ThickeningParams};

use super::thickening_csv::AssessedWall;

/// The settings, with the names of their options on the command line; angles are in degrees, and a
/// tolerance of `null` is told from noise.
pub fn thickening_params_json(medial: &MedialParams, params: &ThickeningParams) -> Value {
    json!({
        "medial_smoothing": medial.smoothing,
        "medial_separation_deg": medial.separation_rad.to_degrees(),
        "medial_end_deg": medial.end_rad.to_degrees(),
        "patch_tolerance": params.tolerance,
        "patch_ratio": match params.ratio {
            RatioForm::GeometricMean => "geometric-mean",
            RatioForm::Product => "product",
        },
        "patch_core": params.core,
        "patch_still": params.still,
        "patch_border": params.border,
        "patch_least_share": params.min_share,
        "patch_least_thickening": params.min_thickening,
        "patch_averaging": params.smoothing,
        "patch_redraws": params.redraws,
        "seed": params.seed,
    })
}

/// What is said of one heart.
pub fn wall_json(wall: &AssessedWall<'_>) -> Value {
    let found = wall.thickening;
    let regular = wall.beat.regular.iter().filter(|&&regular| regular).count();
    let well_share = |half: HalfBeat| {
        let steps: Vec<f64> = (found.steps.iter())
            .filter(|step| step.half == half)
            .map(|step| step.well_share)
            .collect();
        (!steps.is_empty()).then(|| steps.iter().sum::<f64>() / steps.len() as f64)
    };
    json!({
        "subject": wall.subject,
        "assessed": true,
        "reason": null,
        "extent": match found.extent {
            Extent::Everywhere => "thickens everywhere",
            Extent::AllButPatches => "thickens but for patches",
            Extent::HardlyAnywhere => "hardly thickens anywhere",
        },
        "end_diastole": found.end_diastole,
        "end_systole": found.end_systole,
        "atoms": wall.beat.vertices.len(),
        "regular_atoms": regular,
        "regular_area": found.regular_area * wall.unit.area_from_square(),
        "area_unit": wall.unit.area_symbol(),
        "tolerance": found.tolerance,
        "noise": found.noise,
        "well_pt": found.well.exp(),
        "averaged_share": found.averaged_share,
        "well_share_contraction": well_share(HalfBeat::Contraction),
        "well_share_expansion": well_share(HalfBeat::Expansion),
        "oriented": wall.axis.is_some_and(|axis| axis.is_oriented()),
        "smallest_patch": found.smallest.map(|least| {
            json!({ "share": least.share, "area_cm2": least.area_cm2 })
        }),
        "patches": found.patches.iter().map(patch_json).collect::<Vec<Value>>(),
    })
}

/// What is said of a heart whose wall could not be assessed.
pub fn unassessed_wall_json(subject: &str, reason: &str) -> Value {
    json!({ "subject": subject, "assessed": false, "reason": reason })
}

fn patch_json(patch: &Patch) -> Value {
    let segments: Vec<Value> = (patch.segments.iter())
        .map(|part| {
            json!({
                "segment": part.segment.number(),
                "name": part.segment.name(),
                "of_patch": part.of_patch,
                "of_segment": part.of_segment,
            })
        })
        .collect();
    json!({
        "area_cm2": patch.area_cm2,
        "share": patch.share,
        "confidence": patch.confidence,
        "pt": patch.thickening.exp(),
        "segments": segments,
        "centroid": [patch.centroid.x, patch.centroid.y, patch.centroid.z],
        "normal_spread_rad": patch.temporal_consistency.normal_spread_rad,
        "position_spread": patch.temporal_consistency.position_spread,
        "gap": patch.temporal_consistency.gap,
        "pose_distance": patch.temporal_consistency.pose_distance,
    })
}
