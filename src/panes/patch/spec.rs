//! The pane in the window's table. Regions of low thickening, and the thresholds.

use egui::Ui;

use crate::panes::commands::{Command, Pane};
use crate::panes::look::Look;
use crate::panes::pane::{Header, PaneSpec, Place};
use crate::panes::viewport::hearts::Viewport;

use super::patch_panel_ui;
use super::view::PatchData;

impl Pane {
    /// Regions of low thickening, and the thresholds.
    pub const PATCH: Self = Self::named("patch");
}

/// Regions of low thickening, and the thresholds.
pub const PANE: PaneSpec = PaneSpec {
    pane: Pane::PATCH,
    title: "Patch",
    toggle: "Pane: patch",
    place: Place::BelowLeft,
    header: Header::Title,
    ui,
};

/// The regions of the selected subject as they are on screen.
pub fn patch_data(look: &Look<'_>) -> PatchData {
    let viewport = look.memo().get::<Viewport>();
    PatchData::of(look.state(), viewport.borrow_mut().shown().first())
}

fn ui(ui: &mut Ui, look: &Look<'_>, commands: &mut Vec<Command>) {
    patch_panel_ui(ui, &patch_data(look).view(look.state()), commands);
}
