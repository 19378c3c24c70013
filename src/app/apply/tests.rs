//! What commands do to the state, without a window.

use super::{Effect, Moment, apply};
use crate::app::export::FigureKind;
use crate::document::state::State;
use crate::document::testing::{state_of, subject_with_frames};
use crate::document::{CohortColumn, ViewMode};
use crate::engine::{PoseMapQuery, Topic};
use crate::panes::{
    Command, EditCommand, FileCommand, Phase, PhaseFrame, PlaybackCommand, SelectCommand,
    ViewCommand, Whose, WindowCommand, WorkCommand,
};
use crate::picture::Quantity;
use crate::render::Camera;
use crate::study::Revision;

fn moment(now_s: f64) -> Moment {
    Moment {
        now_s,
        pointer_held: false,
        fresh_revision: Revision(1000 + now_s as u64),
    }
}

fn two_hearts() -> State {
    state_of(vec![
        subject_with_frames("a", 8),
        subject_with_frames("b", 4),
    ])
}

fn give(state: &mut State, command: Command) -> Vec<Effect> {
    apply(state, command, &moment(0.0))
}

#[test]
fn a_point_of_the_map_selects_its_heart_and_frame_and_plays() {
    let mut state = two_hearts();
    let pose = Command::Select(SelectCommand::SelectPose {
        subject: 1,
        frame: 3,
        play: true,
    });
    give(&mut state, pose);
    assert_eq!((state.document.subject, state.document.frame()), (1, 3));
    assert!(state.play.playing);
    give(&mut state, Command::Edit(EditCommand::Undo));
    assert_eq!((state.document.subject, state.document.frame()), (0, 0));
    assert!(!state.play.playing);
    give(&mut state, Command::Edit(EditCommand::Redo));
    assert_eq!((state.document.subject, state.document.frame()), (1, 3));
}

#[test]
fn a_pose_that_does_not_exist_changes_nothing() {
    let mut state = two_hearts();
    let before = state.document.clone();
    let pose = Command::Select(SelectCommand::SelectPose {
        subject: 9,
        frame: 0,
        play: true,
    });
    give(&mut state, pose);
    give(&mut state, Command::Select(SelectCommand::SelectSubject(9)));
    give(
        &mut state,
        Command::Playback(PlaybackCommand::SetPosition(f64::NAN)),
    );
    give(
        &mut state,
        Command::Edit(EditCommand::SetPhase(
            Whose::Selected,
            Phase::EndSystole,
            PhaseFrame::Frame(99),
        )),
    );
    assert_eq!(state.document, before);
    assert!(!state.history.can_undo());
}

#[test]
fn frames_step_around_the_beat() {
    let mut state = two_hearts();
    give(
        &mut state,
        Command::Playback(PlaybackCommand::StepFrame(-1)),
    );
    assert_eq!(state.document.position, 7.0);
    give(&mut state, Command::Playback(PlaybackCommand::StepFrame(1)));
    assert_eq!(state.document.position, 0.0);
    give(
        &mut state,
        Command::Playback(PlaybackCommand::SetPosition(2.4)),
    );
    give(&mut state, Command::Playback(PlaybackCommand::StepFrame(1)));
    assert_eq!(state.document.position, 3.0);
    give(
        &mut state,
        Command::Playback(PlaybackCommand::SetPosition(2.4)),
    );
    give(
        &mut state,
        Command::Playback(PlaybackCommand::StepFrame(-1)),
    );
    assert_eq!(state.document.position, 2.0);
}

#[test]
fn playing_leaves_no_steps_of_undo() {
    let mut state = two_hearts();
    give(&mut state, Command::Select(SelectCommand::SelectSubject(1)));
    give(&mut state, Command::Playback(PlaybackCommand::TogglePlay));
    let subject = state.document.selected().unwrap().clone();
    for _ in 0..100 {
        let (position, _) = state
            .play
            .advance(&subject, state.document.position, None, 0.016);
        state.document.position = position;
    }
    give(&mut state, Command::Playback(PlaybackCommand::TogglePlay));
    give(&mut state, Command::Edit(EditCommand::Undo));
    assert_eq!(state.document.subject, 0);
    assert!(!state.history.can_undo());
}

#[test]
fn a_camera_drag_is_one_step_and_two_drags_are_two() {
    let mut state = two_hearts();
    for drag in 0..2 {
        for step in 1..=20 {
            let camera = Camera {
                half_height: (drag * 20 + step) as f32,
                ..Camera::default()
            };
            give(
                &mut state,
                Command::View(ViewCommand::SetCamera { camera, drag: true }),
            );
        }
        state.history.end_drag();
    }
    give(&mut state, Command::Edit(EditCommand::Undo));
    assert_eq!(state.document.viewpoint.half_height, Some(20.0));
    give(&mut state, Command::Edit(EditCommand::Undo));
    assert_eq!(state.document.viewpoint.half_height, None);
    assert!(!state.history.can_undo());
}

