//! What the pointer reads on the map of deformations.

use egui::{Response, RichText, Ui};

use crate::ui::deformation_map::clusters::cluster_name;
use crate::ui::deformation_map::{DeformationMapView, DeformationPoint};
use crate::ui::marks::role_name;
use crate::ui::normal_ranges::EJECTION_FRACTION;
use crate::ui::style::note;

/// Shows the tooltip of the heart under the pointer.
pub fn hover_ui(response: Response, view: &DeformationMapView, pointed: Option<usize>) {
    let Some(point) = pointed.and_then(|index| view.points.get(index)) else {
        return;
    };
    response
        .on_hover_cursor(egui::CursorIcon::PointingHand)
        .on_hover_ui_at_pointer(|ui| point_ui(ui, view, point));
}

fn point_ui(ui: &mut Ui, view: &DeformationMapView, point: &DeformationPoint) {
    let Some(subject) = view.subjects.get(point.subject) else {
        return;
    };
    ui.label(RichText::new(&subject.id).strong());
    let label = subject.label.as_deref().unwrap_or("no label");
    ui.label(format!("{label}, counts as {}", role_name(subject.role)));
    if let Some(ef) = subject.ejection_fraction {
        ui.label(format!(
            "Ejection fraction {:.0} %, {}",
            100.0 * ef,
            EJECTION_FRACTION.short
        ));
    }
    let alike: Vec<&str> = point
        .nearest
        .iter()
        .filter_map(|index| view.subjects.get(*index))
        .map(|subject| subject.id.as_str())
        .collect();
    if !alike.is_empty() {
        ui.label(format!("Moves most like {}", alike.join(", ")));
    }
    if let Some(cluster) = point.cluster.filter(|_| view.shows_clusters) {
        ui.label(format!("Cluster {}", cluster_name(cluster)));
    }
    ui.label(note("Click to play this heart"));
}
