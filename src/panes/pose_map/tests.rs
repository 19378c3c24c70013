//! What the header of the pose map asks for, and what its note says.

use egui_kittest::{Harness, kittest::Queryable as _};

use super::*;
use crate::analysis::embedding::MapMethod;
use crate::engine::PoseMapQuery;
use crate::panes::commands::{Command, MapCommand, Pane, WindowCommand};
use crate::panes::scatter_map::{ScatterPoint, ScatterView, scatter_map_ui};
use crate::ui::controls::named_header_ui;

fn harness() -> Harness<'static, Vec<Command>> {
    let mut harness = Harness::builder()
        .with_size([400.0, 300.0])
        .with_context_setup(|ctx| crate::ui::style::apply(ctx, true))
        .build_ui_state(
            move |ui, commands: &mut Vec<Command>| {
                let [note, explanation] = pose_map_note(Some(0.083), Some(10));
                let points = [ScatterPoint::default()];
                let map = ScatterView {
                    note,
                    explanation,
                    ..ScatterView::new(&POSE_MAP, &[], &points)
                };
                let params = PoseMapQuery::default();
                named_header_ui(ui, "Poses", |ui| {
                    pose_map_choosers_ui(ui, params, 56.0, commands);
                });
                scatter_map_ui(ui, &map, 0.0, commands);
            },
            Vec::new(),
        );
    harness.run();
    harness
}

#[test]
fn the_method_is_chosen_in_the_header() {
    let mut harness = harness();
    harness.get_by_label("Method: SMACOF").click();
    harness.run();
    harness.get_by_label("MDS").click();
    harness.run();
    let params = PoseMapQuery {
        method: MapMethod::ClassicalMds,
        ..Default::default()
    };
    assert_eq!(
        *harness.state(),
        [Command::Map(MapCommand::SetPoseMap(params))]
    );
}

#[test]
fn all_settings_are_a_step_away_from_the_header() {
    let mut harness = harness();
    harness.get_by_label("Metric: Displacement").click();
    harness.run();
    // The menu is longer than this small window.
    harness.get_by_label("All settings…").click_accesskit();
    harness.run();
    assert_eq!(
        *harness.state(),
        [Command::Window(WindowCommand::ShowPane(Pane::METRIC))]
    );
}

#[test]
fn the_note_says_stress_and_neighbours() {
    harness().get_by_label("stress 0.08 · 10 neighbours · axes have no unit");
    assert_eq!(pose_map_note(None, None)[0], "");
}
