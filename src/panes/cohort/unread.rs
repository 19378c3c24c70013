//! Rows of subjects that are still to be read, among those that are.

use egui::{Align2, Rect, Role, Sense, Ui, WidgetInfo, pos2};

use crate::document::{CohortColumn, CohortSort};
use crate::panes::cohort::columns::{Columns, cell};
use crate::panes::commands::{Command, FileCommand};
use crate::study::UnreadSubject;
use crate::ui::style::text_font;
use crate::ui::theme::colours;

/// A row of the table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ShownRow {
    /// A subject of the study, by its index.
    Read(usize),
    /// One that is still to be read.
    Unread(usize),
}

/// All rows in the order shown: where nothing sorts them, that of the input; else what is unread comes last, as missing
/// values do.
pub(super) fn shown_rows(
    visible: &[usize],
    sort: Option<CohortSort>,
    unread: &[UnreadSubject],
    search: &str,
) -> Vec<ShownRow> {
    let words: Vec<String> = search.split_whitespace().map(str::to_lowercase).collect();
    let matches = |unread: &UnreadSubject| {
        let label = unread.label.as_deref().unwrap_or_default();
        let text = format!("{} {label}", unread.id).to_lowercase();
        words.iter().all(|word| text.contains(word))
    };
    let unread = unread.iter().enumerate();
    let mut unread = unread.filter(|(_, unread)| matches(unread)).peekable();
    let mut shown = Vec::new();
    for &index in visible {
        while sort.is_none()
            && let Some((place, _)) = unread.next_if(|(_, unread)| unread.read_before <= index)
        {
            shown.push(ShownRow::Unread(place));
        }
        shown.push(ShownRow::Read(index));
    }
    shown.extend(unread.map(|(place, _)| ShownRow::Unread(place)));
    shown
}

/// One that is still to be read; a click has it read before the others, and selects it then.
pub(super) fn unread_row_ui(
    ui: &mut Ui,
    rect: Rect,
    unread: &UnreadSubject,
    awaited: Option<&str>,
    columns: &Columns,
    commands: &mut Vec<Command>,
) {
    let colours = colours(ui);
    let awaited = awaited == Some(&unread.id);
    let id = ui.scope_id().with(("row", &unread.id));
    let response = ui.interact(rect, id, Sense::click());
    response.widget_info(|| {
        let mut info = WidgetInfo::selected(Role::ListBoxOption, true, awaited, &unread.id);
        info.current_text_value = Some("reading…".to_owned());
        info
    });
    if awaited || response.hovered() {
        let fill = match awaited {
            true => colours.selected_row,
            false => colours.control,
        };
        ui.painter().rect_filled(rect, 0.0, fill);
    }
    let y = rect.center().y;
    cell(
        ui,
        columns,
        CohortColumn::Subject,
        y,
        &unread.id,
        colours.muted,
    );
    let [left, right] = columns.span(CohortColumn::Label);
    if left < right {
        let label = unread.label.as_deref().unwrap_or("–");
        cell(ui, columns, CohortColumn::Label, y, label, colours.muted);
    }
    ui.painter().text(
        pos2(columns.verdict[1], y),
        Align2::RIGHT_CENTER,
        "reading…",
        text_font(),
        colours.muted,
    );
    crate::ui::controls::focus_ring(ui, &response);
    if response.clicked() {
        commands.push(FileCommand::ReadFirst(unread.id.clone()).into());
    }
    response.on_hover_text("Still to be read. Click to read it next and show it");
}

#[cfg(test)]
mod tests {
    use super::ShownRow::{Read, Unread};
    use super::*;

    fn unread(id: &str, read_before: usize) -> UnreadSubject {
        UnreadSubject {
            id: id.to_owned(),
            label: Some("DCM".to_owned()),
            read_before,
        }
    }

    #[test]
    fn rows_stand_in_the_order_of_the_input_whether_read_or_not_and_sorted_ones_come_first() {
        let all = [unread("a", 0), unread("c", 1), unread("e", 2)];
        let wanted = [Unread(0), Read(0), Unread(1), Read(1), Unread(2)];
        assert_eq!(shown_rows(&[0, 1], None, &all, ""), wanted);
        let wanted = [Read(1), Read(0), Unread(0), Unread(1), Unread(2)];
        let sort = Some(CohortSort::default());
        assert_eq!(shown_rows(&[1, 0], sort, &all, ""), wanted);
        assert_eq!(shown_rows(&[], None, &all, "dcm E"), [Unread(2)]);
    }
}
