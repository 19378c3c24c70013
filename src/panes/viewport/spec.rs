//! The pane "3D view": its word, title, place and how it is drawn.

use egui::Ui;

use super::empty_state::{EmptyStateView, empty_state_ui};
use super::header::viewport_header_ui;
use super::viewport::Viewport;
use crate::panes::commands::{Command, Pane};
use crate::panes::pane::{Header, PaneSpec, Place};
use crate::panes::pane_context::PaneContext;

impl Pane {
    /// The 3D view.
    pub const VIEWPORT: Self = Self::named("viewport");
}

/// The 3D view.
pub const PANE: PaneSpec = PaneSpec {
    pane: Pane::VIEWPORT,
    title: "3D view",
    toggle: "Pane: 3D view",
    open: None,
    place: Place::Middle,
    header: Header::Always(header_ui),
    figure: None,
    ui,
};

fn header_ui(ui: &mut Ui, cx: &PaneContext<'_>, commands: &mut Vec<Command>) {
    viewport_header_ui(ui, cx.state(), commands);
}

fn ui(ui: &mut Ui, cx: &PaneContext<'_>, commands: &mut Vec<Command>) {
    let state = cx.state();
    if state.document.study().subjects.is_empty() {
        let view = EmptyStateView {
            files_hover: ui.input(|input| !input.raw.hovered_files.is_empty()),
            opening: cx.is_opening(),
        };
        return empty_state_ui(ui, &view, commands);
    }
    let viewport = cx.memo().get::<Viewport>();
    viewport.borrow_mut().ui(ui, state, cx.meter(), commands);
}
