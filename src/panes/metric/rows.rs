//! Rows of the pane: a heading, a sentence, a choice.

use crate::ui::controls::chooser_ui;
use crate::ui::number_field::row_ui;
use crate::ui::style::{medium, note, text_font};
use crate::ui::text::text_width;
use crate::ui::theme::space;
use egui::Ui;

pub(super) fn heading_ui(ui: &mut Ui, name: &str) {
    ui.add_space(space::MEDIUM);
    ui.label(medium(name));
}

/// A sentence below a control, over the whole width.
pub(super) fn sentence_ui(ui: &mut Ui, text: &str) {
    ui.add(egui::Label::new(note(text)).wrap());
    ui.add_space(space::SMALL);
}

/// A name with a menu of choices behind it.
pub(super) fn choice_row_ui(
    ui: &mut Ui,
    name: &str,
    what: &str,
    shown: &str,
    enabled: bool,
    menu: impl FnOnce(&mut Ui),
) {
    row_ui(ui, name, what, enabled, |ui| {
        // The name of what is chosen among is read from the row.
        let taken = text_width(ui, name, text_font()) + space::LARGE;
        let widest = (ui.available_width() - taken).max(60.0);
        ui.scope(|ui| {
            ui.set_max_width(widest);
            chooser_ui(ui, name, shown, menu);
        });
    });
}
