//! Edited studies: what analyses count, what is exported and read again, what is added.

use super::editing::{card, choose, ids, key, redo, row, study, undo};
use super::*;
use cardiomorph::app::PathQuestion;
use cardiomorph::panes::{EditCommand, FileCommand, Phase, PhaseFrame, Whose};
use cardiomorph::study::{CoordinateUnit, LabelClass};
use egui::Key;

/// The tables of a study as they are exported.
fn tables(harness: &mut Harness<'_, App>) -> Vec<(String, String)> {
    let folder = tempfile::tempdir().unwrap();
    let export = FileCommand::ExportTables(Some(folder.path().to_owned()));
    give(harness, export.into());
    wait(harness, "the tables", |app| !app.busy());
    let mut tables: Vec<(String, String)> = std::fs::read_dir(folder.path())
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.extension().is_some_and(|ending| ending == "csv"))
        .map(|path| {
            let name = path.file_name().unwrap().to_string_lossy().into_owned();
            (name, std::fs::read_to_string(path).unwrap())
        })
        .collect();
    tables.sort();
    tables
}

#[test]
fn no_table_counts_an_excluded_subject_and_all_are_those_of_a_study_without_it() {
    let mut harness = mapped_window();
    choose(&mut harness, "N03", &["Exclude from the cohort"]);
    wait(&mut harness, "the rest of the cohort", |app| {
        app.state()
            .map()
            .is_some_and(|map| map.embedding.len() == 176)
            && !app.busy()
    });
    assert_eq!(study(&harness).subjects.len(), 22);
    let excluded = row(&harness, "N03");
    assert_eq!(
        excluded.accesskit_node().value().as_deref(),
        Some("excluded")
    );
    harness.get_by_label_contains("22 subjects · 1 excluded");
    let excluded = tables(&mut harness);
    assert!(excluded.len() > 8, "{:?}", excluded.len());
    // Its own wall can be looked at.
    row(&harness, "N03").click();
    harness.run_steps(2);
    assert_eq!(harness.state().state().document.subject, 22);
    wait(&mut harness, "its wall", |app| {
        app.hearts_on_screen().first().map(|heart| heart.0) == Some(22)
            && matches!(app.state().wall_of(22), Some((Ok(_), true)))
    });
    assert!(
        harness
            .state()
            .state()
            .measures_of(22)
            .unwrap()
            .ef
            .is_some()
    );
    assert!(harness.state().state().verdict_of(22).is_none());
    choose(&mut harness, "N03", &["Delete from the study"]);
    let deleted = tables(&mut harness);
    for (left, right) in excluded.iter().zip(&deleted) {
        assert_eq!(left.0, right.0);
        assert!(left.1 == right.1, "{} differs", left.0);
        assert!(
            !left.1.contains("N03"),
            "{} has the excluded subject",
            left.0
        );
    }
    assert_eq!(excluded.len(), deleted.len());
    undo(&mut harness);
    choose(&mut harness, "N03", &["Include in the cohort"]);
    assert_eq!(study(&harness).subjects.len(), 23);
    let whole: Vec<String> = ids(&harness);
    assert!(
        whole.is_sorted_by_key(|id| id.clone()),
        "in the order of the input: {whole:?}"
    );
}

/// A window whose dialogs answer with this folder.
fn window_saving_into(folder: &Path) -> Harness<'static, App> {
    let folder = folder.to_owned();
    let mut harness = window(AppOptions {
        ask_paths: Arc::new(move |question| {
            assert_eq!(*question, PathQuestion::SaveStudy);
            Some(vec![folder.clone()])
        }),
        ..AppOptions::built_in(small())
    });
    wait_for_heart(&mut harness);
    harness
}

