//! The pane "Activity": its word, title, place and how it is drawn.

use egui::Ui;

use super::activity_ui;
use crate::panes::commands::{Command, Pane};
use crate::panes::pane::{Header, PaneSpec, Place};
use crate::panes::pane_context::PaneContext;

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
    figure: None,
    ui,
};

fn ui(ui: &mut Ui, cx: &PaneContext<'_>, commands: &mut Vec<Command>) {
    activity_ui(ui, cx.activities(), commands);
}
