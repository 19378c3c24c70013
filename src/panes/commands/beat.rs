//! Commands about the selected subject and the place in its cycle.

use super::action::{Menu, NONE, Row, SHIFT, row};
use egui::Key;

/// Commands about the selected subject and the place in its cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum BeatCommand {
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
    /// Move to a position in the cycle, counted in frames; fractions lie between poses.
    SetPosition(f64),
    /// Whole frames forward or back.
    StepFrame(i32),
    /// Jump to end-diastole.
    GoToEndDiastole,
    /// Jump to end-systole.
    GoToEndSystole,
    /// Play or pause.
    TogglePlay,
    /// Speed relative to the recorded motion: 1 is real time.
    SetSpeed(f32),
    /// Whether playing starts over.
    ToggleLoop,
    /// Play only from one frame to another; the frame after the last is the end of the cycle. `None` plays all.
    SetLoopRange(Option<[usize; 2]>),
    /// The part that plays begins at the frame on screen.
    LoopFromHere,
    /// The part that plays ends at the frame on screen.
    LoopToHere,
}

/// Those that need no more than a name: one line each, a table is read as a table.
#[rustfmt::skip]
pub(super) static ACTIONS: &[Row<BeatCommand>] = &[
    row(Menu::Edit, 1, "Next subject", Some((NONE, Key::Tab)), BeatCommand::StepSubject(1)),
    row(Menu::Edit, 1, "Previous subject", Some((SHIFT, Key::Tab)), BeatCommand::StepSubject(-1)),
    row(Menu::Analysis, 0, "Play or pause", Some((NONE, Key::Space)), BeatCommand::TogglePlay),
    row(Menu::Analysis, 0, "Loop", None, BeatCommand::ToggleLoop),
    row(Menu::Analysis, 0, "Loop from this frame", Some((NONE, Key::OpenBracket)), BeatCommand::LoopFromHere),
    row(Menu::Analysis, 0, "Loop up to this frame", Some((NONE, Key::CloseBracket)), BeatCommand::LoopToHere),
    row(Menu::Analysis, 0, "Play the whole cycle", None, BeatCommand::SetLoopRange(None)),
    row(Menu::Analysis, 0, "Next frame", Some((NONE, Key::ArrowRight)), BeatCommand::StepFrame(1)),
    row(Menu::Analysis, 0, "Previous frame", Some((NONE, Key::ArrowLeft)), BeatCommand::StepFrame(-1)),
    row(Menu::Analysis, 0, "Go to end-diastole", Some((SHIFT, Key::ArrowLeft)), BeatCommand::GoToEndDiastole),
    row(Menu::Analysis, 0, "Go to end-systole", Some((SHIFT, Key::ArrowRight)), BeatCommand::GoToEndSystole),
];
