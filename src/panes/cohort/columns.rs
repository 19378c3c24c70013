//! Positions of the columns of the cohort table, and their cells.

use egui::{Align2, Ui, pos2, vec2};

use crate::document::{CohortColumn, TypedField};
use crate::panes::cohort::rows::CohortVerdict;
use crate::panes::verdict_marks::verdict_mark;
use crate::report::NO_VALUE;
use crate::ui::style::{note_font, text_font};
use crate::ui::text::{text_width, without_middle};
use crate::ui::theme::{colours, line, space};

/// Horizontal places of the columns.
pub(super) struct Columns {
    pub(super) mark: f32,
    pub(super) subject: f32,
    pub(super) label: f32,
    /// Right edge: numbers end here.
    pub(super) ejection_fraction: f32,
    /// Left and right edge of the verdicts.
    pub(super) verdict: [f32; 2],
    /// What the verdict's column has room for.
    pub(super) room: VerdictRoom,
}

/// What there is room for beside the mark of a verdict.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum VerdictRoom {
    /// "patch 31 %".
    Words,
    /// "31 %".
    Share,
    /// The mark alone.
    Mark,
}

/// Room between the ejection fraction and the verdict.
const GAP: f32 = space::MEDIUM + 2.0;
/// Width of the mark of a verdict with the gap after it.
const VERDICT_MARK: f32 = 14.0;
/// Room that a subject's name has before a verdict has words or a share.
const SUBJECT_WIDTH: f32 = 64.0;
/// Longer names have this much room before them at most: their middle can be left out.
const NAME_WIDTH: f32 = 150.0;
/// Room of the heading over names, with the arrow of sorting.
const HEADING_WIDTH: f32 = 54.0;
/// Room that a label needs; with less its mark alone stands for it.
const LABEL_WIDTH: f32 = 46.0;
/// Room of a cell that is typed into.
const TYPING_WIDTH: f32 = 110.0;
/// Room of "100" and of its heading.
const EF_WIDTH: f32 = 38.0;
/// Room of "100" alone.
const EF_NUMBER_WIDTH: f32 = 28.0;

impl VerdictRoom {
    fn width(self) -> f32 {
        match self {
            Self::Words => VERDICT_MARK + 78.0,
            Self::Share => VERDICT_MARK + 36.0,
            Self::Mark => VERDICT_MARK,
        }
    }
}

impl Columns {
    /// Subject, ejection fraction and the mark of the verdict have room first: names tell patients apart, and the words of
    /// a verdict yield where names of this width at most do not fit. Labels have a column where room is left; elsewhere,
    /// and in a study without labels, names take it.
    pub(super) fn within(across: egui::Rangef, labelled: bool, names: f32) -> Self {
        let inner = across.shrink(space::LARGE);
        let from = inner.min + 22.0;
        let free_beside = |room: VerdictRoom| inner.max - room.width() - GAP - EF_WIDTH - from;
        let subject = (names + space::MEDIUM).clamp(SUBJECT_WIDTH, NAME_WIDTH);
        let room = [VerdictRoom::Words, VerdictRoom::Share]
            .into_iter()
            .find(|room| free_beside(*room) >= subject)
            .unwrap_or(VerdictRoom::Mark);
        let verdict = [inner.max - room.width(), inner.max];
        let to = verdict[0] - GAP;
        let free = free_beside(room).max(0.0);
        let labelled = labelled && free >= subject + LABEL_WIDTH;
        Self {
            mark: inner.min + 6.0,
            subject: from,
            label: if labelled {
                let most = (free * 0.56).max(subject);
                from + most.min(names.max(HEADING_WIDTH) + space::MEDIUM)
            } else {
                from + free
            },
            ejection_fraction: to,
            verdict,
            room,
        }
    }

