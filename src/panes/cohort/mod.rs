//! The table of subjects: filter, sort, select.

mod columns;
mod header;
mod row_menu;
pub(crate) mod rows;
pub(crate) mod spec;
mod typing;
mod unread;
mod values;
pub(crate) mod view;

use egui::{
    Rect, Response, RichText, Role, ScrollArea, Sense, TextEdit, Ui, WidgetInfo, pos2, vec2,
};

use crate::document::CohortColumn;
use crate::panes::buttons::command_button_ui;
use crate::panes::cohort::rows::{CohortRow, CohortVerdict};
use crate::panes::commands::{Command, FileCommand, SelectCommand, ViewCommand};
use crate::panes::subject_drag::{
    DraggedSubject, SubjectTarget, dragged_subject, subject_target_ui,
};
use crate::ui::controls::{dragged_from_within, empty_pane_ui, escaped};
use crate::ui::label_marks::label_mark;
use crate::ui::marks::class_name;
use crate::ui::style::{note, text_font};
use crate::ui::text::{counted, text_width};
use crate::ui::theme::{colours, line, space};

use columns::{Columns, cell, excluded_cell, number_cell, verdict_cell};
use header::header_ui;
use row_menu::row_menu_ui;
use typing::typing_ui;
use unread::{ShownRow, shown_rows, unread_row_ui};
pub use values::{CohortEdits, CohortView};

/// Draws the filter box and the table.
pub fn cohort_table_ui(ui: &mut Ui, view: &CohortView, commands: &mut Vec<Command>) {
    if view.rows.is_empty() {
        empty_pane_ui(
            ui,
            "No subjects",
            "Open meshes or masks, a folder of them or a study",
            |ui| {
                command_button_ui(ui, "Open folder…", FileCommand::ChooseFolder, commands);
                let name = "Open the built-in cohort";
                command_button_ui(ui, name, FileCommand::OpenBuiltIn, commands);
            },
        );
        return;
    }
    search_ui(ui, view, commands);
    let labelled = view.rows.iter().any(|row| row.label.is_some());
    let longest = view.rows.iter().map(|row| row.id.as_str());
    let longest = longest.max_by_key(|id| id.chars().count());
    let names = longest.map_or(0.0, |id| text_width(ui, id, text_font()));
    let across = ui.available_rect_before_wrap().x_range();
    let columns = Columns::within(across, labelled, names);
    header_ui(ui, view.sort, &columns, commands);
    let shown = shown_rows(view.visible, view.sort, view.unread, view.search);
    if shown.is_empty() {
        ui.add_space(space::LARGE);
        ui.vertical_centered(|ui| {
            ui.label(note(format!("No subject matches “{}”", view.search)));
            let clear = ViewCommand::SetSearch(String::new());
            command_button_ui(ui, "Clear the filter", clear, commands);
        });
        return;
    }
    rows_ui(ui, view, &shown, &columns, commands);
}

fn search_ui(ui: &mut Ui, view: &CohortView, commands: &mut Vec<Command>) {
    egui::Frame::new()
        .inner_margin(egui::Margin::symmetric(space::LARGE as i8, 6))
        .show(ui, |ui| {
            let mut text = view.search.to_owned();
            let edit = TextEdit::singleline(&mut text)
                .hint_text("Filter by name, label, EF, verdict")
                .margin(vec2(space::MEDIUM, 3.0))
                .desired_width(f32::INFINITY);
            let response = ui.add(edit).accessible_name("Filter subjects");
            if response.changed() {
                commands.push(ViewCommand::SetSearch(text).into());
            } else if !view.search.is_empty() && view.edits.typing.is_none() && escaped(ui) {
                commands.push(ViewCommand::SetSearch(String::new()).into());
            }
        });
}

fn rows_ui(
    ui: &mut Ui,
    view: &CohortView,
    rows: &[ShownRow],
    columns: &Columns,
    commands: &mut Vec<Command>,
) {
    ui.spacing_mut().item_spacing.y = 0.0;
    let height = ui.available_height();
    let area = ScrollArea::vertical()
        .id_salt("cohort rows")
        .auto_shrink(false);
    // The row that is typed into is in sight, else the selected one when it is another.
    let typed = view.edits.typing.map(|typing| typing.subject);
    let looked_at = typed.or(view.selected);
    // By its id: subjects that were read since may stand before it.
    let shown_before = ui.data(|data| data.get_temp::<String>(ui.scope_id().with("shown")));
    let row = looked_at.and_then(|index| view.rows.get(index));
    let id = row.map(|row| row.id.clone());
    let moved = id.is_some() && shown_before != id;
    if moved && let Some(id) = id {
        ui.data_mut(|data| data.insert_temp(ui.scope_id().with("shown"), id));
    }
    let chosen = looked_at.map(ShownRow::Read);
    let place = rows.iter().position(|row| Some(*row) == chosen);
    area.show_viewport(ui, |ui, seen| {
        ui.set_height(space::ROW * rows.len() as f32);
        let top = ui.max_rect().top();
        let first = (seen.top() / space::ROW).floor().max(0.0) as usize;
        let last = ((seen.bottom() / space::ROW).ceil() as usize).min(rows.len());
        for (place, row) in rows.iter().enumerate().take(last).skip(first) {
            let rect = Rect::from_min_size(
                pos2(ui.max_rect().left(), top + place as f32 * space::ROW),
                vec2(ui.max_rect().width(), space::ROW),
            );
            match *row {
                ShownRow::Read(index) => row_ui(ui, rect, index, view, columns, commands),
                ShownRow::Unread(index) => {
                    let unread = &view.unread[index];
                    unread_row_ui(ui, rect, unread, view.awaited, columns, commands);
                }
            }
        }
        if let (true, Some(place)) = (moved, place) {
            let y = place as f32 * space::ROW;
            if y < seen.top() || y + space::ROW > seen.top() + height {
                let rect =
                    Rect::from_min_size(pos2(ui.max_rect().left(), top + y), vec2(1.0, space::ROW));
                ui.scroll_to_rect(rect, Some(egui::Align::Center));
            }
        }
    });
}

