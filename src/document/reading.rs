//! A study that is shown while it is read: subjects that were read since come into the document, and into all that undo
//! restores.

use std::sync::Arc;

use crate::analysis::transport::Reference;
use crate::document::document::{Document, OpeningReport, TransportChoice};
use crate::document::state::State;
use crate::study::{ReadSubject, Revision, Study};

/// A study of later, and where it has the subjects of the one before.
type Grown = (Study, Vec<usize>);

impl State {
    /// Shows a study whose other subjects are still to be read.
    pub fn begin_reading(&mut self, study: Study) {
        self.show_study(Arc::new(study), OpeningReport::default());
        self.reading = Some(self.last_opening);
        self.awaited = None;
    }

    /// Takes in subjects that were read; whether anybody can still see the study that they are of.
    pub fn add_read(&mut self, read: &[ReadSubject], fresh: &mut dyn FnMut() -> Revision) -> bool {
        let found = self.grow(None, &mut |study| study.with_read(read, fresh()));
        self.select_awaited();
        found
    }

    /// Nothing further is read: what is unread leaves the study.
    pub fn end_reading(&mut self, report: OpeningReport, fresh: &mut dyn FnMut() -> Revision) {
        let report = Arc::new(report);
        self.grow(Some(&report), &mut |study| {
            // Where all was read it is the same study, of which much may be known by now.
            let settled = match study.unread.is_empty() {
                true => study.clone(),
                false => study.without_unread(fresh()),
            };
            (settled, (0..study.subjects.len()).collect())
        });
        self.reading = None;
        self.awaited = None;
    }

    /// Selects the subject that the user waits for, once it is read.
    pub fn select_awaited(&mut self) {
        let Some(id) = &self.awaited else {
            return;
        };
        // After an undo another study may be on screen, in which the id names somebody else.
        if self.reading != Some(self.document.study.opening) {
            return;
        }
        let study = self.document.study();
        if let Some(index) = study.index_of(id) {
            let before = self.document.clone();
            self.document.select_subject(index);
            self.document.end_transport_out_of_sight();
            self.history.record(before, None, false, 0.0);
            self.awaited = None;
        } else if study.unread.iter().all(|unread| unread.id != *id) {
            self.message = format!("{id} cannot be read");
            self.awaited = None;
        }
    }

    /// Puts later states of the study that is being read in place of those in the document and in its history.
    fn grow(
        &mut self,
        report: Option<&Arc<OpeningReport>>,
        grow: &mut dyn FnMut(&Study) -> Grown,
    ) -> bool {
        let Some(opening) = self.reading else {
            return false;
        };
        // Steps of undo share a study, and share what it becomes.
        let mut grown: Vec<(Arc<Study>, Arc<Study>, Vec<usize>)> = Vec::new();
        let kept = &mut self.kept;
        let mut grow_in = |document: &mut Document| {
            if document.study.opening != opening {
                return None;
            }
            let before = document.study();
            let known = grown
                .iter()
                .position(|(known, ..)| Arc::ptr_eq(known, before));
            let place = known.unwrap_or_else(|| {
                let (after, index) = grow(before);
                // What is read since is no edit.
                if kept.contains(&before.revision) {
                    kept.insert(after.revision);
                }
                grown.push((Arc::clone(before), Arc::new(after), index));
                grown.len() - 1
            });
            let (_, after, index) = &grown[place];
            document.study.study = Arc::clone(after);
            if let Some(report) = report {
                document.study.report = Arc::clone(report);
            }
            follow(document, index);
            Some(index.clone())
        };
        let on_screen = grow_in(&mut self.document);
        let mut found = on_screen.is_some();
        for document in self.history.documents() {
            found |= grow_in(document).is_some();
        }
        if let Some(index) = on_screen {
            self.answers.follow(&index);
            let now =
                |subject: &mut usize| *subject = index.get(*subject).copied().unwrap_or(*subject);
            if let Some(typing) = &mut self.typing {
                now(&mut typing.subject);
                typing.subjects.iter_mut().for_each(now);
            }
            if let Some(picked) = &mut self.picked {
                now(&mut picked.subject);
            }
        }
        found
    }
}

