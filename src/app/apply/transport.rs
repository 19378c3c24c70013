//! Commands about transported motions and interpolated poses.

use crate::document::ViewMode;
use crate::engine::{InterpolatedPosesQuery, MotionTransportQuery, Topic};
use crate::panes::TransportCommand;
use crate::picture::Quantity;

use super::change::{Moment, change};
use super::effect::Effect;
use crate::app::errors::push_card;
use crate::document::document::TransportChoice;
use crate::document::state::State;
use crate::document::undo::Gesture;

/// Applies a command about transported motions or interpolated poses.
pub fn apply(state: &mut State, command: TransportCommand, moment: &Moment) -> Vec<Effect> {
    match command {
        TransportCommand::TransportMotion { from, onto } => {
            return start_transport(state, moment, from, onto);
        }
        TransportCommand::TransportToOther => {
            if let Some(onto) = state.document.compared() {
                return start_transport(state, moment, state.document.subject, onto);
            }
        }
        TransportCommand::StopTransport => {
            change(state, moment, None, |document| document.transported = None);
        }
        TransportCommand::SetInterpolatedPoses(count) => {
            change(state, moment, None, |document| {
                document.interpolated_poses = count;
            });
            // Whoever chooses a number wants them, even if they were stopped before.
            return vec![Effect::Retry(Topic::of::<InterpolatedPosesQuery>())];
        }
        TransportCommand::StepPose(step) => step_pose(state, moment, step),
    }
    Vec::new()
}

fn start_transport(state: &mut State, moment: &Moment, from: usize, onto: usize) -> Vec<Effect> {
    let (Some(source), Some(target)) = (state.subject(from), state.subject(onto)) else {
        return Vec::new();
    };
    if from == onto {
        return Vec::new();
    }
    let (ours, theirs) = (&source.sequence, &target.sequence);
    if ours.correspondence() != theirs.correspondence() {
        let title = format!(
            "The motion of {} cannot be transported to {}",
            source.id, target.id
        );
        let message = format!(
            "the meshes do not correspond: {} vertices and {} faces, {} vertices and {} faces",
            ours.vertex_count(),
            ours.face_count(),
            theirs.vertex_count(),
            theirs.face_count()
        );
        push_card(&mut state.errors, title, message);
        return Vec::new();
    }
    let plays = ours.frame_count() > 1;
    let motion = TransportChoice { from, onto };
    let again = state.document.visible_transport() == Some(motion);
    change(state, moment, None, |document| {
        if document.subject != from {
            document.select_subject(from);
        }
        document.view_mode = ViewMode::SideBySide;
        document.compare_with = Some(onto);
        document.transported = Some(motion);
        document.quantity = Quantity::MotionDifference;
    });
    state.play.playing = plays;
    // Asked for once more, what was stopped begins again.
    let retry = again.then_some(Effect::Retry(Topic::of::<MotionTransportQuery>()));
    retry.into_iter().collect()
}

