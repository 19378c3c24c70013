//! Positions of the columns of the cohort table, and their cells.

use egui::{Align2, Ui, pos2};

use crate::document::{CohortColumn, TypedField};
use crate::panes::cohort::rows::CohortVerdict;
use crate::panes::verdict_marks::verdict_mark;
use crate::report::NO_VALUE;
use crate::ui::style::{note_font, text_font};
use crate::ui::text::text_width;
use crate::ui::theme::{colours, space};

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
/// Room of the heading over names, with the arrow of sorting.
const HEADING_WIDTH: f32 = 54.0;
/// Room that a label needs; with less its mark alone stands for it.
const LABEL_WIDTH: f32 = 46.0;
/// Room of a cell that is typed into.
const TYPING_WIDTH: f32 = 110.0;
/// Room of "100" and of its heading.
const EF_WIDTH: f32 = 38.0;

impl VerdictRoom {
    fn width(self) -> f32 {
        match self {
            Self::Words => VERDICT_MARK + 70.0,
            Self::Share => VERDICT_MARK + 36.0,
            Self::Mark => VERDICT_MARK,
        }
    }
}

impl Columns {
    /// Subject, ejection fraction and verdict have room first. Labels have a column where room is left, and what names
    /// of this width at most do not need; elsewhere, and in a study without labels, names take it.
    pub(super) fn within(across: egui::Rangef, labelled: bool, names: f32) -> Self {
        let inner = across.shrink(space::LARGE);
        let from = inner.min + 22.0;
        let free_beside = |room: VerdictRoom| inner.max - room.width() - GAP - EF_WIDTH - from;
        let room = [VerdictRoom::Words, VerdictRoom::Share]
            .into_iter()
            .find(|room| free_beside(*room) >= SUBJECT_WIDTH)
            .unwrap_or(VerdictRoom::Mark);
        let verdict = [inner.max - room.width(), inner.max];
        let to = verdict[0] - GAP;
        let free = free_beside(room).max(0.0);
        let labelled = labelled && free >= SUBJECT_WIDTH + space::MEDIUM + LABEL_WIDTH;
        Self {
            mark: inner.min + 6.0,
            subject: from,
            label: if labelled {
                let most = (free * 0.56).max(SUBJECT_WIDTH + space::MEDIUM);
                from + most.min(names.max(HEADING_WIDTH) + space::MEDIUM)
            } else {
                from + free
            },
            ejection_fraction: to,
            verdict,
            room,
        }
    }

    /// Where a cell of a row is typed into: at least so wide that a label fits.
    pub(super) fn typing_cell(&self, field: TypedField, row: egui::Rect) -> egui::Rect {
        let [left, right] = match field {
            TypedField::Label => self.span(CohortColumn::Label),
            TypedField::Name => self.span(CohortColumn::Subject),
        };
        // Where labels have no column, they begin where names end.
        let left = left.min(self.verdict[0] - TYPING_WIDTH);
        let right = right.max(left + TYPING_WIDTH);
        egui::Rect::from_x_y_ranges(left - space::SMALL..=right, row.y_range().shrink(1.0))
    }

    /// Room of a column, for its heading and its text.
    pub(super) fn span(&self, column: CohortColumn) -> [f32; 2] {
        let gap = space::MEDIUM;
        match column {
            CohortColumn::Role => [self.mark - 10.0, self.subject - 2.0],
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

/// In place of the verdict on a subject that is excluded from the cohort.
pub(super) fn excluded_cell(ui: &Ui, columns: &Columns, y: f32) {
    let muted = colours(ui).muted;
    let at = pos2(columns.verdict[0], y);
    let text = match columns.room {
        VerdictRoom::Mark => "–",
        VerdictRoom::Words | VerdictRoom::Share => "excluded",
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

/// First letters of a name that stay when its middle is left out, and how many last ones go before them.
const HEAD: usize = 3;
const TAIL: usize = 8;

/// A name with as little left out of its middle as makes it fit.
fn without_middle(name: &str, fits: impl Fn(&str) -> bool) -> String {
    let letters: Vec<char> = name.chars().collect();
    if letters.len() <= HEAD + 2 || fits(name) {
        return name.to_owned();
    }
    let part = |letters: &[char]| letters.iter().collect::<String>();
    let fitting = |head: usize| {
        let shown = |from: usize| format!("{}…{}", part(&letters[..head]), part(&letters[from..]));
        let mut from = head + 1..letters.len() - 1;
        let found = from.find(|&from| fits(&shown(from)));
        let from = found.unwrap_or(letters.len() - 1);
        (letters.len() - from, shown(from))
    };
    let (tail, shown) = fitting(HEAD);
    let number = significant_number(&letters);
    let holds_number = |tail: usize| number.is_none_or(|start| letters.len() - tail <= start);
    if tail >= TAIL && holds_number(tail) {
        return shown;
    }
    // Names of one study begin alike: its letters say less than the last ones, and those less than a number.
    let (tail, shown) = fitting(1);
    if holds_number(tail) {
        return shown;
    }
    let from_number = number.and_then(|start| {
        let mut ends = (start + 1..letters.len()).rev();
        ends.find_map(|end| {
            let shown = format!("…{}…", part(&letters[start..end]));
            fits(&shown).then_some(shown)
        })
    });
    from_number.unwrap_or(shown)
}

/// Where the last number of a name begins, without the zeros in front of it.
fn significant_number(letters: &[char]) -> Option<usize> {
    let last = letters.iter().rposition(char::is_ascii_digit)?;
    let before = letters[..last].iter().rposition(|c| !c.is_ascii_digit());
    let start = before.map_or(0, |before| before + 1);
    let zeros = letters[start..last].iter().take_while(|c| **c == '0');
    Some(start + zeros.count())
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
    fn a_name_keeps_its_beginning_and_its_end() {
        let fits = |max: usize| move |shown: &str| shown.chars().count() <= max;
        assert_eq!(without_middle("patient015", fits(10)), "patient015");
        assert_eq!(without_middle("patient015", fits(8)), "p…ent015");
        assert_eq!(without_middle("patient015", fits(2)), "p…5");
        let long = "Patient000151_stress";
        assert_eq!(without_middle(long, fits(14)), "Pat…151_stress");
        assert_eq!(without_middle(long, fits(13)), "P…0151_stress");
        assert_eq!(without_middle(long, fits(10)), "…151_stre…");
        assert_eq!(without_middle(long, fits(6)), "…151_…");
        assert_eq!(without_middle("Patient_of_no_number", fits(9)), "P…_number");
        assert_eq!(without_middle("P03", fits(1)), "P03");
        assert_eq!(without_middle("", fits(0)), "");
    }
}
