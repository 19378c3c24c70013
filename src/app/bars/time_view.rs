//! What the time bar shows of the selected subject.

use crate::document::State;
use crate::panes::beat::BeatData;

use super::time_bar::TimeBarView;

/// The time bar of a state.
pub fn time_bar_view<'a>(beat: &'a BeatData, state: &State) -> TimeBarView<'a> {
    let document = &state.document;
    let (end_diastole, end_systole) = state.phases_of(document.subject);
    let time = document.selected().and_then(|subject| {
        let count = subject.sequence.frame_count();
        subject.timing.time_at(document.position, count)
    });
    TimeBarView {
        playing: state.play.playing,
        speed: state.play.speed,
        looping: state.play.repeat,
        position: document.position,
        axis: beat.axis(),
        end_diastole,
        end_systole,
        time_ms: time.map(|time| 1e3 * time.0),
        between: beat.between.short,
        interpolated_poses: &beat.interpolated_poses,
        note: &beat.note,
    }
}
