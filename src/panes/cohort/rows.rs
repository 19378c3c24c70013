//! Which rows of the cohort are shown, and in which order.

use std::cmp::Ordering;

use crate::analysis::measures::EF_RANGE;
use crate::document::{CohortColumn, CohortSort};
use crate::panes::verdict_marks::VerdictMark;
use crate::report::SubjectRow;
use crate::study::{LabelClass, natural_order};
use crate::ui::LabelMark;
use crate::ui::marks::class_name;

/// The verdict on one subject.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CohortVerdict {
    /// The verdict as a shape.
    pub mark: VerdictMark,
    /// Share of the wall in abnormal patches; `None` without one.
    pub share: Option<f64>,
    /// Predicted probability of class abnormal, in `0..=1`; `None` where it is not assessed.
    pub probability: Option<f64>,
    /// In a sentence or two.
    pub words: String,
}

impl CohortVerdict {
    /// "patch 31 %".
    pub fn text(&self) -> String {
        let word = self.mark.word();
        match self.share {
            Some(share) => format!("{word} {:.0} %", 100.0 * share),
            None => word.to_owned(),
        }
    }

    /// For a narrow column, beside the mark: "31 %"; empty without an abnormal patch.
    pub fn short(&self) -> String {
        self.share
            .map_or_else(String::new, |share| format!("{:.0} %", 100.0 * share))
    }
}

/// One subject as the cohort table and the palette show it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CohortRow {
    /// Pseudonym.
    pub id: String,
    /// Free text of the study.
    pub label: Option<String>,
    /// Class of the label.
    pub class: LabelClass,
    /// Shape and colour of the label.
    pub mark: LabelMark,
    /// Ejection fraction as a fraction; `None` until it is computed or where it cannot be.
    pub ejection_fraction: Option<f64>,
    /// Its verdict; `None` until there is one.
    pub verdict: Option<CohortVerdict>,
    /// Number of frames.
    pub frame_count: usize,
    /// Warnings of the load report.
    pub warning_count: usize,
    /// Subjects whose vertices correspond have the same number.
    pub correspondence: usize,
    /// Whether no analysis of the cohort counts it.
    pub excluded: bool,
    /// Its place in the order of the input.
    pub place: usize,
    /// Whether the filter of the table leaves it out; maps then dim it.
    pub filtered_out: bool,
}

impl CohortRow {
    /// "56", in percent.
    pub fn ejection_fraction_text(&self) -> Option<String> {
        Some(SubjectRow::EF.shown_value(self.ejection_fraction?))
    }

    /// "Ejection fraction 56 %, normal 52–74 %".
    pub fn ejection_fraction_in_words(&self) -> Option<String> {
        let percent = self.ejection_fraction_text()?;
        let range = EF_RANGE.words();
        Some(format!("Ejection fraction {percent} %, normal {range}"))
    }
}

/// What the table knows of a column; `columns.rs` places it and draws its cells.
pub(super) struct CohortColumnSpec {
    /// Which column.
    pub column: CohortColumn,
    /// What stands above it; its mark alone has no room for words.
    pub heading: &'static str,
    /// What its heading does, as a screen reader says it.
    pub sort_by: &'static str,
    /// The same for who points at it.
    pub sort_hint: &'static str,
    /// What a row says in it, which the filter reads; `None` where there is no value.
    pub text: fn(&CohortRow) -> Option<String>,
    sort_key: fn(&CohortRow) -> Option<SortKey<'_>>,
}

/// What rows are ordered by.
enum SortKey<'a> {
    /// Runs of digits count as numbers.
    Words(&'a str),
    /// By the first, then by the second.
    Numbers([f64; 2]),
}

/// All columns from left to right.
pub(super) const COLUMNS: [CohortColumnSpec; 5] = [
    CohortColumnSpec {
        column: CohortColumn::Class,
        heading: "",
        sort_by: "Sort by Class",
        sort_hint: "Sort by Class",
        text: |row| Some(class_name(row.class).to_owned()),
        sort_key: |row| Some(SortKey::Numbers([f64::from(row.class as u8), 0.0])),
    },
    CohortColumnSpec {
        column: CohortColumn::Subject,
        heading: "Subject",
        sort_by: "Sort by Subject",
        sort_hint: "Sort by Subject",
        text: |row| Some(row.id.clone()),
        sort_key: |row| Some(SortKey::Words(&row.id)),
    },
    CohortColumnSpec {
        column: CohortColumn::Label,
        heading: "Label",
        sort_by: "Sort by Label",
        sort_hint: "Sort by Label",
        text: |row| row.label.clone(),
        sort_key: |row| row.label.as_deref().map(SortKey::Words),
    },
    CohortColumnSpec {
        column: CohortColumn::EjectionFraction,
        heading: "EF %",
        sort_by: "Sort by EF %",
        sort_hint: "Sort by EF %",
        text: CohortRow::ejection_fraction_text,
        sort_key: |row| Some(SortKey::Numbers([row.ejection_fraction?, 0.0])),
    },
    CohortColumnSpec {
        column: CohortColumn::Verdict,
        heading: "Verdict",
        sort_by: "Sort by Verdict",
        sort_hint: "Sort by verdict (predicted probability of abnormal)",
        text: |row| row.verdict.as_ref().map(CohortVerdict::text),
        sort_key: |row| {
            let verdict = row.verdict.as_ref()?;
            let mark = f64::from(verdict.mark as u8);
            Some(SortKey::Numbers([verdict.probability?, mark]))
        },
    },
];

