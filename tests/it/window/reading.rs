//! A large study is shown while it is read: its first subject, the one that is clicked, what waits for all, Cancel.

use super::*;
use cardiomorph::io::{Limits, open_paths};
use cardiomorph::panes::{EditCommand, FileCommand, Whose};
use cardiomorph::progress::Progress;
use cardiomorph::study::CoordinateUnit;

/// A large cohort, and a window that reads it: the first subject is there, others are not.
fn reading_window() -> (tempfile::TempDir, Harness<'static, App>) {
    let folder = large_cohort_on_disk();
    let mut harness = window(AppOptions::opening(vec![folder.path().to_owned()]));
    let begin = Instant::now();
    while harness.state().state().document.selected().is_none() {
        assert!(begin.elapsed() < Duration::from_secs(60));
        harness.step();
    }
    let study = harness.state().state().document.study();
    assert!(!study.unread.is_empty(), "it is shown while it is read");
    (folder, harness)
}

fn ids(app: &App) -> Vec<String> {
    let subjects = app.state().document.study().subjects.iter();
    subjects.map(|subject| subject.id.clone()).collect()
}

fn selected(app: &App) -> String {
    app.state().document.selected().unwrap().id.clone()
}

#[test]
fn the_row_that_is_clicked_is_read_before_the_others_and_selected_and_nothing_of_the_cohort_is_told_before_all_are_read()
 {
    let (folder, mut harness) = reading_window();
    assert_eq!(selected(harness.state()), "N01");
    harness.get_by_label("P03").click();
    wait(&mut harness, "the subject that was clicked", |app| {
        let (state, study) = (app.state(), app.state().document.study());
        if !study.unread.is_empty() {
            let told = state.measures().is_some() || state.map().is_some();
            assert!(!told, "an answer about a part of the cohort");
        }
        selected(app) == "P03"
    });
    let unread = harness.state().state().document.study().unread.clone();
    assert!(
        unread.iter().any(|unread| unread.id == "P02"),
        "it came before those above it: {unread:?}"
    );
    wait(&mut harness, "its heart", |app| {
        let study = app.state().document.study();
        let shown = app.hearts_on_screen();
        shown
            .first()
            .map(|heart| study.subjects[heart.0].id.as_str())
            == Some("P03")
    });
    wait(&mut harness, "all subjects and the map", |app| {
        app.state().map().is_some() && app.state().measures().is_some()
    });
    let by_command = open_paths(
        &[folder.path().to_owned()],
        &Limits::default(),
        &Progress::default(),
    )
    .unwrap();
    let expected = by_command.study.subjects.iter();
    let expected: Vec<String> = expected.map(|subject| subject.id.clone()).collect();
    assert_eq!(ids(harness.state()), expected);
    let state = harness.state().state();
    assert_eq!(state.document.study.report.notices, by_command.notices);
    assert_eq!(state.measures().unwrap().len(), 23);
    assert_eq!(selected(harness.state()), "P03");
    give(&mut harness, Command::Edit(EditCommand::Undo));
    assert_eq!(selected(harness.state()), "N01");
    assert_eq!(ids(harness.state()), expected, "undo forgets no subject");
}

#[test]
fn cancel_leaves_what_was_read_and_says_how_many_were_not() {
    let (_folder, mut harness) = reading_window();
    give(
        &mut harness,
        Command::Work(WorkCommand::Cancel(Topic::OPENING)),
    );
    wait(&mut harness, "what was read", |app| {
        app.state().document.study().unread.is_empty() && app.state().measures().is_some()
    });
    let state = harness.state().state();
    let read = state.document.study().subjects.len();
    assert!((1..23).contains(&read), "{read}");
    assert_eq!(state.measures().unwrap().len(), read);
    let told = format!(
        "reading was stopped: {} of 23 subjects were not read",
        23 - read
    );
    let notices = &state.document.study.report.notices;
    assert!(
        notices.iter().any(|notice| notice.text == told),
        "{notices:?}"
    );
    assert!(state.errors.is_empty(), "{:?}", state.errors);
}

#[test]
fn a_study_that_is_still_read_is_not_exported_in_part_nor_given_another_unit() {
    let (_folder, mut harness) = reading_window();
    let out = tempfile::tempdir().unwrap();
    let export = FileCommand::ExportStudy(Some(out.path().to_owned()));
    give(&mut harness, export.into());
    let unit = EditCommand::SetUnit(Whose::All, CoordinateUnit::Centimetre);
    give(&mut harness, unit.into());
    let titles = harness
        .state()
        .state()
        .errors
        .iter()
        .map(|card| &card.title);
    let titles: Vec<&String> = titles.collect();
    assert_eq!(titles, ["Nothing was exported", "The unit was not changed"]);
    assert!(!harness.state().state().is_edited());
    wait(&mut harness, "all subjects", |app| {
        app.state().document.study().unread.is_empty()
    });
    assert!(!out.path().join("study.toml").exists());
}
