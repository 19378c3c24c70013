//! Commands about transported motions and interpolated poses.

use super::action::{Menu, NONE, Row, row};
use egui::Key;

/// Commands about transported motions and interpolated poses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TransportCommand {
    /// Transport the motion of one subject to another, and show both side by side.
    TransportMotion {
        /// Subject of the motion.
        from: usize,
        /// Subject that it is transported to.
        onto: usize,
    },
    /// Transport the motion of the selected subject to the other one of the side-by-side view.
    TransportToOther,
    /// Show the other subject with its own motion again.
    StopTransport,
    /// How many poses are computed between two frames; 0 blends frames straight.
    SetInterpolatedPoses(u16),
    /// Poses forward or back, those between frames included.
    StepPose(i32),
}

/// Those that need no more than a name: one line each, a table is read as a table.
#[rustfmt::skip]
pub(super) static ACTIONS: &[Row<TransportCommand>] = &[
    row(Menu::Analysis, 0, "Next pose, recorded or interpolated", Some((NONE, Key::Period)), TransportCommand::StepPose(1)),
    row(Menu::Analysis, 0, "Previous pose, recorded or interpolated", Some((NONE, Key::Comma)), TransportCommand::StepPose(-1)),
    row(Menu::Analysis, 4, "Interpolated poses: off", None, TransportCommand::SetInterpolatedPoses(0)),
    row(Menu::Analysis, 4, "Interpolated poses: 1 per interval", None, TransportCommand::SetInterpolatedPoses(1)),
    row(Menu::Analysis, 4, "Interpolated poses: 3 per interval", None, TransportCommand::SetInterpolatedPoses(3)),
    row(Menu::Analysis, 4, "Interpolated poses: 7 per interval", None, TransportCommand::SetInterpolatedPoses(7)),
    row(Menu::Analysis, 5, "Transport motion to the other subject", Some((NONE, Key::T)), TransportCommand::TransportToOther),
    row(Menu::Analysis, 5, "Show own motion", None, TransportCommand::StopTransport),
];
