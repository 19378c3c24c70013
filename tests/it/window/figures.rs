//! Figures of the window: written as files, taken up again from a picture.

#[cfg(test)]
mod plots;

use super::*;
use cardiomorph::panes::{
    EditCommand, FileCommand, PlaybackCommand, SelectCommand, TransportCommand, ViewCommand,
    WallCommand,
};

use std::sync::Mutex;
use std::sync::mpsc::{Receiver, Sender, channel};

use cardiomorph::app::PathQuestion;
use cardiomorph::document::Document;
use cardiomorph::picture::figure::SavedView;
use cardiomorph::picture::page::{VIEW_KEY, png_text};
use cardiomorph::picture::{BullsEyeQuantity, Quantity, WallPart};

/// P05 has a large patch.
const PATCHED: usize = 13;

/// A window on the heart with a patch, looked at in a way of its own.
fn arranged_window() -> Harness<'static, App> {
    let mut harness = cohort_window();
    give(
        &mut harness,
        Command::Select(SelectCommand::SelectPose {
            subject: PATCHED,
            frame: 3,
            play: false,
        }),
    );
    let mut settings = harness.state().state().document.thickening;
    settings.patches.extent_threshold = 0.5;
    for command in [
        Command::Wall(WallCommand::SetThickening(settings)),
        Command::Transport(TransportCommand::SetInterpolatedPoses(0)),
        Command::Wall(WallCommand::ToggleAtoms),
        Command::View(ViewCommand::ToggleEpicardium),
        Command::View(ViewCommand::SetQuantity(Quantity::AreaRatio)),
        Command::View(ViewCommand::SetColourLimits(Some([0.7, 1.4]))),
        Command::View(ViewCommand::ViewFrom(
            cardiomorph::picture::AnatomicalView::Lateral,
        )),
        Command::Wall(WallCommand::SelectPart(Some(WallPart::Patch(0)))),
        Command::Wall(WallCommand::SetBullsEye(BullsEyeQuantity::ThicknessRatio)),
    ] {
        give(&mut harness, command);
    }
    wait_for_verdicts(&mut harness);
    harness
}

/// Until the wall of the heart with a patch and the verdicts are those of today's thresholds.
fn wait_for_verdicts(harness: &mut Harness<'_, App>) {
    wait(harness, "wall and verdicts", |app| {
        let state = app.state();
        matches!(state.wall_of(PATCHED), Some((Ok(_), true)))
            && matches!(state.verdicts(), Some((_, true)))
            && app.hearts_on_screen()[0].0 == PATCHED
            && !app.busy()
    });
}

fn written(harness: &mut Harness<'_, App>, command: Command, path: &Path) {
    give(harness, command);
    wait(harness, "the figure", |_| path.exists());
}

fn document(harness: &Harness<'_, App>) -> Document {
    harness.state().state().document.clone()
}

fn drop_file(harness: &mut Harness<'_, App>, path: &Path) {
    let dropped = Arc::new(Dropped(path.to_owned()));
    harness.input_mut().dropped_files.push(dropped);
    harness.step();
}

#[test]
fn a_patch_figure_dropped_on_the_window_restores_the_view_that_it_shows() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("P05_patch.png");
    let mut harness = arranged_window();
    written(
        &mut harness,
        Command::File(FileCommand::ExportPatchFigure(Some(path.clone()))),
        &path,
    );
    let shown = document(&harness);
    for command in [
        Command::Select(SelectCommand::SelectSubject(2)),
        Command::Wall(WallCommand::ToggleAtoms),
        Command::View(ViewCommand::ToggleWireframe),
        Command::View(ViewCommand::SetQuantity(Quantity::Tissue)),
        Command::View(ViewCommand::FitView),
        Command::Wall(WallCommand::ResetThickening),
        Command::Wall(WallCommand::SetBullsEye(BullsEyeQuantity::Thickening)),
        Command::View(ViewCommand::SetViewMode(ViewMode::AllFrames)),
    ] {
        give(&mut harness, command);
    }
    let changed = document(&harness);
    drop_file(&mut harness, &path);
    wait(&mut harness, "the view of the picture", |app| {
        app.state().document.subject == PATCHED
    });
    let restored = document(&harness);
    assert_eq!(restored.position, shown.position);
    assert_eq!(restored.visibility, shown.visibility);
    assert_eq!(restored.quantity, shown.quantity);
    assert_eq!(restored.limits(), Some([0.7, 1.4]));
    assert_eq!(restored.part, shown.part);
    assert_eq!(restored.bulls_eye, shown.bulls_eye);
    assert_eq!(restored.thickening, shown.thickening);
    assert_eq!(restored.view_mode, ViewMode::Single);
    assert!(
        restored.viewpoint.half_height.is_some(),
        "zoomed as the picture is"
    );
    assert!(harness.state().state().errors.is_empty());
    // The picture of the restored view is the same picture.
    let again = folder.path().join("again.png");
    wait_for_verdicts(&mut harness);
    written(
        &mut harness,
        Command::File(FileCommand::ExportPatchFigure(Some(again.clone()))),
        &again,
    );
    let other = differing(&path, &again);
    assert!(other < 1e-3, "{other} of all pixels differ");
    give(&mut harness, Command::Edit(EditCommand::Undo));
    assert_eq!(document(&harness), changed, "one step of undo");
}