#[test]
fn a_stated_phase_is_an_edit_that_can_be_taken_back() {
    let mut state = two_hearts();
    let before = state.document.study().revision;
    give(
        &mut state,
        Command::Edit(EditCommand::SetPhase(
            Whose::Selected,
            Phase::EndSystole,
            PhaseFrame::Frame(5),
        )),
    );
    assert_eq!(state.phases_of(0).1, Some(5));
    assert_ne!(state.document.study().revision, before);
    give(
        &mut state,
        Command::Playback(PlaybackCommand::GoToEndSystole),
    );
    assert_eq!(state.document.frame(), 5);
    give(&mut state, Command::Edit(EditCommand::Undo));
    give(&mut state, Command::Edit(EditCommand::Undo));
    assert_eq!(state.phases_of(0).1, None);
    assert_eq!(state.document.study().revision, before);
}

#[test]
fn hundred_changes_of_many_kinds_are_taken_back_one_by_one() {
    let mut state = two_hearts();
    let mut seen = vec![state.document.clone()];
    for step in 0..120 {
        let command = match step % 5 {
            0 => Command::View(ViewCommand::ToggleWireframe),
            1 => Command::View(ViewCommand::NextQuantity),
            2 => Command::Select(SelectCommand::SelectSubject((step / 5 + 1) % 2)),
            3 => Command::View(ViewCommand::SortCohort(CohortColumn::Subject)),
            _ => Command::View(ViewCommand::SetViewMode(if (step / 5) % 2 == 0 {
                ViewMode::AllFrames
            } else {
                ViewMode::Single
            })),
        };
        apply(&mut state, command, &moment(step as f64 * 10.0));
        seen.push(state.document.clone());
    }
    for document in seen.iter().rev().skip(1) {
        give(&mut state, Command::Edit(EditCommand::Undo));
        assert_eq!(state.document, *document);
    }
}

#[test]
fn opening_another_study_can_be_taken_back() {
    let mut state = two_hearts();
    let first = state.document.study().clone();
    let mut other = crate::study::Study::clone(&first);
    other.subjects.truncate(1);
    other.revision = Revision(2);
    state.show_study(std::sync::Arc::new(other), Default::default());
    assert_eq!(state.document.study().subjects.len(), 1);
    give(&mut state, Command::Edit(EditCommand::Undo));
    assert_eq!(state.document.study().subjects.len(), 2);
}

#[test]
fn what_reaches_beyond_the_state_comes_back_as_effects() {
    let mut state = two_hearts();
    let path = std::path::PathBuf::from("figure.png");
    assert_eq!(
        give(
            &mut state,
            Command::File(FileCommand::ExportFigure(Some(path.clone())))
        ),
        [Effect::WriteFigure(FigureKind::View, path)]
    );
    assert_eq!(
        give(
            &mut state,
            Command::Work(WorkCommand::Cancel(Topic::of::<PoseMapQuery>()))
        ),
        [Effect::Stop(Topic::of::<PoseMapQuery>())]
    );
    let picture = std::path::PathBuf::from("P07_patch.png");
    assert_eq!(
        give(
            &mut state,
            Command::File(FileCommand::Open(vec!["ward".into(), picture.clone()]))
        ),
        [Effect::ReadPicture {
            picture,
            study: vec!["ward".into()]
        }]
    );
    assert_eq!(
        give(&mut state, Command::File(FileCommand::Open(Vec::new()))),
        []
    );
    assert_eq!(
        give(&mut state, Command::Window(WindowCommand::ToggleFullScreen)),
        [Effect::SetFullScreen(true)]
    );
    assert!(!state.history.can_undo());
}

#[test]
fn sheets_lie_over_the_window_one_at_a_time() {
    let mut state = two_hearts();
    give(&mut state, Command::Window(WindowCommand::ToggleShortcuts));
    give(&mut state, Command::Window(WindowCommand::TogglePalette));
    assert!(state.sheets.palette && !state.sheets.shortcuts);
    give(&mut state, Command::Window(WindowCommand::TogglePalette));
    assert_eq!(state.sheets, Default::default());
}

#[test]
fn limits_that_are_no_range_go_back_to_the_fixed_one() {
    let mut state = two_hearts();
    give(
        &mut state,
        Command::View(ViewCommand::SetQuantity(Quantity::Displacement)),
    );
    give(
        &mut state,
        Command::View(ViewCommand::SetColourLimits(Some([0.0, 9.0]))),
    );
    assert_eq!(state.document.limits(), Some([0.0, 9.0]));
    give(
        &mut state,
        Command::View(ViewCommand::SetColourLimits(Some([4.0, 4.0]))),
    );
    assert_eq!(state.document.limits(), None);
}

#[test]
fn stepping_through_subjects_follows_the_table() {
    let mut state = state_of(vec![
        subject_with_frames("c", 3),
        subject_with_frames("a", 3),
        subject_with_frames("b", 3),
    ]);
    give(
        &mut state,
        Command::View(ViewCommand::SortCohort(CohortColumn::Subject)),
    );
    for expected in [1, 2, 0] {
        give(&mut state, Command::Select(SelectCommand::StepSubject(1)));
        assert_eq!(state.document.subject, expected);
    }
    give(&mut state, Command::Select(SelectCommand::StepSubject(-1)));
    assert_eq!(state.document.subject, 2);
    give(
        &mut state,
        Command::View(ViewCommand::SetSearch("a".to_owned())),
    );
    give(&mut state, Command::Select(SelectCommand::StepSubject(1)));
    assert_eq!(state.document.subject, 1);
}
