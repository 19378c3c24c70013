//! Images in the window: slices that cross, the steps of an import, edits that undo takes back, walls in the cohort.

use super::*;
use cardiomorph::analysis::preparation::Road;
use cardiomorph::document::{ImageTool, ImportStep};
use cardiomorph::engine::ImageWallsQuery;
use cardiomorph::panes::{EditCommand, ImagesCommand, ImportCommand, WindowCommand};

/// Half-axes across and along of endocardium and epicardium at each instant, in millimetres.
const AXES: [[[f64; 2]; 2]; 3] = [
    [[24.0, 70.0], [36.0, 82.0]],
    [[18.0, 62.0], [33.0, 77.0]],
    [[22.0, 67.0], [35.0, 80.0]],
];

/// The ejection fraction of half ellipsoids: volumes are as a² c.
fn true_ef() -> f64 {
    let volumes = AXES.map(|[[a, c], _]| a * a * c);
    1.0 - volumes[1] / volumes[0]
}

/// A gated SPECT study as a NIfTI-1 file: a bright wall of soft edges in voxels of 4 mm, and a liver beside it.
fn spect(liver: bool) -> Vec<u8> {
    let size = [32_u16, 32, 30];
    let mut bytes = vec![0_u8; 352];
    bytes[0..4].copy_from_slice(&348_i32.to_le_bytes());
    let sizes = [4, size[0], size[1], size[2], AXES.len() as u16];
    for (place, size) in sizes.into_iter().enumerate() {
        bytes[40 + 2 * place..42 + 2 * place].copy_from_slice(&size.to_le_bytes());
    }
    bytes[70..72].copy_from_slice(&16_i16.to_le_bytes());
    bytes[72..74].copy_from_slice(&32_i16.to_le_bytes());
    for (place, step) in [1.0_f32, 4.0, 4.0, 4.0, 300.0].into_iter().enumerate() {
        bytes[76 + 4 * place..80 + 4 * place].copy_from_slice(&step.to_le_bytes());
    }
    bytes[108..112].copy_from_slice(&352.0_f32.to_le_bytes());
    // Millimetres and milliseconds.
    bytes[123] = 2 | 16;
    // Positions are known: RAS of the file, so that LPS is 4 mm times the voxel, and 8 mm higher.
    bytes[254..256].copy_from_slice(&1_i16.to_le_bytes());
    for (place, step) in [(280, -4.0_f32), (300, -4.0), (320, 4.0), (324, 8.0)] {
        bytes[place..place + 4].copy_from_slice(&step.to_le_bytes());
    }
    bytes[344..348].copy_from_slice(b"n+1\0");
    for [endo, epi] in AXES {
        let [a, c] = [0, 1].map(|n| 0.5 * (endo[n] + epi[n]));
        let half = 0.5 * (epi[0] - endo[0]) / a;
        for k in 0..size[2] {
            for j in 0..size[1] {
                for i in 0..size[0] {
                    let [x, y] = [i, j].map(|n| 4.0 * (f64::from(n) - 15.5));
                    let z = 4.0 * (f64::from(k) - 4.0);
                    let out = ((x * x + y * y) / (a * a) + z * z / (c * c)).sqrt();
                    let wall = (-((out - 1.0) / half).powi(2)).exp();
                    let wall = if z >= 0.0 { 100.5 * wall } else { 0.0 };
                    let beside = [(x - 50.0) / 12.0, (y - 46.0) / 12.0, (z - 40.0) / 16.0];
                    let far: f64 = beside.iter().map(|part| part * part).sum();
                    let liver = if liver { 110.0 * (-far).exp() } else { 0.0 };
                    bytes.extend(((10.25 + wall + liver) as f32).to_le_bytes());
                }
            }
        }
    }
    bytes
}

/// A window with the study of a file, once its images are there.
fn image_window(liver: bool) -> (tempfile::TempDir, Harness<'static, App>) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("p7.nii");
    std::fs::write(&path, spect(liver)).unwrap();
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
    for step in ImportStep::ALL {
        give(&mut harness, ImportCommand::GoTo(step).into());
        harness.run_steps(3);
        if step == ImportStep::Tissue {
            // The liver: 50 mm to the left of the axis, 46 mm behind it.
            let at = nalgebra::Point3::new(112.0, 108.0, 64.0);
            let moved = ImagesCommand::MoveTo(at);
            give(&mut harness, moved.into());
            let radius = ImportCommand::SetEraser(24.0);
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
    assert!(
        (ef - true_ef()).abs() <= 0.04,
        "EF {ef:.3}, truth {:.3}",
        true_ef()
    );
    assert_eq!(state.errors, []);
}
