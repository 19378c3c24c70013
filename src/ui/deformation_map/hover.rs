//! What the pointer reads on the map of deformations.

use egui::{Response, Ui};

use crate::ui::deformation_map::clusters::cluster_name;
use crate::ui::deformation_map::{DeformationMapView, DeformationPoint};
use crate::ui::map_ground::{subject_ui, tooltip_ui};
use crate::ui::style::note;

/// Shows the tooltip of the heart under the pointer.
pub fn hover_ui(response: Response, view: &DeformationMapView, pointed: Option<usize>) {
    let Some(point) = pointed.and_then(|index| view.points.get(index)) else {
        return;
    };
    tooltip_ui(response, |ui| point_ui(ui, view, point));
}

fn point_ui(ui: &mut Ui, view: &DeformationMapView, point: &DeformationPoint) {
    let Some(subject) = view.subjects.get(point.subject) else {
        return;
    };
    subject_ui(ui, &subject.id, subject);
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