    /// Where a cell of a row is typed into: a label beside the name of this width, which stays readable; a name in its
    /// place, beside the ejection fraction.
    pub(super) fn typing_cell(&self, field: TypedField, row: egui::Rect, name: f32) -> egui::Rect {
        let [left, right] = match field {
            TypedField::Label => {
                let [left, right] = self.span(CohortColumn::Label);
                let end = row.right() - space::SMALL;
                // Where labels have no column, they take the room of the numbers.
                let left = left.min(end - TYPING_WIDTH);
                let left = left.max(self.subject + name + space::MEDIUM);
                [left, right.max(left + TYPING_WIDTH).min(end)]
            }
            TypedField::Name => {
                let [left, right] = self.span(CohortColumn::Subject);
                let end = self.ejection_fraction - EF_NUMBER_WIDTH;
                [left, right.max((left + TYPING_WIDTH).min(end))]
            }
        };
        egui::Rect::from_x_y_ranges(left - space::SMALL..=right, row.y_range().shrink(1.0))
    }

    /// Room of a column, for its heading and its text.
    pub(super) fn span(&self, column: CohortColumn) -> [f32; 2] {
        let gap = space::MEDIUM;
        match column {
            CohortColumn::Class => [self.mark - 10.0, self.subject - 2.0],
            CohortColumn::Subject => [self.subject, self.label - gap],
            CohortColumn::Label => [self.label, self.ejection_fraction - EF_WIDTH],
            CohortColumn::EjectionFraction => {
                [self.ejection_fraction - EF_WIDTH, self.ejection_fraction]
            }
            CohortColumn::Verdict => self.verdict,
        }
    }
}

/// The mark of a verdict and as many words as there is room for.
pub(super) fn verdict_cell(
    ui: &Ui,
    columns: &Columns,
    y: f32,
    verdict: Option<&CohortVerdict>,
    classifying: bool,
) {
    let colours = colours(ui);
    let left = columns.verdict[0];
    let write = |x: f32, text: String, colour| {
        let at = pos2(x, y);
        ui.painter()
            .text(at, Align2::LEFT_CENTER, text, note_font(), colour);
    };
    let Some(verdict) = verdict else {
        write(
            left,
            if classifying { "…" } else { NO_VALUE }.to_owned(),
            colours.muted,
        );
        return;
    };
    let colour = verdict.mark.colour(colours);
    let centre = pos2(left + 4.0, y);
    verdict_mark(ui.painter(), centre, 4.5, verdict.mark, colour);
    let text = match columns.room {
        VerdictRoom::Words => verdict.text(),
        VerdictRoom::Share => verdict.short(),
        VerdictRoom::Mark => return,
    };
    let patch = verdict.share.is_some();
    let colour = if patch { colours.text } else { colours.muted };
    write(left + VERDICT_MARK, text, colour);
}

/// In place of the verdict on a subject that is excluded from the cohort: a word, or a struck-out ring where it has no room.
pub(super) fn excluded_cell(ui: &Ui, columns: &Columns, y: f32) {
    let muted = colours(ui).muted;
    let at = pos2(columns.verdict[0], y);
    let text = match columns.room {
        VerdictRoom::Mark => {
            let stroke = egui::Stroke::new(line::MARK, muted);
            let (centre, radius) = (at + vec2(4.0, 0.0), 5.0);
            let arm = radius * vec2(0.7, -0.7);
            ui.painter().circle_stroke(centre, radius, stroke);
            ui.painter()
                .line_segment([centre - arm, centre + arm], stroke);
            return;
        }
        VerdictRoom::Share => "excl.",
        VerdictRoom::Words => "excluded",
    };
    ui.painter()
        .text(at, Align2::LEFT_CENTER, text, note_font(), muted);
}

/// A number that ends at the right edge of its column, or a mark that it is missing or still to come.
pub(super) fn number_cell(
    ui: &Ui,
    right: f32,
    y: f32,
    number: Option<String>,
    colour: egui::Color32,
    coming: bool,
) {
    let missing = if coming { "…" } else { NO_VALUE };
    let (text, colour) = match number {
        Some(text) => (text, colour),
        None => (missing.to_owned(), colours(ui).muted),
    };
    let at = pos2(right, y);
    ui.painter()
        .text(at, Align2::RIGHT_CENTER, text, text_font(), colour);
}

