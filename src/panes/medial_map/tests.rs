//! What the medial map says, and what its header asks for.

use egui_kittest::{Harness, kittest::Queryable as _};

use super::*;
use crate::analysis::embedding::MapMethod;
use crate::panes::commands::{Command, MapCommand};
use crate::panes::scatter_map::{ScatterView, scatter_map_ui};
use crate::ui::controls::named_header_ui;

#[test]
fn the_method_is_chosen_in_the_header() {
    let mut harness = Harness::builder()
        .with_size([420.0, 320.0])
        .with_context_setup(|ctx| crate::ui::style::apply(ctx, true))
        .build_ui_state(
            move |ui, commands: &mut Vec<Command>| {
                let map = ScatterView::new(&MEDIAL_MAP, &[], &[]);
                named_header_ui(ui, "Medial", |ui| {
                    medial_map_choosers_ui(ui, MapMethod::Smacof, commands);
                });
                scatter_map_ui(ui, &map, 0.0, commands);
            },
            Vec::new(),
        );
    harness.run();
    harness.get_by_label("No poses");
    harness.get_by_label("Method: SMACOF").click();
    harness.run();
    harness.get_by_label("MDS").click();
    harness.run();
    let wanted = Command::Map(MapCommand::SetMapMethod(MapMethod::ClassicalMds));
    assert_eq!(*harness.state(), [wanted]);
}

#[test]
fn patches_are_counted_from_one_and_a_single_pose_has_no_mean_distance() {
    assert_eq!(
        medial_facts(Some(0), 1.018, Some(0.25)),
        [
            "Patch 1: thickness ratio PT 1.02, mean over the step",
            "Mean pose distance of this path 0.25"
        ]
    );
    let whole = medial_facts(None, 1.018, None);
    assert_eq!(
        whole,
        ["Akinetic region: thickness ratio PT 1.02, mean over the step"]
    );
}

#[test]
fn the_note_says_the_stress_and_its_hover_the_axes() {
    let [note, explanation] = medial_map_note(Some(0.084), "directions as in the files");
    assert_eq!(note, "stress 0.08");
    assert!(explanation.ends_with("Compared by directions as in the files."));
}
