//! Parts of the summary of an analysis: maps and classification.

use serde_json::{Value, json};

use crate::analysis::classification::{Accuracy, Classes};
use crate::analysis::deformations::{DeformationMap, PartDistances};
use crate::analysis::embedding::Embedding;
use crate::analysis::medial_map::MedialMap;
use crate::analysis::metrics::{EnergyShares, MetricKind};
use crate::analysis::pose_distances::BeatShares;
use crate::analysis::transport::FoundPath;
use crate::study::Study;

/// What the distances within beats are made of, `null` where no pose moves. Shares are in 0 to 1.
pub fn beat_shares_json(found: &BeatShares, kind: MetricKind) -> Value {
    let shares = |shares: Option<EnergyShares>| {
        shares.map(|shares| {
            json!({
                "own": shares.own,
                "curvature": shares.curvature,
                "displacement": shares.displacement,
            })
        })
    };
    json!({
        "own_term": kind.words().term,
        "beats": found.beats,
        "end_diastole_to_end_systole": shares(found.phases),
        "frame_to_frame": shares(found.steps),
    })
}

/// How well a pose map keeps distances.
pub(super) fn map_json(map: &Embedding) -> Value {
    json!({
        "stress": map.stress,
        "iterations": map.iterations,
        "neighbours": map.neighbours,
        "reconstruction_error": map.reconstruction_error,
        "parts": map.parts,
    })
}

/// The map of medial poses: its stress, in which axes subjects are compared, and who is not on it; without a map, why.
pub(super) fn medial_map_json(study: &Study, map: Result<&MedialMap, &str>) -> Value {
    let map = match map {
        Ok(map) => map,
        Err(reason) => return json!({ "reason": reason }),
    };
    let id = |subject: usize| study.subjects.get(subject).map(|subject| &subject.id);
    let paths: Vec<Value> = (map.spreads.iter())
        .map(|spread| {
            json!({
                "subject": id(spread.subject),
                "patch": spread.part.patch(),
                "mean_distance": spread.mean_distance,
            })
        })
        .collect();
    let left_out: Vec<Value> = (map.left_out.iter())
        .map(|(subject, reason)| json!({ "subject": id(*subject), "reason": reason }))
        .collect();
    json!({
        "poses": map.poses.len(),
        "stress": map.embedding.stress,
        "frame": map.frame.words(),
        "paths": paths,
        "left_out": left_out,
    })
}

/// How the deformation map is made, and its reconstruction error.
pub(super) fn deformations_json(study: &Study, map: &DeformationMap, comparison: &str) -> Value {
    let left_out = map.parts.iter().flat_map(|mapped| &mapped.parts.left_out);
    let left_out = left_out.map(|left| {
        let id = study.subjects.get(left.subject).map(|subject| &subject.id);
        json!({ "subject": id, "reason": left.reason })
    });
    json!({
        "compared": comparison,
        "left_out": left_out.collect::<Vec<Value>>(),
        "transports": map.parts.as_ref().map(|mapped| transports_json(study, &mapped.parts)),
        "count": map.subjects.len(),
        "time_weight": map.time_weight,
        "samples": map.curves.first().map_or(0, Vec::len),
        "median_shape_share": map.parts.as_ref().and_then(|mapped| mapped.parts.median_shape_share()),
        "neighbours": map.embedding.neighbours,
        "parts": map.embedding.parts,
        "reconstruction_error": map.embedding.reconstruction_error,
        // Where neighbourhoods fall into parts, the map is one of the distances.
        "method": if map.embedding.stress.is_some() { "smacof" } else { "lle" },
        "stress": map.embedding.stress,
    })
}

