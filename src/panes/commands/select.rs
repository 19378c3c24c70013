//! Commands that select subjects.

use super::action::{Menu, NONE, Row, SHIFT, row};
use egui::Key;

/// Commands that select subjects.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum SelectCommand {
    /// Show a subject at a frame and, from a map, play its motion.
    SelectPose {
        /// Index into the study's subjects.
        subject: usize,
        /// Frame of its sequence.
        frame: usize,
        /// Whether to play on from there.
        play: bool,
    },
    /// Show a subject, keeping the phase.
    SelectSubject(usize),
    /// The next subject of the table, or the one before for −1.
    StepSubject(i32),
    /// The second subject of the side-by-side view.
    CompareWith(Option<usize>),
}

/// Those that need no more than a name: one line each, a table is read as a table.
#[rustfmt::skip]
pub(super) static ACTIONS: &[Row<SelectCommand>] = &[
    row(Menu::Edit, 1, "Next subject", Some((NONE, Key::Tab)), SelectCommand::StepSubject(1)),
    row(Menu::Edit, 1, "Previous subject", Some((SHIFT, Key::Tab)), SelectCommand::StepSubject(-1)),
];
