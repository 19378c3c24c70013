//! Commands that select subjects.

use crate::document::state::State;
use crate::panes::SelectCommand;
use crate::panes::cohort::view::visible_subjects;

use super::change::{Moment, change};

/// Applies a command about which subjects are shown.
pub fn apply(state: &mut State, command: SelectCommand, moment: &Moment) {
    if !matches!(command, SelectCommand::CompareWith(_)) {
        state.awaited = None;
    }
    match command {
        SelectCommand::SelectPose {
            subject,
            frame,
            play,
        } => select_pose(state, moment, subject, frame, play),
        SelectCommand::SelectSubject(subject) => {
            if subject < state.document.study().count() {
                change(state, moment, None, |d| d.select_subject(subject));
            }
        }
        SelectCommand::StepSubject(step) => step_subject(state, moment, step),
        SelectCommand::CompareWith(subject) => {
            change(state, moment, None, |d| d.compare_with = subject);
        }
    }
}

fn select_pose(state: &mut State, moment: &Moment, subject: usize, frame: usize, play: bool) {
    let Some(shown) = state.subject(subject) else {
        return;
    };
    let frames = shown.sequence.frame_count();
    change(state, moment, None, |document| {
        document.select_subject_at(subject, frame.min(frames - 1) as f64);
    });
    state.play.playing = play && frames > 1;
}

fn step_subject(state: &mut State, moment: &Moment, step: i32) {
    let rows = visible_subjects(state);
    let count = rows.len() as i64;
    if count == 0 {
        return;
    }
    let row = rows.iter().position(|row| *row == state.document.subject);
    // From a subject that the filter hides, the first step leads to the first or last row.
    let here = row.map_or(if step > 0 { -1 } else { 0 }, |row| row as i64);
    let next = (here + i64::from(step)).rem_euclid(count) as usize;
    change(state, moment, None, |document| {
        document.select_subject(rows[next]);
    });
}
