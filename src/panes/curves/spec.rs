//! The pane "Volume": its word, title, place and how it is drawn.

use egui::Ui;

use crate::panes::commands::{Command, Pane};
use crate::panes::pane::{Header, PaneSpec, Place};
use crate::panes::pane_context::PaneContext;

use super::curves_ui;
use super::figure::FIGURE;
use super::view::curves_view;

impl Pane {
    /// Volumes over the cardiac cycle.
    pub const CURVES: Self = Self::named("curves");
}

/// Volumes over the cardiac cycle.
pub const PANE: PaneSpec = PaneSpec {
    pane: Pane::CURVES,
    title: "Volume",
    toggle: "Pane: volume curve",
    open: None,
    place: Place::BelowRight,
    header: Header::Beside(unit_ui),
    figure: Some(FIGURE),
    ui,
};

fn unit_ui(ui: &mut Ui, cx: &PaneContext<'_>, _: f32, _: &mut Vec<Command>) {
    if let Some(subject) = cx.state().document.selected() {
        ui.weak(subject.unit.volume_symbol());
    }
}

fn ui(ui: &mut Ui, cx: &PaneContext<'_>, commands: &mut Vec<Command>) {
    let state = cx.state();
    curves_ui(ui, &curves_view(state, state.is_measuring()), commands);
}
