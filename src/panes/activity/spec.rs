//! The pane in the window's table. Finished and running work.

use egui::Ui;

use super::activity_ui;
use crate::panes::commands::{Command, Pane};
use crate::panes::look::Look;
use crate::panes::pane::{Header, PaneSpec, Place};

impl Pane {
    /// Finished and running work.
    pub const ACTIVITY: Self = Self::named("activity");
}

/// Finished and running work.
pub const PANE: PaneSpec = PaneSpec {
    pane: Pane::ACTIVITY,
    title: "Activity",
    toggle: "Pane: activity",
    open: None,
    place: Place::Left,
    header: Header::Title,
    ui,
};

fn ui(ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
    activity_ui(ui, look.activities(), commands);
}
