//! What lies around a heart: errors, stated frames, views, panes, sheets, tables.

use super::*;
use cardiomorph::panes::{
    EditCommand, FileCommand, Phase, PhaseFrame, ViewCommand, Whose, WindowCommand,
};

#[test]
fn a_broken_file_let_go_over_the_window_gives_its_error_and_leaves_the_study_open() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("broken.obj");
    std::fs::write(&path, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n").unwrap();
    let mut harness = cohort_window();
    harness
        .input_mut()
        .dropped_files
        .push(Arc::new(Dropped(path)));
    wait(&mut harness, "the error card", |app| {
        !app.state().errors.is_empty()
    });
    harness.run();
    let card = harness.state().state().errors[0].clone();
    assert!(card.title.contains("broken.obj"), "{card:?}");
    assert!(card.message.contains("line 4"), "{card:?}");
    assert_eq!(harness.state().state().document.study().subjects.len(), 23);
    harness.get_by_label_contains("broken.obj");
    harness.get_by_label("Dismiss").click();
    harness.run();
    assert!(harness.state().state().errors.is_empty());
}

#[test]
fn a_frame_stated_as_end_systole_is_measured_again_and_taken_back() {
    let mut harness = mapped_window();
    let before = harness.state().state().measures_of(0).unwrap().clone();
    let stated = (before.end_systole.unwrap() + 2) % 8;
    give(
        &mut harness,
        Command::Edit(EditCommand::SetPhase(
            Whose::Selected,
            Phase::EndSystole,
            PhaseFrame::Frame(stated),
        )),
    );
    wait(&mut harness, "new measures", |app| {
        app.state().measures_of(0).unwrap().end_systole == Some(stated)
    });
    assert!(harness.state().state().measures_of(0).unwrap().ef < before.ef);
    give(&mut harness, Command::Edit(EditCommand::Undo));
    wait(&mut harness, "the old measures", |app| {
        app.state().measures_of(0) == Some(&before)
    });
}

#[test]
fn the_views_show_one_two_and_all_hearts() {
    let mut harness = cohort_window();
    for (mode, count) in [
        (ViewMode::SideBySide, 2),
        (ViewMode::AllFrames, 8),
        (ViewMode::Single, 1),
    ] {
        give(&mut harness, Command::View(ViewCommand::SetViewMode(mode)));
        wait(&mut harness, "the hearts", |app| {
            app.hearts_on_screen().len() == count
        });
    }
}

#[test]
fn panes_close_and_come_back() {
    let mut harness = cohort_window();
    harness.run();
    assert!(harness.query_by_label("Pose map").is_some() || harness.state().busy());
    give(
        &mut harness,
        Command::Window(WindowCommand::TogglePane(Pane::MEASURES)),
    );
    harness.run_steps(2);
    assert!(
        harness
            .query_by_label_contains("Ejection fraction")
            .is_none()
    );
    give(&mut harness, Command::Window(WindowCommand::ResetLayout));
    harness.run_steps(2);
    assert!(
        harness
            .query_by_label_contains("Ejection fraction")
            .is_some()
    );
}

#[test]
fn the_palette_and_the_sheets_open_by_key_and_close_by_escape() {
    let mut harness = cohort_window();
    harness.key_press_modifiers(egui::Modifiers::COMMAND, egui::Key::K);
    harness.run_steps(4);
    assert!(harness.state().state().sheets.palette);
    harness.key_press(egui::Key::Escape);
    harness.run_steps(4);
    assert!(!harness.state().state().sheets.palette);
    harness.key_press_modifiers(egui::Modifiers::SHIFT, egui::Key::Questionmark);
    harness.run_steps(4);
    assert!(harness.state().state().sheets.shortcuts);
    harness.key_press(egui::Key::Escape);
    harness.run_steps(4);
    assert!(!harness.state().state().sheets.shortcuts);
}

#[test]
fn with_nothing_to_open_the_window_says_how_to_begin() {
    let mut harness = window(AppOptions::empty());
    harness.run();
    harness.get_by_label("Open a study");
    assert!(harness.state().hearts_on_screen().is_empty());
}

#[test]
fn tables_are_written_by_a_job() {
    let folder = tempfile::tempdir().unwrap();
    let mut harness = mapped_window();
    let path: PathBuf = folder.path().join("report");
    give(
        &mut harness,
        Command::File(FileCommand::ExportTables(Some(path.clone()))),
    );
    wait(&mut harness, "the tables", |app| {
        app.state().message.starts_with("Wrote")
    });
    let table = std::fs::read_to_string(path.join("measures.csv")).unwrap();
    assert_eq!(table.lines().count(), 24);
    assert!(path.join("poses_mds.csv").exists());
}

#[test]
fn a_pane_whose_tab_has_no_room_is_opened_from_the_menu_of_its_strip() {
    use egui::accesskit::Role;
    let mut harness = window(AppOptions::built_in(small()));
    harness.set_size(egui::vec2(1024.0, 640.0));
    wait_for_heart(&mut harness);
    let tab = |harness: &Harness<'_, App>, name: &str| {
        let mut tabs = harness.query_all_by_role_and_label(Role::Tab, name);
        tabs.next().is_some()
    };
    assert!(tab(&harness, "Measures") && !tab(&harness, "Verdict"));
    for tab in harness.query_all_by_role(Role::Tab) {
        assert!(tab.rect().width() > 20.0, "{:?}", tab.rect());
    }
    let strip = harness.get_by_role_and_label(Role::Tab, "Measures").rect();
    {
        let menus = harness.get_all_by_label_contains("More panes: ");
        let mut menus = menus.filter(|menu| menu.rect().y_range().contains(strip.center().y));
        menus.next().unwrap().click();
    }
    harness.run_steps(3);
    harness
        .get_by_role_and_label(Role::RadioButton, "Verdict")
        .click();
    harness.run_steps(3);
    assert!(tab(&harness, "Verdict") && !tab(&harness, "Measures"));
}

#[test]
fn a_folder_of_masks_let_go_over_the_window_becomes_beating_walls() {
    let folder = tempfile::tempdir().unwrap();
    crate::cli::mesh::cohort(folder.path());
    let mut harness = cohort_window();
    harness
        .input_mut()
        .dropped_files
        .push(Arc::new(Dropped(folder.path().to_owned())));
    wait(&mut harness, "the walls", |app| {
        app.state().document.study().subjects.len() == 2 && !app.hearts_on_screen().is_empty()
    });
    assert!(harness.state().state().errors.is_empty());
    let study = harness.state().state().document.study();
    assert_eq!(study.subjects[0].id, "a1");
    assert_eq!(study.subjects[0].sequence.frame_count(), 2);
    let notices = &study.subjects[0].notices;
    let made = |text: &str| {
        text.starts_with("walls made from masks (label 3 cavity, 2 wall, 1 right ventricle)")
    };
    assert!(
        notices.iter().any(|notice| made(&notice.text)),
        "{notices:?}"
    );
}
