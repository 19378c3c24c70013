//! The strip above the medial map: how it is embedded.

use egui::Ui;

use crate::analysis::embedding::MapMethod;
use crate::panes::commands::{Command, MapCommand};
use crate::panes::metric::words::method_name;
use crate::panes::scatter_map::method_choices_ui;
use crate::ui::controls::chooser_ui;

/// Draws the chooser of the method, for a header that has its own title. Pose map and map of
/// the medial shape space share the method, so that they can be compared.
pub fn medial_map_choosers_ui(ui: &mut Ui, method: MapMethod, commands: &mut Vec<Command>) {
    chooser_ui(ui, "Method", method_name(method), |ui| {
        let chosen = method_choices_ui(ui, method);
        commands.extend(chosen.map(|method| Command::from(MapCommand::SetMapMethod(method))));
    });
}
