//! The verdict on the selected subject in words, with its evidence and the classifier.

use crate::analysis::verdicts::{
    ClassifierQuality, ClassifierSource, Finding, TrainingSetDistance, Verdict, VerdictParams,
    Verdicts,
};
use crate::document::state::State;
use crate::engine::Showing;
use crate::panes::cohort::rows::CohortVerdict;
use crate::panes::verdict::evidence_rows::evidence;
use crate::panes::verdict_marks::VerdictMark;
use crate::panes::work_state::WorkState;
use crate::picture::percent;
use crate::study::LabelRole;
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
    let role = (state.document.selected()).map_or(LabelRole::Unknown, |shown| study.role(shown));
    let calibrated = matches!(verdicts.classifier, ClassifierSource::Cohort { .. });
    VerdictReport {
        mark: mark(verdict.finding),
        heading: heading(verdict),
        sentence: sentence(verdict),
        probability: Some(verdict.probability),
        calibrated,
        source: match (calibrated, role) {
            (false, _) => "Default thresholds: too few labelled subjects",
            (true, LabelRole::Unknown) => {
                "Classifier trained on the labelled subjects; this subject has no class"
            }
            (true, _) => "Leave-one-out: this subject was not in the training set",
        },
        training_distance: verdict
            .training_set_distance
            .as_ref()
            .map(training_distance),
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
        Finding::Patch => VerdictMark::Patch,
        Finding::GlobalHypokinesia => VerdictMark::GlobalHypokinesia,
        Finding::WithoutPatch => VerdictMark::AbnormalWithoutPatch,
    }
}

/// "Abnormal patch · 31 % of the LV".
fn heading(verdict: &Verdict) -> String {
    match verdict.finding {
        Finding::Nothing => "No regional abnormality".to_owned(),
        Finding::Patch => format!("Abnormal patch · {} of the LV", percent(verdict.patched)),
        Finding::GlobalHypokinesia => "Global hypokinesia".to_owned(),
        Finding::WithoutPatch => "Abnormal without a patch".to_owned(),
    }
}

/// What the finding means, with what could be mistaken for another one.
fn sentence(verdict: &Verdict) -> String {
    let little = (verdict.patched > 0.0)
        .then(|| format!("; low thickening in {} of the LV", percent(verdict.patched)));
    let little = little.unwrap_or_default();
    match verdict.finding {
        Finding::Nothing => format!("The wall thickens as in the normal subjects{little}"),
        Finding::Patch => {
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

fn training_distance(found: &TrainingSetDistance) -> TrainingDistance {
    let times = found.distance / found.median.max(f64::MIN_POSITIVE);
    let times = if times < 9.95 {
        format!("{times:.1} ×")
    } else {
        format!("{times:.0} ×")
    };
    let outside = found.as_far < OUTSIDE;
    let words = if outside {
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
    TrainingDistance { words, outside }
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
    let calibrated = matches!(
        state.verdicts()?.0.classifier,
        ClassifierSource::Cohort { .. }
    );
    Some(match state.verdict_of(subject)? {
        Ok(verdict) => {
            let number = if calibrated {
                format!(
                    "predicted probability of abnormal {:.0} %",
                    100.0 * verdict.probability
                )
            } else {
                format!("uncalibrated score {:.2}", verdict.probability)
            };
            CohortVerdict {
                mark: mark(verdict.finding),
                share: (verdict.finding == Finding::Patch).then_some(verdict.patched),
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
    let source = match verdicts.classifier {
        ClassifierSource::Cohort { normal, abnormal } => format!(
            "Logistic classifier, trained on the labelled subjects that can be assessed ({normal} normal, {abnormal} \
             abnormal); each of them is classified leave-one-out"
        ),
        ClassifierSource::Uncalibrated { normal, abnormal } => format!(
            "Default thresholds on the share of akinetic wall, uncalibrated: {normal} normal and {abnormal} abnormal \
             subjects can be assessed; training needs {} of each",
            VerdictParams::default().min_labelled
        ),
    };
    let results = match (verdicts.classifier, &verdicts.quality) {
        (ClassifierSource::Cohort { normal, abnormal }, Some(quality)) => {
            results(quality, normal, abnormal).to_vec()
        }
        _ => Vec::new(),
    };
    ClassifierReport { source, results }
}

fn results(quality: &ClassifierQuality, normal: usize, abnormal: usize) -> [ClassifierResult; 4] {
    let accuracy = &quality.accuracy;
    [
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
    ]
}

#[cfg(test)]
mod tests;
