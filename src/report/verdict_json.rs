//! Verdicts as part of a summary: the classifier, its accuracy, and how many subjects it classifies as what.

use serde_json::{Value, json};

use crate::analysis::verdicts::{AppliedClassifier, ClassifierSource, VerdictParams, Verdicts};

/// `rule` names where the classifier comes from: trained on the labelled subjects, `"file"` for one that was trained on another study,
/// `"built-in"` for the one that ships with the program, where they
/// are too few; `quality` is null then, and `classifier` says what it was trained on. Counts are subjects; accuracy and AUC are leave-one-out, beside their
/// permutation means.
pub fn verdicts_json(verdicts: &Verdicts, params: &VerdictParams) -> Value {
    let (source, normal, abnormal) = match &verdicts.classifier {
        ClassifierSource::Cohort { normal, abnormal } => ("learnt", normal, abnormal),
        ClassifierSource::OtherStudy(AppliedClassifier {
            labelled: Some([normal, abnormal]),
            ..
        }) => ("built-in", normal, abnormal),
        ClassifierSource::OtherStudy(AppliedClassifier {
            normal, abnormal, ..
        }) => ("file", normal, abnormal),
    };
    let source_json = match &verdicts.classifier {
        ClassifierSource::Cohort { .. } => Value::Null,
        ClassifierSource::OtherStudy(rule) => json!({
            "name": rule.name,
            "study": rule.study,
            "normal": rule.normal,
            "abnormal": rule.abnormal,
            "auc": rule.auc,
        }),
    };
    let assessed = || {
        verdicts
            .subjects
            .iter()
            .filter_map(|subject| subject.as_ref().ok())
    };
    json!({
        "rule": source,
        "classifier": source_json,
        "normal": normal,
        "abnormal": abnormal,
        "features": verdicts.features.iter().map(|feature| feature.name()).collect::<Vec<_>>(),
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
            "kinds": quality.labels.map(|labels| json!({
                "correct": labels.correct,
                "of": labels.of,
                "largest_kind": labels.largest_label,
            })),
        })),
        "assessed": assessed().count(),
        "not_assessed": verdicts.subjects.len() - assessed().count(),
        "called_abnormal": assessed().filter(|verdict| verdict.abnormal).count(),
    })
}
