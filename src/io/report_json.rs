//! The summary of an analysis as one JSON object.

use serde_json::{Value, json};

use super::report_csv::phase_source;
use crate::analysis::embedding::Embedding;
use crate::analysis::measures::SubjectMeasures;
use crate::analysis::pose_distances::PoseDistances;
use crate::study::{LabelRole, Study};

/// Measures of every subject as a list, with the names of the columns of `subjects.csv`.
pub fn subjects_json(study: &Study, measures: &[SubjectMeasures]) -> Value {
    let rows = study
        .subjects
        .iter()
        .zip(measures)
        .map(|(subject, measured)| {
            json!({
                "id": subject.id,
                "label": subject.label,
                "end_diastole": measured.end_diastole,
                "end_systole": measured.end_systole,
                "edv": measured.edv,
                "esv": measured.esv,
                "sv": measured.sv,
                "ef": measured.ef,
                "mass_g": measured.mass.map(|mass| mass.0),
                "volume_unit": measured.unit.volume_symbol(),
                "phase_source": phase_source(measured.phase_source),
            })
        });
    Value::Array(rows.collect())
}

/// What an analysis found. `maps` holds each map with the word for its method; `metric` says in
/// words how poses were compared.
pub fn summary_json(
    study: &Study,
    measures: &[SubjectMeasures],
    distances: &PoseDistances,
    metric: &str,
    maps: &[(&str, &Embedding)],
) -> Value {
    let count = |role| {
        study
            .subjects
            .iter()
            .filter(|s| study.role(s) == role)
            .count()
    };
    let left_out: Vec<Value> = distances
        .left_out
        .iter()
        .map(|left_out| {
            let id = study.subjects.get(left_out.subject).map(|s| s.id.clone());
            json!({ "subject": id, "reason": left_out.reason })
        })
        .collect();
    let maps: serde_json::Map<String, Value> = maps
        .iter()
        .map(|(method, map)| {
            let value = json!({ "stress": map.stress, "iterations": map.iterations });
            ((*method).to_owned(), value)
        })
        .collect();
    json!({
        "program": "Cardiomorph",
        "version": env!("CARGO_PKG_VERSION"),
        "note": "research use, not for diagnosis",
        "study": study.name,
        "labels": {
            "normal": count(LabelRole::Normal),
            "abnormal": count(LabelRole::Abnormal),
            "other": count(LabelRole::Unknown),
        },
        "subjects": subjects_json(study, measures),
        "poses": distances.poses.len(),
        "metric": metric,
        "left_out": left_out,
        "maps": maps,
    })
}
