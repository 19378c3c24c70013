//! The panes "Import" and "Batch": their words, titles, places and how they are drawn.

use egui::Ui;

use crate::panes::commands::{Command, Pane};
use crate::panes::pane::{Header, PaneSpec, Place};
use crate::panes::pane_context::PaneContext;
use crate::ui::style::note;

use super::batch::batch_ui;
use super::view::import_ui;

impl Pane {
    /// The steps from images to a subject.
    pub const IMPORT: Self = Self::named("import");
    /// All images of the study in a table.
    pub const BATCH: Self = Self::named("batch");
}

/// The steps from images to a subject.
pub const PANE: PaneSpec = PaneSpec {
    pane: Pane::IMPORT,
    title: "Import",
    toggle: "Pane: import",
    open: Some((4, "Import images")),
    place: Place::Left,
    header: Header::Beside(step_ui),
    figure: None,
    ui: import_ui,
};

/// All images of the study in a table.
pub const BATCH_PANE: PaneSpec = PaneSpec {
    pane: Pane::BATCH,
    title: "Batch",
    toggle: "Pane: batch of images",
    open: Some((4, "Batch of images")),
    place: Place::Middle,
    header: Header::Title,
    figure: None,
    ui: batch_ui,
};

fn step_ui(ui: &mut Ui, cx: &PaneContext<'_>, taken: f32, _commands: &mut Vec<Command>) {
    let document = &cx.state().document;
    if document.shown_images().is_some() && ui.available_width() - taken > 60.0 {
        ui.label(note(format!("step {} of 5", document.import.step.number())));
    }
}
