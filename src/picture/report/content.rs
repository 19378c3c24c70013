//! What the report says, as texts.

use crate::analysis::verdicts::{Finding, RuleSource, Verdicts};
use crate::picture::patch_words::{percent, probability_words, sentence};
use crate::picture::report::ReportOrder;

/// Subject, label, EF, EDV, verdict, probability, patch, note.
pub(super) type Row = [String; 8];

/// Heads of the table, with units.
pub(super) fn heads(volume: &str) -> Row {
    [
        "Subject",
        "Label",
        "EF",
        &format!("EDV, {volume}"),
        "Verdict",
        "Probability",
        "Patch, of the LV",
        "",
    ]
    .map(str::to_owned)
}

/// One row per subject.
pub(super) fn rows(order: &ReportOrder<'_>) -> Vec<Row> {
    let subjects = order.study.subjects.iter().enumerate();
    subjects
        .map(|(index, subject)| {
            let measures = order.measures.get(index);
            let none = || "–".to_owned();
            let told = order.verdicts.subjects.get(index);
            let [verdict, probability, share, note] = match told {
                Some(Ok(verdict)) => [
                    verdict.finding.name().to_owned(),
                    probability_words(verdict.probability),
                    if verdict.finding == Finding::Patch {
                        percent(verdict.patched)
                    } else {
                        none()
                    },
                    String::new(),
                ],
                Some(Err(reason)) => [
                    "not assessed".to_owned(),
                    none(),
                    none(),
                    reason.to_string(),
                ],
                None => [none(), none(), none(), String::new()],
            };
            [
                subject.id.clone(),
                subject.label.clone().unwrap_or_else(none),
                measures.and_then(|m| m.ef).map_or_else(none, percent),
                (measures.and_then(|m| m.edv)).map_or_else(none, |edv| format!("{edv:.0}")),
                verdict,
                probability,
                share,
                note,
            ]
        })
        .collect()
}

/// How many hearts have what.
pub(super) fn counts(verdicts: &Verdicts) -> String {
    let count = |finding: Finding| {
        let told = verdicts.subjects.iter().flatten();
        told.filter(|verdict| verdict.finding == finding).count()
    };
    let mut parts: Vec<String> = [
        Finding::Patch,
        Finding::GlobalFailure,
        Finding::Elsewhere,
        Finding::Nothing,
    ]
    .into_iter()
    .map(|finding| (finding, count(finding)))
    .filter(|(_, count)| *count > 0)
    .map(|(finding, count)| format!("{}: {count}", finding.name()))
    .collect();
    let not = verdicts
        .subjects
        .iter()
        .filter(|told| told.is_err())
        .count();
    if not > 0 {
        parts.push(format!("not assessed: {not}"));
    }
    sentence(&parts.join(" · "))
}

/// What the rule is worth.
pub(super) fn rule(verdicts: &Verdicts) -> String {
    let (normal, abnormal) = match verdicts.rule {
        RuleSource::Uncalibrated { normal, abnormal } => {
            return format!(
                "The rule was fixed beforehand, since only {normal} normal and {abnormal} abnormal hearts with a \
                 label could be assessed: its number is an order, no probability."
            );
        }
        RuleSource::Cohort { normal, abnormal } => (normal, abnormal),
    };
    let mut words = format!(
        "The rule was learnt from {normal} normal and {abnormal} abnormal hearts with a label; each of them was \
         judged by a rule made without it."
    );
    if let Some(quality) = &verdicts.quality {
        let told = quality.accuracy;
        words += &format!(
            " It is right in {} of {} ({}; by chance {}, p = {:.3}), calls {} normal hearts abnormal and {} abnormal ones \
             normal. Area under the ROC curve {:.2}, by chance {:.2}, p = {:.3}.",
            told.correct,
            told.of,
            percent(told.share()),
            percent(told.baseline),
            told.p_value,
            quality.false_alarms,
            quality.missed,
            quality.auc,
            quality.auc_baseline,
            quality.auc_p_value
        );
    }
    words
}
