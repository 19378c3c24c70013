//! The pane "Verdict": its word, title, place and how it is drawn.

use egui::Ui;

use super::verdict_panel_ui;
use super::view::verdict_view;
use crate::panes::commands::{Command, Pane};
use crate::panes::pane::{Header, PaneSpec, Place};
use crate::panes::pane_context::PaneContext;

impl Pane {
    /// The verdict on the selected subject, with its evidence.
    pub const VERDICT: Self = Self::named("verdict");
}

/// The verdict on the selected subject, with its evidence.
pub const PANE: PaneSpec = PaneSpec {
    pane: Pane::VERDICT,
    title: "Verdict",
    toggle: "Pane: verdict",
    open: Some((3, "Verdict")),
    place: Place::BelowLeft,
    header: Header::Title,
    figure: None,
    ui,
};

fn ui(ui: &mut Ui, cx: &PaneContext<'_>, commands: &mut Vec<Command>) {
    verdict_panel_ui(ui, &verdict_view(cx.state()), commands);
}
