//! The pane "Measures": its word, title, place and how it is drawn.

use egui::Ui;

use crate::panes::commands::{Command, Pane};
use crate::panes::pane::{Header, PaneSpec, Place};
use crate::panes::pane_context::PaneContext;

use super::measures_card_ui;
use super::view::measures_view;

impl Pane {
    /// Clinical measures of the selected subject.
    pub const MEASURES: Self = Self::named("measures");
}

/// Clinical measures of the selected subject.
pub const PANE: PaneSpec = PaneSpec {
    pane: Pane::MEASURES,
    title: "Measures",
    toggle: "Pane: measures",
    open: None,
    place: Place::BelowLeft,
    header: Header::Title,
    figure: None,
    ui,
};

fn ui(ui: &mut Ui, cx: &PaneContext<'_>, commands: &mut Vec<Command>) {
    let state = cx.state();
    measures_card_ui(ui, &measures_view(state, state.is_measuring()), commands);
}
