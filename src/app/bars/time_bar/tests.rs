//! What the time bar does under the pointer.

use super::*;
use crate::panes::PlaybackCommand;
use crate::panes::cycle_axis::CycleAxis;
use egui_kittest::{Harness, kittest::Queryable as _};

fn harness() -> Harness<'static, Vec<Command>> {
    harness_with(None)
}

fn harness_with(loop_frames: Option<[usize; 2]>) -> Harness<'static, Vec<Command>> {
    Harness::builder()
        .with_size([1000.0, 60.0])
        .with_context_setup(|ctx| crate::ui::style::apply(ctx, true))
        .build_ui_state(
            move |ui, commands: &mut Vec<Command>| {
                let view = TimeBarView {
                    loop_frames,
                    escape_ends_range: loop_frames.is_some(),
                    playing: false,
                    speed: 1.0,
                    looping: true,
                    position: 0.5,
                    axis: CycleAxis {
                        frame_shares: vec![0.0, 0.25, 0.5, 0.75],
                    },
                    end_diastole: Some(0),
                    end_systole: Some(2),
                    time_ms: Some(100.0),
                    cycle_ms: Some(800.0),
                    between: Some("interpolated"),
                    interpolated_poses: vec![2.25, 2.5, 2.75],
                    note: "3 interpolated poses per interval".to_owned(),
                };
                time_bar_ui(ui, &view, commands);
            },
            Vec::new(),
        )
}

#[test]
fn buttons_push_what_they_say() {
    let mut harness = harness();
    harness.run();
    harness.get_by_label("100 ms · 12 % R-R · interpolated");
    for name in ["Play", "Next frame", "Previous frame", "Loop"] {
        harness.get_by_label(name).click();
        harness.run();
    }
    assert_eq!(
        harness.into_state(),
        [
            Command::Playback(PlaybackCommand::TogglePlay),
            Command::Playback(PlaybackCommand::StepFrame(1)),
            Command::Playback(PlaybackCommand::StepFrame(-1)),
            Command::Playback(PlaybackCommand::ToggleLoop)
        ]
    );
}

#[test]
fn a_click_near_a_frame_lands_on_it_and_a_drag_moves_freely() {
    let mut harness = harness();
    harness.run();
    let rail = harness
        .get_by_label("Position in the cardiac cycle")
        .rect()
        .shrink2(vec2(8.0, 0.0));
    let near = pos2(egui::lerp(rail.x_range(), 0.5) + 4.0, rail.center().y);
    harness.drag_at(near);
    harness.drop_at(near);
    harness.run();
    assert_eq!(
        harness.state().last(),
        Some(&Command::Playback(PlaybackCommand::SetPosition(2.0)))
    );
    harness.drag_at(near);
    harness.step();
    harness.hover_at(near + vec2(30.0, 0.0));
    harness.step();
    harness.drop_at(near + vec2(30.0, 0.0));
    harness.run();
    let Some(Command::Playback(PlaybackCommand::SetPosition(position))) = harness.state().last()
    else {
        panic!("no position");
    };
    assert!(*position > 2.05 && *position < 2.5, "{position}");
}

#[test]
fn a_click_near_a_pose_between_frames_lands_on_it() {
    let mut harness = harness();
    harness.run();
    let rail = harness
        .get_by_label("Position in the cardiac cycle")
        .rect()
        .shrink2(vec2(8.0, 0.0));
    // Position 2.5 of four even frames is at five eighths of the cycle.
    for (share, offset, position) in [(0.625, 4.0, 2.5), (0.5625, -3.0, 2.25), (0.5, 4.0, 2.0)] {
        let at = pos2(egui::lerp(rail.x_range(), share) + offset, rail.center().y);
        harness.drag_at(at);
        harness.drop_at(at);
        harness.run();
        let wanted = Command::Playback(PlaybackCommand::SetPosition(position));
        assert_eq!(harness.state().last(), Some(&wanted));
    }
}

#[test]
fn speeds_are_written_without_needless_digits() {
    assert_eq!(speed_text(1.0), "1.0×");
    assert_eq!(speed_text(0.25), "0.25×");
}

#[test]
fn without_times_the_share_is_one_of_the_cycle_by_frames() {
    let view = TimeBarView {
        position: 2.0,
        axis: CycleAxis {
            frame_shares: vec![0.0, 0.25, 0.5, 0.75],
        },
        ..TimeBarView::default()
    };
    assert_eq!(readout_text(&view), "50 % of the cycle by frames");
}

