//! The verdict on the selected subject in words, with its evidence and the classifier.

use crate::analysis::verdicts::{
    AppliedClassifier, ClassifierQuality, ClassifierSource, Feature, Finding, NotAssessed,
    TrainingSetDistance, Verdict, Verdicts,
};
use crate::document::state::State;
use crate::engine::Showing;
use crate::panes::cohort::rows::CohortVerdict;
use crate::panes::verdict::evidence_rows::{evidence, written};
use crate::panes::verdict_marks::VerdictMark;
use crate::panes::work_state::WorkState;
use crate::picture::percent;
use crate::study::LabelClass;
use crate::ui::text::p_text;

use super::values::*;

/// Share of the training subjects at least as far from the others, below which a subject is outside their distribution.
const OUTSIDE: f64 = 0.05;

/// What the pane shows of the selected subject.
pub fn verdict_view(state: &State) -> VerdictPanelView<'_> {
    let verdicts = state.verdicts();
    VerdictPanelView {
        subject: state.document.selected().map(|subject| &*subject.id),
        state: verdict_state(state),
        verdict: report(state),
        classifier: verdicts.map(|(verdicts, _)| classifier_report(verdicts)),
    }
}

/// Whether verdicts are still to come.
pub fn classifying(state: &State) -> bool {
    let work = verdict_state(state);
    matches!(work, WorkState::Waiting | WorkState::Computing { .. })
}

fn verdict_state(state: &State) -> WorkState {
    if state.document.selected().is_none() {
        return WorkState::Empty;
    }
    match &state.answers.verdicts {
        None => WorkState::Waiting,
        // Statistics of the cohort wait until nothing else is computed.
        Some(Showing::Computing { watch, .. }) if watch.elapsed().is_zero() => WorkState::Waiting,
        showing => WorkState::of(showing.as_ref()),
    }
}

/// The verdict on the selected subject. A wall that cannot be assessed says so before all others are classified.
fn report(state: &State) -> Option<VerdictReport> {
    let subject = state.document.selected_index()?;
    let not_assessed = |why: String| VerdictReport {
        mark: VerdictMark::NotAssessed,
        heading: "Not assessed".to_owned(),
        sentence: crate::picture::sentence(&why),
        ..VerdictReport::default()
    };
    match (state.verdict_of(subject), state.wall_of(subject)) {
        (Some(Ok(verdict)), _) => {
            let (verdicts, _) = state.verdicts()?;
            Some(report_of(state, verdicts, verdict))
        }
        (Some(Err(NotAssessed::NotComparable(why))), _) => Some(VerdictReport {
            heading: "Not comparable".to_owned(),
            ..not_assessed(why.clone())
        }),
        (Some(Err(reason)), _) => Some(not_assessed(reason.to_string())),
        _ if state.document.study().is_excluded(subject) => {
            Some(not_assessed("excluded from the cohort".to_owned()))
        }
        (None, Some((Err(why), true))) => Some(not_assessed(why.clone())),
        (None, _) => None,
    }
}

fn report_of(state: &State, verdicts: &Verdicts, verdict: &Verdict) -> VerdictReport {
    let study = state.document.study();
    let class =
        (state.document.selected()).map_or(LabelClass::Neither, |shown| study.class_of(shown));
    VerdictReport {
        mark: mark(verdict.finding),
        heading: heading(verdict),
        sentence: sentence(verdict),
        labels: (verdict.labels.iter())
            .map(|label| {
                (
                    label.label.clone(),
                    super::found::percent(label.probability),
                )
            })
            .collect(),
        reasons: reasons(verdict),
        probability: Some(verdict.probability),
        source: match (&verdicts.classifier, class) {
            (
                ClassifierSource::OtherStudy(AppliedClassifier {
                    labelled: Some(_), ..
                }),
                _,
            ) => "Built-in classifier: too few labelled subjects",
            (ClassifierSource::OtherStudy(_), _) => "Classifier of another study, from a file",
            (ClassifierSource::Cohort { .. }, LabelClass::Neither) => {
                "Classifier trained on the labelled subjects; this subject has no class"
            }
            (ClassifierSource::Cohort { .. }, _) => {
                "Leave-one-out: this subject was not in the training set"
            }
        },
        training_distance: (verdict.training_set_distance.as_ref())
            .map(|found| training_distance(found, &verdict.outside)),
        evidence: evidence(study, verdicts, &verdict.features),
        similar: [&verdict.similar_normal, &verdict.similar_abnormal].map(|subjects| {
            subjects
                .iter()
                .filter_map(|&subject| similar(state, subject))
                .collect()
        }),
    }
}

