//! Thickening of every subject in the summary of an analysis.

use serde_json::{Value, json};

use super::assessed_wall::AssessedWall;
use super::patches::PatchRow;
use super::table::json_cells;
use crate::analysis::medial::MedialParams;
use crate::analysis::medial_space::RatioForm;
use crate::analysis::thickening::{HalfBeat, Patch, ThickeningParams, WallThickening};

/// The settings, with the names of their options on the command line; angles are in degrees, and a
/// tolerance of `null` is estimated from noise.
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
        "patch_core": params.core_threshold,
        "patch_still": params.akinetic_threshold,
        "patch_border": params.extent_threshold,
        "patch_least_share": params.min_share,
        "patch_least_thickening": params.min_thickening,
        "patch_averaging": params.smoothing,
        "patch_redraws": params.redraws,
        "seed": params.seed,
    })
}

/// One assessed subject.
pub fn wall_json(wall: &AssessedWall<'_>) -> Value {
    let found = wall.thickening;
    let regular = wall.beat.regular.iter().filter(|&&regular| regular).count();
    let remote_share = |half: HalfBeat| {
        let steps: Vec<f64> = (found.steps.iter())
            .filter(|step| step.half == half)
            .map(|step| step.remote_share)
            .collect();
        (!steps.is_empty()).then(|| steps.iter().sum::<f64>() / steps.len() as f64)
    };
    json!({
        "subject": wall.subject,
        "assessed": true,
        "reason": null,
        "extent": match found.wall_thickening {
            WallThickening::Everywhere => "thickens everywhere",
            WallThickening::AllButPatches => "thickens but for patches",
            WallThickening::HardlyAnywhere => "hardly thickens anywhere",
        },
        "end_diastole": found.end_diastole,
        "end_systole": found.end_systole,
        "atoms": wall.beat.vertices.len(),
        "regular_atoms": regular,
        "regular_area": found.regular_area * wall.unit.area_from_square(),
        "area_unit": wall.unit.area_symbol(),
        "tolerance": found.tolerance,
        "noise": found.noise,
        "well_pt": found.remote.exp(),
        "averaged_share": found.averaged_share,
        "well_share_contraction": remote_share(HalfBeat::Contraction),
        "well_share_expansion": remote_share(HalfBeat::Expansion),
        "oriented": wall.axis.is_some_and(|axis| axis.is_oriented()),
        "smallest_patch": found.smallest.map(|least| {
            json!({ "share": least.share, "area_cm2": least.area_cm2 })
        }),
        "patches": (PatchRow::of_wall(wall).iter().zip(&found.patches))
            .map(|(row, patch)| patch_json(row, patch))
            .collect::<Vec<Value>>(),
    })
}

/// One subject whose wall is not assessed.
pub fn unassessed_wall_json(subject: &str, reason: &str) -> Value {
    json!({ "subject": subject, "assessed": false, "reason": reason })
}

/// [`PatchRow::IN_SUMMARY`], then what only the summary has.
fn patch_json(row: &PatchRow, patch: &Patch) -> Value {
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
    let mut object = json_cells(row, &PatchRow::IN_SUMMARY);
    let consistency = patch.temporal_consistency;
    let further = [
        ("segments", json!(segments)),
        (
            "centroid",
            json!([patch.centroid.x, patch.centroid.y, patch.centroid.z]),
        ),
        ("normal_spread_rad", json!(consistency.normal_spread_rad)),
        ("position_spread", json!(consistency.position_spread)),
        ("gap", json!(consistency.gap)),
        ("pose_distance", json!(consistency.pose_distance)),
    ];
    object.extend(further.map(|(key, value)| (key.to_owned(), value)));
    Value::Object(object)
}
