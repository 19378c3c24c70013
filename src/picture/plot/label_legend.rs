//! What the marks of labels mean: a line of marks with the names of their labels and how many subjects have each.

use std::collections::BTreeMap;

use crate::picture::figure::Pen;
use crate::picture::label_marks::LabelMark;
use crate::picture::page::Anchor;
use crate::study::Study;

use super::marks::draw_mark;

/// Widest name, in ems of running text.
const NAME_WIDTH_EM: f32 = 10.0;

/// One mark of a legend.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LegendEntry {
    /// The mark.
    pub mark: LabelMark,
    /// Its label, as the study writes it, with the number of subjects that have it.
    pub words: String,
}

impl LegendEntry {
    /// One entry per mark that `subjects` of a study have: normal first, without a label last.
    pub fn of(study: &Study, subjects: impl IntoIterator<Item = usize>) -> Vec<Self> {
        let marks = LabelMark::of_subjects(study);
        let mut counts: BTreeMap<LabelMark, (String, usize)> = BTreeMap::new();
        for index in subjects {
            let (Some(subject), Some(mark)) = (study.subject(index), marks.get(index)) else {
                continue;
            };
            let name = || (mark.name(subject.label.as_deref()), 0);
            counts.entry(*mark).or_insert_with(name).1 += 1;
        }
        (counts.into_iter())
            .map(|(mark, (name, count))| Self {
                mark,
                words: format!("{name} {count}"),
            })
            .collect()
    }
}

/// Where a legend stands, and how large its marks are.
#[derive(Clone, Copy, Debug)]
pub(in crate::picture) struct LegendPlace {
    pub(in crate::picture) left: f32,
    pub(in crate::picture) right: f32,
    /// Base line of its first line.
    pub(in crate::picture) base: f32,
    /// Base line below which no line stands.
    pub(in crate::picture) last: f32,
    /// Half the size of a mark.
    pub(in crate::picture) mark: f32,
}

/// Draws a legend on as many lines as there is room for; returns the base line of the last one.
pub(in crate::picture) fn draw_label_legend(
    pen: &mut Pen<'_>,
    entries: &[LegendEntry],
    place: LegendPlace,
) -> f32 {
    let LegendPlace { left, mark, .. } = place;
    let (set, line) = (pen.regular(pen.theme.muted), pen.line_height());
    let (mut x, mut base) = (left + mark, place.base);
    for (index, entry) in entries.iter().enumerate() {
        let most = NAME_WIDTH_EM * pen.text;
        let words = pen
            .fonts
            .shortened(&entry.words, set.weight, set.size, most);
        let width = pen.fonts.width(&words, set.weight, set.size);
        // The end of the last line is for the number of those that have no room.
        let on_last_line = base + line > place.last;
        let kept = if on_last_line { 4.5 * pen.text } else { 0.0 };
        if x + 2.0 * mark + width > place.right - kept && index > 0 {
            if on_last_line {
                let more = format!("and {} more", entries.len() - index);
                pen.write(&more, set, Anchor::Start, [x, base]);
                return base;
            }
            (x, base) = (left + mark, base + line);
        }
        let colour = entry.mark.colour_on(pen.theme);
        let middle = [x, base - 0.35 * pen.text];
        draw_mark(pen.page, entry.mark, colour, middle, mark, true);
        x += 2.0 * mark;
        x += pen.write(&words, set, Anchor::Start, [x, base]) + 4.0 * mark;
    }
    base
}