/// Share of the pixels that differ by more than the rounding of a camera that was told in words.
fn differing(a: &Path, b: &Path) -> f64 {
    let [a, b] = [a, b].map(pixels);
    assert_eq!(a.len(), b.len());
    let pairs = a.chunks(4).zip(b.chunks(4));
    let far = |(a, b): &(&[u8], &[u8])| a.iter().zip(*b).any(|(a, b)| a.abs_diff(*b) > 24);
    pairs.filter(far).count() as f64 / (a.len() / 4) as f64
}

fn pixels(path: &Path) -> Vec<u8> {
    let file = std::io::BufReader::new(std::fs::File::open(path).unwrap());
    let mut reader = png::Decoder::new(file).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut pixels).unwrap();
    pixels
}

#[test]
fn a_picture_without_a_view_says_so_and_changes_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("holiday.png");
    let file = std::fs::File::create(&path).unwrap();
    let mut encoder = png::Encoder::new(file, 1, 1);
    encoder.set_color(png::ColorType::Grayscale);
    let mut writer = encoder.write_header().unwrap();
    writer.write_image_data(&[7]).unwrap();
    writer.finish().unwrap();
    let mut harness = cohort_window();
    let before = document(&harness);
    drop_file(&mut harness, &path);
    wait(&mut harness, "the error card", |app| {
        !app.state().errors.is_empty()
    });
    let card = harness.state().state().errors[0].clone();
    assert!(card.message.contains("holiday.png"), "{card:?}");
    assert!(card.message.contains("contains no view"), "{card:?}");
    assert_eq!(document(&harness), before);
}

#[test]
fn f2_asks_for_a_place_and_svg_and_pdf_are_written_by_their_endings() {
    let folder = tempfile::tempdir().unwrap();
    let mut harness = arranged_window();
    for (name, start) in [("a.svg", &b"<svg"[..]), ("a.pdf", b"%PDF")] {
        let path = folder.path().join(name);
        written(
            &mut harness,
            Command::File(FileCommand::ExportPatchFigure(Some(path.clone()))),
            &path,
        );
        assert!(std::fs::read(&path).unwrap().starts_with(start), "{name}");
        wait(&mut harness, "the end of the export", |app| !app.busy());
    }
    let wrong = folder.path().join("a.docx");
    give(
        &mut harness,
        Command::File(FileCommand::ExportPatchFigure(Some(wrong.clone()))),
    );
    let card = harness.state().state().errors[0].clone();
    assert!(
        card.message.contains("must end in .png, .svg or .pdf"),
        "{card:?}"
    );
    assert!(!wrong.exists());
}

/// A file dialog that a test answers: what it asks comes out, a path goes in.
struct Dialog {
    asked: Receiver<PathQuestion>,
    answer: Sender<PathBuf>,
}

/// A window whose dialogs the test answers, on the heart with a patch.
fn asking_window() -> (Harness<'static, App>, Dialog) {
    let (ask, asked) = channel();
    let (answer, answers) = channel::<PathBuf>();
    let ends = Mutex::new((ask, answers));
    let mut options = AppOptions::built_in(small());
    options.ask_paths = Arc::new(move |question| {
        let (ask, answers) = &*ends.lock().unwrap();
        ask.send(question.clone()).unwrap();
        answers.recv().ok().map(|path| vec![path])
    });
    let mut harness = window(options);
    wait_for_heart(&mut harness);
    give(
        &mut harness,
        Command::Select(SelectCommand::SelectSubject(PATCHED)),
    );
    wait_for_verdicts(&mut harness);
    (harness, Dialog { asked, answer })
}

/// What the dialog asks once it is open, while the window goes on.
fn question(harness: &mut Harness<'_, App>, dialog: &Dialog) -> PathQuestion {
    let begin = Instant::now();
    loop {
        if let Ok(question) = dialog.asked.try_recv() {
            return question;
        }
        assert!(begin.elapsed() < Duration::from_secs(30), "no dialog");
        harness.step();
        std::thread::sleep(Duration::from_millis(3));
    }
}

