//! What the pointer reads on the map.

use egui::{Response, Ui};

use crate::ui::map_ground::{subject_ui, tooltip_ui};
use crate::ui::pose_map::{MapPoint, PoseMapView};
use crate::ui::style::note;

/// Shows the tooltip of the point under the pointer.
pub fn hover_ui(response: Response, view: &PoseMapView, nearest: Option<usize>) {
    let Some(point) = nearest.and_then(|index| view.points.get(index)) else {
        return;
    };
    tooltip_ui(response, |ui| point_ui(ui, view, point));
}

fn point_ui(ui: &mut Ui, view: &PoseMapView, point: &MapPoint) {
    let Some(subject) = view.subjects.get(point.subject) else {
        return;
    };
    let phase = point.phase.after_name();
    let title = format!("{} · frame {}{phase}", subject.id, point.frame);
    subject_ui(ui, &title, subject);
    ui.label(note("Click to play this heart from this pose"));
}
