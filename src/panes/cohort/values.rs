//! What the cohort table shows, as plain values.

use super::rows::CohortRow;
use crate::document::{CohortSort, Typing};
use crate::study::{Study, UnreadSubject};

/// What the cohort pane shows.
#[derive(Clone, Debug, Default)]
pub struct CohortView<'a> {
    /// All subjects in the order of the study.
    pub rows: &'a [CohortRow],
    /// Those shown, in the order shown: the answer of [`crate::panes::visible_rows`].
    pub visible: &'a [usize],
    /// The text in the filter box.
    pub search: &'a str,
    /// How the rows are sorted.
    pub sort: Option<CohortSort>,
    /// The selected subject.
    pub selected: Option<usize>,
    /// The second subject of the side-by-side view.
    pub compared: Option<usize>,
    /// Whether ejection fractions are being computed.
    pub measuring: bool,
    /// Whether verdicts are being computed.
    pub classifying: bool,
    /// Subjects that are still to be read.
    pub unread: &'a [UnreadSubject],
    /// The id of the one of them that is read before the others.
    pub awaited: Option<&'a str>,
    /// What edits of a row need.
    pub edits: CohortEdits<'a>,
}

/// What edits of a row need; the default is a table that cannot be edited.
#[derive(Clone, Copy, Debug, Default)]
pub struct CohortEdits<'a> {
    /// The study that is edited.
    pub study: Option<&'a Study>,
    /// The cell that is typed into.
    pub typing: Option<&'a Typing>,
    /// The frame on screen of the selected subject.
    pub frame: Option<usize>,
    /// The subject whose surface was clicked last.
    pub picked: Option<usize>,
}
