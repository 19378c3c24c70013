//! What every map does under the pointer and the keyboard, and what it says.

use egui::{Key, Pos2, vec2};
use egui_kittest::{Harness, kittest::Queryable as _};

use super::lens::Lens;
use super::view::play_command;
use super::*;
use crate::engine::{PoseMapQuery, Topic};
use crate::panes::cohort::rows::CohortRow;
use crate::panes::commands::{Command, MapCommand, SelectCommand, WorkCommand};
use crate::panes::work_state::WorkState;
use crate::study::LabelClass;

/// Points and subjects of a small map: two poses of P0, one of P1, one each of two patches of P2.
pub struct Map {
    pub subjects: Vec<CohortRow>,
    pub points: Vec<ScatterPoint>,
}

impl Default for Map {
    fn default() -> Self {
        let classes = [
            LabelClass::Neither,
            LabelClass::Normal,
            LabelClass::Abnormal,
        ];
        let subject = |(index, class): (usize, LabelClass)| CohortRow {
            id: format!("P{index}"),
            class,
            ejection_fraction: Some(0.5),
            ..CohortRow::default()
        };
        let point = |(subject, patch, frame, at)| ScatterPoint {
            subject,
            patch,
            frames: Some([frame, frame]),
            start_frame: frame,
            at,
            phase: PosePhase::of(frame, (Some(0), Some(1))),
            label: (frame == 0).then_some("ED"),
            facts: vec![format!("Fact of {subject}")],
            ..ScatterPoint::default()
        };
        Self {
            subjects: classes.into_iter().enumerate().map(subject).collect(),
            points: [
                (0, None, 0, [-1.0, 0.0]),
                (0, None, 1, [-0.5, 0.5]),
                (1, None, 0, [1.0, 0.25]),
                (2, Some(0), 0, [0.25, -0.5]),
                (2, Some(1), 0, [0.4, 0.9]),
            ]
            .map(point)
            .to_vec(),
        }
    }
}

static WORDS: MapWords = MapWords {
    job: Topic::of::<PoseMapQuery>(),
    name: "Map",
    item: "Path",
    empty: "Nothing here",
    what: "Something would be here.",
    none: "No map",
    hints: &["Click to play"],
    command: play_command,
};

/// The map as it is shown while P0 is selected.
pub fn view(map: &Map) -> ScatterView<'_> {
    ScatterView {
        selected: Some(0),
        current: vec![[-0.75, 0.25]],
        shows_clusters: true,
        note: "stress 0.08".to_owned(),
        explanation: "What stress is.".to_owned(),
        ..ScatterView::new(&WORDS, &map.subjects, &map.points)
    }
}

type Shown = Harness<'static, Vec<Command>>;

/// The map, alone or two of them one above the other, changed by `change`.
fn harness(count: usize, change: impl Fn(&mut Map, &mut WorkState) + 'static) -> Shown {
    let mut harness = Harness::builder()
        .with_size([400.0, 300.0 * count as f32])
        .with_step_dt(1.0 / 30.0)
        .with_max_steps(64)
        .with_context_setup(|ctx| crate::ui::style::apply(ctx, true))
        .build_ui_state(
            move |ui, commands: &mut Vec<Command>| {
                let (mut map, mut state) = (Map::default(), WorkState::Ready);
                change(&mut map, &mut state);
                for index in 0..count {
                    let view = ScatterView {
                        state: state.clone(),
                        ..view(&map)
                    };
                    let below = 300.0 * (count - 1 - index) as f32;
                    ui.push_id(index, |ui| scatter_map_ui(ui, &view, below, commands));
                }
            },
            Vec::new(),
        );
    harness.run();
    harness
}

fn plain() -> Shown {
    harness(1, |_, _| {})
}

/// Where a point of the fitted map lies on screen.
fn place(harness: &Shown, index: usize) -> Pos2 {
    let rect = harness.get_by_label("Map").rect();
    let plot = rect.shrink2(vec2(34.0, 26.0));
    let points = Map::default().points;
    let places = points.iter().map(|point| point.at);
    Lens::fit(places, plot.width(), plot.height()).on_screen(rect, points[index].at)
}

fn click(harness: &mut Shown, at: Pos2) {
    harness.hover_at(at);
    harness.step();
    harness.drag_at(at);
    harness.drop_at(at);
    harness.run();
}

fn played(subject: usize, frame: usize) -> Command {
    Command::Select(SelectCommand::SelectPose {
        subject,
        frame,
        play: true,
    })
}

