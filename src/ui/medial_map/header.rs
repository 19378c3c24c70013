//! The strip above the map: how distances become places.

use egui::Ui;

use crate::analysis::embedding::MapMethod;
use crate::ui::command::Command;
use crate::ui::controls::{choice_ui, chooser_ui, pane_header_ui};
use crate::ui::medial_map::MedialMapView;
use crate::ui::metric_words::method_name;
use crate::ui::style::medium;

/// Draws the name of the pane and the chooser.
pub fn medial_map_header_ui(ui: &mut Ui, view: &MedialMapView, commands: &mut Vec<Command>) {
    pane_header_ui(
        ui,
        |ui| {
            ui.add(egui::Label::new(medium("Medial")).truncate());
        },
        |ui| medial_map_choosers_ui(ui, view, commands),
    );
}

/// Draws the chooser of the method, for a header that has its own title. The maps of poses and of the medial
/// space share it, so that they can be compared.
pub fn medial_map_choosers_ui(ui: &mut Ui, view: &MedialMapView, commands: &mut Vec<Command>) {
    let isomap = match view.method {
        MapMethod::Isomap { neighbours } => MapMethod::Isomap { neighbours },
        _ => MapMethod::ISOMAP,
    };
    chooser_ui(ui, "Method", method_name(view.method), |ui| {
        for method in [MapMethod::ClassicalMds, MapMethod::Smacof, isomap] {
            if choice_ui(ui, method_name(method), view.method == method) {
                commands.push(Command::SetMapMethod(method));
            }
        }
    });
}
