//! Verdicts as part of a summary: the rule, how good it is, and how many hearts it found what in.

use serde_json::{Value, json};

use crate::analysis::verdicts::{Feature, RuleSource, VerdictParams, Verdicts};

/// `rule` is `"learnt"` from the labelled hearts or `"fixed"` where they are too few; `quality` is null then. Counts are
/// hearts; `accuracy` and `auc` come from rules that had not seen the heart, beside those of permuted labels.
pub fn verdicts_json(verdicts: &Verdicts, params: &VerdictParams) -> Value {
    let (rule, normal, abnormal) = match verdicts.rule {
        RuleSource::Cohort { normal, abnormal } => ("learnt", normal, abnormal),
        RuleSource::Uncalibrated { normal, abnormal } => ("fixed", normal, abnormal),
    };
    let assessed = || {
        verdicts
            .subjects
            .iter()
            .filter_map(|found| found.as_ref().ok())
    };
    json!({
        "rule": rule,
        "normal": normal,
        "abnormal": abnormal,
        "features": Feature::OF_RULE.map(Feature::name),
        "parameters": {
            "ridge": params.ridge,
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
            "false_alarms": quality.false_alarms,
            "missed": quality.missed,
            "auc": quality.auc,
            "auc_chance": quality.auc_baseline,
            "auc_p_value": quality.auc_p_value,
        })),
        "assessed": assessed().count(),
        "not_assessed": verdicts.subjects.len() - assessed().count(),
        "called_abnormal": assessed().filter(|verdict| verdict.abnormal).count(),
    })
}