/// Indices of the rows that match a search, sorted; rows that compare equal keep the study's order.
///
/// Every word of the search must occur in what the row says in its columns; letter case does not matter. Missing values come last in either direction.
pub fn visible_rows(rows: &[CohortRow], search: &str, sort: Option<CohortSort>) -> Vec<usize> {
    let words: Vec<String> = search.split_whitespace().map(str::to_lowercase).collect();
    let mut visible: Vec<usize> = (0..rows.len())
        .filter(|index| {
            let text = searchable(&rows[*index]);
            words.iter().all(|word| text.contains(word.as_str()))
        })
        .collect();
    visible.sort_by_key(|index| rows[*index].place);
    if let Some(sort) = sort {
        visible.sort_by(|a, b| compare(&rows[*a], &rows[*b], sort));
    }
    visible
}

/// "6 of 23" while a filter leaves subjects out.
pub fn count_text(shown: usize, count: usize) -> String {
    match shown == count {
        true => count.to_string(),
        false => format!("{shown} of {count}"),
    }
}

fn searchable(row: &CohortRow) -> String {
    let texts = COLUMNS.iter().filter_map(|column| (column.text)(row));
    let excluded = row.excluded.then(|| "excluded".into());
    texts
        .chain(excluded)
        .collect::<Vec<_>>()
        .join(" ")
        .to_lowercase()
}

fn compare(a: &CohortRow, b: &CohortRow, sort: CohortSort) -> Ordering {
    let Some(column) = COLUMNS.iter().find(|spec| spec.column == sort.column) else {
        return Ordering::Equal;
    };
    let order = |a: SortKey<'_>, b: SortKey<'_>| {
        let ascending = match (a, b) {
            (SortKey::Words(a), SortKey::Words(b)) => natural_order(a, b),
            (SortKey::Numbers([a, second_a]), SortKey::Numbers([b, second_b])) => {
                a.total_cmp(&b).then(second_a.total_cmp(&second_b))
            }
            // The keys of one column are of one kind.
            (SortKey::Words(_), SortKey::Numbers(_)) | (SortKey::Numbers(_), SortKey::Words(_)) => {
                Ordering::Equal
            }
        };
        match sort.descending {
            true => ascending.reverse(),
            false => ascending,
        }
    };
    missing_last((column.sort_key)(a), (column.sort_key)(b), order)
}

fn missing_last<T>(a: Option<T>, b: Option<T>, compare: impl Fn(T, T) -> Ordering) -> Ordering {
    match (a, b) {
        (Some(a), Some(b)) => compare(a, b),
        (Some(_), None) => Ordering::Less,
        (None, Some(_)) => Ordering::Greater,
        (None, None) => Ordering::Equal,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(id: &str, class: LabelClass, ef: Option<f64>) -> CohortRow {
        CohortRow {
            id: id.to_owned(),
            label: None,
            class,
            ejection_fraction: ef,
            ..CohortRow::default()
        }
    }

    fn cohort() -> Vec<CohortRow> {
        vec![
            row("P10", LabelClass::Abnormal, Some(0.31)),
            row("P2", LabelClass::Abnormal, None),
            row("N1", LabelClass::Normal, Some(0.62)),
        ]
    }

    #[test]
    fn every_word_of_a_search_must_occur() {
        assert_eq!(visible_rows(&cohort(), "abnormal p", None), [0, 1]);
        assert_eq!(visible_rows(&cohort(), "62", None), [2]);
        assert_eq!(visible_rows(&cohort(), "p 62", None), [0_usize; 0]);
    }

    #[test]
    fn numbers_in_names_count_as_numbers() {
        let sort = Some(CohortSort::default());
        assert_eq!(visible_rows(&cohort(), "", sort), [2, 1, 0]);
    }

    #[test]
    fn verdicts_are_found_by_their_words_and_sorted_by_probability() {
        let verdict = |mark, share, probability| {
            Some(CohortVerdict {
                mark,
                share,
                probability,
                words: String::new(),
            })
        };
        let mut rows = cohort();
        rows[0].verdict = verdict(VerdictMark::Patch, Some(0.312), Some(0.98));
        rows[1].verdict = verdict(VerdictMark::NotAssessed, None, None);
        rows[2].verdict = verdict(VerdictMark::NoAbnormality, None, Some(0.03));
        let texts = rows.iter().map(|row| row.verdict.as_ref().unwrap().text());
        let texts: Vec<String> = texts.collect();
        assert_eq!(texts, ["patch 31 %", "not assessed", "no finding"]);
        assert_eq!(visible_rows(&rows, "patch", None), [0]);
        assert_eq!(visible_rows(&rows, "not assessed", None), [1]);
        for (descending, order) in [(false, [2, 0, 1]), (true, [0, 2, 1])] {
            let sort = Some(CohortSort {
                column: CohortColumn::Verdict,
                descending,
            });
            assert_eq!(visible_rows(&rows, "", sort), order);
        }
    }

    #[test]
    fn missing_values_come_last_in_either_direction() {
        for (descending, order) in [(false, [0, 2, 1]), (true, [2, 0, 1])] {
            let sort = Some(CohortSort {
                column: CohortColumn::EjectionFraction,
                descending,
            });
            assert_eq!(visible_rows(&cohort(), "", sort), order);
        }
    }
}
