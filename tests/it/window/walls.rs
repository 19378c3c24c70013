//! The middle of the wall in the window: atoms, patches, thresholds, the bull's-eye.

use super::*;
use cardiomorph::panes::{EditCommand, SelectCommand, WallCommand, WindowCommand};

use cardiomorph::analysis::segments::Segment;
use cardiomorph::document::FoundWall;
use cardiomorph::picture::BullsEyeQuantity;
use cardiomorph::picture::{Quantity, WallPart};
use egui::Key;

/// P05 has a large patch.
const PATCHED: usize = 13;

fn wall(app: &App) -> Option<(&FoundWall, bool)> {
    let state = app.state();
    state.wall_of(state.document.subject)
}

/// A window with the wall of a heart that has a patch.
fn patched_window() -> Harness<'static, App> {
    let mut harness = cohort_window();
    give(
        &mut harness,
        Command::Select(SelectCommand::SelectPose {
            subject: PATCHED,
            frame: 3,
            play: false,
        }),
    );
    wait(&mut harness, "the wall", |app| {
        matches!(wall(app), Some((Ok(_), true))) && app.hearts_on_screen()[0].0 == PATCHED
    });
    harness
}

fn patches(app: &App) -> usize {
    match wall(app) {
        Some((Ok(found), _)) => found.thickening.patches.len(),
        _ => 0,
    }
}

#[test]
fn keys_show_and_hide_atoms_and_patches_and_step_the_quantities() {
    let mut harness = patched_window();
    let visible = |harness: &Harness<'_, App>| harness.state().state().document.visibility;
    assert!(!visible(&harness).atoms && visible(&harness).patches);
    harness.get_by_label_contains("of the LV. ");
    for key in [Key::M, Key::P] {
        harness.key_press(key);
        harness.run_steps(2);
    }
    assert!(visible(&harness).atoms && !visible(&harness).patches);
    assert!(harness.query_by_label_contains("of the LV. ").is_none());
    harness.key_press(Key::B);
    harness.run_steps(2);
    let document = &harness.state().state().document;
    assert_eq!(document.bulls_eye, BullsEyeQuantity::ThicknessRatio);
    for _ in 0..3 {
        harness.key_press(Key::C);
        harness.run_steps(2);
    }
    let document = &harness.state().state().document;
    assert_eq!(document.quantity, Quantity::ThicknessRatio);
    for _ in 0..6 {
        give(&mut harness, Command::Edit(EditCommand::Undo));
    }
    assert!(!visible(&harness).atoms && visible(&harness).patches);
}

#[test]
fn a_row_of_the_table_selects_its_patch_and_turns_the_heart_to_it() {
    let mut harness = patched_window();
    assert!(patches(harness.state()) > 0, "the heart has a patch");
    give(
        &mut harness,
        Command::Window(WindowCommand::ShowPane(Pane::PATCH)),
    );
    harness.run_steps(2);
    let look = harness.state().state().document.viewpoint;
    harness.get_by_label_contains("Patch 1: ").click();
    harness.run_steps(2);
    let document = &harness.state().state().document;
    assert_eq!(document.part, Some(WallPart::Patch(0)));
    assert_ne!(document.viewpoint, look);
    give(&mut harness, Command::Edit(EditCommand::Undo));
    let document = &harness.state().state().document;
    assert_eq!((document.part, document.viewpoint), (None, look));
}

#[test]
fn a_threshold_finds_other_patches_while_the_ones_before_stay_on_screen() {
    let mut harness = patched_window();
    let share = |app: &App| match wall(app) {
        Some((Ok(found), _)) => (found.thickening.patches.iter())
            .map(|patch| patch.share)
            .sum::<f64>(),
        _ => f64::NAN,
    };
    let before = share(harness.state());
    let mut settings = harness.state().state().document.thickening;
    settings.patches.extent_threshold = 0.8;
    settings.patches.core_threshold = 0.5;
    harness
        .state_mut()
        .push(Command::Wall(WallCommand::SetThickening(settings)));
    while !matches!(wall(harness.state()), Some((_, false))) {
        harness.step();
    }
    assert_eq!(share(harness.state()), before, "what was there stays");
    wait(&mut harness, "the new patches", |app| {
        matches!(wall(app), Some((Ok(_), true)))
    });
    assert!(share(harness.state()) > before);
    give(&mut harness, Command::Edit(EditCommand::Undo));
    harness.run_steps(2);
    assert_eq!(share(harness.state()), before);
}

#[test]
fn a_segment_of_the_bulls_eye_is_selected_everywhere() {
    let mut harness = patched_window();
    give(
        &mut harness,
        Command::Window(WindowCommand::ShowPane(Pane::BULLS_EYE)),
    );
    harness.run_steps(2);
    // The apex is in the middle, above the colour bar.
    let area = harness.get_by_label("Bull's-eye map").rect();
    let middle = area.center() - egui::vec2(0.0, 20.0);
    click_at(&mut harness, middle);
    harness.run_steps(2);
    let apex = WallPart::Segment(Segment::new(17).unwrap());
    assert_eq!(harness.state().state().document.part, Some(apex));
    give(
        &mut harness,
        Command::Select(SelectCommand::SelectSubject(2)),
    );
    let document = &harness.state().state().document;
    assert_eq!(document.part, Some(apex), "every heart has that segment");
}

#[test]
fn a_blood_pool_alone_is_not_assessed_and_says_why() {
    let folder = tempfile::tempdir().unwrap();
    for frame in 0..3 {
        let size = 30.0 - 2.0 * f64::from(frame);
        let corners = [[1, 1, 1], [-1, -1, 1], [-1, 1, -1], [1, -1, -1]];
        let mut text = String::new();
        for [x, y, z] in corners.map(|corner| corner.map(|part| f64::from(part) * size)) {
            text += &format!("v {x} {y} {z}\n");
        }
        text += "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
        std::fs::write(folder.path().join(format!("pool_{frame}.obj")), text).unwrap();
    }
    let mut harness = window(AppOptions::opening(vec![folder.path().to_owned()]));
    wait(&mut harness, "the answer", |app| {
        matches!(wall(app), Some((Err(_), true)))
    });
    assert!(
        harness.state().state().errors.is_empty(),
        "that is no error"
    );
    give(
        &mut harness,
        Command::Window(WindowCommand::ShowPane(Pane::PATCH)),
    );
    harness.run_steps(2);
    assert!(harness.get_all_by_label("Not assessed").count() >= 1);
}
