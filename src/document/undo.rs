//! Undo and redo over copies of the document, with drags and quick repeats as one step.

use std::collections::VecDeque;

use crate::document::document::Document;

/// How many steps can be taken back.
const MAX_STEPS: usize = 200;

/// Repeats of one kind of change within this time are one step, such as turns of a wheel and
/// typed letters: shorter than a person needs to look at the result and decide again.
const REPEAT_S: f64 = 0.8;

/// Changes that come in many small parts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Gesture {
    /// Turning, moving or zooming the camera.
    Camera,
    /// Dragging along the time bar or stepping frames.
    Time,
    /// Typing into the filter of the cohort.
    Search,
    /// Typing colour limits.
    Limits,
    /// Dragging the ends of the part of the cycle that plays.
    LoopRange,
    /// Dragging a threshold of patches.
    Threshold,
    /// Moving through the slices of an image.
    Crosshair,
    /// Dragging the window and level of an image.
    GreyWindow,
    /// Dragging a setting of an import.
    Import,
}

/// The past and the future of the document.
#[derive(Debug, Default)]
pub struct History {
    past: VecDeque<Document>,
    future: Vec<Document>,
    open_gesture: Option<(Gesture, f64)>,
}

impl History {
    /// Remembers what the document was before a change.
    ///
    /// Parts of one gesture make one step: while the pointer is held, or within a short time of
    /// each other. `now_s` is any clock that runs forward.
    pub fn record(
        &mut self,
        before: Document,
        gesture: Option<Gesture>,
        pointer_held: bool,
        now_s: f64,
    ) {
        self.future.clear();
        let continues = match (gesture, self.open_gesture) {
            (Some(this), Some((open, last_s))) => {
                this == open && (pointer_held || now_s - last_s < REPEAT_S)
            }
            _ => false,
        };
        self.open_gesture = gesture.map(|gesture| (gesture, now_s));
        if continues {
            return;
        }
        self.past.push_back(before);
        if self.past.len() > MAX_STEPS {
            self.past.pop_front();
        }
    }

    /// The pointer was let go: the next drag is another step.
    pub fn end_drag(&mut self) {
        if matches!(
            self.open_gesture,
            Some((
                Gesture::Camera
                    | Gesture::Time
                    | Gesture::LoopRange
                    | Gesture::Threshold
                    | Gesture::Crosshair
                    | Gesture::GreyWindow
                    | Gesture::Import,
                _
            ))
        ) {
            self.open_gesture = None;
        }
    }

    /// The document before the last step; `current` can then be had back by [`Self::redo`].
    pub fn undo(&mut self, current: &Document) -> Option<Document> {
        self.open_gesture = None;
        let previous = self.past.pop_back()?;
        self.future.push(current.clone());
        Some(previous)
    }

    /// The document that the last undo took away.
    pub fn redo(&mut self, current: &Document) -> Option<Document> {
        self.open_gesture = None;
        let next = self.future.pop()?;
        self.past.push_back(current.clone());
        Some(next)
    }

    /// Whether there is anything to take back.
    pub fn can_undo(&self) -> bool {
        !self.past.is_empty()
    }

    /// Whether there is anything to bring back.
    pub fn can_redo(&self) -> bool {
        !self.future.is_empty()
    }

    /// All that undo and redo can bring back.
    pub fn documents(&mut self) -> impl Iterator<Item = &mut Document> {
        self.past.iter_mut().chain(&mut self.future)
    }

    /// Lets go of studies opened before `opening`, so that a long session does not keep all
    /// that it ever read in memory.
    pub fn forget_studies_before(&mut self, opening: u64) {
        self.past
            .retain(|document| document.study.opening >= opening);
        self.future
            .retain(|document| document.study.opening >= opening);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::testing::{study_of, study_ref, subject_with_frames};

    fn document(position: f64) -> Document {
        let mut document = Document::new(study_ref(study_of(vec![subject_with_frames("a", 3)])));
        document.position = position;
        document
    }

    #[test]
    fn a_hundred_steps_can_be_taken_back_and_brought_again() {
        let mut history = History::default();
        for step in 0..100 {
            history.record(document(f64::from(step)), None, false, f64::from(step));
        }
        let mut current = document(100.0);
        for step in (0..100).rev() {
            current = history.undo(&current).unwrap();
            assert_eq!(current.position, f64::from(step));
        }
        assert!(!history.can_undo());
        for step in 1..=100 {
            current = history.redo(&current).unwrap();
            assert_eq!(current.position, f64::from(step));
        }
        assert!(!history.can_redo());
    }

    #[test]
    fn the_oldest_steps_fall_off_the_end() {
        let mut history = History::default();
        for step in 0..(MAX_STEPS + 10) {
            history.record(document(step as f64), None, false, 0.0);
        }
        let mut current = document(-1.0);
        let mut count = 0;
        while let Some(previous) = history.undo(&current) {
            current = previous;
            count += 1;
        }
        assert_eq!(count, MAX_STEPS);
        assert_eq!(current.position, 10.0);
    }

    #[test]
    fn a_drag_is_one_step_however_long_it_takes() {
        let mut history = History::default();
        for step in 0..50 {
            let now_s = f64::from(step) * 2.0;
            history.record(
                document(f64::from(step)),
                Some(Gesture::Camera),
                true,
                now_s,
            );
        }
        history.end_drag();
        history.record(document(50.0), Some(Gesture::Camera), true, 100.1);
        let current = document(60.0);
        let previous = history.undo(&current).unwrap();
        assert_eq!(previous.position, 50.0);
        assert_eq!(history.undo(&previous).unwrap().position, 0.0);
        assert!(!history.can_undo());
    }

    #[test]
    fn turns_of_the_wheel_in_quick_succession_are_one_step() {
        let mut history = History::default();
        history.record(document(0.0), Some(Gesture::Camera), false, 0.0);
        history.record(document(1.0), Some(Gesture::Camera), false, 0.2);
        history.record(document(2.0), Some(Gesture::Camera), false, 5.0);
        assert_eq!(history.undo(&document(3.0)).unwrap().position, 2.0);
        assert_eq!(history.undo(&document(2.0)).unwrap().position, 0.0);
    }

    #[test]
    fn another_change_ends_what_could_be_brought_back() {
        let mut history = History::default();
        history.record(document(0.0), None, false, 0.0);
        history.undo(&document(1.0)).unwrap();
        assert!(history.can_redo());
        history.record(document(0.0), None, false, 1.0);
        assert!(!history.can_redo());
    }

    #[test]
    fn studies_opened_long_ago_are_let_go() {
        let mut history = History::default();
        history.record(document(0.0), None, false, 0.0);
        let mut later = document(1.0);
        later.study.opening = 3;
        history.record(later, None, false, 0.0);
        history.forget_studies_before(2);
        assert_eq!(history.undo(&document(2.0)).unwrap().position, 1.0);
        assert!(!history.can_undo());
    }
}
