//! The features behind a verdict, each on a scale with the range of the normal subjects.

use egui::{Label, Rect, Role, Sense, Ui, WidgetInfo, pos2, vec2};

use crate::panes::verdict::{EvidenceRow, pair_ui};
use crate::panes::verdict_marks::{VerdictMark, verdict_mark};
use crate::ui::style::{medium, note};
use crate::ui::theme::{colours, line, space};

/// Height of a scale.
const SCALE: f32 = 12.0;

/// Draws the rows: first the model features, then the others.
pub(super) fn evidence_ui(ui: &mut Ui, rows: &[EvidenceRow]) {
    if rows.is_empty() {
        return;
    }
    ui.label(medium("Evidence"));
    ui.add(Label::new(note("Bar: range of the normal subjects")).wrap());
    for (heading, model_feature) in [("Model features", true), ("Other features", false)] {
        let mut rows = rows
            .iter()
            .filter(|row| row.model_feature == model_feature)
            .peekable();
        if rows.peek().is_some() {
            ui.add_space(space::SMALL);
            ui.label(note(heading).color(colours(ui).text));
        }
        rows.for_each(|row| row_ui(ui, row));
    }
    ui.add_space(space::MEDIUM);
}

fn row_ui(ui: &mut Ui, row: &EvidenceRow) {
    let response = pair_ui(ui, row.name, &row.value);
    let normal = if row.normal.is_empty() {
        String::new()
    } else {
        format!(", normal subjects {}", row.normal)
    };
    let words = format!("{}: {}{normal}", row.name, row.value);
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, words.as_str()));
    let scale = scale_ui(ui, row);
    let normal = if row.normal.is_empty() {
        String::new()
    } else {
        format!("\n\nNormal subjects: {}", row.normal)
    };
    let hover = format!("{}{normal}", row.what);
    response.union(scale).on_hover_text(hover);
}

fn scale_ui(ui: &mut Ui, row: &EvidenceRow) -> egui::Response {
    let (area, response) =
        ui.allocate_exact_size(vec2(ui.available_width(), SCALE), Sense::hover());
    let colours = colours(ui);
    let track = area.shrink2(vec2(5.0, 0.0));
    let y = area.center().y - 1.0;
    let at = |share: f32| track.left() + share.clamp(0.0, 1.0) * track.width();
    let painter = ui.painter();
    painter.hline(track.x_range(), y, (line::THIN, colours.line));
    if let Some([from, to]) = row.band {
        let band = Rect::from_min_max(pos2(at(from) - 1.0, y - 2.5), pos2(at(to) + 1.0, y + 2.5));
        painter.rect_filled(band, 2.0, colours.normal.gamma_multiply(0.55));
    }
    if let Some(place) = row.place {
        let centre = pos2(at(place), y);
        painter.circle_filled(centre, 5.5, colours.pane);
        verdict_mark(painter, centre, 4.5, VerdictMark::Patch, colours.strong);
    }
    response
}
