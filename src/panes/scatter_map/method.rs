//! The choice of how distances become places on a map.

use egui::Ui;

use crate::analysis::embedding::MapMethod;
use crate::panes::metric::words::method_name;
use crate::ui::controls::choices_ui;

/// Draws all methods; the one that was clicked. Isomap keeps the number of neighbours it has.
pub fn method_choices_ui(ui: &mut Ui, chosen: MapMethod) -> Option<MapMethod> {
    let methods = [MapMethod::ClassicalMds, MapMethod::Smacof, isomap(chosen)];
    choices_ui(
        ui,
        methods.map(|method| (method, method_name(method))),
        chosen,
    )
}

/// Isomap with the neighbours it has, or those of the start.
pub fn isomap(chosen: MapMethod) -> MapMethod {
    match chosen {
        MapMethod::Isomap { .. } => chosen,
        MapMethod::ClassicalMds | MapMethod::Smacof => MapMethod::ISOMAP,
    }
}
