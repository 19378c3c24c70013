//! The status bar: what runs, how far it is, what was found while reading.

use crate::app::{StatusBarView, StatusJob};
use crate::document::state::State;
use crate::engine::{Activity, ActivityState};
use crate::study::Severity;

/// Work shorter than this shows no bar: it would only flicker.
const SHOWN_AFTER_S: f64 = 0.2;

/// What runs now and what was found while reading.
pub fn status_bar_view<'a>(
    state: &'a State,
    running: Vec<Activity>,
    adapter: &'a str,
) -> StatusBarView<'a> {
    let mut shown = running;
    shown.retain(|activity| activity.asked_ago.as_secs_f64() >= SHOWN_AFTER_S);
    // The oldest is told of: it holds up what the user asked for first.
    let job = shown.pop().map(|activity| {
        let (fraction, phase, left) = match activity.state {
            ActivityState::Running {
                fraction,
                phase,
                time_left,
            } => (fraction, phase, time_left.map(|left| left.as_secs_f64())),
            _ => (1.0, "", None),
        };
        StatusJob {
            topic: activity.topic,
            text: match phase {
                "" => activity.name,
                _ => format!("{}: {phase}", activity.name),
            },
            fraction,
            seconds_left: left,
        }
    });
    let (study, report) = (state.document.study(), &state.document.study.report);
    let notices = study.all().flat_map(|subject| &subject.notices);
    let severities = notices.chain(&report.notices).map(|notice| notice.severity);
    let (warnings, notes): (Vec<_>, Vec<_>) =
        severities.partition(|severity| *severity == Severity::Warning);
    let warning_count = warnings.len() + report.errors.len();
    StatusBarView {
        job,
        more_jobs: shown.len(),
        message: &state.message,
        adapter,
        notice_count: notes.len() + warning_count,
        warning_count,
    }
}
