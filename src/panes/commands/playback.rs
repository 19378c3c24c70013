//! Commands about the place in the cycle of the selected subject, and about playing.

use super::action::{Menu, NONE, Row, SHIFT, row};
use egui::Key;

/// Commands about the place in the cycle of the selected subject, and about playing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PlaybackCommand {
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
pub(super) static ACTIONS: &[Row<PlaybackCommand>] = &[
    row(Menu::Analysis, 0, "Play or pause", Some((NONE, Key::Space)), PlaybackCommand::TogglePlay),
    row(Menu::Analysis, 0, "Loop", None, PlaybackCommand::ToggleLoop),
    row(Menu::Analysis, 0, "Loop from this frame", Some((NONE, Key::OpenBracket)), PlaybackCommand::LoopFromHere),
    row(Menu::Analysis, 0, "Loop up to this frame", Some((NONE, Key::CloseBracket)), PlaybackCommand::LoopToHere),
    row(Menu::Analysis, 0, "Play the whole cycle", None, PlaybackCommand::SetLoopRange(None)),
    row(Menu::Analysis, 0, "Next frame", Some((NONE, Key::ArrowRight)), PlaybackCommand::StepFrame(1)),
    row(Menu::Analysis, 0, "Previous frame", Some((NONE, Key::ArrowLeft)), PlaybackCommand::StepFrame(-1)),
    row(Menu::Analysis, 0, "Go to end-diastole", Some((SHIFT, Key::ArrowLeft)), PlaybackCommand::GoToEndDiastole),
    row(Menu::Analysis, 0, "Go to end-systole", Some((SHIFT, Key::ArrowRight)), PlaybackCommand::GoToEndSystole),
];
