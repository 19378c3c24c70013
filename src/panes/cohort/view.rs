//! The cohort table: rows from subjects and measures, kept until one of them changes.

use super::rows::{CohortRow, visible_rows};
use super::values::{CohortEdits, CohortView};
use crate::analysis::measures::SubjectMeasures;
use crate::analysis::verdicts::Verdicts;
use crate::document::CohortSort;
use crate::document::state::State;
use crate::panes::pane_context::{Kept, PaneContext};
use crate::panes::same::Same;
use crate::panes::verdict::view::cohort_verdict;
use crate::study::{Revision, Severity, Study, Subject};
use crate::ui::LabelMark;

/// What rows are made from: measures and verdicts as long as they are the same ones.
type MadeFrom = (
    Revision,
    Option<Same<Vec<SubjectMeasures>>>,
    Option<Same<Verdicts>>,
);

/// The rows of this frame, which the maps and the palette show, too.
pub fn cohort_data(cx: &PaneContext<'_>) -> Kept<CohortData> {
    let data = cx.memo().get::<CohortData>();
    data.borrow_mut().refresh(cx.state());
    data
}

/// Rows of the table with what they were made from.
#[derive(Debug, Default)]
pub struct CohortData {
    made_from: Option<MadeFrom>,
    rows: Vec<CohortRow>,
    filtered_by: Option<(String, Option<CohortSort>)>,
    visible: Vec<usize>,
}

impl CohortData {
    /// Makes rows again where the study, the measures, the verdicts, the filter or the order changed.
    pub fn refresh(&mut self, state: &State) {
        let verdicts = state.verdicts().map(|(verdicts, _)| verdicts);
        let revision = state.document.study().revision;
        let sources = (revision, Same::of(state.measures()), Same::of(verdicts));
        if self.made_from.as_ref() != Some(&sources) {
            self.rows = cohort_rows(state);
            self.made_from = Some(sources);
            self.filtered_by = None;
        }
        let document = &state.document;
        let filter = (&document.search, document.sorting);
        if self.filtered_by.as_ref().map(|(s, o)| (s, *o)) != Some(filter) {
            self.visible = visible_rows(&self.rows, &document.search, document.sorting);
            for row in &mut self.rows {
                row.filtered_out = true;
            }
            for &shown in &self.visible {
                if let Some(row) = self.rows.get_mut(shown) {
                    row.filtered_out = false;
                }
            }
            self.filtered_by = Some((document.search.clone(), document.sorting));
        }
    }

    /// The subjects of the cohort by their indices: those that maps show.
    pub fn rows(&self) -> &[CohortRow] {
        let cohort = self.rows.iter().position(|row| row.excluded);
        &self.rows[..cohort.unwrap_or(self.rows.len())]
    }

    /// All subjects by their indices, excluded ones last.
    pub fn all_rows(&self) -> &[CohortRow] {
        &self.rows
    }

    /// How many subjects the filter shows.
    pub fn shown_count(&self) -> usize {
        self.visible.len()
    }

    /// What the pane shows; the last two say whether measures and verdicts are still to come.
    pub fn view<'a>(
        &'a self,
        state: &'a State,
        [measuring, classifying]: [bool; 2],
    ) -> CohortView<'a> {
        let document = &state.document;
        CohortView {
            rows: &self.rows,
            visible: &self.visible,
            search: &document.search,
            sort: document.sorting,
            selected: document.selected_index(),
            compared: document.compared_on_screen(),
            measuring,
            classifying,
            unread: &document.study().unread,
            awaited: state.awaited.as_deref(),
            edits: CohortEdits {
                study: Some(document.study()),
                typing: state.typing.as_ref(),
                frame: document.selected().map(|_| document.frame()),
                picked: state.picked.map(|point| point.subject),
            },
        }
    }
}

/// Indices of the subjects that the table shows, in its order.
pub fn visible_subjects(state: &State) -> Vec<usize> {
    let document = &state.document;
    visible_rows(&cohort_rows(state), &document.search, document.sorting)
}

/// Shape and colour of the label of every subject.
pub fn label_marks(study: &Study) -> Vec<LabelMark> {
    LabelMark::of_subjects(study)
}

fn cohort_rows(state: &State) -> Vec<CohortRow> {
    let study = state.document.study();
    let marks = label_marks(study);
    let mut groups = Vec::new();
    let mut group_of = |subject: &Subject| {
        let key = subject.sequence.correspondence();
        let known = groups.iter().position(|other| *other == key);
        known.unwrap_or_else(|| {
            groups.push(key);
            groups.len() - 1
        })
    };
    let mut places = vec![0; study.count()];
    for (place, index) in study.in_order().into_iter().enumerate() {
        places[index] = place;
    }
    (study.all().enumerate())
        .map(|(index, subject)| CohortRow {
            excluded: study.is_excluded(index),
            place: places[index],
            correspondence: group_of(subject),
            id: subject.id.clone(),
            label: subject.label.clone(),
            class: study.class_of(subject),
            mark: marks.get(index).copied().unwrap_or_default(),
            ejection_fraction: state.measures_of(index).and_then(|measures| measures.ef),
            verdict: cohort_verdict(state, index),
            frame_count: subject.sequence.frame_count(),
            filtered_out: false,
            warning_count: subject
                .notices
                .iter()
                .filter(|notice| notice.severity == Severity::Warning)
                .count(),
        })
        .collect()
}
