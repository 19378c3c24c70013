//! A name beside a value.

use crate::ui::theme::{colours, space};
use egui::Ui;

/// A line with a name on the left and a number on the right; a long name takes a second line.
pub(super) fn pair_ui(ui: &mut Ui, name: &str, value: &str) -> egui::Response {
    use crate::ui::style::{medium_note_font, note_font};
    let colours = colours(ui);
    let painter = ui.painter().clone();
    let value = painter.layout_no_wrap(value.to_owned(), medium_note_font(), colours.text);
    let room = (ui.available_width() - value.size().x - space::MEDIUM).max(8.0);
    let name = painter.layout(name.to_owned(), note_font(), colours.muted, room);
    let size = egui::vec2(ui.available_width(), name.size().y.max(18.0));
    let (rect, response) = ui.allocate_exact_size(size, egui::Sense::hover());
    let y = |height: f32| rect.center().y - 0.5 * height;
    let left = egui::pos2(rect.left(), y(name.size().y));
    painter.galley(left, name, colours.muted);
    let right = egui::pos2(rect.right() - value.size().x, y(value.size().y));
    painter.galley(right, value, colours.text);
    response
}