fn mark(finding: Finding) -> VerdictMark {
    match finding {
        Finding::Nothing => VerdictMark::NoAbnormality,
        Finding::AbnormalPatch => VerdictMark::Patch,
        Finding::GlobalHypokinesia => VerdictMark::GlobalHypokinesia,
        Finding::WithoutPatch => VerdictMark::AbnormalWithoutPatch,
    }
}

/// "Abnormal patch · 31 % of the LV".
fn heading(verdict: &Verdict) -> String {
    match verdict.finding {
        _ if !verdict.wall => crate::picture::sentence(verdict.words()),
        finding @ Finding::AbnormalPatch => {
            let name = crate::picture::sentence(finding.name());
            format!("{name} · {} of the LV", percent(verdict.patched))
        }
        finding => crate::picture::sentence(finding.name()),
    }
}

/// What the finding means, with what could be mistaken for another one.
fn sentence(verdict: &Verdict) -> String {
    let little = (verdict.patched > 0.0)
        .then(|| format!("; low thickening in {} of the LV", percent(verdict.patched)));
    let little = little.unwrap_or_default();
    match verdict.finding {
        _ if !verdict.wall => {
            "By ejection fraction, volumes, shape and motion; there is no wall to assess regions of"
                .to_owned()
        }
        Finding::Nothing => format!("The heart is as those of the normal subjects{little}"),
        Finding::AbnormalPatch => {
            "Thickening in part of the wall is far below that of remote myocardium".to_owned()
        }
        Finding::GlobalHypokinesia => {
            "Thickening of the whole wall is low, without a regional abnormality".to_owned()
        }
        Finding::WithoutPatch => {
            "Features differ from those of the normal subjects, without an akinetic region"
                .to_owned()
        }
    }
}

/// "Speaks for it: low ejection fraction, large …": the strongest features with their values, in words.
fn reasons(verdict: &Verdict) -> String {
    let named = (verdict.reasons.iter()).filter_map(|reason| {
        let value = written(reason.feature, verdict.features.get(reason.feature)?);
        Some(format!("{} {value}", reason.feature.name()))
    });
    let named: Vec<String> = named.collect();
    match named.as_slice() {
        [] => String::new(),
        _ => format!("Strongest features: {}", named.join(", ")),
    }
}

/// Distance to what the classifier has seen, and the features outside the range of that.
fn training_distance(found: &TrainingSetDistance, beyond: &[Feature]) -> TrainingDistance {
    let times = found.distance / found.median.max(f64::MIN_POSITIVE);
    let times = if times < 9.95 {
        format!("{times:.1} ×")
    } else {
        format!("{times:.0} ×")
    };
    let outside = found.as_far < OUTSIDE;
    let mut words = if outside {
        format!(
            "Outside the training distribution: {times} the median distance, {} percentile. Interpret the verdict with \
             caution",
            ordinal(100.0 * (1.0 - found.as_far))
        )
    } else {
        format!(
            "Within the training distribution: {times} the median distance, {} percentile",
            ordinal(100.0 * (1.0 - found.as_far))
        )
    };
    if !beyond.is_empty() {
        let names: Vec<&str> = beyond.iter().map(|feature| feature.name()).collect();
        words += &format!(". Outside the training range: {}", names.join(", "));
    }
    TrainingDistance {
        words,
        outside: outside || !beyond.is_empty(),
    }
}

/// "74th", of a number that is rounded to an integer.
fn ordinal(number: f64) -> String {
    let number = number.round() as u32;
    let ending = match (number % 100, number % 10) {
        (11..=13, _) => "th",
        (_, 1) => "st",
        (_, 2) => "nd",
        (_, 3) => "rd",
        _ => "th",
    };
    format!("{number}{ending}")
}

