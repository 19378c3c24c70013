//! Figures asked for before their subject is drawn or classified, and moments between frames.

use super::*;
use cardiomorph::panes::{FileCommand, PlaybackCommand, SelectCommand, ViewCommand};

use std::io::BufReader;

use cardiomorph::picture::Quantity;
use cardiomorph::picture::figure::SavedView;
use cardiomorph::picture::page::{VIEW_KEY, png_text};

/// P05 has a large patch.
const PATCHED: usize = 13;

fn shows(harness: &Harness<'_, App>, text: &str) -> bool {
    harness.query_all_by_label_contains(text).next().is_some()
}

/// What a picture says of itself under a word.
fn said(path: &Path, word: &str) -> Option<String> {
    png_text(BufReader::new(std::fs::File::open(path).unwrap()), word).unwrap()
}

fn position_in(path: &Path) -> (String, f64) {
    let view = SavedView::read(&said(path, VIEW_KEY).unwrap()).unwrap();
    (view.subject.id, view.position)
}

#[test]
fn a_figure_asked_for_before_its_verdict_is_known_waits_for_it_or_says_so() {
    let folder = tempfile::tempdir().unwrap();
    for (name, patch) in [("patch.png", true), ("view.png", false)] {
        let path = folder.path().join(name);
        let mut harness = cohort_window();
        let select = Command::Select(SelectCommand::SelectSubject(PATCHED));
        harness.state_mut().push(select);
        assert!(
            harness.state().state().verdicts().is_none(),
            "not yet known"
        );
        let export = match patch {
            true => FileCommand::ExportPatchFigure(Some(path.clone())),
            false => FileCommand::ExportFigure(Some(path.clone())),
        };
        harness.state_mut().push(Command::File(export));
        wait(&mut harness, "the figure", |_| path.exists());
        let verdict = said(&path, "Verdict").unwrap_or_default();
        // The figure of the 3D view does not wait for the cohort, but says how it stands.
        let says = verdict.starts_with("Abnormal patch") || !patch && verdict == "Not yet assessed";
        assert!(says, "{name}: “{verdict}”");
    }
}

#[test]
fn two_figures_asked_for_at_once_are_both_written() {
    let folder = tempfile::tempdir().unwrap();
    let paths = ["a.png", "b.png"].map(|name| folder.path().join(name));
    let mut harness = cohort_window();
    let select = Command::Select(SelectCommand::SelectSubject(15));
    harness.state_mut().push(select);
    for path in &paths {
        let export = FileCommand::ExportFigure(Some(path.clone()));
        harness.state_mut().push(Command::File(export));
    }
    wait(&mut harness, "both figures", |_| {
        paths.iter().all(|path| path.exists())
    });
}

#[test]
fn a_figure_that_waits_for_its_subject_keeps_frame_and_colours_of_its_command() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("view.png");
    let mut harness = cohort_window();
    for command in [
        Command::Select(SelectCommand::SelectSubject(15)),
        Command::Playback(PlaybackCommand::SetPosition(2.0)),
        Command::File(FileCommand::ExportFigure(Some(path.clone()))),
        Command::Playback(PlaybackCommand::SetPosition(5.0)),
        Command::View(ViewCommand::SetQuantity(Quantity::Displacement)),
    ] {
        harness.state_mut().push(command);
    }
    wait(&mut harness, "the figure", |_| path.exists());
    assert_eq!(position_in(&path), ("P07".to_owned(), 2.0));
    let colours = said(&path, "Quantity").unwrap();
    assert_eq!(colours, Quantity::Tissue.word());
}

#[test]
fn between_frames_no_frame_and_no_phase_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("between.png");
    let mut harness = cohort_window();
    let phases = harness.state().state().phases_of(0);
    let systole = phases.1.unwrap();
    let at = |position| Command::Playback(PlaybackCommand::SetPosition(position));
    give(&mut harness, at(systole as f64));
    harness.run();
    assert!(shows(&harness, &format!("frame {systole} (0–7) · ES")));
    give(&mut harness, at(systole as f64 + 0.25));
    wait(&mut harness, "the poses between frames", |app| !app.busy());
    harness.run();
    let between = format!("between frames {systole} and {}", systole + 1);
    assert!(shows(&harness, &between), "{between}");
    assert!(!shows(&harness, &format!("frame {systole} (0–7)")));
    assert!(!shows(&harness, "(0–7) · ES"));
    let figure = FileCommand::ExportFigure(Some(path.clone()));
    give(&mut harness, Command::File(figure));
    wait(&mut harness, "the figure", |_| path.exists());
    let moment = said(&path, "Moment").unwrap();
    assert!(moment.contains(&between), "{moment}");
    assert!(!moment.contains("ES"), "{moment}");
    give(&mut harness, at(7.5));
    harness.run();
    assert!(shows(&harness, "between frames 7 and 0"));
}
