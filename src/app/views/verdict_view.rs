//! What is said of the selected heart in words, with its evidence beside the normal hearts and the rule behind it.

use crate::analysis::verdicts::{
    Familiarity, Finding, RuleQuality, RuleSource, Verdict, VerdictParams, Verdicts,
};
use crate::app::state::State;
use crate::app::views::evidence::evidence;
use crate::engine::{Interrupted, Showing};
use crate::picture::percent;
use crate::study::LabelRole;
use crate::ui::{
    AlikeHeart, Chance, CohortVerdict, Familiar, RuleTold, ToldVerdict, VerdictMark,
    VerdictPanelView, VerdictState,
};

/// Share of the hearts that a rule has seen that lie as far from the others: below it, a heart is unlike them.
const UNLIKE: f64 = 0.05;

/// Texts of the verdict pane.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct VerdictData {
    state: VerdictState,
    told: Option<ToldVerdict>,
    rule: Option<RuleTold>,
}

impl VerdictData {
    /// What is known of the selected heart.
    pub fn of(state: &State) -> Self {
        Self {
            state: verdict_state(state),
            told: told(state),
            rule: state.verdicts().map(|(verdicts, _)| rule_told(verdicts)),
        }
    }

    /// Whether verdicts are still to come.
    pub fn judging(&self) -> bool {
        let state = &self.state;
        matches!(
            state,
            VerdictState::Waiting | VerdictState::Computing { .. }
        )
    }

    /// What the pane shows.
    pub fn view<'a>(&'a self, state: &'a State) -> VerdictPanelView<'a> {
        VerdictPanelView {
            subject: state.document.selected().map(|subject| &*subject.id),
            state: &self.state,
            told: self.told.as_ref(),
            rule: self.rule.as_ref(),
        }
    }
}

fn verdict_state(state: &State) -> VerdictState {
    if state.document.selected().is_none() {
        return VerdictState::Empty;
    }
    match &state.answers.verdicts {
        Some(Showing::Ready(_)) => VerdictState::Ready,
        // Statistics of the cohort wait until nothing else is computed.
        Some(Showing::Computing { watch, .. }) if watch.elapsed().is_zero() => {
            VerdictState::Waiting
        }
        Some(Showing::Computing { watch, .. }) => VerdictState::Computing {
            fraction: watch.fraction(),
            phase: watch.phase(),
            seconds_left: watch.time_left().map(|left| left.as_secs_f64()),
        },
        Some(Showing::Interrupted { why, .. }) => match why {
            Interrupted::Stopped => VerdictState::Stopped,
            Interrupted::Failed(error) => VerdictState::Failed(error.to_string()),
        },
        None => VerdictState::Waiting,
    }
}

/// What is said of the selected heart. A wall that cannot be assessed says so before all others are judged.
fn told(state: &State) -> Option<ToldVerdict> {
    let subject = state.document.subject;
    let not_assessed = |why: String| ToldVerdict {
        mark: VerdictMark::NotAssessed,
        heading: "Not assessed".to_owned(),
        sentence: crate::picture::sentence(&why),
        ..ToldVerdict::default()
    };
    match (state.verdict_of(subject), state.wall_of(subject)) {
        (Some(Ok(verdict)), _) => {
            let (verdicts, _) = state.verdicts()?;
            Some(told_of(state, verdicts, verdict))
        }
        (Some(Err(reason)), _) => Some(not_assessed(reason.to_string())),
        (None, Some((Err(why), true))) => Some(not_assessed(why.clone())),
        (None, _) => None,
    }
}

fn told_of(state: &State, verdicts: &Verdicts, verdict: &Verdict) -> ToldVerdict {
    let study = state.document.study();
    let role = (state.document.selected()).map_or(LabelRole::Unknown, |heart| study.role(heart));
    let calibrated = matches!(verdicts.rule, RuleSource::Cohort { .. });
    ToldVerdict {
        mark: mark(verdict.finding),
        heading: heading(verdict),
        sentence: sentence(verdict),
        probability: Some(verdict.probability),
        calibrated,
        source: match (calibrated, role) {
            (false, _) => "By a fixed rule: too few hearts with a label",
            (true, LabelRole::Unknown) => {
                "By the rule of the labelled hearts; this one is not of them"
            }
            (true, _) => "By a rule that has not seen this heart",
        },
        familiar: verdict.familiarity.as_ref().map(familiar),
        evidence: evidence(study, verdicts, &verdict.features),
        alike: [&verdict.alike_normal, &verdict.alike_abnormal].map(|hearts| {
            hearts
                .iter()
                .filter_map(|&heart| alike(state, heart))
                .collect()
        }),
    }
}

fn mark(finding: Finding) -> VerdictMark {
    match finding {
        Finding::Nothing => VerdictMark::Nothing,
        Finding::Patch => VerdictMark::Patch,
        Finding::GlobalFailure => VerdictMark::Global,
        Finding::Elsewhere => VerdictMark::Elsewhere,
    }
}

/// "Abnormal patch · 31 % of the LV".
fn heading(verdict: &Verdict) -> String {
    match verdict.finding {
        Finding::Nothing => "No abnormal patch".to_owned(),
        Finding::Patch => format!("Abnormal patch · {} of the LV", percent(verdict.patched)),
        Finding::GlobalFailure => "Global failure".to_owned(),
        Finding::Elsewhere => "Abnormal without a patch".to_owned(),
    }
}

