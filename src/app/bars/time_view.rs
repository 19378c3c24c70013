//! What the time bar shows of the selected subject.

use crate::document::{State, image_timing};
use crate::panes::cycle_axis::CycleAxis;
use crate::panes::pose_words::{between_words_of, line_note};

use super::time_bar::TimeBarView;

/// The time bar of a state.
pub fn time_bar_view(state: &State) -> TimeBarView {
    let document = &state.document;
    let Some(subject) = document.selected() else {
        return image_view(state);
    };
    let (end_diastole, end_systole) = state.phases_of(document.subject);
    let between = between_words_of(state, document.subject, document.position);
    let motion = state.interpolated_poses_of(document.subject);
    let count = subject.sequence.frame_count();
    let time = subject.timing.time_at(document.position, count);
    TimeBarView {
        playing: state.play.playing,
        speed: state.play.speed,
        looping: state.play.repeat,
        loop_frames: document.loop_frames(),
        escape_ends_range: document.loop_range.is_some() && document.search.is_empty(),
        position: document.position,
        axis: CycleAxis::of(subject),
        end_diastole,
        end_systole,
        time_ms: time.map(|time| 1e3 * time.0),
        cycle_ms: subject.timing.rr.map(|rr| 1e3 * rr.0),
        between: between.short,
        interpolated_poses: motion.map_or_else(Vec::new, |motion| motion.positions()),
        note: line_note(state, between),
    }
}

/// The time bar of images of which no subject is made.
fn image_view(state: &State) -> TimeBarView {
    let document = &state.document;
    let Some(series) = document.shown_series() else {
        return TimeBarView::default();
    };
    let (timing, count) = (image_timing(series), document.instant_count());
    // Between two instants the nearer one is on screen.
    let instant = document.instant();
    TimeBarView {
        playing: state.play.playing,
        speed: state.play.speed,
        looping: state.play.repeat,
        position: document.position,
        axis: CycleAxis::of_instants(&timing, count),
        time_ms: timing
            .time_at(instant as f64, count)
            .map(|time| 1e3 * time.0),
        cycle_ms: timing.rr.map(|rr| 1e3 * rr.0),
        ..TimeBarView::default()
    }
}
