//! The choice of how distances become places on a map.

use egui::Ui;

use crate::analysis::embedding::MapMethod;
use crate::panes::metric::words::method_name;
use crate::ui::controls::choice_ui;

/// Draws all methods; the one that was clicked. Isomap keeps the number of neighbours it has.
pub fn method_choices_ui(ui: &mut Ui, chosen: MapMethod) -> Option<MapMethod> {
    let isomap = match chosen {
        MapMethod::Isomap { .. } => chosen,
        MapMethod::ClassicalMds | MapMethod::Smacof => MapMethod::ISOMAP,
    };
    let mut clicked = None;
    for method in [MapMethod::ClassicalMds, MapMethod::Smacof, isomap] {
        if choice_ui(ui, method_name(method), chosen == method) {
            clicked = Some(method);
        }
    }
    clicked
}