/// Text of one cell, cut off with an ellipsis where the column ends; returns where it is.
pub(super) fn cell(
    ui: &Ui,
    columns: &Columns,
    column: CohortColumn,
    y: f32,
    text: &str,
    colour: egui::Color32,
) -> egui::Rect {
    let [left, right] = columns.span(column);
    let max_width = (right - left).max(8.0);
    // Names of one study often begin alike and differ at their end.
    let text = match column {
        CohortColumn::Subject => without_middle(text, |shown| {
            text_width(ui, shown, text_font()) <= max_width
        }),
        _ => text.to_owned(),
    };
    let mut job = egui::text::LayoutJob::simple_singleline(text, text_font(), colour);
    job.wrap = egui::text::TextWrapping::truncate_at_width(max_width);
    let galley = ui.painter().layout_job(job);
    let at = pos2(left, y - 0.5 * galley.size().y);
    let place = egui::Rect::from_min_size(at, galley.size());
    ui.painter().galley(at, galley, colour);
    place
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::panes::cohort::rows::COLUMNS;

    #[test]
    fn columns_never_overlap_and_subject_and_verdict_go_before_the_label() {
        for labelled in [true, false] {
            for width in 176..420 {
                let columns =
                    Columns::within(egui::Rangef::new(0.0, width as f32), labelled, 200.0);
                let spans = COLUMNS.map(|spec| columns.span(spec.column));
                let shown: Vec<[f32; 2]> = spans
                    .into_iter()
                    .filter(|[left, right]| left < right)
                    .collect();
                for pair in shown.windows(2) {
                    assert!(pair[0][1] <= pair[1][0], "{width}: {pair:?}");
                }
                let [left, right] = columns.span(CohortColumn::Subject);
                assert!(right - left >= 56.0, "{width}: {}", right - left);
                let [left, right] = columns.span(CohortColumn::Label);
                assert!(right <= left || right - left >= LABEL_WIDTH, "{width}");
            }
        }
    }

    #[test]
    fn the_words_of_verdicts_yield_to_names_that_do_not_fit() {
        let pane = egui::Rangef::new(7.0, 261.0);
        let name_width = |columns: &Columns| {
            let [left, right] = columns.span(CohortColumn::Subject);
            right - left
        };
        for (names, words) in [(24.0, true), (58.0, true), (138.0, false)] {
            for labelled in [true, false] {
                let columns = Columns::within(pane, labelled, names);
                assert_eq!(columns.room == VerdictRoom::Words, words, "{names}");
                assert!(name_width(&columns) >= names, "{names}");
            }
        }
        // The end of "not assessed" keeps clear of the dots that open the menu of a row.
        let columns = Columns::within(pane, false, 24.0);
        assert!(columns.verdict[1] - columns.verdict[0] - VERDICT_MARK >= 76.0);
    }

    #[test]
    fn who_types_sees_whose_row_it_is_and_the_ejection_fraction() {
        let row = egui::Rect::from_x_y_ranges(7.0..=196.0, 0.0..=24.0);
        for width in [189.0, 254.0, 300.0, 420.0] {
            let pane = egui::Rangef::new(7.0, 7.0 + width);
            let row = egui::Rect::from_x_y_ranges(pane, row.y_range());
            for names in [24.0, 60.0] {
                let columns = Columns::within(pane, true, names);
                let cell = columns.typing_cell(TypedField::Label, row, names);
                assert!(cell.left() >= columns.subject + names, "{width}: {cell}");
                assert!(
                    cell.width() > 60.0 && row.contains_rect(cell),
                    "{width}: {cell}"
                );
                let cell = columns.typing_cell(TypedField::Name, row, names);
                let number = columns.ejection_fraction - 24.0;
                assert!(
                    cell.right() <= number && cell.width() > 60.0,
                    "{width}: {cell}"
                );
            }
        }
    }
}
