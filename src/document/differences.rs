//! Which two poses side by side are compared, and why there may be none.

use std::sync::Arc;

use crate::analysis::pose_distances::{PoseDistanceParams, PoseId};
use crate::study::Subject;

use crate::document::document::{Document, cycle_share, nearest_frame, position_at_phase};

/// Which poses were compared, and how.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PosePair {
    /// The pose of the selected subject.
    pub a: PoseId,
    /// The pose of the subject beside it.
    pub b: PoseId,
    /// How.
    pub distances: PoseDistanceParams,
}

/// The poses side by side, at their nearest frames; `None` where there are no two subjects, one plays
/// a transported motion, or they do not correspond.
pub fn pair_on_screen(document: &Document) -> Option<PosePair> {
    let (selected, subject, other) = both_subjects(document)?;
    if hindrance(document).is_some() {
        return None;
    }
    let position = position_at_phase(other, cycle_share(selected, document.position));
    Some(PosePair {
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

/// Why there is no difference to another subject on screen; `None` if there is one.
pub fn hindrance(document: &Document) -> Option<&'static str> {
    let Some((selected, _, other)) = both_subjects(document) else {
        return Some("The contribution to the distance needs two subjects side by side");
    };
    if document.visible_transport().is_some() {
        return Some(
            "For a transported motion, choose the difference from the subject's own motion",
        );
    }
    let corresponds = selected.sequence.correspondence() == other.sequence.correspondence();
    (!corresponds).then_some("The contribution to the distance needs vertex correspondence")
}

fn both_subjects(document: &Document) -> Option<(&Arc<Subject>, usize, &Arc<Subject>)> {
    let other = document.compared_on_screen()?;
    Some((
        document.selected()?,
        other,
        document.study().subject(other)?,
    ))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::ViewMode;
    use crate::document::testing::{study_of, study_ref, subject_with_frames};

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
}
