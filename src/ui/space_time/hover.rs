//! What the pointer reads on a curve through time.

use egui::{Response, RichText, Ui};

use crate::ui::marks::role_name;
use crate::ui::normal_ranges::EJECTION_FRACTION;
use crate::ui::pose_map::PosePhase;
use crate::ui::space_time::{Hit, SpaceTimeView};
use crate::ui::style::note;

/// Shows the tooltip of the curve under the pointer, or how the plot is turned.
pub fn hover_ui(response: Response, view: &SpaceTimeView, hit: Option<Hit>) {
    let Some(hit) = hit else {
        return;
    };
    response
        .on_hover_cursor(egui::CursorIcon::PointingHand)
        .on_hover_ui_at_pointer(|ui| curve_ui(ui, view, hit));
}

fn curve_ui(ui: &mut Ui, view: &SpaceTimeView, hit: Hit) {
    let Some(curve) = view.curves.get(hit.curve) else {
        return;
    };
    let (Some(subject), Some(point)) = (
        view.subjects.get(curve.subject),
        curve.points.get(hit.point),
    ) else {
        return;
    };
    let phase = match point.phase {
        PosePhase::EndDiastole => " · end-diastole",
        PosePhase::EndSystole => " · end-systole",
        PosePhase::Between => "",
    };
    let percent = 100.0 * point.share;
    let title = format!("{} · {percent:.0} % R-R{phase}", subject.id);
    ui.label(RichText::new(title).strong());
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
    ui.label(note(
        "Drag to turn, scroll to zoom, double click to turn back",
    ));
}
