//! The measures card of a state.

use crate::document::state::State;
use crate::report::SubjectRow;

use super::MeasuresView;

/// What the measures card shows; `computing` says whether measures are still to come.
pub fn measures_view(state: &State, computing: bool) -> MeasuresView<'_> {
    let document = &state.document;
    let Some(subject) = document.selected() else {
        return MeasuresView::default();
    };
    let measures = match state.measures_of(document.subject) {
        // Unit and phases too are those that the numbers were made with: after an edit the measures before stay until
        // the new ones are there, and must not stand beside frames that they are not of.
        Some(measured) => SubjectRow::new(subject.id.clone(), subject.label.clone(), measured),
        None => {
            let (end_diastole, end_systole) = state.phases_of(document.subject);
            SubjectRow {
                unit: subject.unit,
                end_diastole,
                end_systole,
                phases_stated: end_diastole.is_some() || end_systole.is_some(),
                ..SubjectRow::default()
            }
        }
    };
    MeasuresView {
        subject: Some(&subject.id),
        computing,
        measures,
        current_frame: document.frame(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::measures::measure_subject;
    use crate::document::testing::{state_of, subject_with_frames};
    use crate::engine::Showing;
    use std::sync::Arc;

    #[test]
    fn phases_on_the_card_are_those_that_the_ejection_fraction_was_made_with() {
        let measured = measure_subject(&subject_with_frames("a", 6));
        let mut edited = subject_with_frames("a", 6);
        edited.end_systole = Some(2);
        let mut state = state_of(vec![edited]);
        let stated = measures_view(&state, true).measures;
        assert_eq!((stated.ef, stated.end_systole), (None, Some(2)));
        assert!(stated.phases_stated);
        // Those before the edit, while those after it are computed.
        state.answers.measures = Some(Showing::Ready(Arc::new(vec![measured])));
        let before = measures_view(&state, true).measures;
        assert!(before.ef.is_some() && !before.phases_stated);
        assert_eq!(
            (before.end_diastole, before.end_systole),
            (Some(0), Some(5))
        );
        assert_eq!(state.phases_of(0).1, Some(2));
    }
}
