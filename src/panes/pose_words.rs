//! What is said of the pose on screen: recorded, interpolated along a geodesic, or straight between frames and why.

use crate::document::interpolated_poses::{BetweenWords, between_words, geodesic_params};
use crate::document::state::State;

/// What is said of the pose on screen of a subject.
pub fn between_words_of(state: &State, subject: usize, position: f64) -> BetweenWords {
    let motion = state.interpolated_poses_of(subject).map(|motion| &**motion);
    between_words(motion, position, straight_because(state))
}

/// Why interpolated poses are linear interpolations, where that is not for want of time.
pub fn straight_because(state: &State) -> &'static str {
    let Some(params) = geodesic_params(&state.document) else {
        return "Interpolated poses are off (menu Analysis)";
    };
    let motion = state.answers.interpolated_poses(state.document.subject);
    let stopped = motion.is_some_and(|motion| motion.stopped);
    if params.check().is_err() {
        "The metric of the map has no geodesics: choose the additive form"
    } else if stopped {
        "The computation of interpolated poses was stopped"
    } else {
        ""
    }
}

/// What the line of the time bar says to whoever points at it.
pub fn line_note(state: &State, between: BetweenWords) -> String {
    if between.badge.is_some() {
        return between.note;
    }
    match state.document.interpolated_poses {
        0 => "Interpolated poses are off (menu Analysis)".to_owned(),
        1 => "1 interpolated pose per interval, computed while the subject plays".to_owned(),
        count => {
            format!("{count} interpolated poses per interval, computed while the subject plays")
        }
    }
}
