//! Images in the window: slices that cross, the steps of an import, edits that undo takes back, walls in the cohort.

use std::sync::Arc;

use super::*;
use crate::synthetic_spect;
use cardiomorph::analysis::measures::measure_subject;
use cardiomorph::analysis::preparation::Road;
use cardiomorph::document::{ImageTool, ImportStep};
use cardiomorph::engine::ImageWallsQuery;
use cardiomorph::image::Image;
use cardiomorph::panes::{EditCommand, ImagesCommand, ImportCommand, WindowCommand};
use cardiomorph::study::Subject;
use cardiomorph::study::built_in::{BuiltInParams, cohort};

/// A built-in heart, normal.
fn heart() -> Arc<Subject> {
    let params = BuiltInParams::default();
    Arc::clone(&cohort(&params).unwrap().study.subjects[0])
}

/// Its gated SPECT study, with or without a liver beside it.
fn gated(liver: bool) -> synthetic_spect::Study {
    let mut scene = synthetic_spect::Scene::default();
    if !liver {
        scene.liver = 0.0;
    }
    synthetic_spect::gated_spect(&heart().sequence, &scene)
}

/// An image whose axes are those of the patient, as a NIfTI-1 file of an R-R interval of 800 ms.
fn nifti(image: &Image) -> Vec<u8> {
    let mut bytes = vec![0_u8; 352];
    let mut put =
        |place: usize, value: &[u8]| bytes[place..place + value.len()].copy_from_slice(value);
    let (frame, volumes) = (image.frame(), image.volumes());
    put(0, &348_i32.to_le_bytes());
    put(40, &4_i16.to_le_bytes());
    for (place, size) in frame.size().into_iter().chain([volumes.len()]).enumerate() {
        put(42 + 2 * place, &(size as i16).to_le_bytes());
    }
    put(70, &16_i16.to_le_bytes());
    put(72, &32_i16.to_le_bytes());
    let [x, y, z] = frame.spacing().map(|step| step as f32);
    for (place, step) in [1.0, x, y, z, 800.0 / volumes.len() as f32]
        .into_iter()
        .enumerate()
    {
        put(76 + 4 * place, &step.to_le_bytes());
    }
    put(108, &352.0_f32.to_le_bytes());
    // Millimetres and milliseconds.
    put(123, &[2 | 16]);
    put(254, &1_i16.to_le_bytes());
    // The file counts from right to left and from back to front.
    let origin = frame.origin();
    for (place, value) in [
        (280, -x),
        (292, -origin.x as f32),
        (300, -y),
        (308, -origin.y as f32),
        (320, z),
        (324, origin.z as f32),
    ] {
        put(place, &value.to_le_bytes());
    }
    put(344, b"n+1\0");
    bytes.extend(
        volumes
            .iter()
            .flat_map(|volume| volume.iter())
            .flat_map(|value| value.to_le_bytes()),
    );
    bytes
}

/// A window with the study of a file, once its images are there.
fn image_window(liver: bool) -> (tempfile::TempDir, Harness<'static, App>) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("p7.nii");
    std::fs::write(&path, nifti(&gated(liver).image)).unwrap();
    let mut harness = window(AppOptions::opening(vec![path]));
    wait_up_to(120, &mut harness, "images", |app| {
        !app.state().document.images().is_empty() && app.state().document.shown_series().is_some()
    });
    for pane in [Pane::IMPORT, Pane::SLICES] {
        give(&mut harness, WindowCommand::ShowPane(pane).into());
    }
    wait(&mut harness, "the steps", |app| {
        app.state().errors.is_empty()
    });
    harness.run_steps(6);
    (folder, harness)
}

fn slice(harness: &Harness<'_, App>, name: &str) -> egui::Rect {
    let slices = harness.get_all_by_label_contains(name);
    slices.last().unwrap().rect()
}

#[test]
fn a_study_of_images_brings_its_panes_and_a_click_moves_all_slices() {
    let (_folder, mut harness) = image_window(false);
    let before = harness.state().state().document.crosshair().unwrap();
    let axial = slice(&harness, "Axial");
    click_at(&mut harness, axial.center() + egui::vec2(20.0, -15.0));
    harness.run_steps(2);
    let after = harness.state().state().document.crosshair().unwrap();
    // The left of the patient is at the right, the front above; the slice stays.
    assert!(after.x > before.x && after.y < before.y, "{before} {after}");
    assert!((after.z - before.z).abs() < 1e-9);
    give(&mut harness, EditCommand::Undo.into());
    let undone = harness.state().state().document.crosshair().unwrap();
    assert_eq!(undone, before);
    give(&mut harness, ImagesCommand::StepSlice(1).into());
    let stepped = harness.state().state().document.crosshair().unwrap();
    assert!((stepped.z - before.z).abs() > 1.9, "{before} {stepped}");
}

