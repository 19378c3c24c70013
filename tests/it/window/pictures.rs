//! Pictures named on the command line, or opened, that hold a view.

use super::*;
use cardiomorph::engine::OpenSource;
use cardiomorph::panes::{FileCommand, PlaybackCommand, SelectCommand, ViewCommand};
use cardiomorph::picture::Quantity;

/// A figure of P03 at frame 2 with its cavity coloured, exported from a study on disk; and the study.
fn exported(name: &str) -> (tempfile::TempDir, PathBuf, PathBuf) {
    let (folder, manifest) = cohort_on_disk();
    let text = std::fs::read_to_string(&manifest).unwrap();
    std::fs::write(&manifest, text.replace("Built-in cohort", "Ward 3")).unwrap();
    let picture = folder.path().join(name);
    let mut harness = window(AppOptions::opening(vec![manifest.clone()]));
    wait_for_heart(&mut harness);
    let study = harness.state().state().document.study().clone();
    let subject = study.index_of("P03").unwrap();
    for command in [
        Command::from(SelectCommand::SelectSubject(subject)),
        PlaybackCommand::SetPosition(2.0).into(),
        ViewCommand::SetQuantity(Quantity::AreaRatio).into(),
        ViewCommand::SetColourLimits(Some([0.6, 1.3])).into(),
    ] {
        give(&mut harness, command);
    }
    give(
        &mut harness,
        FileCommand::ExportFigure(Some(picture.clone())).into(),
    );
    wait(&mut harness, "the figure", |app| {
        picture.exists() && !app.busy()
    });
    (folder, picture, manifest)
}

fn assert_restored(harness: &mut Harness<'_, App>) {
    wait(harness, "the view of the picture", |app| {
        let document = &app.state().document;
        document
            .selected()
            .is_some_and(|subject| subject.id == "P03")
            && app
                .hearts_on_screen()
                .first()
                .is_some_and(|heart| heart.1 == 2.0)
    });
    let document = &harness.state().state().document;
    assert_eq!(document.quantity, Quantity::AreaRatio);
    assert_eq!(document.limits(), Some([0.6, 1.3]));
    assert!(document.viewpoint.half_height.is_some());
    assert_eq!(harness.state().state().errors, []);
}

#[test]
fn a_picture_named_with_its_study_restores_its_view_from_every_kind_of_file() {
    for name in ["P03.png", "P03.svg", "P03.pdf"] {
        let (folder, picture, manifest) = exported(name);
        // Far from its study, which is named.
        let moved = tempfile::tempdir().unwrap();
        let far = moved.path().join(name);
        std::fs::rename(&picture, &far).unwrap();
        let mut harness = window(AppOptions::opening(vec![far, manifest]));
        assert_restored(&mut harness);
        drop(folder);
    }
}

#[test]
fn a_picture_named_alone_opens_the_study_around_it() {
    let (_folder, picture, _) = exported("P03.png");
    let mut harness = window(AppOptions::opening(vec![picture]));
    assert_restored(&mut harness);
}

#[test]
fn a_picture_whose_study_is_not_found_says_so_and_waits_for_it() {
    let (_folder, picture, manifest) = exported("P03.png");
    let moved = tempfile::tempdir().unwrap();
    let far = moved.path().join("P03.png");
    std::fs::rename(&picture, &far).unwrap();
    let mut harness = window(AppOptions::opening(vec![far]));
    wait(&mut harness, "a card", |app| !app.state().errors.is_empty());
    let state = harness.state().state();
    assert!(
        state.document.selected().is_none(),
        "no other study is opened"
    );
    let message = state.errors[0].message.clone();
    assert!(
        message.contains("shows P03 of the study “Ward 3”"),
        "{message}"
    );
    assert!(message.contains("open that study"), "{message}");
    give(&mut harness, WorkCommand::DismissError(0).into());
    give(&mut harness, FileCommand::Open(vec![manifest]).into());
    assert_restored(&mut harness);
}

#[test]
fn a_picture_of_the_built_in_cohort_opens_it() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("N02.png");
    let mut harness = cohort_window();
    give(&mut harness, SelectCommand::SelectSubject(1).into());
    let export = FileCommand::ExportFigure(Some(path.clone()));
    give(&mut harness, export.into());
    wait(&mut harness, "the figure", |app| {
        path.exists() && !app.busy()
    });
    drop(harness);
    let mut options = AppOptions::built_in(small());
    options.open = Some(OpenSource::Paths(vec![path]));
    let mut harness = window(options);
    wait(&mut harness, "N02", |app| {
        app.state().document.subject == 1 && !app.hearts_on_screen().is_empty()
    });
    assert_eq!(harness.state().state().errors, []);
}
