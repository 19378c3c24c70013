//! The pane "Deformations": its word, title, place and how it is drawn.

use egui::Ui;

use super::figure::FIGURE;
use super::view::with_view;
use super::{deformation_header_ui, deformation_map_ui};
use crate::panes::commands::{Command, Pane};
use crate::panes::pane::{Header, PaneSpec, Place};
use crate::panes::pane_context::PaneContext;

impl Pane {
    /// The map of whole deformations.
    pub const DEFORMATION_MAP: Self = Self::named("deformation_map");
}

/// The map of whole deformations.
pub const PANE: PaneSpec = PaneSpec {
    pane: Pane::DEFORMATION_MAP,
    title: "Deformations",
    toggle: "Pane: deformations",
    open: Some((2, "Deformation map")),
    place: Place::Above,
    header: Header::Beside(note_ui),
    figure: Some(FIGURE),
    ui,
};

fn note_ui(ui: &mut Ui, cx: &PaneContext<'_>, taken: f32, commands: &mut Vec<Command>) {
    with_view(ui, cx, |ui, view| {
        deformation_header_ui(ui, view, taken, commands);
    });
}

fn ui(ui: &mut Ui, cx: &PaneContext<'_>, commands: &mut Vec<Command>) {
    with_view(ui, cx, |ui, view| deformation_map_ui(ui, view, commands));
}
