//! The content of the report, as texts.

use crate::analysis::classification::{Accuracy, Classes};
use crate::analysis::verdicts::{ClassifierSource, Finding, Verdicts};
use crate::picture::patch_words::{percent, probability_words, sentence};
use crate::picture::report::order::ReportOrder;
use crate::report::{NO_VALUE, PatchRow, SubjectRow, VerdictRow};
use crate::units::LengthUnit;

/// Subject, label, EF, EDV, verdict, probability, patch, note.
pub(super) type Row = [String; 8];

/// Heads of the table, with the unit of volumes.
pub(super) fn heads(unit: LengthUnit) -> Row {
    [
        SubjectRow::SUBJECT.heading.to_owned(),
        SubjectRow::LABEL.heading.to_owned(),
        SubjectRow::EF.heading.to_owned(),
        SubjectRow::EDV.heading_with_unit(unit),
        VerdictRow::FINDING.heading.to_owned(),
        VerdictRow::PROBABILITY.short_heading.to_owned(),
        format!("Patch, {}", PatchRow::SHARE.heading),
        String::new(),
    ]
}

/// One row per subject.
pub(super) fn rows(order: &ReportOrder<'_>) -> Vec<Row> {
    let measures = SubjectRow::of_study(order.study, order.measures);
    let verdicts = VerdictRow::of_study(order.study, order.verdicts);
    let subjects = order.study.subjects.iter().enumerate();
    subjects
        .map(|(index, subject)| {
            let none = || NO_VALUE.to_owned();
            let row = measures.get(index);
            let assessed = order.verdicts.subjects.get(index);
            let verdict = verdicts.get(index);
            let finding = verdict.map_or_else(none, |row| VerdictRow::FINDING.shown(row));
            let [finding, probability, share, note] = match assessed {
                Some(Ok(verdict)) => [
                    finding,
                    probability_words(verdict.probability),
                    if verdict.finding == Finding::AbnormalPatch {
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
            let unit = subject.unit;
            [
                subject.id.clone(),
                row.map_or_else(none, |row| SubjectRow::LABEL.shown(row)),
                row.map_or_else(none, |row| SubjectRow::EF.shown_with_unit(row, unit)),
                row.map_or_else(none, |row| SubjectRow::EDV.shown(row)),
                finding,
                probability,
                share,
                note,
            ]
        })
        .collect()
}

/// How many subjects have which verdict.
pub(super) fn counts(verdicts: &Verdicts) -> String {
    let count = |finding: Finding, wall: bool| {
        let assessed = verdicts.subjects.iter().flatten();
        assessed
            .filter(|verdict| verdict.finding == finding && verdict.wall == wall)
            .count()
    };
    let mut parts: Vec<String> = [
        Finding::AbnormalPatch,
        Finding::GlobalHypokinesia,
        Finding::WithoutPatch,
        Finding::Nothing,
    ]
    .into_iter()
    .flat_map(|finding| [true, false].map(|wall| (finding.words(wall), count(finding, wall))))
    .filter(|(_, count)| *count > 0)
    .map(|(words, count)| format!("{words}: {count}"))
    .collect();
    let not = verdicts
        .subjects
        .iter()
        .filter(|assessed| assessed.is_err())
        .count();
    if not > 0 {
        parts.push(format!("not assessed: {not}"));
    }
    sentence(&parts.join(" · "))
}

/// Which classifier the verdicts come from, and its accuracy.
pub(super) fn classifier(verdicts: &Verdicts) -> String {
    let (normal, abnormal) = match &verdicts.classifier {
        ClassifierSource::OtherStudy(rule) => return format!("{}.", rule.words()),
        ClassifierSource::Cohort { normal, abnormal } => (normal, abnormal),
    };
    let mut words = format!(
        "Linear classifier, trained on {normal} normal and {abnormal} abnormal subjects with a label; each of them is \
         classified leave-one-out (it is not in the training set)."
    );
    if let Some(quality) = &verdicts.quality {
        let accuracy = quality.accuracy;
        words += &format!(
            " Accuracy {} of {} ({}; permutation mean {}, p = {:.3}), false positives {}, false negatives {}. Area \
             under the ROC curve {:.2}, permutation mean {:.2}, p = {:.3}.",
            accuracy.correct,
            accuracy.of,
            percent(accuracy.share()),
            percent(accuracy.baseline),
            accuracy.p_value,
            quality.false_positives,
            quality.false_negatives,
            quality.auc,
            quality.auc_baseline,
            quality.auc_p_value
        );
        if let Some(labels) = quality.labels {
            words += &format!(
                " Most probable label: the own one of {} of {} subjects, leave-one-out ({} have the most frequent one).",
                labels.correct, labels.of, labels.largest_label
            );
        }
    }
    words
}

/// How well the labels are classified on whole deformations; `None` where there are too few.
pub(super) fn classes(classes: &Classes) -> Option<String> {
    let of = |name: &str, found: Option<Accuracy>| {
        let found = found?;
        Some(format!(
            "{name} {} of {} (permutation mean {}, p = {:.3})",
            found.correct,
            found.of,
            percent(found.baseline),
            found.p_value
        ))
    };
    let found: Vec<String> = [
        of("nearest neighbour", classes.nearest_neighbour),
        of("linear classifier", classes.linear_classifier),
        of("classifier on the 2-D embedding", classes.plane_classifier),
        of("cluster agreement", classes.tau),
    ]
    .into_iter()
    .flatten()
    .collect();
    (!found.is_empty()).then(|| {
        format!(
            "Labels by the distances of whole deformations, leave-one-out: {}.",
            found.join(", ")
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::verdicts::AppliedClassifier;

    #[test]
    fn the_classifier_of_the_verdicts_is_named_with_what_it_was_trained_on() {
        let verdicts = Verdicts {
            subjects: Vec::new(),
            classifier: ClassifierSource::OtherStudy(AppliedClassifier {
                name: "ward".to_owned(),
                study: "Ward 7".to_owned(),
                normal: 8,
                abnormal: 16,
                auc: Some(0.98),
                labelled: None,
            }),
            features: Vec::new(),
            quality: None,
        };
        assert_eq!(
            classifier(&verdicts),
            "Classifier “ward”, trained on 24 subjects of Ward 7 (8 normal, 16 abnormal), AUC 0.98 there."
        );
    }

    #[test]
    fn what_tells_labels_apart_is_said_with_its_permutation_mean() {
        let accuracy = Accuracy {
            correct: 18,
            of: 20,
            baseline: 0.5,
            p_value: 0.001,
        };
        let mut found = Classes {
            nearest_neighbour: Some(accuracy),
            ..Classes::default()
        };
        assert_eq!(
            classes(&found).unwrap(),
            "Labels by the distances of whole deformations, leave-one-out: nearest neighbour 18 of 20 (permutation \
             mean 50 %, p = 0.001)."
        );
        found.nearest_neighbour = None;
        assert_eq!(classes(&found), None);
    }
}