/// The next pose in either direction, interpolated poses included.
fn step_pose(state: &mut State, moment: &Moment, step: i32) {
    let Some(subject) = state.document.selected() else {
        return;
    };
    let between = (state.interpolated_poses_of(state.document.subject))
        .map_or_else(Vec::new, |motion| motion.positions());
    let mut positions: Vec<f64> = (0..subject.sequence.frame_count())
        .map(|frame| frame as f64)
        .chain(between)
        .collect();
    positions.sort_by(f64::total_cmp);
    let here = state.document.position;
    let count = positions.len() as i64;
    // From between two poses, a step leads to the nearest one in its direction.
    let start = if step > 0 {
        positions.partition_point(|position| *position <= here + 1e-6) as i64 - 1
    } else {
        positions.partition_point(|position| *position < here - 1e-6) as i64
    };
    let place = (start + i64::from(step)).rem_euclid(count.max(1)) as usize;
    let Some(position) = positions.get(place).copied() else {
        return;
    };
    state.play.playing = false;
    change(state, moment, Some(Gesture::Time), |document| {
        document.position = position;
    });
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use super::*;
    use crate::app::apply::apply;
    use crate::document::answers::InterpolationAnswer;
    use crate::document::interpolated_poses::tests::straight_paths;
    use crate::document::interpolated_poses::{MotionMemo, geodesic_params};
    use crate::document::testing::{state_of, subject_with_frames};
    use crate::mesh::phantom;
    use crate::panes::{Command, EditCommand, PlaybackCommand, SelectCommand, ViewCommand};
    use crate::study::{MeshSequence, Revision, Subject, SurfaceKind, SurfaceSequence};
    use crate::units::LengthUnit;

    fn give(state: &mut State, command: Command) -> Vec<Effect> {
        let moment = Moment {
            now_s: 0.0,
            pointer_held: false,
            fresh_revision: Revision(9),
        };
        apply(state, command, &moment)
    }

    fn other_mesh(id: &str) -> Subject {
        let cavity =
            SurfaceSequence::new(SurfaceKind::Cavity, vec![phantom::sphere(2, 30.0)]).unwrap();
        let sequence = MeshSequence::new(vec![cavity]).unwrap();
        Subject::new(id, sequence, LengthUnit::Millimetre)
    }

    fn three_subjects() -> State {
        state_of(vec![
            subject_with_frames("a", 8),
            subject_with_frames("b", 4),
            other_mesh("c"),
        ])
    }

    #[test]
    fn a_dropped_motion_plays_beside_its_target_and_undo_takes_it_back() {
        let mut state = three_subjects();
        let before = state.document.clone();
        let motion = TransportChoice { from: 1, onto: 0 };
        let effects = give(
            &mut state,
            Command::Transport(TransportCommand::TransportMotion { from: 1, onto: 0 }),
        );
        assert_eq!(effects, []);
        assert_eq!(state.document.visible_transport(), Some(motion));
        assert_eq!(state.document.subject, 1);
        assert_eq!(state.document.quantity, Quantity::MotionDifference);
        assert!(state.play.playing);
        let again = give(
            &mut state,
            Command::Transport(TransportCommand::TransportMotion { from: 1, onto: 0 }),
        );
        assert_eq!(again, [Effect::Retry(Topic::of::<MotionTransportQuery>())]);
        give(&mut state, Command::Edit(EditCommand::Undo));
        assert_eq!(state.document, before);
        give(&mut state, Command::Edit(EditCommand::Redo));
        assert_eq!(state.document.visible_transport(), Some(motion));
    }

    #[test]
    fn whatever_shows_other_subjects_ends_the_transport() {
        for command in [
            Command::Transport(TransportCommand::StopTransport),
            Command::Select(SelectCommand::SelectSubject(0)),
            Command::View(ViewCommand::SetViewMode(ViewMode::Single)),
            Command::Select(SelectCommand::CompareWith(Some(2))),
        ] {
            let mut state = three_subjects();
            give(
                &mut state,
                Command::Transport(TransportCommand::TransportMotion { from: 1, onto: 0 }),
            );
            give(&mut state, command.clone());
            assert_eq!(state.document.transported, None, "{command:?}");
            assert_eq!(state.document.quantity, Quantity::Tissue, "{command:?}");
        }
    }

    #[test]
    fn colours_can_be_chosen_beside_a_transported_motion() {
        let mut state = three_subjects();
        give(
            &mut state,
            Command::Transport(TransportCommand::TransportMotion { from: 1, onto: 0 }),
        );
        give(
            &mut state,
            Command::View(ViewCommand::SetQuantity(Quantity::Tissue)),
        );
        assert!(state.document.visible_transport().is_some());
        assert_eq!(state.document.quantity, Quantity::Tissue);
    }

    #[test]
    fn a_subject_that_does_not_correspond_is_refused_with_a_reason() {
        let mut state = three_subjects();
        let before = state.document.clone();
        give(
            &mut state,
            Command::Transport(TransportCommand::TransportMotion { from: 0, onto: 2 }),
        );
        assert_eq!(state.document, before);
        let card = &state.errors[0];
        assert_eq!(card.title, "The motion of a cannot be transported to c");
        assert!(card.message.contains("42 vertices") && card.message.contains("162 vertices"));
        give(
            &mut state,
            Command::Transport(TransportCommand::TransportMotion { from: 0, onto: 0 }),
        );
        give(
            &mut state,
            Command::Transport(TransportCommand::TransportMotion { from: 0, onto: 7 }),
        );
        assert_eq!(state.document, before);
    }

    #[test]
    fn the_beat_beside_is_chosen_without_a_pointer() {
        let mut state = three_subjects();
        give(
            &mut state,
            Command::Transport(TransportCommand::TransportToOther),
        );
        let motion = TransportChoice { from: 0, onto: 1 };
        assert_eq!(state.document.visible_transport(), Some(motion));
    }

    #[test]
    fn steps_lead_through_the_poses_between_frames() {
        let mut state = three_subjects();
        let params = geodesic_params(&state.document).unwrap();
        let subject = Arc::clone(state.document.selected().unwrap());
        give(
            &mut state,
            Command::Transport(TransportCommand::StepPose(1)),
        );
        assert_eq!(
            state.document.position, 1.0,
            "without interpolated poses, frame by frame"
        );
        let paths = straight_paths(&subject, 3);
        let mut memo = MotionMemo::default();
        memo.put(&subject, &params, 0, &paths);
        state.answers.interpolated_poses = vec![InterpolationAnswer {
            subject: 0,
            motion: memo.get(&subject, &params).cloned(),
            stopped: false,
        }];
        for position in [1.25, 1.5, 1.75, 2.0] {
            give(
                &mut state,
                Command::Transport(TransportCommand::StepPose(1)),
            );
            assert_eq!(state.document.position, position);
        }
        give(
            &mut state,
            Command::Transport(TransportCommand::StepPose(-1)),
        );
        assert_eq!(state.document.position, 1.75);
        give(
            &mut state,
            Command::Playback(PlaybackCommand::SetPosition(1.3)),
        );
        give(
            &mut state,
            Command::Transport(TransportCommand::StepPose(-1)),
        );
        assert_eq!(state.document.position, 1.25);
        give(
            &mut state,
            Command::Playback(PlaybackCommand::SetPosition(0.0)),
        );
        give(
            &mut state,
            Command::Transport(TransportCommand::StepPose(-1)),
        );
        assert_eq!(
            state.document.position, 7.75,
            "before the first frame comes the last interval"
        );
        give(
            &mut state,
            Command::Transport(TransportCommand::SetInterpolatedPoses(0)),
        );
        give(
            &mut state,
            Command::Transport(TransportCommand::StepPose(1)),
        );
        assert_eq!(state.document.position, 0.0);
    }
}