#[test]
fn a_click_near_a_point_plays_its_subject_and_one_on_empty_ground_does_nothing() {
    let mut harness = plain();
    let at = place(&harness, 1);
    click(&mut harness, at + vec2(-40.0, 0.0));
    assert_eq!(*harness.state(), []);
    click(&mut harness, at + vec2(6.0, -6.0));
    assert_eq!(*harness.state(), [played(0, 1)]);
}

#[test]
fn the_pointer_passes_over_subjects_that_the_filter_leaves_out() {
    let mut harness = harness(1, |map, _| map.subjects[0].filtered_out = true);
    let at = place(&harness, 1);
    click(&mut harness, at);
    assert_eq!(*harness.state(), []);
    let at = place(&harness, 2);
    click(&mut harness, at);
    assert_eq!(*harness.state(), [played(1, 0)]);
}

#[test]
fn after_a_drag_points_are_hit_where_they_are_seen_and_a_double_click_shows_all() {
    let mut harness = plain();
    let point = place(&harness, 2);
    let seen = |harness: &Shown| harness.get_by_label("Path of P1, normal").rect().center();
    let at_first = seen(&harness);
    let ground = point + vec2(-60.0, 40.0);
    harness.drag_at(ground);
    harness.step();
    harness.hover_at(ground + vec2(-50.0, 20.0));
    harness.step();
    harness.drop_at(ground + vec2(-50.0, 20.0));
    harness.run();
    assert!((seen(&harness) - (point + vec2(-50.0, 20.0))).length() < 2.0);
    click(&mut harness, point + vec2(-50.0, 20.0));
    assert_eq!(*harness.state(), [played(1, 0)]);
    // The click before must be long ago, or the second one of these is a third.
    harness.run_steps(15);
    for pressed in [true, false, true, false] {
        harness.event(egui::Event::PointerButton {
            pos: ground,
            button: egui::PointerButton::Primary,
            pressed,
            modifiers: egui::Modifiers::NONE,
        });
    }
    harness.run();
    assert!((seen(&harness) - at_first).length() < 0.5);
}

#[test]
fn a_click_right_after_a_double_click_shows_all_again() {
    let mut harness = plain();
    let ground = place(&harness, 2) + vec2(-60.0, 40.0);
    let seen = |harness: &Shown| harness.get_by_label("Path of P1, normal").rect().center();
    let at_first = seen(&harness);
    let click = |harness: &mut Shown| {
        harness.drag_at(ground);
        harness.drop_at(ground);
        harness.step();
    };
    click(&mut harness);
    click(&mut harness);
    harness.drag_at(ground);
    harness.step();
    harness.hover_at(ground + vec2(-50.0, 20.0));
    harness.step();
    harness.drop_at(ground + vec2(-50.0, 20.0));
    harness.step();
    assert!((seen(&harness) - at_first).length() > 20.0);
    // egui counts it as the third of a triple click.
    click(&mut harness);
    harness.run();
    assert!((seen(&harness) - at_first).length() < 0.5);
}

#[test]
fn arrows_and_enter_play_a_subject_without_the_pointer() {
    let mut harness = plain();
    harness.get_by_label("Map").focus();
    harness.run();
    // From the selected subject on the left over its other pose to the one on the right.
    for key in [Key::ArrowRight, Key::ArrowRight, Key::Enter] {
        harness.key_press(key);
        harness.run();
    }
    assert_eq!(*harness.state(), [played(2, 0)]);
}

#[test]
fn the_hover_card_has_name_class_numbers_and_hints() {
    let mut harness = plain();
    let at = place(&harness, 1);
    harness.hover_at(at);
    harness.run_steps(40);
    for line in [
        "P0 · frame 1, 0 % of the cycle by frames · end-systole",
        "no label, class other",
        "Fact of 0",
        "Click to play",
    ] {
        // The point itself has the name that the card begins with.
        assert!(harness.query_all_by_label(line).next().is_some(), "{line}");
    }
    harness.get_by_label_contains("Ejection fraction 50 %");
}

#[test]
fn a_subject_with_one_patch_needs_no_number() {
    let mut harness = plain();
    harness.get_by_label("Path of P2 patch 2, abnormal");
    harness = self::harness(1, |map, _| map.points.truncate(4));
    harness.get_by_label("Path of P2 patch, abnormal");
    assert_eq!(
        view(&Map::default())
            .label(&Map::default().points[4])
            .as_deref(),
        Some("P2 patch 2 ED")
    );
}

