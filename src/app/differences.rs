//! Where two poses side by side differ: densities of their distance on the surface, kept by pair.

use std::sync::Arc;

use crate::analysis::pose_distances::{PoseDistanceParams, PoseId};
use crate::study::{Revision, Subject};
use crate::ui::ViewMode;

use super::document::{Document, nearest_frame, phase_of, position_at_phase};

/// Pairs kept: the frames of two long beats. A list is as long as a heart has vertices.
const MOST_PAIRS: usize = 64;

/// Which poses were compared, and how.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PosePair {
    /// State of the study.
    pub revision: Revision,
    /// The pose of the selected heart.
    pub a: PoseId,
    /// The pose of the heart beside it.
    pub b: PoseId,
    /// How.
    pub distances: PoseDistanceParams,
}

impl PosePair {
    /// Whether both compare the same hearts in the same way, at whatever frames.
    fn same_hearts(&self, other: &Self) -> bool {
        self.revision == other.revision
            && self.distances == other.distances
            && (self.a.subject, self.b.subject) == (other.a.subject, other.b.subject)
    }
}

/// Densities of the pairs looked at lately.
#[derive(Clone, Debug, Default)]
pub struct DifferenceStore {
    /// The one that came last stands last. Each holds one list for all poses.
    pairs: Vec<(PosePair, Arc<Vec<Vec<f32>>>)>,
    shown: Option<(PosePair, Arc<Vec<Vec<f32>>>)>,
}

impl DifferenceStore {
    /// Whether the densities of a pair are at hand.
    pub fn has(&self, pair: &PosePair) -> bool {
        self.pairs.iter().any(|(other, _)| other == pair)
    }

    /// Takes in the densities of a pair.
    pub fn put(&mut self, pair: PosePair, density: Vec<f32>) {
        self.pairs.retain(|(other, _)| *other != pair);
        self.pairs.push((pair, Arc::new(vec![density])));
        if self.pairs.len() > MOST_PAIRS {
            self.pairs.remove(0);
        }
    }

    /// From now on shows this pair; until it is there, what is shown of the same hearts stays.
    pub fn show(&mut self, pair: Option<&PosePair>) {
        let Some(pair) = pair else {
            self.shown = None;
            return;
        };
        if let Some(found) = self.pairs.iter().find(|(other, _)| other == pair) {
            self.shown = Some(found.clone());
        } else if !(self.shown.as_ref()).is_some_and(|(shown, _)| shown.same_hearts(pair)) {
            self.shown = None;
        }
    }

    /// What is shown: one number per vertex, for all poses.
    pub fn shown(&self) -> Option<&Arc<Vec<Vec<f32>>>> {
        self.shown.as_ref().map(|(_, density)| density)
    }
}

/// The poses side by side, at their nearest frames; `None` where there are no two hearts, one plays
/// a carried beat, or they do not correspond.
pub fn pair_on_screen(document: &Document) -> Option<PosePair> {
    let (selected, subject, other) = both_hearts(document)?;
    if hindrance(document).is_some() {
        return None;
    }
    let position = position_at_phase(other, phase_of(selected, document.position));
    Some(PosePair {
        revision: document.study().revision,
        a: PoseId {
            subject: document.subject,
            frame: document.frame(),
        },
        b: PoseId {
            subject,
            frame: nearest_frame(position, other.sequence.frame_count()),
        },
        distances: document.map.distances,
    })
}

/// Why there is no difference to another heart on screen; `None` if there is one.
pub fn hindrance(document: &Document) -> Option<&'static str> {
    let Some((selected, _, other)) = both_hearts(document) else {
        return Some("The contribution to the distance needs two subjects side by side");
    };
    if document.carrying().is_some() {
        return Some(
            "For a transported motion, choose the difference from the subject’s own motion",
        );
    }
    let corresponds = selected.sequence.correspondence() == other.sequence.correspondence();
    (!corresponds).then_some("The contribution to the distance needs vertex correspondence")
}

fn both_hearts(document: &Document) -> Option<(&Arc<Subject>, usize, &Arc<Subject>)> {
    if document.view_mode != ViewMode::SideBySide {
        return None;
    }
    let other = document.compared()?;
    let subjects = &document.study().subjects;
    Some((document.selected()?, other, subjects.get(other)?))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::testing::{study_of, study_ref, subject_with_frames};

    fn document() -> Document {
        let mut document = Document::new(study_ref(study_of(vec![
            subject_with_frames("a", 8),
            subject_with_frames("b", 4),
        ])));
        document.view_mode = ViewMode::SideBySide;
        document
    }

    #[test]
    fn poses_are_compared_at_the_same_phase() {
        let mut document = document();
        document.position = 6.2;
        let pair = pair_on_screen(&document).unwrap();
        assert_eq!((pair.a.subject, pair.a.frame), (0, 6));
        assert_eq!((pair.b.subject, pair.b.frame), (1, 3));
        document.view_mode = ViewMode::Single;
        assert_eq!(pair_on_screen(&document), None);
        assert!(hindrance(&document).unwrap().contains("side by side"));
    }

    #[test]
    fn what_is_shown_stays_until_the_next_frame_of_the_same_hearts_is_there() {
        let mut document = document();
        let first = pair_on_screen(&document).unwrap();
        let mut store = DifferenceStore::default();
        store.put(first, vec![1.0]);
        store.show(Some(&first));
        let before = Arc::clone(store.shown().unwrap());
        document.position = 2.0;
        let second = pair_on_screen(&document).unwrap();
        store.show(Some(&second));
        assert!(Arc::ptr_eq(store.shown().unwrap(), &before));
        store.put(second, vec![2.0]);
        store.show(Some(&second));
        assert_eq!(store.shown().unwrap()[0], [2.0]);
        document.select_subject(1);
        document.compare_with = Some(0);
        store.show(pair_on_screen(&document).as_ref());
        assert!(store.shown().is_none(), "of other hearts nothing stays");
        for frame in 0..2 * MOST_PAIRS {
            let a = PoseId { subject: 0, frame };
            store.put(PosePair { a, ..first }, vec![0.0]);
        }
        assert!(!store.has(&first) && store.pairs.len() == MOST_PAIRS);
    }
}
