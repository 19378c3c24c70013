//! What the pointer reads on every map: whose heart it is on.

use egui::{CursorIcon, Response, RichText, Ui};

use crate::ui::marks::role_name;
use crate::ui::normal_ranges::EJECTION_FRACTION;

use super::MapSubject;

/// Shows a hand and, beside it, what `read_ui` writes.
pub fn tooltip_ui(response: Response, read_ui: impl FnOnce(&mut Ui)) {
    response
        .on_hover_cursor(CursorIcon::PointingHand)
        .on_hover_ui_at_pointer(read_ui);
}

/// The head of a tooltip: what is pointed at, the label of its subject and its ejection fraction.
pub fn subject_ui(ui: &mut Ui, title: &str, subject: &MapSubject) {
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
}