#[test]
fn an_edit_of_the_threshold_and_a_sphere_are_taken_back_by_undo() {
    let (_folder, mut harness) = image_window(true);
    give(&mut harness, ImportCommand::GoTo(ImportStep::Tissue).into());
    harness.run_steps(4);
    harness.get_by_label("Largest part").click();
    harness.run_steps(3);
    let edits = |harness: &Harness<'_, App>| {
        let import = &harness.state().state().document.import;
        import
            .settings
            .get(&0)
            .map_or(0, |settings| settings.edits.len())
    };
    assert_eq!(edits(&harness), 1);
    let tool = ImportCommand::UseTool(Some(ImageTool::Eraser));
    give(&mut harness, tool.into());
    harness.run_steps(2);
    let coronal = slice(&harness, "Coronal");
    click_at(&mut harness, coronal.center());
    harness.run_steps(2);
    assert_eq!(edits(&harness), 2);
    for left in [1, 0] {
        give(&mut harness, EditCommand::Undo.into());
        assert_eq!(edits(&harness), left);
    }
}

#[test]
fn walls_that_are_being_made_are_stopped_by_cancel_and_made_again() {
    let (_folder, mut harness) = image_window(false);
    // Another base asks for other walls than those that opening made.
    give(&mut harness, ImportCommand::GoTo(ImportStep::Walls).into());
    let topic = Topic::of::<ImageWallsQuery>();
    wait(&mut harness, "walls begun", |app| app.works_on(topic));
    give(&mut harness, WorkCommand::Cancel(topic).into());
    wait(&mut harness, "a stop", |app| !app.works_on(topic));
    harness.run_steps(3);
    harness.get_by_label("Make walls").click();
    wait(&mut harness, "walls begun again", |app| app.works_on(topic));
}

#[test]
fn gated_counts_with_a_liver_walk_through_all_steps_to_a_subject_with_its_ejection_fraction() {
    let (_folder, mut harness) = image_window(true);
    let study = gated(true);
    for step in ImportStep::ALL {
        give(&mut harness, ImportCommand::GoTo(step).into());
        harness.run_steps(3);
        if step == ImportStep::Tissue {
            let moved = ImagesCommand::MoveTo(study.liver_centre);
            give(&mut harness, moved.into());
            let radius = ImportCommand::SetEraser(study.liver_radius_mm);
            give(&mut harness, radius.into());
            let tool = ImportCommand::UseTool(Some(ImageTool::Eraser));
            give(&mut harness, tool.into());
            harness.run_steps(2);
            // Enter erases at the crosshair.
            let label = "Axial";
            let slices = harness.get_all_by_label_contains(label);
            slices.last().unwrap().focus();
            harness.run_steps(2);
            harness.key_press(egui::Key::Enter);
            harness.run_steps(2);
        }
    }
    let import = &harness.state().state().document.import;
    let settings = import.settings.get(&0).unwrap().clone();
    assert_eq!((settings.road, settings.edits.len()), (Road::Spect, 1));
    let topic = Topic::of::<ImageWallsQuery>();
    wait_up_to(120, &mut harness, "walls", |app| {
        !app.works_on(topic) && !app.busy()
    });
    let add = ImportCommand::Add(vec![(0, settings)]);
    give(&mut harness, add.into());
    wait_up_to(60, &mut harness, "measures", |app| {
        let state = app.state();
        state
            .measures_of(0)
            .is_some_and(|measures| measures.ef.is_some())
    });
    let state = harness.state().state();
    assert_eq!(state.document.study().subjects.len(), 1);
    let ef = state.measures_of(0).unwrap().ef.unwrap();
    let truth = measure_subject(&heart()).ef.unwrap();
    assert!((ef - truth).abs() <= 0.04, "EF {ef:.3}, truth {truth:.3}");
    assert_eq!(state.errors, []);
}
