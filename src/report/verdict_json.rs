//! Verdicts as part of a summary: the classifier, its accuracy, and how many subjects it classifies as what.

use serde_json::{Value, json};

use crate::analysis::verdicts::{ClassifierSource, Feature, VerdictParams, Verdicts};

/// `rule` is `"learnt"` for a classifier trained on the labelled subjects, `"file"` for a rule that was learnt on another study,
/// `"fixed"` for default thresholds where they
/// are too few; `quality` is null then. Counts are subjects; accuracy and AUC are leave-one-out, beside their
/// permutation means.
pub fn verdicts_json(verdicts: &Verdicts, params: &VerdictParams) -> Value {
    let (source, normal, abnormal) = match verdicts.classifier {
        ClassifierSource::Cohort { normal, abnormal } => ("learnt", normal, abnormal),
        ClassifierSource::Rule { normal, abnormal } => ("file", normal, abnormal),
        ClassifierSource::Uncalibrated { normal, abnormal } => ("fixed", normal, abnormal),
    };
    let assessed = || {
        verdicts
            .subjects
            .iter()
            .filter_map(|subject| subject.as_ref().ok())
    };
    json!({
        "rule": source,
        "normal": normal,
        "abnormal": abnormal,
        "features": Feature::MODEL_FEATURES.map(Feature::name),
        "parameters": {
            "least_labelled": params.min_labelled,
            "least_wall_volume": params.min_wall_volume,
            "permutations": params.permutations,
            "seed": params.seed,
        },
        "quality": verdicts.quality.map(|quality| json!({
            "correct": quality.accuracy.correct,
            "of": quality.accuracy.of,
            "chance": quality.accuracy.baseline,
            "p_value": quality.accuracy.p_value,
            "false_alarms": quality.false_positives,
            "missed": quality.false_negatives,
            "auc": quality.auc,
            "auc_chance": quality.auc_baseline,
            "auc_p_value": quality.auc_p_value,
            "kinds": quality.kinds.map(|kinds| json!({
                "correct": kinds.correct,
                "of": kinds.of,
                "largest_kind": kinds.largest_kind,
            })),
        })),
        "assessed": assessed().count(),
        "not_assessed": verdicts.subjects.len() - assessed().count(),
        "called_abnormal": assessed().filter(|verdict| verdict.abnormal).count(),
    })
}
