//! Classifiers as files in the window: opened, dropped, forgotten, trained and written.

use super::*;
use cardiomorph::engine::read_classifier;
use cardiomorph::panes::{ClassifierCommand, EditCommand, FileCommand, WindowCommand};

fn classified(app: &App) -> bool {
    matches!(app.state().verdicts(), Some((_, true))) && !app.busy()
}

fn shows(harness: &Harness<'_, App>, text: &str) -> bool {
    harness.query_all_by_label_contains(text).next().is_some()
}

/// The name of the classifier that the document holds.
fn used(app: &App) -> Option<String> {
    let rule = app.state().document.rule.as_ref();
    rule.map(|rule| rule.name().to_owned())
}

fn show_verdict(harness: &mut Harness<'_, App>) {
    let show = WindowCommand::ShowPane(Pane::VERDICT);
    give(harness, Command::Window(show));
    harness.run_steps(2);
}

/// A classifier of the built-in cohort, trained by a window and written into a folder.
fn trained(folder: &Path) -> PathBuf {
    let path = folder.join("built-in cohort.json");
    let mut harness = cohort_window();
    // Without an ending it becomes one of a classifier.
    let place = path.with_extension("");
    give(&mut harness, ClassifierCommand::Export(Some(place)).into());
    wait_up_to(120, &mut harness, "the classifier", |app| {
        path.exists() && !app.busy()
    });
    path
}

#[test]
fn a_classifier_is_trained_written_opened_forgotten_and_comes_back_by_undo() {
    let folder = tempfile::tempdir().unwrap();
    let path = trained(folder.path());
    let rule = read_classifier(&path).unwrap();
    assert_eq!(rule.rule().origin.study, "Built-in cohort");
    let mut harness = cohort_window();
    wait(&mut harness, "verdicts", classified);
    show_verdict(&mut harness);
    assert!(shows(&harness, "each of them is classified leave-one-out"));
    give(&mut harness, ClassifierCommand::Open(path).into());
    wait(&mut harness, "verdicts of the classifier", |app| {
        used(app).is_some() && classified(app)
    });
    assert_eq!(used(harness.state()).as_deref(), Some("built-in cohort"));
    let auc = rule.rule().training.auc.unwrap();
    assert!(shows(
        &harness,
        &format!(
            "Classifier “built-in cohort”, trained on 23 subjects of Built-in cohort (9 normal, 14 abnormal), \
             AUC {auc:.2} there"
        )
    ));
    assert!(shows(&harness, "Classifier of another study, from a file"));
    assert!(shows(&harness, "the training distribution: "));
    give(&mut harness, ClassifierCommand::Forget.into());
    wait(&mut harness, "verdicts by the labels", classified);
    assert!(used(harness.state()).is_none());
    assert!(shows(&harness, "each of them is classified leave-one-out"));
    give(&mut harness, Command::Edit(EditCommand::Undo));
    assert!(used(harness.state()).is_some());
    give(&mut harness, Command::Edit(EditCommand::Undo));
    assert!(used(harness.state()).is_none());
}

#[test]
fn a_classifier_is_dropped_alone_or_named_with_a_study() {
    let folder = tempfile::tempdir().unwrap();
    let path = trained(folder.path());
    let mut harness = cohort_window();
    let opening = harness.state().state().document.study.opening;
    give(&mut harness, FileCommand::Open(vec![path.clone()]).into());
    wait(&mut harness, "the classifier", |app| used(app).is_some());
    assert_eq!(harness.state().state().document.study.opening, opening);
    assert!(harness.state().state().errors.is_empty());
    // Beside a study it is for that one; alone on the command line, for the built-in cohort.
    let mut options = AppOptions::opening(vec![path]);
    options.built_in = small();
    let mut harness = window(options);
    wait_for_heart(&mut harness);
    wait(&mut harness, "the classifier", |app| used(app).is_some());
    assert_eq!(
        harness.state().state().document.study().name,
        "Built-in cohort"
    );
}

#[test]
fn what_is_no_classifier_has_one_card_and_changes_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("broken.json");
    std::fs::write(
        &path,
        "{\n  \"format\": \"cardiomorph rule\",\n  \"version\": x\n}",
    )
    .unwrap();
    let mut harness = cohort_window();
    let before = harness.state().state().document.clone();
    give(&mut harness, ClassifierCommand::Open(path).into());
    wait(&mut harness, "the card", |app| {
        !app.state().errors.is_empty()
    });
    let state = harness.state().state();
    assert_eq!((state.errors.len(), &state.document), (1, &before));
    let message = &state.errors[0].message;
    assert!(
        message.contains("line 3") && message.ends_with("broken.json"),
        "{message}"
    );
}

#[test]
fn without_a_file_dialog_the_classifier_is_typed() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("typed.json");
    std::fs::copy("assets/classifiers/built-in.json", &path).unwrap();
    let mut options = AppOptions::built_in(small());
    options.ask_paths = Arc::new(|_| None);
    let mut harness = window(options);
    wait_for_heart(&mut harness);
    give(&mut harness, ClassifierCommand::Choose.into());
    wait(&mut harness, "the sheet", |app| {
        app.state().path_entry.is_some()
    });
    assert!(shows(&harness, "Open a classifier"));
    let (text, replace) = (path.display().to_string(), false);
    give(&mut harness, FileCommand::TakePath { text, replace }.into());
    wait(&mut harness, "the classifier", |app| used(app).is_some());
    assert_eq!(used(harness.state()).as_deref(), Some("typed"));
    show_verdict(&mut harness);
    wait(&mut harness, "verdicts", classified);
    assert!(shows(&harness, "Classifier “typed”, trained on "));
}
