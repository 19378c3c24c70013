//! The table of patches: numbers with units, segments below, a click selects and frames.

use egui::{Align2, Rect, Role, Sense, Ui, WidgetInfo, pos2, vec2};

use crate::picture::{PatchStanding, WallPart};
use crate::ui::command::Command;
use crate::ui::controls::focus_ring;
use crate::ui::patch_panel::PatchRow;
use crate::ui::style::{note_font, text_font};
use crate::ui::theme::{colours, line, radius, space};

/// Height of the line with the numbers.
const LINE: f32 = 20.0;
/// Columns: heading in a narrow and in a wide pane, and what it means.
const COLUMNS: [[&str; 3]; 4] = [
    [
        "cm²",
        "area, cm²",
        "Area on the medial surface at end-diastole",
    ],
    [
        "% LV",
        "share, % of LV",
        "Share of the medial surface of the ventricle",
    ],
    [
        "thick.",
        "thickening, %",
        "Mean thickening from end-diastole to end-systole, in percent",
    ],
    [
        "conf.",
        "confidence, %",
        "Share of redraws of the noise in which the patch is found again, in percent",
    ],
];
/// Width below which three columns have room.
const NARROW: f32 = 160.0;
/// Width from which headings are written out.
const WIDE: f32 = 330.0;

/// Draws the table over the whole width.
pub(super) fn table_ui(
    ui: &mut Ui,
    rows: &[PatchRow],
    standing: PatchStanding,
    commands: &mut Vec<Command>,
) {
    headings_ui(ui);
    for (index, row) in rows.iter().enumerate() {
        row_ui(ui, index, row, standing, commands);
    }
}

/// Right ends of the columns; the last has no room in a narrow pane.
fn ends(area: Rect) -> Vec<f32> {
    let inner = area.shrink2(vec2(space::SMALL, 0.0));
    let count = if area.width() < NARROW {
        COLUMNS.len() - 1
    } else {
        COLUMNS.len()
    };
    let number = 14.0;
    let step = (inner.width() - number) / count as f32;
    (1..=count)
        .map(|column| inner.left() + number + step * column as f32)
        .collect()
}

fn headings_ui(ui: &mut Ui) {
    let (area, _) = ui.allocate_exact_size(vec2(ui.available_width(), LINE), Sense::hover());
    let colours = colours(ui);
    let wide = usize::from(area.width() > WIDE);
    let mut left = area.left();
    for (column, right) in ends(area).into_iter().enumerate() {
        let at = pos2(right, area.center().y);
        let text = COLUMNS[column][wide];
        ui.painter()
            .text(at, Align2::RIGHT_CENTER, text, note_font(), colours.muted);
        let cell = Rect::from_x_y_ranges(left..=right, area.y_range());
        let id = ui.scope_id().with(("patch column", column));
        ui.interact(cell, id, Sense::hover())
            .on_hover_text(COLUMNS[column][2]);
        left = right;
    }
    let stroke = (line::THIN, colours.line);
    ui.painter().hline(area.x_range(), area.bottom(), stroke);
}

/// The numbers of a row, without units.
fn numbers(row: &PatchRow) -> [String; COLUMNS.len()] {
    let area = row.area_cm2.map_or("–".to_owned(), |area| {
        if area < 9.95 {
            format!("{area:.1}")
        } else {
            format!("{area:.0}")
        }
    });
    let whole = |share: f64| format!("{:.0}", 100.0 * share);
    // A minus sign, and no minus zero.
    let thickening = whole(row.thickening).replace("-0", "0").replace('-', "−");
    [area, whole(row.share), thickening, whole(row.confidence)]
}

fn row_ui(
    ui: &mut Ui,
    index: usize,
    row: &PatchRow,
    standing: PatchStanding,
    commands: &mut Vec<Command>,
) {
    let colours = colours(ui);
    let width = ui.available_width();
    let words = ui.painter().layout(
        row.segments.clone(),
        note_font(),
        colours.muted,
        width - 14.0 - 2.0 * space::SMALL,
    );
    let height = LINE + words.size().y + space::SMALL;
    let (area, response) = ui.allocate_exact_size(vec2(width, height), Sense::click());
    let numbers = numbers(row);
    response.widget_info(|| {
        let [area, share, thickening, confidence] = &numbers;
        let name = format!(
            "{} {}: {area} cm², {share} % of the LV, thickening {thickening} %, confidence \
             {confidence} %, {}",
            standing.part(),
            index + 1,
            row.segments
        );
        WidgetInfo::selected(Role::Row, true, row.selected, name)
    });
    let painter = ui.painter();
    if row.selected {
        painter.rect_filled(area, f32::from(radius::CONTROL), colours.selected_row);
    } else if response.hovered() {
        painter.rect_filled(area, f32::from(radius::CONTROL), colours.control);
    }
    let middle = area.top() + 0.5 * LINE;
    painter.text(
        pos2(area.left() + space::SMALL, middle),
        Align2::LEFT_CENTER,
        (index + 1).to_string(),
        note_font(),
        match standing {
            PatchStanding::ThickensLittle => colours.muted,
            _ => colours.selection,
        },
    );
    for (text, right) in numbers.iter().zip(ends(area)) {
        let at = pos2(right, middle);
        painter.text(at, Align2::RIGHT_CENTER, text, text_font(), colours.text);
    }
    let at = pos2(area.left() + space::SMALL + 14.0, area.top() + LINE);
    painter.galley(at, words, colours.muted);
    focus_ring(ui, &response);
    if response.clicked() {
        commands.push(match row.camera {
            Some(camera) => Command::ShowPatch {
                patch: index,
                camera,
            },
            None => Command::SelectPart(Some(WallPart::Patch(index))),
        });
    }
    response.on_hover_text(match standing {
        PatchStanding::ThickensLittle => "Select this place and look at it",
        _ => "Select this patch and look at it",
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_carry_no_more_digits_than_they_deserve_and_a_true_minus() {
        let row = PatchRow {
            area_cm2: Some(4.26),
            share: 0.312,
            thickening: -0.034,
            confidence: 0.98,
            ..PatchRow::default()
        };
        assert_eq!(numbers(&row), ["4.3", "31", "−3", "98"]);
        let still = PatchRow {
            thickening: -0.001,
            ..PatchRow::default()
        };
        assert_eq!(numbers(&still)[0], "–");
        assert_eq!(numbers(&still)[2], "0");
    }
}
