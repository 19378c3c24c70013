//! The pane "Images": its word, title, place and how it is drawn.

use egui::Ui;

use crate::panes::commands::{Command, ImagesCommand, Pane};
use crate::panes::pane::{Header, PaneSpec, Place};
use crate::panes::pane_context::PaneContext;
use crate::ui::controls::{choices_ui, chooser_ui};

use super::view::slices_ui;

impl Pane {
    /// The images in three slices.
    pub const SLICES: Self = Self::named("slices");
}

/// The images in three slices.
pub const PANE: PaneSpec = PaneSpec {
    pane: Pane::SLICES,
    title: "Images",
    toggle: "Pane: images",
    open: None,
    place: Place::Middle,
    header: Header::Beside(series_ui),
    figure: None,
    ui: slices_ui,
};

/// Where a person has several series, which one is on screen.
fn series_ui(ui: &mut Ui, cx: &PaneContext<'_>, taken: f32, commands: &mut Vec<Command>) {
    let document = &cx.state().document;
    let Some(images) = document.shown_images() else {
        return;
    };
    if images.series.len() < 2 || ui.available_width() - taken < 120.0 {
        return;
    }
    let now = document.slices.series.min(images.series.len() - 1);
    let names = images.series.iter().map(|series| series.name.as_str());
    let names: Vec<(usize, &str)> = names.enumerate().collect();
    let shown = names.get(now).map_or("", |(_, name)| *name);
    chooser_ui(ui, "Series", shown, |ui| {
        let chosen = choices_ui(ui, names.iter().copied(), now);
        commands.extend(chosen.map(|series| Command::from(ImagesCommand::ShowSeries(series))));
    });
}
