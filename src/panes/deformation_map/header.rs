//! The strip above the deformation map: what is compared, what the map keeps, and how well.

use egui::Ui;

use crate::analysis::deformations::Comparison;
use crate::panes::commands::{Command, MapCommand};
use crate::ui::controls::{choices_ui, chooser_ui};
use crate::ui::style::{note, note_font};

use super::map::DeformationMapView;
use super::words::{COMPARISONS, EXPLANATION, fit_parts};

/// Draws what is compared, as a chooser, and beside it what the map keeps and how well: short where there is little room.
///
/// `kept` points of the width are for what stands on the left.
pub fn deformation_header_ui(
    ui: &mut Ui,
    view: &DeformationMapView,
    kept: f32,
    commands: &mut Vec<Command>,
) {
    // Without room for the chooser, menu and palette have its choices.
    if ui.available_width() - kept > 150.0 {
        let now = view.comparison.name();
        let chooser = chooser_ui(ui, "Compare", now, |ui| {
            let named = Comparison::NAMED.map(|comparison| (comparison.name(), comparison.name()));
            let chosen = choices_ui(ui, named, now);
            let wanted = Comparison::NAMED
                .into_iter()
                .find(|c| Some(c.name()) == chosen);
            commands.extend(wanted.map(|wanted| MapCommand::SetComparison(wanted).into()));
        });
        chooser.on_hover_text(COMPARISONS);
    }
    deformation_note(ui, view, kept);
}

/// Draws what the map keeps and how well: short where there is little room.
pub fn deformation_note(ui: &mut Ui, view: &DeformationMapView, kept: f32) {
    let fit = &view.fit;
    let long = fit_parts(fit, ["neighbours", "reconstruction error"]).join(" · ");
    let parts = fit_parts(fit, ["k", "error"]);
    let room = ui.available_width() - kept;
    let fits = |text: &String| {
        let text = text.clone();
        let painter = ui.painter();
        let galley = painter.layout_no_wrap(text, note_font(), egui::Color32::PLACEHOLDER);
        galley.size().x <= room
    };
    // Where there is no room, words go first, then the last part.
    let shorter = (0..=parts.len())
        .rev()
        .map(|count| parts[..count].join(" · "));
    let fitting = std::iter::once(long.clone()).chain(shorter).find(fits);
    if let Some(text) = fitting.filter(|text| !text.is_empty()) {
        ui.label(note(text))
            .on_hover_text(format!("{long}\n\n{EXPLANATION}"));
    }
}
