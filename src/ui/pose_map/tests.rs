//! What the map does under the pointer.

use egui::{Pos2, Rect, pos2, vec2};
use egui_kittest::{Harness, kittest::Queryable as _};

use super::*;
use crate::ui::map_ground::Lens;

fn subjects() -> Vec<MapSubject> {
    (0..3)
        .map(|index| MapSubject {
            id: format!("P{index}"),
            ..MapSubject::default()
        })
        .collect()
}

fn points() -> Vec<MapPoint> {
    [
        (0, 0, [-1.0, 0.0]),
        (0, 1, [-0.5, 0.5]),
        (1, 0, [1.0, 0.25]),
        (2, 0, [0.25, -0.5]),
    ]
    .into_iter()
    .map(|(subject, frame, at)| MapPoint {
        subject,
        frame,
        at,
        ..Default::default()
    })
    .collect()
}

fn harness(state: MapState, with_points: bool) -> Harness<'static, Vec<Command>> {
    let (subjects, points) = (subjects(), points());
    Harness::builder()
        .with_size([400.0, 300.0])
        .with_context_setup(|ctx| crate::ui::style::apply(ctx, true))
        .build_ui_state(
            move |ui, commands: &mut Vec<Command>| {
                let view = PoseMapView {
                    state: state.clone(),
                    subjects: &subjects,
                    points: if with_points { &points } else { &[] },
                    selected: Some(0),
                    selected_frame: 0,
                    current: Some([-0.75, 0.25]),
                    compared: None,
                    params: PoseMapParams::default(),
                    stress: Some(0.08),
                    neighbours: None,
                    left_out: "",
                };
                pose_map_header_ui(ui, &view, commands);
                pose_map_ui(ui, &view, commands);
            },
            Vec::new(),
        )
}

fn fitted(width: f32, height: f32) -> Lens {
    Lens::fit(points().iter().map(|point| point.at), width, height)
}

/// Where a point of the fitted map lies on screen.
fn place(harness: &Harness<'_, Vec<Command>>, index: usize) -> Pos2 {
    let rect = harness.get_by_label("Pose map").rect();
    let plot = rect.shrink2(vec2(34.0, 26.0));
    fitted(plot.width(), plot.height()).on_screen(rect, points()[index].at)
}

fn click(harness: &mut Harness<'_, Vec<Command>>, at: Pos2) {
    harness.hover_at(at);
    harness.step();
    harness.drag_at(at);
    harness.drop_at(at);
    harness.run();
}

#[test]
fn a_click_near_a_point_shows_that_heart_at_that_pose_and_plays() {
    let mut harness = harness(MapState::Ready, true);
    harness.run();
    let at = place(&harness, 2) + vec2(6.0, -6.0);
    click(&mut harness, at);
    let wanted = Command::SelectPose {
        subject: 1,
        frame: 0,
        play: true,
    };
    assert_eq!(*harness.state(), [wanted]);
}

#[test]
fn a_click_on_empty_ground_selects_nothing() {
    let mut harness = harness(MapState::Ready, true);
    harness.run();
    let at = place(&harness, 2) + vec2(-40.0, 0.0);
    click(&mut harness, at);
    assert_eq!(*harness.state(), []);
}

#[test]
fn after_a_drag_points_are_hit_where_they_are_seen() {
    let mut harness = harness(MapState::Ready, true);
    harness.run();
    let ground = place(&harness, 2) + vec2(-60.0, 10.0);
    harness.drag_at(ground);
    harness.step();
    harness.hover_at(ground + vec2(-50.0, 20.0));
    harness.step();
    harness.drop_at(ground + vec2(-50.0, 20.0));
    harness.run();
    let at = place(&harness, 2) + vec2(-50.0, 20.0);
    click(&mut harness, at);
    let wanted = Command::SelectPose {
        subject: 1,
        frame: 0,
        play: true,
    };
    assert_eq!(*harness.state(), [wanted]);
}

#[test]
fn zooming_keeps_what_is_under_the_pointer() {
    let rect = Rect::from_min_size(pos2(10.0, 20.0), vec2(300.0, 200.0));
    let mut lens = fitted(300.0, 200.0);
    let before = lens.on_screen(rect, points()[3].at);
    lens.zoom_about(before - rect.center(), 3.0);
    assert!((lens.on_screen(rect, points()[3].at) - before).length() < 1e-3);
    assert!((lens.points_per_unit - 3.0 * fitted(300.0, 200.0).points_per_unit).abs() < 1e-9);
}

#[test]
fn a_map_that_is_being_computed_can_be_cancelled_with_and_without_one_before() {
    for with_points in [false, true] {
        let state = MapState::Computing {
            fraction: 0.4,
            seconds_left: None,
        };
        let mut harness = harness(state, with_points);
        harness.run();
        harness.get_by_label("Cancel").click();
        harness.run();
        assert_eq!(
            *harness.state(),
            [Command::Cancel(Topic::of::<PoseMapParams>())]
        );
    }
}

#[test]
fn the_method_is_chosen_in_the_header() {
    let mut harness = harness(MapState::Ready, true);
    harness.run();
    harness.get_by_label("Method: SMACOF").click();
    harness.run();
    harness.get_by_label("MDS").click();
    harness.run();
    let params = PoseMapParams {
        method: crate::analysis::embedding::MapMethod::ClassicalMds,
        ..Default::default()
    };
    assert_eq!(*harness.state(), [Command::SetPoseMap(params)]);
}

#[test]
fn all_settings_are_a_step_away_from_the_header() {
    let mut harness = harness(MapState::Ready, true);
    harness.run();
    harness.get_by_label("Metric: Quasi-conformal").click();
    harness.run();
    // The menu is longer than this small window.
    harness.get_by_label("All settings…").click_accesskit();
    harness.run();
    let wanted = Command::ShowPane(crate::ui::command::Pane::Metric);
    assert_eq!(*harness.state(), [wanted]);
}
