//! The status bar and the activity list: what runs, how far it is, what was done.

use crate::app::{StatusBarView, StatusJob};
use crate::document::state::State;
use crate::engine::{Activity, ActivityState, Topic};
use crate::study::Severity;

/// Work shorter than this shows no bar: it would only flicker.
const SHOWN_AFTER_S: f64 = 0.2;

/// Owned texts behind the status bar.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StatusData {
    job: Option<(Topic, String, f32, Option<f64>)>,
    more_jobs: usize,
    notice_count: usize,
    warning_count: usize,
}

impl StatusData {
    /// What runs now and what was found while reading.
    pub fn of(state: &State, running: &[Activity]) -> Self {
        let shown: Vec<&Activity> = running
            .iter()
            .filter(|activity| activity.asked_ago.as_secs_f64() >= SHOWN_AFTER_S)
            .collect();
        // The oldest is told of: it holds up what the user asked for first.
        let job = shown.last().map(|activity| {
            let (fraction, phase, left) = match activity.state {
                ActivityState::Running {
                    fraction,
                    phase,
                    time_left,
                } => (fraction, phase, time_left.map(|left| left.as_secs_f64())),
                _ => (1.0, "", None),
            };
            let text = if phase.is_empty() {
                activity.name.clone()
            } else {
                format!("{}: {phase}", activity.name)
            };
            (activity.topic, text, fraction, left)
        });
        let severities = || {
            let study = state.document.study();
            study
                .subjects
                .iter()
                .flat_map(|subject| &subject.notices)
                .chain(&state.document.study.report.notices)
                .map(|notice| notice.severity)
        };
        let errors = state.document.study.report.errors.len();
        Self {
            job,
            more_jobs: shown.len().saturating_sub(1),
            notice_count: severities().count() + errors,
            warning_count: severities()
                .filter(|severity| *severity == Severity::Warning)
                .count()
                + errors,
        }
    }

    /// What the status bar shows.
    pub fn view<'a>(&'a self, state: &'a State, adapter: &'a str) -> StatusBarView<'a> {
        StatusBarView {
            job: self
                .job
                .as_ref()
                .map(|(kind, text, fraction, left)| StatusJob {
                    kind: *kind,
                    text,
                    fraction: *fraction,
                    seconds_left: *left,
                }),
            more_jobs: self.more_jobs,
            message: &state.message,
            adapter,
            notice_count: self.notice_count,
            warning_count: self.warning_count,
        }
    }
}
