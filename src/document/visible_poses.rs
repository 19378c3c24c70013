//! Which poses of which subjects the 3D view shows.

use crate::document::document::{cycle_share, position_at_phase};
use crate::document::state::State;
use crate::document::view_mode::ViewMode;

/// One subject on the view.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VisiblePose {
    /// Index into the study's subjects.
    pub subject: usize,
    /// Place in its cycle, counted in frames.
    pub position: f64,
    /// Whether it plays a transported motion, whose frames the position then counts.
    pub transported: bool,
}

/// The subjects on the view, first the selected one.
pub fn visible_poses(state: &State) -> Vec<VisiblePose> {
    let document = &state.document;
    let Some(selected) = document.selected() else {
        return Vec::new();
    };
    let one = VisiblePose {
        subject: document.subject,
        position: document.position,
        transported: false,
    };
    match document.view_mode {
        ViewMode::Single => vec![one],
        ViewMode::SideBySide => {
            let other = document
                .compared()
                .and_then(|index| Some((index, state.subject(index)?)));
            let transported = state.transported_subject().is_some();
            let other = other.map(|(subject, other)| VisiblePose {
                subject,
                // A transported motion has the frames of the subject that it came from. Otherwise linked
                // by phase: subjects with other frame counts move in step.
                position: if transported {
                    document.position
                } else {
                    position_at_phase(other, cycle_share(selected, document.position))
                },
                transported,
            });
            [Some(one), other].into_iter().flatten().collect()
        }
        ViewMode::AllFrames => (0..selected.sequence.frame_count())
            .map(|frame| VisiblePose {
                subject: document.subject,
                position: frame as f64,
                transported: false,
            })
            .collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::testing::{state_of, subject_with_frames};

    #[test]
    fn two_subjects_side_by_side_are_shown_at_the_same_share_of_the_beat() {
        let mut state = state_of(vec![
            subject_with_frames("a", 8),
            subject_with_frames("b", 4),
        ]);
        state.document.view_mode = ViewMode::SideBySide;
        state.document.position = 6.0;
        let poses = visible_poses(&state);
        assert_eq!(poses.len(), 2);
        assert_eq!((poses[1].subject, poses[1].position), (1, 3.0));
    }

    #[test]
    fn all_frames_of_a_subject_are_shown_in_their_order() {
        let mut state = state_of(vec![subject_with_frames("a", 25)]);
        state.document.view_mode = ViewMode::AllFrames;
        let positions: Vec<f64> = visible_poses(&state).iter().map(|p| p.position).collect();
        assert_eq!(positions, (0..25).map(f64::from).collect::<Vec<_>>());
    }

    #[test]
    fn a_lone_subject_has_nobody_beside_it() {
        let mut state = state_of(vec![subject_with_frames("a", 3)]);
        state.document.view_mode = ViewMode::SideBySide;
        assert_eq!(visible_poses(&state).len(), 1);
        assert!(visible_poses(&State::default()).is_empty());
    }
}
