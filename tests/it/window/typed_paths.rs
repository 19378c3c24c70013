//! Paths typed into the window where the system shows no file dialog.

use super::*;
use cardiomorph::panes::FileCommand;
use egui::Key;

/// A window on the built-in cohort whose system has no file dialog: the answer comes at once, and is none.
fn window_without_dialogs() -> Harness<'static, App> {
    let mut options = AppOptions::built_in(small());
    options.ask_paths = Arc::new(|_| None);
    let mut harness = window(options);
    wait_for_heart(&mut harness);
    harness
}

fn wait_for_sheet(harness: &mut Harness<'_, App>) {
    wait(harness, "the sheet", |app| app.state().path_entry.is_some());
}

/// Puts a text into the field in place of the proposal.
fn type_path(harness: &mut Harness<'_, App>, text: &str) {
    harness.key_press_modifiers(egui::Modifiers::COMMAND, Key::A);
    harness.step();
    harness.event(egui::Event::Text(text.to_owned()));
    harness.step();
    harness.step();
}

fn shows(harness: &Harness<'_, App>, text: &str) -> bool {
    harness.query_all_by_label_contains(text).next().is_some()
}

/// What stands in the field.
fn typed(harness: &Harness<'_, App>) -> String {
    let field = harness.get_by_label("Path");
    field.accesskit_node().value().unwrap_or_default()
}

#[test]
fn without_a_file_dialog_a_figure_goes_where_is_typed_and_replaces_only_what_was_agreed_to() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir_all(folder.path().join("figures/ward")).unwrap();
    let path = folder.path().join("figures/ward/heart.png");
    let mut harness = window_without_dialogs();
    give(&mut harness, FileCommand::ExportFigure(None).into());
    wait_for_sheet(&mut harness);
    assert!(typed(&harness).ends_with("N01_frame_0.png"), "the proposal");
    // Tab completes one folder after the other.
    type_path(&mut harness, &format!("{}/fi", folder.path().display()));
    for end in ["/figures/", "/figures/ward/"] {
        harness.key_press(Key::Tab);
        wait(&mut harness, "the completed name", |app| {
            let entry = app.state().path_entry.as_ref();
            entry.is_some_and(|entry| entry.text.ends_with(end))
        });
        assert!(typed(&harness).ends_with(end), "{}", typed(&harness));
    }
    // The cursor is behind it: what is typed goes on.
    harness.event(egui::Event::Text("heart".to_owned()));
    harness.step();
    harness.key_press(Key::Enter);
    wait(&mut harness, "the figure", |app| {
        path.exists() && !app.busy()
    });
    assert!(harness.state().state().path_entry.is_none());

    std::fs::write(&path, "mine").unwrap();
    give(&mut harness, FileCommand::ExportFigure(None).into());
    wait_for_sheet(&mut harness);
    let proposed = typed(&harness);
    assert!(
        proposed.starts_with(path.parent().unwrap().to_str().unwrap()),
        "{proposed}"
    );
    type_path(&mut harness, path.to_str().unwrap());
    harness.key_press(Key::Enter);
    wait(&mut harness, "the question", |app| {
        let entry = app.state().path_entry.as_ref();
        entry.is_some_and(|entry| entry.replaces.is_some())
    });
    assert!(shows(&harness, "lies there already"));
    // Enter, pressed once too often, replaces nothing.
    harness.key_press(Key::Enter);
    harness.run_steps(5);
    assert_eq!(std::fs::read(&path).unwrap(), b"mine");
    harness.get_by_label("Replace").click();
    wait(&mut harness, "the figure", |app| {
        std::fs::read(&path).is_ok_and(|bytes| bytes.starts_with(b"\x89PNG")) && !app.busy()
    });
    assert!(harness.state().state().errors.is_empty());
}

#[test]
fn without_a_file_dialog_a_typed_path_is_opened_or_refused_in_words() {
    let (_folder, manifest) = cohort_on_disk();
    let mut options = AppOptions::empty();
    options.ask_paths = Arc::new(|_| None);
    let mut harness = window(options);
    harness.run();
    give(&mut harness, FileCommand::ChooseFiles.into());
    wait_for_sheet(&mut harness);
    type_path(&mut harness, "/no such place/study.toml");
    harness.key_press(Key::Enter);
    wait(&mut harness, "the reason", |app| {
        let entry = app.state().path_entry.as_ref();
        entry.is_some_and(|entry| entry.refused.is_some())
    });
    assert!(shows(&harness, "no such file or folder"));
    type_path(&mut harness, manifest.to_str().unwrap());
    harness.get_by_label("Open").click();
    wait(&mut harness, "the study", |app| {
        app.state().document.selected().is_some()
    });
    assert!(harness.state().state().path_entry.is_none());
    assert!(harness.state().state().errors.is_empty());
}

#[test]
fn escape_gives_up_and_a_second_question_waits_for_the_first() {
    let mut harness = window_without_dialogs();
    give(&mut harness, FileCommand::ExportTables(None).into());
    wait_for_sheet(&mut harness);
    give(&mut harness, FileCommand::ExportFigure(None).into());
    harness.run_steps(3);
    let state = harness.state().state();
    assert!(
        state.message.contains("answer it first"),
        "{}",
        state.message
    );
    let entry = state.path_entry.clone().unwrap();
    assert_eq!(entry.title, "Save all tables into a folder");
    harness.key_press(Key::Escape);
    harness.run_steps(3);
    assert!(harness.state().state().path_entry.is_none());
    assert!(!harness.state().busy() || harness.state().state().errors.is_empty());
    // The next question is asked again.
    give(&mut harness, FileCommand::ExportFigure(None).into());
    wait_for_sheet(&mut harness);
}
