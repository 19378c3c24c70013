//! The pane "Thickness": its word, title, place and how it is drawn.

use egui::Ui;

use super::thickness_panel_ui;
use super::view::{ask_thickness, thickness_view};
use crate::panes::commands::{Command, Pane};
use crate::panes::pane::{Header, PaneSpec, Place};
use crate::panes::pane_context::PaneContext;

impl Pane {
    /// Wall thickness by several methods.
    pub const THICKNESS: Self = Self::named("thickness");
}

/// Wall thickness by several methods.
pub const PANE: PaneSpec = PaneSpec {
    pane: Pane::THICKNESS,
    title: "Thickness",
    toggle: "Pane: thickness",
    open: Some((3, "Wall thickness by five methods")),
    place: Place::BelowRight,
    header: Header::Title,
    figure: None,
    ui,
};

fn ui(ui: &mut Ui, cx: &PaneContext<'_>, commands: &mut Vec<Command>) {
    let poses = ask_thickness(cx);
    thickness_panel_ui(ui, &thickness_view(cx.state(), &poses), commands);
}