/// Subjects have other places now; those that were chosen stay chosen.
fn follow(document: &mut Document, index: &[usize]) {
    let now = |subject: usize| index.get(subject).copied().unwrap_or(subject);
    document.subject = now(document.subject);
    document.compare_with = document.compare_with.map(now);
    document.transported = document.transported.map(|motion| TransportChoice {
        from: now(motion.from),
        onto: now(motion.onto),
    });
    if let Some(transport) = &mut document.map.distances.transport
        && let Reference::Subject(subject) = &mut transport.reference
    {
        *subject = now(*subject);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::testing::subject_with_frames;
    use crate::document::{TypedField, Typing};
    use crate::study::UnreadSubject;

    fn read(id: &str) -> ReadSubject {
        (id.to_owned(), Some(Arc::new(subject_with_frames(id, 3))))
    }

    /// A window that reads a, b, c, d and has read c.
    fn reading() -> State {
        let unread = ["a", "b", "c", "d"].map(|id| UnreadSubject {
            id: id.to_owned(),
            label: None,
            read_before: 0,
        });
        let planned = Study {
            unread: unread.into(),
            ..Study::default()
        };
        let mut state = State::default();
        state.begin_reading(planned.with_read(&[read("c")], Revision(1)).0);
        state
    }

    fn revisions() -> impl FnMut() -> Revision {
        let mut last = 1;
        move || {
            last += 1;
            Revision(last)
        }
    }

    fn selected(state: &State) -> &str {
        &state.document.selected().unwrap().id
    }

    #[test]
    fn what_was_chosen_stays_chosen_while_subjects_come_before_it() {
        let (mut state, mut fresh) = (reading(), revisions());
        state.document.position = 1.5;
        assert!(state.add_read(&[read("d")], &mut fresh));
        state.document.compare_with = Some(1);
        state.document.transported = Some(TransportChoice { from: 0, onto: 1 });
        assert!(state.add_read(&[read("a"), read("b")], &mut fresh));
        assert_eq!((selected(&state), state.document.position), ("c", 1.5));
        assert_eq!(state.document.compare_with, Some(3));
        let motion = TransportChoice { from: 2, onto: 3 };
        assert_eq!(state.document.transported, Some(motion));
        assert!(state.document.study().unread.is_empty());
        let revision = state.document.study().revision;
        state.end_reading(OpeningReport::default(), &mut fresh);
        assert_eq!(state.document.study().revision, revision);
    }

    #[test]
    fn undo_brings_back_what_was_chosen_among_all_that_is_read_and_edits_with_it() {
        let (mut state, mut fresh) = (reading(), revisions());
        state
            .history
            .record(state.document.clone(), None, false, 0.0);
        let edited = state.document.study().labelling(&[0], "MINF", fresh());
        state.document.show_edited(edited);
        state.add_read(&[read("a")], &mut fresh);
        state
            .history
            .record(state.document.clone(), None, false, 0.0);
        state.document.select_subject(0);
        state.add_read(&[read("b")], &mut fresh);
        let ids = |state: &State| -> String {
            state
                .document
                .study()
                .subjects
                .iter()
                .map(|s| s.id.as_str())
                .collect()
        };
        assert_eq!((selected(&state), ids(&state)), ("a", "abc".to_owned()));
        state.document = state.history.undo(&state.document).unwrap();
        assert_eq!((selected(&state), ids(&state)), ("c", "abc".to_owned()));
        assert_eq!(
            state.document.selected().unwrap().label.as_deref(),
            Some("MINF")
        );
        let edited = state.document.study().revision;
        state.document = state.history.undo(&state.document).unwrap();
        assert_eq!((selected(&state), ids(&state)), ("c", "abc".to_owned()));
        assert_eq!(state.document.selected().unwrap().label, None);
        assert_ne!(state.document.study().revision, edited);
        // What is read after an undo comes into what redo brings back.
        state.add_read(&[read("d")], &mut fresh);
        state.document = state.history.redo(&state.document).unwrap();
        assert_eq!(ids(&state), "abcd");
    }

    #[test]
    fn the_subject_that_is_waited_for_is_selected_once_it_is_read() {
        let (mut state, mut fresh) = (reading(), revisions());
        state.awaited = Some("a".to_owned());
        state.add_read(&[read("d")], &mut fresh);
        assert_eq!(selected(&state), "c");
        state.add_read(&[read("a")], &mut fresh);
        assert_eq!((selected(&state), &state.awaited), ("a", &None));
        state.document = state.history.undo(&state.document).unwrap();
        assert_eq!(selected(&state), "c");
        state.awaited = Some("b".to_owned());
        state.add_read(&[("b".to_owned(), None)], &mut fresh);
        assert_eq!(state.message, "b cannot be read");
        assert_eq!((selected(&state), &state.awaited), ("c", &None));
    }

    #[test]
    fn a_subject_that_is_waited_for_is_none_of_another_study_that_undo_has_brought_back() {
        let (mut state, mut fresh) = (reading(), revisions());
        let read_study = state.document.clone();
        state.document.study.opening = 0;
        state.awaited = Some("c".to_owned());
        state.select_awaited();
        assert_eq!(
            state.awaited.as_deref(),
            Some("c"),
            "it is of the study that is read"
        );
        assert!(state.message.is_empty());
        state.document = read_study;
        state.add_read(&[read("a")], &mut fresh);
        assert_eq!((selected(&state), &state.awaited), ("c", &None));
    }

    #[test]
    fn what_is_typed_stays_with_its_row_while_subjects_come_before_it() {
        let (mut state, mut fresh) = (reading(), revisions());
        state.typing = Some(Typing {
            field: TypedField::Label,
            subject: 0,
            subjects: vec![0],
        });
        state.add_read(&[read("a"), read("d")], &mut fresh);
        let typing = state.typing.as_ref().unwrap();
        assert_eq!((typing.subject, &typing.subjects), (1, &vec![1]));
        assert_eq!(state.document.study().subjects[1].id, "c");
    }

    #[test]
    fn what_nobody_can_see_any_more_is_told_so_and_the_end_leaves_what_was_read() {
        let (mut state, mut fresh) = (reading(), revisions());
        let report = OpeningReport {
            notices: vec![crate::study::Notice::warning("stopped")],
            ..OpeningReport::default()
        };
        state.end_reading(report, &mut fresh);
        assert!(state.document.study().unread.is_empty());
        assert_eq!(state.document.study.report.notices.len(), 1);
        assert_eq!(selected(&state), "c");
        assert!(!state.add_read(&[read("a")], &mut fresh));
        assert_eq!(state.document.study().subjects.len(), 1);
    }
}