#[test]
fn an_edited_study_is_written_and_read_back_as_it_was_edited() {
    let folder = tempfile::tempdir().unwrap();
    let mut harness = window_saving_into(folder.path());
    let unknown = CoordinateUnit::Unknown;
    let centimetres = CoordinateUnit::Centimetre;
    for command in [
        EditCommand::SetLabel {
            subjects: vec![0, 1],
            label: "Müller's \"A\"".to_owned(),
        },
        EditCommand::SetClass(Whose::Subject(0), LabelClass::Abnormal),
        EditCommand::Rename {
            subject: 2,
            id: "Zoë 3".to_owned(),
        },
        EditCommand::SetUnit(Whose::Subject(3), unknown),
        EditCommand::SetUnit(Whose::Subject(4), centimetres),
        EditCommand::ClearLandmarks(Whose::Subject(5)),
        EditCommand::SetPhase(Whose::Subject(6), Phase::EndSystole, PhaseFrame::Frame(5)),
        EditCommand::Exclude(Whose::Subject(7)),
        EditCommand::Delete(Whose::Subject(8)),
    ] {
        give(&mut harness, command.into());
        assert!(harness.state().state().errors.is_empty());
    }
    harness.get_by_label_contains(" · edited");
    let written = study(&harness).clone();
    give(&mut harness, FileCommand::ExportStudy(None).into());
    wait(&mut harness, "the study", |app| !app.state().is_edited());
    harness.run_steps(2);
    assert!(harness.query_by_label_contains(" · edited").is_none());
    give(
        &mut harness,
        FileCommand::Open(vec![folder.path().to_owned()]).into(),
    );
    wait(&mut harness, "the study again", |app| {
        app.state().document.study().name == written.name && app.state().document.study.opening == 2
    });
    let read = study(&harness);
    assert_eq!(read.label_classes, written.label_classes);
    assert_eq!(read.in_order(), written.in_order());
    assert_eq!(read.count(), written.count());
    for (read, written) in read.all().zip(written.all()) {
        assert_eq!((&read.id, &read.label), (&written.id, &written.label));
        assert_eq!(read.unit, written.unit);
        assert_eq!(read.end_diastole, written.end_diastole);
        assert_eq!(read.end_systole, written.end_systole);
        assert_eq!(
            read.anatomy.map(|a| a.apex),
            written.anatomy.map(|a| a.apex)
        );
        assert!(read.sequence == written.sequence, "{}", read.id);
    }
    // A study is never written over another one.
    give(&mut harness, EditCommand::Delete(Whose::Subject(0)).into());
    give(&mut harness, FileCommand::ExportStudy(None).into());
    wait(&mut harness, "the refusal", |app| {
        !app.state().errors.is_empty()
    });
    let refused = &harness.state().state().errors[0];
    assert!(
        refused
            .message
            .contains("a study is in this folder already"),
        "{refused:?}"
    );
    assert!(harness.state().state().is_edited());
}

#[test]
fn edits_that_are_not_exported_are_asked_about_once_and_keys_answer() {
    let folder = tempfile::tempdir().unwrap();
    let mut harness = window_saving_into(folder.path());
    give(&mut harness, EditCommand::Exclude(Whose::Subject(1)).into());
    give(&mut harness, FileCommand::OpenBuiltIn.into());
    harness.run_steps(2);
    let asked = "Open another study without exporting the edits?";
    assert!(harness.query_all_by_label(asked).next().is_some());
    key(&mut harness, Key::Escape);
    assert!(harness.state().state().leaving.is_none());
    assert_eq!(study(&harness).subjects.len(), 22);
    give(&mut harness, FileCommand::OpenBuiltIn.into());
    harness.run_steps(2);
    key(&mut harness, Key::Enter);
    wait(&mut harness, "the export", |app| !app.state().is_edited());
    assert!(folder.path().join("study.toml").exists());
    give(&mut harness, EditCommand::Exclude(Whose::Subject(1)).into());
    give(&mut harness, FileCommand::OpenBuiltIn.into());
    harness.run_steps(2);
    harness.get_by_label("Open without exporting").click();
    wait(&mut harness, "the other study", |app| {
        app.state().document.study().subjects.len() == 23
    });
    assert!(!harness.state().state().is_edited());
    undo(&mut harness);
    assert!(
        harness.state().state().is_edited(),
        "the edited study can be had back"
    );
}

