//! The pane "Medial": its word, title, place and how it is drawn.

use egui::Ui;

use super::figure::FIGURE;
use super::medial_map_choosers_ui;
use super::view::medial_map_ui;
use crate::panes::commands::{Command, Pane};
use crate::panes::pane::{Header, PaneSpec, Place};
use crate::panes::pane_context::PaneContext;

impl Pane {
    /// The map of the medial shape space.
    pub const MEDIAL_MAP: Self = Self::named("medial_map");
}

/// The map of the medial shape space.
pub const PANE: PaneSpec = PaneSpec {
    pane: Pane::MEDIAL_MAP,
    title: "Medial",
    toggle: "Pane: medial map",
    open: Some((2, "Medial map")),
    place: Place::Above,
    header: Header::Named(choosers_ui),
    figure: Some(FIGURE),
    ui: medial_map_ui,
};

fn choosers_ui(ui: &mut Ui, cx: &PaneContext<'_>, taken: f32, commands: &mut Vec<Command>) {
    if ui.available_width() - taken > 90.0 {
        medial_map_choosers_ui(ui, cx.state().document.map.method, commands);
    }
}