/// How many lines are drawn in the colour of what is pointed at.
fn bright_lines(harness: &Shown) -> usize {
    let strong = crate::ui::theme::DARK.strong;
    let bright = |clipped: &&egui::epaint::ClippedShape| match &clipped.shape {
        egui::Shape::Path(path) => path.stroke.color == egui::epaint::ColorMode::Solid(strong),
        egui::Shape::Circle(circle) => circle.stroke.color == strong,
        _ => false,
    };
    harness.output().shapes.iter().filter(bright).count()
}

#[test]
fn a_subject_under_the_pointer_stands_out_on_every_map_until_the_pointer_leaves() {
    let mut harness = harness(2, |_, _| {});
    let at = harness.get_all_by_label("Path of P1, normal");
    let at: Vec<Pos2> = at.map(|path| path.rect().center()).collect();
    assert_eq!((at.len(), bright_lines(&harness)), (2, 0));
    for place in at {
        harness.hover_at(place);
        harness.run();
        // A ring on each map, and a second one at the pointer.
        assert_eq!(bright_lines(&harness), 3);
        harness.hover_at(place + vec2(-40.0, 30.0));
        harness.run();
        assert_eq!(bright_lines(&harness), 0);
    }
}

#[test]
fn work_can_be_cancelled_and_begun_again_with_and_without_a_previous_map() {
    for with_points in [false, true] {
        let shown = |state: WorkState| {
            harness(1, move |map, shown| {
                *shown = state.clone();
                if !with_points {
                    map.points.clear();
                }
            })
        };
        let mut computing = shown(WorkState::Computing {
            fraction: 0.4,
            phase: String::new(),
            seconds_left: None,
        });
        computing.get_by_label("40 %");
        computing.get_by_label("Cancel").click();
        computing.run();
        assert_eq!(
            *computing.state(),
            [Command::Work(WorkCommand::Cancel(
                Topic::of::<PoseMapQuery>()
            ))]
        );
        let again = if with_points {
            "Retry"
        } else {
            "Compute the map"
        };
        let mut stopped = shown(WorkState::Stopped);
        stopped.get_by_label(again).click();
        stopped.run();
        assert_eq!(
            *stopped.state(),
            [Command::Work(WorkCommand::Retry(
                Topic::of::<PoseMapQuery>()
            ))]
        );
    }
}

#[test]
fn a_study_without_a_map_says_why_and_offers_a_retry_only_where_it_may_help() {
    let without = |state: WorkState| {
        harness(1, move |map, shown| {
            *shown = state.clone();
            map.points.clear();
        })
    };
    without(WorkState::Empty).get_by_label("Nothing here");
    let failed = without(WorkState::Failed("too few poses".to_owned()));
    failed.get_by_label("too few poses");
    failed.get_by_label("Retry");
    let never = without(WorkState::Unanswerable("no wall".to_owned()));
    never.get_by_label("no wall");
    assert!(never.query_by_label("Retry").is_none());
}

#[test]
fn clusters_have_a_switch_in_the_legend_and_take_the_place_of_the_note() {
    let mut harness = plain();
    harness.get_by_label("stress 0.08 · axes have no unit");
    harness = self::harness(1, |map, _| {
        for point in &mut map.points {
            point.cluster = Some(point.subject % 2);
        }
    });
    assert!(harness.query_by_label_contains("stress").is_none());
    harness.get_by_label("A 4");
    harness.get_by_label("Clusters").click();
    harness.run();
    assert_eq!(*harness.state(), [Command::Map(MapCommand::ToggleClusters)]);
}

#[test]
fn zooming_keeps_what_is_under_the_pointer() {
    let rect = egui::Rect::from_min_size(egui::pos2(10.0, 20.0), vec2(300.0, 200.0));
    let points = Map::default().points;
    let fitted = Lens::fit(points.iter().map(|point| point.at), 300.0, 200.0);
    let mut lens = fitted;
    let before = lens.on_screen(rect, points[3].at);
    lens.zoom_about(before - rect.center(), 3.0);
    assert!((lens.on_screen(rect, points[3].at) - before).length() < 1e-3);
    assert!((lens.points_per_unit - 3.0 * fitted.points_per_unit).abs() < 1e-9);
}

#[test]
fn points_have_names_and_in_a_large_map_those_of_the_chosen_subject_still_do() {
    let small = harness(1, |_, _| {});
    for name in ["P0 · frame 1,", "P1 · frame 0,"] {
        small.get_by_label_contains(name);
    }
    let large = harness(1, |map, _| {
        let last = map.points[4].clone();
        map.points.extend((1..1000).map(|frame| ScatterPoint {
            frames: Some([frame, frame]),
            ..last.clone()
        }));
    });
    large.get_by_label_contains("P0 · frame 1,");
    assert!(large.query_by_label_contains("P2 · frame").is_none());
}
