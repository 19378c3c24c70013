//! What the map does under the pointer, and what it says.

use egui::{Pos2, vec2};
use egui_kittest::{Harness, kittest::Queryable as _};

use super::*;
use crate::ui::map_ground::Lens;

fn subjects() -> Vec<MapSubject> {
    ["N01", "P05", "P08"]
        .map(|id| MapSubject {
            id: id.to_owned(),
            ..MapSubject::default()
        })
        .to_vec()
}

fn points() -> Vec<MedialPoint> {
    [
        (0, None, 1, [-1.0, 0.0]),
        (0, None, 4, [-0.2, 0.8]),
        (1, Some(0), 2, [1.0, 0.25]),
        (2, Some(0), 0, [0.25, -0.5]),
        (2, Some(1), 0, [0.7, -0.9]),
    ]
    .map(|(subject, patch, from, at)| MedialPoint {
        subject,
        patch,
        from,
        to: from + 1,
        at,
        ratio: 1.0,
        ..MedialPoint::default()
    })
    .to_vec()
}

fn harness(state: MapState, with_points: bool) -> Harness<'static, Vec<Command>> {
    let (subjects, points) = (subjects(), points());
    Harness::builder()
        .with_size([420.0, 320.0])
        .with_context_setup(|ctx| crate::ui::style::apply(ctx, true))
        .build_ui_state(
            move |ui, commands: &mut Vec<Command>| {
                let view = MedialMapView {
                    state: state.clone(),
                    subjects: &subjects,
                    mapped: &subjects,
                    points: if with_points { &points } else { &[] },
                    selected: Some(2),
                    current: vec![[0.25, -0.5]],
                    compared: Some(0),
                    method: MapMethod::Smacof,
                    stress: Some(0.084),
                    frame: "directions as in the files",
                    left_out_count: 2,
                    left_out: "P09: no wall\nP10: no wall",
                };
                medial_map_header_ui(ui, &view, commands);
                medial_map_ui(ui, &view, commands);
            },
            Vec::new(),
        )
}

/// Where a point of the fitted map lies on screen.
fn place(harness: &Harness<'_, Vec<Command>>, index: usize) -> Pos2 {
    let rect = harness.get_by_label("Medial map").rect();
    let plot = rect.shrink2(vec2(34.0, 26.0));
    let places = points().into_iter().map(|point| point.at);
    Lens::fit(places, plot.width(), plot.height()).on_screen(rect, points()[index].at)
}

fn click(harness: &mut Harness<'_, Vec<Command>>, at: Pos2) {
    harness.hover_at(at);
    harness.step();
    harness.drag_at(at);
    harness.drop_at(at);
    harness.run();
}

#[test]
fn a_click_near_a_step_shows_that_heart_where_the_step_begins() {
    let mut harness = harness(MapState::Ready, true);
    harness.run();
    let at = place(&harness, 1) + vec2(5.0, -5.0);
    click(&mut harness, at);
    let wanted = Command::SelectPose {
        subject: 0,
        frame: 4,
        play: true,
    };
    assert_eq!(*harness.state(), [wanted]);
}

#[test]
fn a_click_on_empty_ground_selects_nothing() {
    let mut harness = harness(MapState::Ready, true);
    harness.run();
    let at = place(&harness, 2) + vec2(-40.0, -20.0);
    click(&mut harness, at);
    assert_eq!(*harness.state(), []);
}

#[test]
fn the_strip_tells_the_stress_and_how_many_hearts_are_missing() {
    let mut harness = harness(MapState::Ready, true);
    harness.run();
    harness.get_by_label("stress 0.08 · 2 not on the map");
}

#[test]
fn the_pointer_reads_whose_step_it_is_on() {
    let mut harness = harness(MapState::Ready, true);
    harness.run();
    let at = place(&harness, 4);
    harness.hover_at(at);
    for _ in 0..60 {
        harness.step();
    }
    harness.get_by_label("P08 · frame 0 to 1");
    harness.get_by_label_contains("Patch 2: PT 1.00 ×");
}

#[test]
fn work_can_be_cancelled_and_begun_again_with_and_without_a_map_before() {
    let computing = MapState::Computing {
        fraction: 0.4,
        seconds_left: None,
    };
    for with_points in [false, true] {
        let mut shown = harness(computing.clone(), with_points);
        shown.run();
        shown.get_by_label("Cancel").click();
        shown.run();
        assert_eq!(
            *shown.state(),
            [Command::Cancel(Topic::of::<MedialMapParams>())]
        );
        let again = if with_points {
            "Retry"
        } else {
            "Compute the map"
        };
        let mut shown = harness(MapState::Stopped, with_points);
        shown.run();
        shown.get_by_label(again).click();
        shown.run();
        assert_eq!(
            *shown.state(),
            [Command::Retry(Topic::of::<MedialMapParams>())]
        );
    }
}

#[test]
fn a_study_without_map_says_why() {
    let reason = "0 poses of 0 hearts whose wall can be assessed: a map needs at least three";
    let mut shown = harness(MapState::Failed(reason.to_owned()), false);
    shown.run();
    shown.get_by_label("No map");
    shown.get_by_label(reason);
    let mut empty = harness(MapState::Empty, false);
    empty.run();
    empty.get_by_label("No poses");
}

#[test]
fn the_method_is_chosen_in_the_header() {
    let mut harness = harness(MapState::Ready, true);
    harness.run();
    harness.get_by_label("Method: SMACOF").click();
    harness.run();
    harness.get_by_label("MDS").click();
    harness.run();
    let wanted = Command::SetMapMethod(MapMethod::ClassicalMds);
    assert_eq!(*harness.state(), [wanted]);
}
