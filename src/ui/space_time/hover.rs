//! What the pointer reads on a curve through time.

use egui::{Response, Ui};

use crate::ui::map_ground::{subject_ui, tooltip_ui};
use crate::ui::space_time::{Hit, SpaceTimeView};
use crate::ui::style::note;

/// Shows the tooltip of the curve under the pointer, or how the plot is turned.
pub fn hover_ui(response: Response, view: &SpaceTimeView, hit: Option<Hit>) {
    let Some(hit) = hit else {
        return;
    };
    tooltip_ui(response, |ui| curve_ui(ui, view, hit));
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
    let phase = point.phase.after_name();
    let percent = 100.0 * point.share;
    let title = format!("{} · {percent:.0} % R-R{phase}", subject.id);
    subject_ui(ui, &title, subject);
    ui.label(note("Click to play this heart from this pose"));
    ui.label(note(
        "Drag to turn, scroll to zoom, double click to turn back",
    ));
}
