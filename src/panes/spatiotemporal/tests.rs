//! What the spatiotemporal plot does under the pointer and the keyboard.

use egui_kittest::{Harness, kittest::Queryable as _};

use egui::{Key, Pos2, vec2};

use super::*;
use crate::engine::{PoseMapQuery, Topic};
use crate::panes::cohort::rows::CohortRow;
use crate::panes::commands::{Command, SelectCommand, WorkCommand};
use crate::panes::scatter_map::{PosePhase, ScatterPoint, ScatterView};
use crate::panes::work_state::WorkState;

fn points() -> Vec<ScatterPoint> {
    let starts = [[-1.0, 0.0], [1.0, 0.5], [0.2, -0.8]];
    let poses = starts.into_iter().enumerate();
    let poses = poses.flat_map(|start| (0..4).map(move |frame| (start, frame)));
    poses
        .map(|((subject, start), frame)| ScatterPoint {
            subject,
            frames: Some([frame, frame]),
            start_frame: frame,
            at: [start[0] + 0.1 * frame as f64, start[1]],
            share: 0.25 * frame as f64,
            phase: PosePhase::of(frame, (Some(0), Some(2))),
            ..ScatterPoint::default()
        })
        .collect()
}

fn harness(state: WorkState) -> Harness<'static, Vec<Command>> {
    let points = points();
    let subjects: Vec<CohortRow> = (0..3)
        .map(|index| CohortRow {
            id: format!("P{index}"),
            ..CohortRow::default()
        })
        .collect();
    let mut harness = Harness::builder()
        .with_size([420.0, 360.0])
        .with_step_dt(1.0 / 30.0)
        .with_context_setup(|ctx| crate::ui::style::apply(ctx, true))
        .build_ui_state(
            move |ui, commands: &mut Vec<Command>| {
                let map = ScatterView {
                    state: state.clone(),
                    selected: Some(0),
                    ..ScatterView::new(&SPACE_TIME, &subjects, &points)
                };
                space_time_ui(ui, &map, 0.4, commands);
            },
            Vec::new(),
        );
    harness.run();
    harness
}

fn place(harness: &Harness<'_, Vec<Command>>, subject: usize) -> Pos2 {
    harness
        .get_by_label(&format!("Curve of P{subject}, other"))
        .rect()
        .center()
}

#[test]
fn a_click_on_a_curve_plays_that_subject_from_that_pose() {
    let mut harness = harness(WorkState::Ready);
    harness.get_by_label("Curve of P1, other").click();
    harness.run();
    let wanted = Command::Select(SelectCommand::SelectPose {
        subject: 1,
        frame: 2,
        play: true,
    });
    assert_eq!(*harness.state(), [wanted]);
}

#[test]
fn a_drag_turns_the_plot_and_a_double_click_turns_it_back() {
    let mut harness = harness(WorkState::Ready);
    let before = place(&harness, 1);
    let ground = harness
        .get_by_label("Spatiotemporal plot")
        .rect()
        .right_bottom()
        - vec2(8.0, 8.0);
    harness.drag_at(ground);
    harness.step();
    harness.hover_at(ground - vec2(90.0, 30.0));
    harness.step();
    harness.drop_at(ground - vec2(90.0, 30.0));
    harness.run();
    assert!((place(&harness, 1) - before).length() > 10.0);
    assert!(harness.state().is_empty(), "turning selects nothing");
    for _ in 0..2 {
        harness.drag_at(ground);
        harness.drop_at(ground);
        harness.step();
    }
    harness.run();
    assert!((place(&harness, 1) - before).length() < 1e-3);
}

#[test]
fn arrows_turn_and_plus_zooms_while_the_plot_has_the_keyboard() {
    let mut harness = harness(WorkState::Ready);
    let apart =
        |harness: &Harness<'_, Vec<Command>>| (place(harness, 1) - place(harness, 2)).length();
    let (before, middle) = (place(&harness, 1), apart(&harness));
    harness.get_by_label("Spatiotemporal plot").focus();
    harness.run();
    harness.key_press(Key::Plus);
    harness.run();
    assert!(apart(&harness) > 1.2 * middle);
    let zoomed = place(&harness, 1);
    harness.key_press(Key::ArrowRight);
    harness.run();
    assert!((place(&harness, 1) - zoomed).length() > 2.0);
    assert_ne!(place(&harness, 1), before);
}

#[test]
fn a_new_map_can_be_cancelled_while_the_old_curves_stay() {
    let mut harness = harness(WorkState::Computing {
        fraction: 0.3,
        phase: String::new(),
        seconds_left: Some(3.0),
    });
    harness.run();
    place(&harness, 2);
    harness.get_by_label("Cancel").click();
    harness.run();
    assert_eq!(
        *harness.state(),
        [Command::Work(WorkCommand::Cancel(
            Topic::of::<PoseMapQuery>()
        ))]
    );
}
