//! Commands about the place in the cycle of the selected subject, and about playing.

use crate::document::document::position_at_phase;
use crate::document::image_timing;
use crate::document::loop_range::LoopRange;
use crate::document::state::State;
use crate::document::undo::Gesture;
use crate::panes::PlaybackCommand;

use super::change::{Moment, change};

/// Applies a command about time.
pub fn apply(state: &mut State, command: PlaybackCommand, moment: &Moment) {
    match command {
        PlaybackCommand::SetPosition(position) => {
            state.play.playing = false;
            move_to(state, moment, position);
        }
        PlaybackCommand::StepFrame(step) => step_frame(state, moment, step),
        PlaybackCommand::GoToEndDiastole => {
            go_to(state, moment, state.phases_of(state.document.subject).0);
        }
        PlaybackCommand::GoToEndSystole => {
            go_to(state, moment, state.phases_of(state.document.subject).1);
        }
        PlaybackCommand::TogglePlay => toggle_play(state),
        PlaybackCommand::SetSpeed(speed) => state.play.set_speed(speed),
        PlaybackCommand::ToggleLoop => state.play.repeat = !state.play.repeat,
        PlaybackCommand::SetLoopRange(frames) => set_loop_range(state, moment, frames),
        PlaybackCommand::LoopFromHere | PlaybackCommand::LoopToHere => {
            let document = &state.document;
            let (here, count) = (document.frame(), document.frame_count());
            let [from, to] = document.loop_frames().unwrap_or([0, count]);
            let frames = match command {
                PlaybackCommand::LoopFromHere => [here, if to > here { to } else { count }],
                // The first frame is also the end of the cycle.
                _ if here == 0 => [from, count],
                _ => [if from < here { from } else { 0 }, here],
            };
            set_loop_range(state, moment, Some(frames));
        }
    }
}

/// Moves what plays on by so many seconds: the motion of the selected subject, else the images on screen.
pub fn advance(state: &mut State, elapsed_s: f64) {
    let (document, play) = (&mut state.document, &mut state.play);
    let at = document.position;
    (document.position, play.playing) = match (document.selected(), document.shown_series()) {
        (Some(subject), _) => play.advance(subject, at, document.loop_range, elapsed_s),
        (None, Some(series)) => {
            let timing = image_timing(series);
            play.advance_images(&timing, document.instant_count(), at, elapsed_s)
        }
        (None, None) => return,
    };
}

fn step_frame(state: &mut State, moment: &Moment, step: i32) {
    state.play.playing = false;
    let count = state.document.frame_count() as i64;
    let position = state.document.position;
    // From between two poses, a step forward leads to the next one, a step back to the one before.
    let start = if step > 0 {
        position.floor()
    } else {
        position.ceil()
    };
    let frame = (start as i64 + i64::from(step)).rem_euclid(count);
    move_to(state, moment, frame as f64);
}

fn go_to(state: &mut State, moment: &Moment, frame: Option<usize>) {
    if let Some(frame) = frame {
        state.play.playing = false;
        move_to(state, moment, frame as f64);
    }
}

fn move_to(state: &mut State, moment: &Moment, position: f64) {
    if position.is_finite() {
        change(state, moment, Some(Gesture::Time), |document| {
            document.move_to(position);
        });
    }
}

/// Frames that make no range of the selected subject change nothing.
fn set_loop_range(state: &mut State, moment: &Moment, frames: Option<[usize; 2]>) {
    let range = frames
        .zip(state.document.selected())
        .and_then(|(frames, subject)| LoopRange::of_frames(subject, frames));
    if range.is_some() || frames.is_none() {
        change(state, moment, Some(Gesture::LoopRange), |document| {
            document.loop_range = range;
        });
    }
}

fn toggle_play(state: &mut State) {
    let Some(subject) = state.document.selected() else {
        // Images of which no subject is made.
        state.play.playing = !state.play.playing && state.document.frame_count() > 1;
        return;
    };
    let count = subject.sequence.frame_count();
    state.play.playing = !state.play.playing && count > 1;
    let last = count.saturating_sub(1);
    let [from, to] = state.document.loop_frames().unwrap_or([0, last]);
    let at_end = state.document.position >= to.min(last) as f64;
    if state.play.playing && !state.play.repeat && at_end {
        state.document.position = match from {
            0 => position_at_phase(subject, 0.0),
            frame => frame as f64,
        };
    }
}
