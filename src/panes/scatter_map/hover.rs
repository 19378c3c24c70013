//! The card at the pointer: whose point it is, with its numbers and what a click does.

use egui::{CursorIcon, Response, RichText, Ui};

use crate::ui::marks::class_name;
use crate::ui::style::note;

use super::clusters::cluster_name;
use super::point::ScatterPoint;
use super::view::ScatterView;

/// What the pointer does on empty ground.
const GROUND_HINT: &str =
    "Hold Shift, or press and hold, to see the pose that the map implies here (estimated)";

/// Shows a hand and, beside it, the card of the point under the pointer.
pub fn hover_ui(response: Response, view: &ScatterView, pointed: Option<usize>) {
    if view.estimate.is_some() {
        // What is estimated here is said in its place.
        return;
    }
    if let Some(point) = pointed.and_then(|index| view.points.get(index)) {
        response
            .on_hover_cursor(CursorIcon::PointingHand)
            .on_hover_ui_at_pointer(|ui| card_ui(ui, view, point));
    } else if view.ground.is_some() {
        response.on_hover_ui_at_pointer(|ui| {
            ui.label(note(GROUND_HINT));
        });
    }
}

fn card_ui(ui: &mut Ui, view: &ScatterView, point: &ScatterPoint) {
    ui.label(RichText::new(view.title(point)).strong());
    if let Some(subject) = view.subjects.get(point.subject) {
        let label = subject.label.as_deref().unwrap_or("no label");
        ui.label(format!("{label}, class {}", class_name(subject.class)));
        if let Some(words) = subject.ejection_fraction_in_words() {
            ui.label(words);
        }
    }
    for fact in &point.facts {
        ui.label(fact);
    }
    if let Some(cluster) = point.cluster.filter(|_| view.shows_clusters) {
        ui.label(format!("Cluster {}", cluster_name(cluster)));
    }
    for hint in view.words.hints {
        ui.label(note(*hint));
    }
}
