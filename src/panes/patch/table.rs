//! The table of patches: numbers with units, segments below, a click selects and frames.

use egui::{Align2, Rect, Role, Sense, Ui, WidgetInfo, pos2, vec2};

use crate::panes::commands::{Command, WallCommand};
use crate::panes::patch::PatchLine;
use crate::picture::{PatchStanding, WallPart};
use crate::report::{Column, PatchRow};
use crate::ui::controls::focus_ring;
use crate::ui::style::{note_font, text_font};
use crate::ui::theme::{colours, line, radius, space};
use crate::units::LengthUnit;

/// Height of the line with the numbers.
const LINE: f32 = 20.0;
/// The columns; the last has no room in a narrow pane.
const COLUMNS: [Column<PatchRow>; PatchRow::IN_PANE.len()] = PatchRow::IN_PANE;
/// Width below which three columns have room.
const NARROW: f32 = 160.0;
/// Width from which headings are written out.
const WIDE: f32 = 330.0;

/// Draws the table over the whole width.
pub(super) fn table_ui(
    ui: &mut Ui,
    rows: &[PatchLine],
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
    let wide = area.width() > WIDE;
    let mut left = area.left();
    for (column, right) in COLUMNS.iter().zip(ends(area)) {
        let at = pos2(right, area.center().y);
        let text = match wide {
            // All of these units are the same for every subject.
            true => column.heading_with_unit(LengthUnit::default()),
            false => column.short_heading.to_owned(),
        };
        ui.painter()
            .text(at, Align2::RIGHT_CENTER, text, note_font(), colours.muted);
        let cell = Rect::from_x_y_ranges(left..=right, area.y_range());
        let id = ui.scope_id().with(("patch column", column.key));
        ui.interact(cell, id, Sense::hover())
            .on_hover_text(column.explanation);
        left = right;
    }
    let stroke = (line::THIN, colours.line);
    ui.painter().hline(area.x_range(), area.bottom(), stroke);
}

fn row_ui(
    ui: &mut Ui,
    index: usize,
    row: &PatchLine,
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
    response.widget_info(|| {
        let unit = LengthUnit::default();
        let numbers = COLUMNS.each_ref().map(|column| {
            format!(
                "{} {}",
                column.heading,
                column.shown_with_unit(&row.row, unit)
            )
        });
        let name = format!(
            "{} {}: {}, {}",
            standing.part(),
            index + 1,
            numbers.join(", "),
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
            PatchStanding::RegionOnly => colours.muted,
            _ => colours.selection,
        },
    );
    for (column, right) in COLUMNS.iter().zip(ends(area)) {
        let at = pos2(right, middle);
        // Short headings hold no percent sign.
        let is_bare = area.width() <= WIDE && !column.short_heading.contains(['%', '²']);
        let text = match is_bare {
            true => column.shown_with_unit(&row.row, LengthUnit::default()),
            false => column.shown(&row.row),
        };
        painter.text(at, Align2::RIGHT_CENTER, text, text_font(), colours.text);
    }
    let at = pos2(area.left() + space::SMALL + 14.0, area.top() + LINE);
    painter.galley(at, words, colours.muted);
    focus_ring(ui, &response);
    if response.clicked() {
        commands.push(match row.camera {
            Some(camera) => Command::Wall(WallCommand::ShowPatch {
                patch: index,
                camera,
            }),
            None => Command::Wall(WallCommand::SelectPart(Some(WallPart::Patch(index)))),
        });
    }
    response.on_hover_text(match standing {
        PatchStanding::RegionOnly => "Select this region and centre the view on it",
        _ => "Select this patch and centre the view on it",
    });
}