#[test]
fn a_time_is_typed_in_milliseconds_or_percent() {
    let view = TimeBarView {
        axis: CycleAxis {
            frame_shares: vec![0.0, 0.25, 0.5, 0.75],
        },
        cycle_ms: Some(800.0),
        ..TimeBarView::default()
    };
    for (text, position) in [
        ("400 ms", Some(2.0)),
        ("300", Some(1.5)),
        ("37,5 % R-R", Some(1.5)),
        ("50 % of the cycle", Some(2.0)),
        ("100 %", Some(0.0)),
        ("900 ms", None),
        ("-1 %", None),
        ("soon", None),
        ("", None),
    ] {
        assert_eq!(readout::typed_position(&view, text), position, "{text}");
    }
    let unknown = TimeBarView {
        cycle_ms: None,
        ..view
    };
    assert_eq!(readout::typed_position(&unknown, "50"), Some(2.0));
    assert_eq!(readout::typed_position(&unknown, "400 ms"), None);
}

#[test]
fn a_click_on_the_time_makes_it_a_field_and_enter_goes_there() {
    let mut harness = harness();
    harness.run();
    harness
        .get_by_label("100 ms · 12 % R-R · interpolated")
        .click();
    harness.run();
    harness.get_by_label("Time in the cycle").type_text("75 %");
    harness.run();
    harness.key_press(Key::Enter);
    harness.run();
    harness.get_by_label("100 ms · 12 % R-R · interpolated");
    assert_eq!(
        harness.into_state(),
        [Command::Playback(PlaybackCommand::SetPosition(3.0))]
    );
}

#[test]
fn the_motion_plays_up_to_four_times_as_fast() {
    let mut harness = harness();
    harness.set_size(vec2(1000.0, 400.0));
    harness.run();
    harness.get_by_label("Speed: 1.0×").click();
    harness.run();
    harness.get_by_label("4.0×").click();
    harness.run();
    assert_eq!(
        harness.into_state(),
        [Command::Playback(PlaybackCommand::SetSpeed(4.0))]
    );
}

/// The rail, and where the frames and the end of the cycle lie on it.
fn place_of_frame(harness: &Harness<'_, Vec<Command>>, frame: usize) -> egui::Pos2 {
    let name = "Position in the cardiac cycle";
    let rail = harness.get_by_label(name).rect().shrink2(vec2(8.0, 0.0));
    let x = egui::lerp(rail.x_range(), 0.25 * frame as f32);
    pos2(x, rail.center().y - 3.0)
}

fn drag(harness: &mut Harness<'_, Vec<Command>>, from: egui::Pos2, to: egui::Pos2) {
    harness.hover_at(from);
    harness.step();
    harness.drag_at(from);
    harness.step();
    harness.hover_at(from.lerp(to, 0.5));
    harness.step();
    harness.hover_at(to);
    harness.step();
    harness.drop_at(to);
    harness.run();
}

fn range(frames: [usize; 2]) -> Command {
    Command::Playback(PlaybackCommand::SetLoopRange(Some(frames)))
}

#[test]
fn shift_and_a_drag_choose_the_part_that_plays_and_leave_the_position_alone() {
    let mut harness = harness();
    harness.run();
    let [from, to] = [3, 1].map(|frame| place_of_frame(&harness, frame));
    harness.event(egui::Event::ModifiersChanged(egui::Modifiers::SHIFT));
    drag(&mut harness, from, to);
    harness.event(egui::Event::ModifiersChanged(egui::Modifiers::NONE));
    let commands = harness.state();
    assert_eq!(commands.last(), Some(&range([1, 3])), "{commands:?}");
    let moves =
        |command: &Command| matches!(command, Command::Playback(PlaybackCommand::SetPosition(_)));
    assert!(!commands.iter().any(moves), "{commands:?}");
}

#[test]
fn the_ends_of_the_part_that_plays_are_dragged_from_frame_to_frame() {
    let mut harness = harness_with(Some([1, 3]));
    harness.run();
    let end = harness.get_by_label("End of the loop").rect().center();
    let to = pos2(place_of_frame(&harness, 4).x + 30.0, end.y);
    drag(&mut harness, end, to);
    assert_eq!(harness.state().last(), Some(&range([1, 4])));
    let start = harness.get_by_label("Start of the loop").rect().center();
    let past = pos2(place_of_frame(&harness, 3).x, start.y);
    harness.state_mut().clear();
    drag(&mut harness, start, past);
    let commands = harness.state();
    assert!(!commands.contains(&range([3, 3])), "{commands:?}");
}

#[test]
fn esc_plays_all_again() {
    for (loop_frames, wanted) in [(Some([1, 3]), 1), (None, 0)] {
        let mut harness = harness_with(loop_frames);
        harness.run();
        harness.key_press(Key::Escape);
        harness.run();
        let cleared = Command::Playback(PlaybackCommand::SetLoopRange(None));
        assert_eq!(harness.into_state(), vec![cleared; wanted]);
    }
}