fn row_ui(
    ui: &mut Ui,
    rect: Rect,
    index: usize,
    view: &CohortView,
    columns: &Columns,
    commands: &mut Vec<Command>,
) {
    let row = &view.rows[index];
    let colours = colours(ui);
    let selected = view.selected == Some(index);
    let id = ui.scope_id().with(("row", &row.id));
    let response = ui.interact(rect, id, Sense::click_and_drag());
    response.widget_info(|| {
        let mut info = WidgetInfo::selected(Role::ListBoxOption, true, selected, &row.id);
        info.current_text_value = match row.excluded {
            true => Some("excluded".to_owned()),
            false => row.verdict.as_ref().map(CohortVerdict::text),
        };
        info
    });
    if selected {
        ui.painter().rect_filled(rect, 0.0, colours.selected_row);
        let edge = Rect::from_min_size(rect.min, vec2(2.0, rect.height()));
        ui.painter().rect_filled(edge, 0.0, colours.selection);
    } else if response.hovered() {
        ui.painter().rect_filled(rect, 0.0, colours.control);
    } else if view.compared == Some(index) {
        ui.painter()
            .rect_filled(rect, 0.0, colours.selected_row.gamma_multiply(0.5));
    }
    let y = rect.center().y;
    label_mark(ui, pos2(columns.mark, y), 4.0, row.mark, true);
    let id_colour = match (row.excluded, selected) {
        (true, _) => colours.muted,
        (false, true) => colours.strong,
        (false, false) => colours.text,
    };
    let name = cell(ui, columns, CohortColumn::Subject, y, &row.id, id_colour);
    if row.excluded {
        let stroke = (line::THIN, id_colour);
        ui.painter().hline(name.x_range(), y, stroke);
    }
    let [left, right] = columns.span(CohortColumn::Label);
    if left < right {
        let label = row.label.as_deref().unwrap_or("–");
        cell(ui, columns, CohortColumn::Label, y, label, colours.muted);
    }
    let ef = row.ejection_fraction_text();
    number_cell(
        ui,
        columns.ejection_fraction,
        y,
        ef,
        id_colour,
        view.measuring,
    );
    match row.excluded {
        true => excluded_cell(ui, columns, y),
        false => verdict_cell(ui, columns, y, row.verdict.as_ref(), view.classifying),
    }
    crate::ui::controls::focus_ring(ui, &response);
    if response.clicked() {
        commands.push(SelectCommand::SelectSubject(index).into());
    }
    if dragged_from_within(ui, &response) {
        response.dnd_set_drag_payload(DraggedSubject {
            subject: index,
            id: row.id.clone(),
            correspondence: row.correspondence,
        });
    }
    let target = SubjectTarget {
        rect,
        subject: index,
        id: &row.id,
        corresponds: dragged_subject(ui)
            .is_some_and(|dragged| dragged.correspondence == row.correspondence),
    };
    subject_target_ui(ui, &response, &target, commands);
    let typing = (view.edits.typing).filter(|typing| typing.subject == index);
    let button = typing.is_none() && menu_button_ui(ui, rect, &response, &row.id);
    row_menu_ui(ui, &response, button, (index, view), commands);
    if let Some((typing, study)) = typing.zip(view.edits.study) {
        let cell = columns.typing_cell(typing.field, rect, name.width());
        typing_ui(ui, cell, study, typing, commands);
    } else {
        response.on_hover_ui_at_pointer(|ui| row_hover_ui(ui, row));
    }
}

/// Three dots at the end of the row under the pointer or with the keyboard, which open its menu.
fn menu_button_ui(ui: &mut Ui, row: Rect, response: &Response, subject: &str) -> bool {
    if !response.contains_pointer() && !response.has_focus() {
        return false;
    }
    let rect = Rect::from_min_max(pos2(row.right() - 18.0, row.top()), row.max);
    let button = ui.interact(rect, response.id.with("menu"), Sense::click());
    let name = format!("Menu of {subject}");
    button.widget_info(|| WidgetInfo::labeled(Role::Button, true, &name));
    let colours = colours(ui);
    let colour = match button.hovered() {
        true => colours.strong,
        false => colours.muted,
    };
    for step in [-1.0, 0.0, 1.0] {
        // Clear of the words of the verdict.
        let at = rect.center() + vec2(2.0, 4.0 * step);
        ui.painter().circle_filled(at, 1.2, colour);
    }
    button.on_hover_text(name).clicked()
}

fn row_hover_ui(ui: &mut Ui, row: &CohortRow) {
    ui.label(RichText::new(&row.id).strong());
    let label = row.label.as_deref().unwrap_or("none");
    ui.label(format!("Label {label}, class {}", class_name(row.class)));
    ui.label(match row.ejection_fraction_in_words() {
        Some(words) => words,
        None => "Ejection fraction unknown".to_owned(),
    });
    if row.excluded {
        ui.label("Excluded: no analysis of the cohort counts this subject");
    }
    if let Some(verdict) = &row.verdict {
        ui.label(&verdict.words);
    }
    ui.label(note(counted(row.frame_count, "frame")));
    if row.warning_count > 0 {
        ui.colored_label(
            colours(ui).warning,
            format!("{} warnings in the load report", row.warning_count),
        );
    }
}

#[cfg(test)]
mod tests;