/// How the motion of each subject was transported onto the reference: energies of the geodesics over those of the straight
/// lines, none where that was asked for, and the largest relative changes of norms and of products with the direction. A motion
/// for which no geodesic was found is left out, with the reason.
fn transports_json(study: &Study, parts: &PartDistances) -> Vec<Value> {
    (parts.subjects.iter().zip(&parts.transports))
        .map(|(&subject, account)| {
            let shares = account.paths.iter().map(FoundPath::energy_share);
            json!({
                "subject": study.subjects.get(subject).map(|subject| &subject.id),
                "energy_shares": shares.collect::<Vec<f64>>(),
                "converged": account.not_converged() == 0,
                "norm_change": account.norm_change(),
                "product_change": account.product_change(),
            })
        })
        .collect()
}

/// Accuracies of the classifiers (leave-one-out), each beside its permutation mean. `null` where fewer than
/// two classes have labels.
pub(super) fn classification_json(classes: &Classes) -> Value {
    let counts: serde_json::Map<String, Value> = (classes.names.iter().enumerate())
        .map(|(class, name)| {
            let of_class = classes.of_row.iter().filter(|row| **row == Some(class));
            (name.clone(), json!(of_class.count()))
        })
        .collect();
    json!({
        "classes": counts,
        "tau": classes.tau.as_ref().map(accuracy_json),
        "nearest_neighbour": classes.nearest_neighbour.as_ref().map(accuracy_json),
        "linear_rule": classes.linear_classifier.as_ref().map(accuracy_json),
        "plane_rule": classes.plane_classifier.as_ref().map(accuracy_json),
        "clusters": classes.clustering.clusters,
        "inertia": classes.clustering.inertia,
    })
}

/// Shares are in 0 to 1.
fn accuracy_json(accuracy: &Accuracy) -> Value {
    json!({
        "accuracy": accuracy.share(),
        "correct": accuracy.correct,
        "of": accuracy.of,
        "baseline": accuracy.baseline,
        "p_value": accuracy.p_value,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_accuracy_stands_beside_that_of_permuted_labels() {
        let classes = Classes {
            names: vec!["abnormal".to_owned(), "normal".to_owned()],
            of_row: vec![Some(1), Some(0), None, Some(1)],
            tau: Some(Accuracy {
                correct: 2,
                of: 3,
                baseline: 0.5,
                p_value: 0.25,
            }),
            ..Classes::default()
        };
        let value = classification_json(&classes);
        assert_eq!(value["classes"], json!({ "abnormal": 1, "normal": 2 }));
        let expected = json!({
            "accuracy": 2.0 / 3.0, "correct": 2, "of": 3, "baseline": 0.5, "p_value": 0.25
        });
        assert_eq!(value["tau"], expected);
        assert_eq!(value["plane_rule"], Value::Null);
    }

    #[test]
    fn the_map_says_from_how_many_neighbours_and_how_well() {
        let map = DeformationMap {
            subjects: vec![0, 2],
            curves: vec![vec![[0.0; 3]; 64]; 2],
            time_weight: Some(0.75),
            parts: None,
            embedding: Embedding {
                neighbours: Some(5),
                reconstruction_error: Some(1e-3),
                ..Embedding::default()
            },
        };
        let value = deformations_json(&Study::default(), &map, "curves of poses");
        assert_eq!(value["neighbours"], 5);
        assert_eq!(value["reconstruction_error"], 1e-3);
        assert_eq!(value["time_weight"], 0.75);
        assert_eq!(value["samples"], 64);
        assert_eq!(value["compared"], "curves of poses");
        assert_eq!(value["median_shape_share"], Value::Null);
        assert_eq!(
            (&value["method"], &value["stress"]),
            (&json!("lle"), &Value::Null)
        );
        let by_distances = DeformationMap {
            embedding: Embedding {
                stress: Some(0.25),
                parts: Some(2),
                ..Embedding::default()
            },
            ..map
        };
        let value = deformations_json(&Study::default(), &by_distances, "deformation");
        assert_eq!(
            (&value["method"], &value["stress"]),
            (&json!("smacof"), &json!(0.25))
        );
    }
}
