//! The pane "Patch": its word, title, place and how it is drawn.

use egui::Ui;

use crate::panes::commands::{Command, Pane};
use crate::panes::pane::{Header, PaneSpec, Place};
use crate::panes::pane_context::PaneContext;
use crate::panes::viewport::viewport::Viewport;

use super::patch_panel_ui;
use super::view::patch_view;

impl Pane {
    /// Regions of low thickening, and the thresholds.
    pub const PATCH: Self = Self::named("patch");
}

/// Regions of low thickening, and the thresholds.
pub const PANE: PaneSpec = PaneSpec {
    pane: Pane::PATCH,
    title: "Patch",
    toggle: "Pane: patch",
    open: Some((3, "Patch table and thresholds")),
    place: Place::BelowLeft,
    header: Header::Title,
    figure: None,
    ui,
};

fn ui(ui: &mut Ui, cx: &PaneContext<'_>, commands: &mut Vec<Command>) {
    let viewport = cx.memo().get::<Viewport>();
    let view = patch_view(cx.state(), viewport.borrow_mut().shown().first());
    patch_panel_ui(ui, &view, commands);
}
