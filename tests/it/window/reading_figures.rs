//! Figures asked for while a large study is read.

use super::*;
use cardiomorph::panes::FileCommand;
use cardiomorph::picture::page::{VIEW_KEY, png_text};

fn said(path: &Path, word: &str) -> String {
    let file = std::io::BufReader::new(std::fs::File::open(path).unwrap());
    png_text(file, word).unwrap().unwrap_or_default()
}

fn wait_long(harness: &mut Harness<'_, App>, what: &str, done: impl Fn(&App) -> bool) {
    wait_up_to(240, harness, what, done);
}

#[test]
fn a_patch_figure_asked_for_while_a_study_is_read_waits_for_all_and_a_view_for_its_subject() {
    let (study_folder, folder) = (large_cohort_on_disk(), tempfile::tempdir().unwrap());
    let study = study_folder.path().to_owned();
    let figure = folder.path().join("P05_patch.png");
    let mut harness = window(AppOptions::opening(vec![study.clone()]));
    wait_long(&mut harness, "the first subject", |app| {
        app.state().document.selected().is_some()
    });
    let unread = |app: &App| !app.state().document.study().unread.is_empty();
    assert!(unread(harness.state()), "it is shown while it is read");
    // The last subject of the patients that have a patch: others are read after it, before and behind it.
    give(
        &mut harness,
        FileCommand::ReadFirst("P05".to_owned()).into(),
    );
    let selects = |app: &App| {
        let selected = app.state().document.selected();
        selected.is_some_and(|subject| subject.id == "P05")
    };
    wait_long(&mut harness, "P05", selects);
    let export = FileCommand::ExportPatchFigure(Some(figure.clone()));
    give(&mut harness, export.into());
    wait_long(&mut harness, "the figure", |_| figure.exists());
    assert!(!unread(harness.state()), "it waited for the others");
    assert!(said(&figure, VIEW_KEY).contains("P05"));
    let verdict = said(&figure, "Verdict");
    assert!(verdict.starts_with("Abnormal patch"), "{verdict}");
    drop(harness);
    // A picture of a study that is being read has its subject read first.
    let mut harness = window(AppOptions::opening(vec![figure, study]));
    wait_long(&mut harness, "the view", |app| {
        selects(app) && app.state().message.contains("restored")
    });
    assert_eq!(harness.state().state().errors, []);
}
