//! What the map of deformations does under the pointer and the keyboard.

use egui_kittest::{Harness, kittest::Queryable as _};

use super::*;
use crate::engine::DeformationMapSettings;
use crate::study::LabelRole;

fn subjects() -> Vec<MapSubject> {
    [
        LabelRole::Normal,
        LabelRole::Abnormal,
        LabelRole::Unknown,
        LabelRole::Abnormal,
    ]
    .into_iter()
    .enumerate()
    .map(|(index, role)| MapSubject {
        id: format!("P{index}"),
        role,
        ejection_fraction: Some(0.5),
        ..MapSubject::default()
    })
    .collect()
}

fn points() -> Vec<DeformationPoint> {
    [[-1.0, 0.0], [1.0, 0.2], [0.9, 0.9], [0.0, -0.6]]
        .into_iter()
        .enumerate()
        .map(|(subject, at)| DeformationPoint {
            subject,
            at,
            first_frame: 2,
            cluster: Some(subject % 2),
            nearest: vec![(subject + 1) % 4],
        })
        .collect()
}

#[derive(Clone)]
struct Scene {
    state: MapState,
    with_points: bool,
    rules: Vec<RuleView>,
    classes: ClassesView<'static>,
}

fn scene() -> Scene {
    Scene {
        state: MapState::Ready,
        with_points: true,
        rules: Vec::new(),
        classes: ClassesView::Absent,
    }
}

fn harness(scene: Scene) -> Harness<'static, Vec<Command>> {
    let (subjects, points) = (subjects(), points());
    Harness::builder()
        .with_size([420.0, 420.0])
        .with_context_setup(|ctx| crate::ui::style::apply(ctx, true))
        .build_ui_state(
            move |ui, commands: &mut Vec<Command>| {
                let view = DeformationMapView {
                    state: scene.state.clone(),
                    job: Topic::of::<DeformationMapSettings>(),
                    subjects: &subjects,
                    points: if scene.with_points { &points } else { &[] },
                    selected: Some(0),
                    compared: None,
                    neighbours: Some(5),
                    reconstruction_error: Some(0.0123),
                    time_weight: Some(1.42),
                    shows_clusters: true,
                    classes: if scene.rules.is_empty() {
                        scene.classes.clone()
                    } else {
                        ClassesView::Ready(&scene.rules)
                    },
                    left_out: "",
                };
                deformation_note(ui, &view, 0.0);
                deformation_map_ui(ui, &view, commands);
            },
            Vec::new(),
        )
}

fn played(subject: usize) -> Command {
    Command::SelectPose {
        subject,
        frame: 2,
        play: true,
    }
}

#[test]
fn a_click_on_a_heart_plays_it_from_the_beginning_of_its_beat() {
    let mut harness = harness(scene());
    harness.run();
    harness.get_by_label("Deformation of P1, abnormal").click();
    harness.run();
    assert_eq!(*harness.state(), [played(1)]);
}

#[test]
fn hover_tells_label_ejection_fraction_and_who_moves_alike() {
    let mut harness = harness(scene());
    harness.run();
    harness.get_by_label("Deformation of P3, abnormal").hover();
    harness.run_steps(40);
    harness.get_by_label("Moves most like P0");
    harness.get_by_label_contains("Ejection fraction 50 %");
    harness.get_by_label("Cluster B");
}

#[test]
fn arrows_and_enter_play_a_heart_without_the_pointer() {
    let mut harness = harness(scene());
    harness.run();
    harness.get_by_label("Deformation map").focus();
    harness.run();
    for key in [
        egui::Key::ArrowRight,
        egui::Key::ArrowRight,
        egui::Key::Enter,
    ] {
        harness.key_press(key);
        harness.run();
    }
    // From the selected heart on the left over the one below to the one on the right.
    assert_eq!(*harness.state(), [played(1)]);
}

#[test]
fn the_header_says_neighbours_error_and_time() {
    let mut harness = harness(scene());
    harness.run();
    harness.get_by_label("neighbours 5 · error 0.012 · time × 1.4");
}

#[test]
fn clusters_are_switched_off_in_the_legend() {
    let mut harness = harness(scene());
    harness.run();
    harness.get_by_label("A 2");
    harness.get_by_label("Clusters").click();
    harness.run();
    assert_eq!(*harness.state(), [Command::ToggleClusters]);
}

#[test]
fn accuracies_stand_beside_chance() {
    let rule = RuleView {
        name: "Nearest neighbour",
        correct: 20,
        of: 23,
        chance: 12.43,
        p_value: 0.001,
        ..RuleView::default()
    };
    let mut harness = harness(Scene {
        rules: vec![rule],
        ..scene()
    });
    harness.run();
    harness.get_by_label("Nearest neighbour: 20 of 23 · chance 12.4 · p 0.001");
}

#[test]
fn too_few_labels_are_said_so() {
    let mut harness = harness(Scene {
        classes: ClassesView::Unanswerable("not enough labels"),
        ..scene()
    });
    harness.run();
    harness.get_by_label("Classes: not enough labels");
}

#[test]
fn work_on_the_map_can_be_cancelled_with_and_without_one_before() {
    for with_points in [false, true] {
        let state = MapState::Computing {
            fraction: 0.4,
            seconds_left: None,
        };
        let mut harness = harness(Scene {
            state,
            with_points,
            ..scene()
        });
        harness.run();
        harness.get_by_label("Cancel").click();
        harness.run();
        assert_eq!(
            *harness.state(),
            [Command::Cancel(Topic::of::<DeformationMapSettings>())]
        );
    }
}

#[test]
fn a_study_that_is_too_small_says_so_and_offers_no_retry() {
    let why = "Fewer than 4 subjects: no deformation map";
    let mut harness = harness(Scene {
        state: MapState::Unanswerable(why.to_owned()),
        with_points: false,
        ..scene()
    });
    harness.run();
    harness.get_by_label(why);
    assert!(harness.query_by_label("Retry").is_none());
}
