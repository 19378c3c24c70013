//! What the pointer reads on the map.

use egui::{Response, RichText, Ui};

use crate::ui::marks::role_name;
use crate::ui::normal_ranges::EJECTION_FRACTION;
use crate::ui::pose_map::{MapPoint, PoseMapView, PosePhase};
use crate::ui::style::note;

/// Shows the tooltip of the point under the pointer.
pub fn hover_ui(response: Response, view: &PoseMapView, nearest: Option<usize>) {
    let Some(point) = nearest.and_then(|index| view.points.get(index)) else {
        return;
    };
    response
        .on_hover_cursor(egui::CursorIcon::PointingHand)
        .on_hover_ui_at_pointer(|ui| point_ui(ui, view, point));
}

fn point_ui(ui: &mut Ui, view: &PoseMapView, point: &MapPoint) {
    let Some(subject) = view.subjects.get(point.subject) else {
        return;
    };
    let phase = match point.phase {
        PosePhase::EndDiastole => " · end-diastole",
        PosePhase::EndSystole => " · end-systole",
        PosePhase::Between => "",
    };
    ui.label(RichText::new(format!("{} · frame {}{phase}", subject.id, point.frame)).strong());
    let label = subject.label.as_deref().unwrap_or("no label");
    ui.label(format!("{label}, counts as {}", role_name(subject.role)));
    if let Some(ef) = subject.ejection_fraction {
        ui.label(format!(
            "Ejection fraction {:.0} %, {}",
            100.0 * ef,
            EJECTION_FRACTION.short
        ));
    }
    ui.label(note("Click to play this heart from this pose"));
}