/// What the finding means, with what could be mistaken for another one.
fn sentence(verdict: &Verdict) -> String {
    let little = (verdict.patched > 0.0)
        .then(|| format!("; {} of it thickens little", percent(verdict.patched)));
    let little = little.unwrap_or_default();
    match verdict.finding {
        Finding::Nothing => format!("The wall thickens as in normal hearts{little}"),
        Finding::Patch => "A part of the wall does not thicken as the rest does".to_owned(),
        Finding::GlobalFailure => {
            "The whole wall thickens too little, and no part of it stands out".to_owned()
        }
        Finding::Elsewhere => {
            "Unlike the normal hearts, but the wall thickens and no part of it stands still"
                .to_owned()
        }
    }
}

fn familiar(found: &Familiarity) -> Familiar {
    let times = found.distance / found.usual.max(f64::MIN_POSITIVE);
    let times = if times < 9.95 {
        format!("{times:.1} ×")
    } else {
        format!("{times:.0} ×")
    };
    let unlike = found.as_far < UNLIKE;
    let words = if unlike {
        format!(
            "Unlike what the rule has seen: {times} the usual distance, farther than {} of its hearts. Take the \
             verdict with care",
            percent(1.0 - found.as_far)
        )
    } else {
        format!(
            "Like what the rule has seen: {times} the usual distance; {} of its hearts lie as far from the others",
            percent(found.as_far)
        )
    };
    Familiar { words, unlike }
}

fn alike(state: &State, subject: usize) -> Option<AlikeHeart> {
    let study = state.document.study();
    let heart = state.subject(subject)?;
    let verdict = cohort_verdict(state, subject).map(|verdict| verdict.text());
    Some(AlikeHeart {
        subject,
        id: heart.id.clone(),
        label: heart.label.clone().unwrap_or_else(|| "no label".to_owned()),
        role: study.role(heart),
        verdict: verdict.unwrap_or_default(),
    })
}

/// What the cohort table says of one heart.
pub fn cohort_verdict(state: &State, subject: usize) -> Option<CohortVerdict> {
    let calibrated = matches!(state.verdicts()?.0.rule, RuleSource::Cohort { .. });
    Some(match state.verdict_of(subject)? {
        Ok(verdict) => {
            let number = if calibrated {
                format!(
                    "{:.0} % probability of being abnormal",
                    100.0 * verdict.probability
                )
            } else {
                format!("score {:.2}, no probability", verdict.probability)
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

fn rule_told(verdicts: &Verdicts) -> RuleTold {
    let source = match verdicts.rule {
        RuleSource::Cohort { normal, abnormal } => format!(
            "Learnt from the hearts with a label that can be assessed, {normal} normal and {abnormal} abnormal; each \
             is judged by a rule that has not seen it (leave-one-out)"
        ),
        RuleSource::Uncalibrated { normal, abnormal } => format!(
            "Not learnt, uncalibrated: {normal} normal and {abnormal} abnormal hearts with a label can be assessed, \
             and {} of each are needed. A fixed rule stands in: how much of the wall stands still",
            VerdictParams::default().least_labelled
        ),
    };
    let results = match (verdicts.rule, &verdicts.quality) {
        (RuleSource::Cohort { normal, abnormal }, Some(quality)) => {
            results(quality, normal, abnormal).to_vec()
        }
        _ => Vec::new(),
    };
    RuleTold { source, results }
}

fn results(quality: &RuleQuality, normal: usize, abnormal: usize) -> [Chance; 4] {
    let accuracy = &quality.accuracy;
    [
        Chance {
            name: "Right answers",
            what: "Hearts whose label agrees with the verdict of a rule that has not seen them",
            value: format!(
                "{} of {} · {}",
                accuracy.correct,
                accuracy.of,
                percent(accuracy.share())
            ),
            chance: format!(
                "by chance {:.1} · p {}",
                accuracy.baseline * accuracy.of as f64,
                p_text(accuracy.p_value)
            ),
        },
        Chance {
            name: "AUC",
            what: "Area under the ROC curve: how often an abnormal heart has a higher score than a normal one; \
                   leaving out pulls chance below one half",
            value: format!("{:.2}", quality.auc),
            chance: format!(
                "by chance {:.2} · p {}",
                quality.auc_baseline,
                p_text(quality.auc_p_value)
            ),
        },
        Chance {
            name: "False alarms",
            what: "Hearts with a normal label that are called abnormal",
            value: format!("{} of {normal} normal", quality.false_alarms),
            chance: String::new(),
        },
        Chance {
            name: "Missed",
            what: "Hearts with an abnormal label that are called normal",
            value: format!("{} of {abnormal} abnormal", quality.missed),
            chance: String::new(),
        },
    ]
}

fn p_text(p: f64) -> String {
    if p < 0.001 {
        "< 0.001".to_owned()
    } else if p < 0.1 {
        format!("{p:.3}")
    } else {
        format!("{p:.2}")
    }
}

#[cfg(test)]
mod tests;
