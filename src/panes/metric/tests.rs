//! Every change of a setting is one command, and wrong numbers are none.

use egui_kittest::{Harness, kittest::Queryable as _};

use super::*;
use crate::analysis::deformations::Comparison;
use crate::analysis::embedding::MapMethod;
use crate::analysis::metrics::{Form, MetricKind, MetricParams};
use crate::analysis::transport::{CohortTransportParams, Reference};
use crate::panes::MapCommand;
use crate::panes::cohort::rows::CohortRow;

#[derive(Default)]
struct Scene {
    poses: PoseMapQuery,
    deformations: DeformationMapParams,
    commands: Vec<Command>,
}

fn harness(scene: Scene) -> Harness<'static, Scene> {
    let subjects: Vec<CohortRow> = (0..3)
        .map(|index| CohortRow {
            id: format!("P{index}"),
            ..CohortRow::default()
        })
        .collect();
    Harness::builder()
        .with_size([280.0, 900.0])
        .with_context_setup(|ctx| crate::ui::style::apply(ctx, true))
        .build_ui_state(
            move |ui, scene: &mut Scene| {
                let view = MetricPanelView {
                    poses: scene.poses,
                    deformations: scene.deformations,
                    shares: Some("Medians over 3 beats".to_owned()),
                    subjects: &subjects,
                    selected: Some(2),
                    neighbours: Some(5),
                    time_weight: Some(1.42),
                };
                let mut commands = Vec::new();
                metric_panel_ui(ui, &view, &mut commands);
                for command in &commands {
                    match command {
                        Command::Map(MapCommand::SetPoseMap(params)) => scene.poses = *params,
                        Command::Map(MapCommand::SetDeformationMap(params)) => {
                            scene.deformations = *params;
                        }
                        _ => {}
                    }
                }
                scene.commands.extend(commands);
            },
            scene,
        )
}

fn choose(harness: &mut Harness<'_, Scene>, chooser: &str, choice: &str) {
    harness.get_by_label(chooser).click();
    harness.run();
    harness.get_by_label(choice).click();
    harness.run();
}

fn type_into(harness: &mut Harness<'_, Scene>, field: &str, text: &str) {
    harness
        .get_by_role_and_label(egui::accesskit::Role::TextInput, field)
        .focus();
    harness.run();
    harness.key_press_modifiers(egui::Modifiers::COMMAND, egui::Key::A);
    harness.run();
    harness
        .get_by_role_and_label(egui::accesskit::Role::TextInput, field)
        .type_text(text);
    harness.run();
    harness.key_press(egui::Key::Enter);
    harness.run();
}

#[test]
fn kind_and_form_are_chosen_and_say_what_they_ignore() {
    let mut harness = harness(Scene::default());
    harness.run();
    choose(&mut harness, "Kind: Displacement", "Quasi-conformal");
    // A kind comes with its weights.
    let metric = harness.state().poses.distances.metric;
    assert_eq!(metric, MetricParams::of(MetricKind::QuasiConformal));
    choose(&mut harness, "Form: Additive", "Frozen weights");
    harness.get_by_label_contains("Frozen weights: ignores");
    choose(&mut harness, "Kind: Quasi-conformal", "Isometric");
    harness.get_by_label_contains("Isometric: ignores");
    let metric = harness.state().poses.distances.metric;
    assert_eq!(
        (metric.kind, metric.form),
        (MetricKind::Isometric, Form::Frozen)
    );
    assert_eq!(harness.state().commands.len(), 3);
}

#[test]
fn a_weight_is_typed_and_a_wrong_one_is_refused_with_a_reason() {
    let mut scene = Scene::default();
    scene.poses.distances.metric = MetricParams::of(MetricKind::QuasiConformal);
    let mut harness = harness(scene);
    harness.run();
    type_into(&mut harness, "Displacement, λ", "0.5");
    assert_eq!(harness.state().poses.distances.metric.lambda, 0.5);
    type_into(&mut harness, "Displacement, λ", "-1");
    assert_eq!(harness.state().poses.distances.metric.lambda, 0.5);
    harness.get_by_label("lambda must be zero or positive and finite, not -1");
    type_into(&mut harness, "Averaging", "2.5");
    harness.get_by_label("curvature is averaged over a radius between 0 and 0.5 of √area, not 2.5");
    assert_eq!(harness.state().commands.len(), 1);
}

#[test]
fn motions_are_transported_onto_the_mean_or_a_subject() {
    let mut harness = harness(Scene::default());
    harness.run();
    choose(
        &mut harness,
        "Transport: off",
        "onto the mean subject of the cohort",
    );
    let transfer = |harness: &Harness<'_, Scene>| harness.state().poses.distances.transport;
    assert_eq!(transfer(&harness), Some(CohortTransportParams::default()));
    choose(&mut harness, "Transport: onto the mean subject", "onto P2");
    assert_eq!(
        transfer(&harness).map(|transfer| transfer.reference),
        Some(Reference::Subject(2))
    );
}

#[test]
fn isomap_asks_for_its_neighbours() {
    let mut harness = harness(Scene::default());
    harness.run();
    assert!(harness.query_all_by_label("Neighbours").count() >= 1);
    choose(&mut harness, "Method: SMACOF", "Isomap: neighbour graph");
    assert_eq!(
        harness.state().poses.method,
        MapMethod::Isomap { neighbours: 10 }
    );
}

#[test]
fn settings_of_the_deformation_map_may_be_left_to_the_program() {
    let mut harness = harness(Scene::default());
    harness.run();
    // Time counts where curves of poses are compared.
    choose(&mut harness, "Compare: deformation", "curves of poses");
    assert_eq!(harness.state().deformations.comparison, Comparison::Poses);
    type_into(&mut harness, "Time weight", "0");
    assert_eq!(harness.state().deformations.time_weight, Some(0.0));
    type_into(&mut harness, "Neighbours", "8");
    assert_eq!(harness.state().deformations.neighbours, Some(8));
    type_into(&mut harness, "Regularisation", "0");
    harness.get_by_label_contains("regularisation must be above 0");
    assert_eq!(harness.state().commands.len(), 3);
}

#[test]
fn reset_is_enabled_once_a_setting_was_changed() {
    let mut harness = harness(Scene::default());
    harness.run();
    harness.get_by_label("Reset to defaults").click();
    harness.run();
    assert!(harness.state().commands.is_empty());
    choose(&mut harness, "Method: SMACOF", "MDS: classical scaling");
    harness.get_by_label("Reset to defaults").click();
    harness.run();
    assert_eq!(
        harness.state().commands.last(),
        Some(&Command::Map(MapCommand::ResetMaps))
    );
}
