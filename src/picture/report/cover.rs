//! The first pages: verdicts of the subjects, and the classifier that they come from.

use crate::picture::figure::Pen;
use crate::picture::page::{Anchor, FigureFonts, Page, Weight};
use crate::picture::report::content::{Row, classes, classifier, counts, heads, rows};
use crate::picture::report::order::ReportOrder;
use crate::picture::report::sheet::{BOTTOM, LINE, MARGIN, SIZE, TEXT, THEME, pen, sheet};
use crate::units::LengthUnit;

/// Left edges of the columns; numbers end before the next one begins.
const COLUMNS: [f32; 8] = [0.0, 170.0, 300.0, 390.0, 520.0, 770.0, 900.0, 1080.0];
/// Columns of numbers.
const NUMBERS: [usize; 4] = [2, 3, 5, 6];
/// Between a number and the next column.
const GAP: f32 = 22.0;

/// Title, summary and the table of subjects, on as many sheets as it takes.
pub(super) fn cover_pages(order: &ReportOrder<'_>, fonts: &FigureFonts) -> Vec<Page> {
    let mut pages = vec![sheet()];
    let mut base = summary(&mut pen(&mut pages[0], fonts), order);
    let unit = order.study.subjects.first().map(|subject| subject.unit);
    let heads = heads(unit.unwrap_or(LengthUnit::Millimetre));
    let rows = rows(order);
    let mut begun = false;
    for row in &rows {
        let notes = fonts.wrapped(
            &row[7],
            Weight::Regular,
            0.87 * TEXT,
            SIZE[0] - 2.0 * MARGIN - COLUMNS[1],
        );
        let height = LINE * (1.0 + notes.len() as f32);
        if base + height > BOTTOM {
            pages.push(sheet());
            base = MARGIN + TEXT;
            begun = false;
        }
        let Some(page) = pages.last_mut() else {
            break;
        };
        let mut pen = pen(page, fonts);
        if !begun {
            base = head_row(&mut pen, &heads, base);
            begun = true;
        }
        write_row(&mut pen, row, base, THEME.text);
        let mut small = pen.regular(THEME.muted);
        small.size *= 0.87;
        for (step, words) in notes.iter().enumerate() {
            let at = [MARGIN + COLUMNS[1], base + LINE * (step as f32 + 1.0)];
            pen.write(words, small, Anchor::Start, at);
        }
        base += height;
    }
    pages
}

/// Title and paragraphs; returns the base line of what follows.
fn summary(pen: &mut Pen<'_>, order: &ReportOrder<'_>) -> f32 {
    let study = order.study;
    let room = SIZE[0] - 2.0 * MARGIN;
    let mut base = MARGIN + 36.0;
    let title = pen.strong(THEME.text, 40.0);
    pen.write_within(&study.name, title, Anchor::Start, [MARGIN, base], room);
    base += 1.6 * LINE;
    let poses: usize = (study.subjects.iter())
        .map(|subject| subject.sequence.frame_count())
        .sum();
    let size = format!("{} subjects, {poses} poses", study.subjects.len());
    let muted = pen.regular(THEME.muted);
    pen.write(&size, muted, Anchor::Start, [MARGIN, base]);
    base += 1.8 * LINE;
    let counted = pen.strong(THEME.text, 1.2 * TEXT);
    for words in pen
        .fonts
        .wrapped(&counts(order.verdicts), Weight::SemiBold, 1.2 * TEXT, room)
    {
        pen.write(&words, counted, Anchor::Start, [MARGIN, base]);
        base += 1.2 * LINE;
    }
    let results =
        std::iter::once(classifier(order.verdicts)).chain(order.classes.and_then(classes));
    let strong = pen.regular(THEME.text);
    let paragraphs = (results.map(|words| (words, strong)))
        .chain(order.parameters.iter().cloned().map(|words| (words, muted)));
    for (paragraph, set) in paragraphs {
        for words in pen.fonts.wrapped(&paragraph, Weight::Regular, TEXT, room) {
            pen.write(&words, set, Anchor::Start, [MARGIN, base]);
            base += LINE;
        }
        base += 0.4 * LINE;
    }
    base + LINE
}

fn head_row(pen: &mut Pen<'_>, heads: &Row, base: f32) -> f32 {
    write_row(pen, heads, base, THEME.muted);
    let below = base + 0.4 * LINE;
    let ends = [[MARGIN, below], [SIZE[0] - MARGIN, below]];
    pen.page.line(&ends, false, 1.4, THEME.line);
    base + 1.4 * LINE
}

/// All cells but the note.
fn write_row(pen: &mut Pen<'_>, row: &Row, base: f32, colour: [f32; 3]) {
    let set = pen.regular(colour);
    for (column, cell) in row.iter().enumerate().take(7) {
        let (left, right) = (MARGIN + COLUMNS[column], MARGIN + COLUMNS[column + 1] - GAP);
        let (anchor, x) = if NUMBERS.contains(&column) {
            (Anchor::End, right)
        } else {
            (Anchor::Start, left)
        };
        pen.write_within(cell, set, anchor, [x, base], right - left);
    }
}
