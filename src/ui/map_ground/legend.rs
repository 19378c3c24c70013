//! How many hearts of each role a map holds, with their marks.

use egui::{Align2, Sense, Ui, pos2, vec2};

use crate::study::LabelRole;
use crate::ui::map_ground::MapSubject;
use crate::ui::marks::{role_mark, role_name};
use crate::ui::style::note_font;
use crate::ui::theme::{colours, space};

/// Draws one entry per role that occurs; names are left to the hover where there is little room.
pub fn role_counts_ui(ui: &mut Ui, subjects: &[MapSubject], wide: bool) {
    for role in [LabelRole::Normal, LabelRole::Abnormal, LabelRole::Unknown] {
        let count = subjects
            .iter()
            .filter(|subject| subject.role == role)
            .count();
        if count > 0 {
            entry_ui(ui, role, count, wide);
        }
    }
}

fn entry_ui(ui: &mut Ui, role: LabelRole, count: usize, wide: bool) {
    let colours = colours(ui);
    ui.spacing_mut().item_spacing.x = space::SMALL;
    let (mark, _) = ui.allocate_exact_size(vec2(10.0, 12.0), Sense::hover());
    role_mark(
        ui.painter(),
        mark.center(),
        4.0,
        role,
        colours.role(role),
        role != LabelRole::Unknown,
    );
    let name = format!("{} {count}", role_name(role));
    let text = if wide {
        name.clone()
    } else {
        count.to_string()
    };
    let galley = ui
        .painter()
        .layout_no_wrap(text, note_font(), colours.muted);
    let (rect, response) = ui.allocate_exact_size(galley.size(), Sense::hover());
    let at = Align2::LEFT_CENTER
        .align_size_within_rect(galley.size(), rect)
        .min;
    ui.painter().galley(pos2(at.x, at.y), galley, colours.muted);
    response.on_hover_text(name);
    ui.add_space(space::MEDIUM);
}
