//! What the deformation map says beside and below its points.

use egui_kittest::{Harness, kittest::Queryable as _};

use super::*;
use crate::analysis::deformations::Comparison;
use crate::engine::ClassesBy;
use crate::panes::cohort::rows::CohortRow;
use crate::panes::commands::{Command, MapCommand, SelectCommand};
use crate::panes::scatter_map::{PosePhase, ScatterPoint, ScatterView};

fn harness(
    rows: Vec<ClassifierView>,
    absent: ClassesView<'static>,
) -> Harness<'static, Vec<Command>> {
    harness_with(None, rows, absent)
}

/// With a stress, the map is one of distances.
fn harness_with(
    stress: Option<f64>,
    rows: Vec<ClassifierView>,
    absent: ClassesView<'static>,
) -> Harness<'static, Vec<Command>> {
    let subjects: Vec<CohortRow> = (0..4)
        .map(|index| CohortRow {
            id: format!("P{index}"),
            ..CohortRow::default()
        })
        .collect();
    let places = [[-1.0, 0.0], [1.0, 0.2], [0.9, 0.9], [0.0, -0.6]];
    let points = places.into_iter().enumerate();
    let points: Vec<ScatterPoint> = points
        .map(|(subject, at)| ScatterPoint {
            subject,
            at,
            start_frame: 2,
            phase: PosePhase::WholeMotion,
            label: Some(""),
            ..ScatterPoint::default()
        })
        .collect();
    let mut harness = Harness::builder()
        .with_size([420.0, 420.0])
        .with_context_setup(|ctx| crate::ui::style::apply(ctx, true))
        .build_ui_state(
            move |ui, commands: &mut Vec<Command>| {
                let map = ScatterView::new(&DEFORMATION_MAP, &subjects, &points);
                let view = DeformationMapView {
                    map,
                    comparison: Comparison::default(),
                    fit: DeformationFit {
                        neighbours: Some(5),
                        reconstruction_error: Some(0.0123),
                        stress,
                        time_weight: Some(1.42),
                    },
                    classes: if rows.is_empty() {
                        absent.clone()
                    } else {
                        ClassesView::Ready(&rows)
                    },
                    classes_by: Some(ClassesBy::Label),
                };
                deformation_header_ui(ui, &view, 0.0, commands);
                deformation_map_ui(ui, &view, commands);
            },
            Vec::new(),
        );
    harness.run();
    harness
}

#[test]
fn a_map_of_distances_says_so_and_names_no_neighbours() {
    let harness = harness_with(Some(0.125), Vec::new(), ClassesView::Absent);
    harness.get_by_label("SMACOF · stress 0.12 · time × 1.4");
}

#[test]
fn a_click_on_a_subject_plays_it_from_the_beginning_of_its_beat() {
    let mut harness = harness(Vec::new(), ClassesView::Absent);
    harness.get_by_label("neighbours 5 · reconstruction error 0.012 · time × 1.4");
    harness.get_by_label("Deformation of P1, other").click();
    harness.run();
    let played = Command::Select(SelectCommand::SelectPose {
        subject: 1,
        frame: 2,
        play: true,
    });
    assert_eq!(*harness.state(), [played]);
}

#[test]
fn accuracies_stand_beside_the_permutation_mean() {
    let row = ClassifierView {
        name: "Nearest neighbour",
        correct: 20,
        of: 23,
        permutation_mean: 12.43,
        p_value: 0.001,
        ..ClassifierView::default()
    };
    harness(vec![row], ClassesView::Absent)
        .get_by_label("Nearest neighbour: 20 of 23 · permutation mean 12.4 · p 0.001");
}

#[test]
fn too_few_labels_are_reported() {
    harness(Vec::new(), ClassesView::Unanswerable("not enough labels"))
        .get_by_label("Classifiers: not enough labels");
}

#[test]
fn subjects_are_told_apart_by_label_or_by_class_whatever_came_of_the_classification() {
    for absent in [
        ClassesView::Unanswerable("not enough labels"),
        ClassesView::Computing { fraction: 0.5 },
    ] {
        let mut harness = harness(Vec::new(), absent);
        harness.get_by_label("Classes: by label").click();
        harness.run();
        harness.get_by_label("normal and abnormal").click();
        harness.run();
        let chosen = Command::Map(MapCommand::SetClassesBy(ClassesBy::Class));
        assert_eq!(*harness.state(), [chosen]);
    }
}