#[test]
fn subjects_of_another_folder_are_added_in_one_step_and_the_report_tells_of_both() {
    let (folder, _) = cohort_on_disk();
    let mut harness = cohort_window();
    let before = harness.state().state().document.clone();
    let one = folder.path().join("N01");
    assert!(one.is_dir());
    give(&mut harness, FileCommand::Add(vec![one]).into());
    wait(&mut harness, "the subject", |app| {
        app.state().document.study().subjects.len() == 24
    });
    let added = study(&harness).subjects[23].clone();
    assert_ne!(added.id, "N01", "no two subjects have one id");
    assert!(added.id.starts_with("N01"), "{}", added.id);
    assert_eq!(harness.state().state().document.subject, before.subject);
    assert!(
        added
            .notices
            .iter()
            .any(|notice| notice.text.contains("already"))
    );
    let report = harness.state().state().document.study.report.clone();
    let says = |words: &str| {
        report
            .notices
            .iter()
            .any(|notice| notice.text.contains(words))
    };
    assert!(!says("all 23 subjects have the same faces"), "{report:?}");
    undo(&mut harness);
    assert_eq!(harness.state().state().document, before);
    redo(&mut harness);
    assert_eq!(study(&harness).subjects.len(), 24);
    let broken = folder.path().join("broken.obj");
    std::fs::write(&broken, "v 0 0 0\nf 1 2 9\n").unwrap();
    give(&mut harness, FileCommand::Add(vec![broken]).into());
    wait(&mut harness, "the refusal", |app| {
        app.state().errors.len() == 2
    });
    assert_eq!(card(&harness), "Nothing was added");
    assert_eq!(study(&harness).subjects.len(), 24);
}

#[test]
fn a_figure_of_an_excluded_subject_is_written_and_its_view_comes_back() {
    let mut harness = cohort_window();
    choose(&mut harness, "N03", &["Exclude from the cohort"]);
    row(&harness, "N03").click();
    wait(&mut harness, "its heart", |app| {
        app.hearts_on_screen().first().map(|heart| heart.0) == Some(22)
    });
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("N03.png");
    give(
        &mut harness,
        FileCommand::ExportFigure(Some(path.clone())).into(),
    );
    wait(&mut harness, "the figure", |_| path.exists());
    row(&harness, "P01").click();
    harness.run_steps(3);
    give(&mut harness, FileCommand::Open(vec![path]).into());
    wait(&mut harness, "its view", |app| {
        app.state().document.subject == 22
    });
    assert!(harness.state().state().errors.is_empty());
}

#[test]
fn a_study_that_is_exported_before_another_is_opened_makes_room_for_it_once_it_is_written() {
    let folder = tempfile::tempdir().unwrap();
    let mut harness = window_saving_into(folder.path());
    let opening = harness.state().state().document.study.opening;
    give(&mut harness, EditCommand::Exclude(Whose::Subject(0)).into());
    give(&mut harness, FileCommand::OpenBuiltIn.into());
    harness.get_by_label("Export study and open…").click();
    wait(&mut harness, "the other study", |app| {
        app.state().document.study.opening != opening && !app.busy()
    });
    assert!(study(&harness).excluded.is_empty(), "made anew");
    assert!(harness.state().state().leaving.is_none());
    let written = std::fs::read_to_string(folder.path().join("study.toml")).unwrap();
    assert!(written.contains("exclude"), "{written}");
}

#[test]
fn an_export_that_fails_leaves_the_edited_study_on_screen() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("study.toml"), "name = \"another\"\n").unwrap();
    let mut harness = window_saving_into(folder.path());
    let opening = harness.state().state().document.study.opening;
    give(&mut harness, EditCommand::Exclude(Whose::Subject(0)).into());
    give(&mut harness, FileCommand::OpenBuiltIn.into());
    harness.get_by_label("Export study and open…").click();
    wait(&mut harness, "the refusal", |app| {
        !app.state().errors.is_empty()
    });
    harness.run_steps(5);
    assert_eq!(harness.state().state().document.study.opening, opening);
    assert!(harness.state().state().is_edited());
    // An export that succeeds later is no reason to leave.
    assert!(harness.state().state().leaving.is_none());
}