fn similar(state: &State, subject: usize) -> Option<SimilarSubject> {
    let shown = state.subject(subject)?;
    let verdict = cohort_verdict(state, subject).map(|verdict| verdict.text());
    Some(SimilarSubject {
        subject,
        id: shown.id.clone(),
        label: shown.label.clone().unwrap_or_else(|| "no label".to_owned()),
        verdict: verdict.unwrap_or_default(),
    })
}

/// The verdict on one subject in the cohort table.
pub fn cohort_verdict(state: &State, subject: usize) -> Option<CohortVerdict> {
    Some(match state.verdict_of(subject)? {
        Ok(verdict) => {
            let number = format!(
                "predicted probability of abnormal {:.0} %",
                100.0 * verdict.probability
            );
            CohortVerdict {
                mark: mark(verdict.finding),
                share: (verdict.finding == Finding::AbnormalPatch).then_some(verdict.patched),
                probability: Some(verdict.probability),
                words: format!("Verdict: {}, {number}", lower_first(&heading(verdict))),
            }
        }
        Err(reason) => CohortVerdict {
            mark: VerdictMark::NotAssessed,
            share: None,
            probability: None,
            words: format!("Verdict: not assessed: {reason}"),
        },
    })
}

fn lower_first(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| {
        first.to_lowercase().chain(letters).collect()
    })
}

fn classifier_report(verdicts: &Verdicts) -> ClassifierReport {
    let source = match &verdicts.classifier {
        ClassifierSource::Cohort { normal, abnormal } => format!(
            "Logistic classifier, trained on the labelled subjects that can be assessed ({normal} normal, {abnormal} \
             abnormal); each of them is classified leave-one-out"
        ),
        ClassifierSource::OtherStudy(rule) => rule.words(),
    };
    let results = match (&verdicts.classifier, &verdicts.quality) {
        (ClassifierSource::Cohort { normal, abnormal }, Some(quality)) => {
            results(quality, *normal, *abnormal)
        }
        _ => Vec::new(),
    };
    ClassifierReport { source, results }
}

fn results(quality: &ClassifierQuality, normal: usize, abnormal: usize) -> Vec<ClassifierResult> {
    let accuracy = &quality.accuracy;
    let labels = quality.labels.map(|labels| ClassifierResult {
        name: "Label (leave-one-out)",
        what: "Subjects whose most probable label is their own (leave-one-out)",
        value: format!("{} of {}", labels.correct, labels.of),
        permutation_test: format!("most frequent label: {}", labels.largest_label),
    });
    let results = [
        ClassifierResult {
            name: "Accuracy (leave-one-out)",
            what: "Subjects whose verdict agrees with the class of their label (leave-one-out)",
            value: format!(
                "{} of {} · {}",
                accuracy.correct,
                accuracy.of,
                percent(accuracy.share())
            ),
            permutation_test: format!(
                "permutation mean {:.1} · p {}",
                accuracy.baseline * accuracy.of as f64,
                p_text(accuracy.p_value)
            ),
        },
        ClassifierResult {
            name: "AUC",
            what: "Area under the ROC curve: probability that an abnormal subject has a higher score than a normal one; \
                   leave-one-out lowers its permutation mean below 0.5",
            value: format!("{:.2}", quality.auc),
            permutation_test: format!(
                "permutation mean {:.2} · p {}",
                quality.auc_baseline,
                p_text(quality.auc_p_value)
            ),
        },
        ClassifierResult {
            name: "False positives",
            what: "Subjects of class normal that are classified as abnormal",
            value: format!("{} of {normal} normal", quality.false_positives),
            permutation_test: String::new(),
        },
        ClassifierResult {
            name: "False negatives",
            what: "Subjects of class abnormal that are classified as normal",
            value: format!("{} of {abnormal} abnormal", quality.false_negatives),
            permutation_test: String::new(),
        },
    ];
    results.into_iter().chain(labels).collect()
}

#[cfg(test)]
mod tests;
