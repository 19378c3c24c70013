//! The headings of the cohort table; a click sorts by a column.

use egui::{Align2, FontId, Rect, Role, Sense, Ui, WidgetInfo, pos2, vec2};

use crate::document::{CohortColumn, CohortSort};
use crate::panes::commands::{Command, ViewCommand};
use crate::ui::controls::focus_ring;
use crate::ui::style::note_font;
use crate::ui::theme::{colours, space};

use super::columns::{Columns, VerdictRoom};
use super::rows::{COLUMNS, CohortColumnSpec};

pub(super) fn header_ui(
    ui: &mut Ui,
    sort: Option<CohortSort>,
    columns: &Columns,
    commands: &mut Vec<Command>,
) {
    let (row, _) = ui.allocate_exact_size(vec2(ui.available_width(), space::ROW), Sense::hover());
    for spec in &COLUMNS {
        let [left, right] = columns.span(spec.column);
        if left < right {
            let rect = Rect::from_min_max(pos2(left, row.top()), pos2(right, row.bottom()));
            let words = spec.column != CohortColumn::Verdict || columns.room != VerdictRoom::Mark;
            let text = if words { spec.heading } else { "" };
            heading_ui(ui, rect, spec, text, sort, commands);
        }
    }
}

fn heading_ui(
    ui: &Ui,
    rect: Rect,
    spec: &CohortColumnSpec,
    text: &str,
    sort: Option<CohortSort>,
    commands: &mut Vec<Command>,
) {
    let id = ui.scope_id().with(("sort", spec.sort_by));
    let response = ui.interact(rect, id, Sense::click());
    response.widget_info(|| WidgetInfo::labeled(Role::Button, true, spec.sort_by));
    let sorted = sort.filter(|sort| sort.column == spec.column);
    let colour = if sorted.is_some() || response.hovered() {
        colours(ui).text
    } else {
        colours(ui).muted
    };
    // Numbers end where their heading ends, and the arrow stands before it.
    let numbers = spec.column == CohortColumn::EjectionFraction;
    let (align, arrow_align) = match numbers {
        true => (Align2::RIGHT_CENTER, Align2::RIGHT_CENTER),
        false => (Align2::LEFT_CENTER, Align2::LEFT_CENTER),
    };
    let mut job = egui::text::LayoutJob::simple_singleline(text.to_owned(), note_font(), colour);
    job.wrap = egui::text::TextWrapping::truncate_at_width(rect.width());
    let galley = ui.painter().layout_job(job);
    let place = align.align_size_within_rect(galley.size(), rect);
    ui.painter().galley(place.min, galley, colour);
    if let Some(sort) = sorted {
        let arrow = if sort.descending { "▼" } else { "▲" };
        let at = match numbers {
            true => place.left_center() - vec2(3.0, 0.0),
            false => place.right_center() + vec2(3.0, 0.0),
        };
        let font = FontId::proportional(8.0);
        ui.painter().text(at, arrow_align, arrow, font, colour);
    }
    focus_ring(ui, &response);
    if response.on_hover_text(spec.sort_hint).clicked() {
        commands.push(ViewCommand::SortCohort(spec.column).into());
    }
}