/// The subject that a picture says it shows.
fn shown_in(path: &Path) -> (String, f64) {
    let file = std::fs::File::open(path).unwrap();
    let text = png_text(std::io::BufReader::new(file), VIEW_KEY).unwrap();
    let view = SavedView::read(&text.unwrap()).unwrap();
    (view.subject.id, view.position)
}

#[test]
fn a_figure_holds_the_subject_of_its_command_while_another_one_is_clicked() {
    let folder = tempfile::tempdir().unwrap();
    for (command, name) in [
        (
            Command::File(FileCommand::ExportPatchFigure(None)),
            "P05_patch.png",
        ),
        (
            Command::File(FileCommand::ExportFigure(None)),
            "P05_frame_2.png",
        ),
    ] {
        let (mut harness, dialog) = asking_window();
        give(
            &mut harness,
            Command::Playback(PlaybackCommand::SetPosition(2.0)),
        );
        give(&mut harness, command);
        let asked = question(&mut harness, &dialog);
        let PathQuestion::SaveFigure { suggested, .. } = asked else {
            panic!("{asked:?}");
        };
        assert_eq!(suggested, name);
        give(
            &mut harness,
            Command::Select(SelectCommand::SelectSubject(15)),
        );
        give(
            &mut harness,
            Command::Playback(PlaybackCommand::SetPosition(5.0)),
        );
        wait(&mut harness, "P07 on screen", |app| {
            app.hearts_on_screen()[0].0 == 15
        });
        let path = folder.path().join(&suggested);
        dialog.answer.send(path.clone()).unwrap();
        wait(&mut harness, "the figure", |_| path.exists());
        assert_eq!(shown_in(&path), ("P05".to_owned(), 2.0), "{name}");
    }
}

#[test]
fn a_figure_asked_for_right_after_a_click_waits_for_the_clicked_subject() {
    let (mut harness, dialog) = asking_window();
    // In one frame, before anything of P07 is drawn or measured.
    harness
        .state_mut()
        .push(Command::Select(SelectCommand::SelectSubject(15)));
    harness
        .state_mut()
        .push(Command::File(FileCommand::ExportPatchFigure(None)));
    let asked = question(&mut harness, &dialog);
    let PathQuestion::SaveFigure { suggested, .. } = asked else {
        panic!("{asked:?}");
    };
    assert_eq!(suggested, "P07_patch.png");
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(suggested);
    dialog.answer.send(path.clone()).unwrap();
    wait(&mut harness, "the figure", |_| path.exists());
    assert_eq!(shown_in(&path).0, "P07");
    assert!(harness.state().state().errors.is_empty());
}

#[test]
fn a_figure_whose_subject_is_left_before_it_is_drawn_is_refused_by_name() {
    let (mut harness, _dialog) = asking_window();
    harness
        .state_mut()
        .push(Command::Select(SelectCommand::SelectSubject(15)));
    harness
        .state_mut()
        .push(Command::File(FileCommand::ExportFigure(None)));
    harness
        .state_mut()
        .push(Command::Select(SelectCommand::SelectSubject(2)));
    wait(&mut harness, "a card", |app| !app.state().errors.is_empty());
    let card = harness.state().state().errors[0].clone();
    assert_eq!(card.title, "There is no figure of P07");
}

#[test]
fn tables_hold_the_study_of_their_command_while_another_one_is_opened() {
    let (mut harness, dialog) = asking_window();
    give(&mut harness, Command::File(FileCommand::ExportTables(None)));
    assert_eq!(question(&mut harness, &dialog), PathQuestion::SaveTables);
    let (folder, manifest) = cohort_on_disk();
    let text = std::fs::read_to_string(&manifest).unwrap();
    std::fs::write(&manifest, text.replace("\"P05\"", "\"Q05\"")).unwrap();
    give(
        &mut harness,
        Command::File(FileCommand::Open(vec![manifest])),
    );
    wait(&mut harness, "the other study", |app| {
        app.state().document.study().subjects[PATCHED].id == "Q05"
    });
    let tables = folder.path().join("tables");
    dialog.answer.send(tables.clone()).unwrap();
    let subjects = tables.join("subjects.csv");
    wait(&mut harness, "the tables", |_| subjects.exists());
    let text = std::fs::read_to_string(&subjects).unwrap();
    assert!(text.contains("P05") && !text.contains("Q05"), "{text}");
}
