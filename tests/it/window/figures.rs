//! Figures of the window: written as files, taken up again from a picture.

use super::*;

use cardiomorph::app::Document;
use cardiomorph::picture::{BullsEyeQuantity, Quantity, WallPart};

/// P05 has a large patch.
const PATCHED: usize = 13;

/// A window on the heart with a patch, looked at in a way of its own.
fn arranged_window() -> Harness<'static, App> {
    let mut harness = cohort_window();
    give(
        &mut harness,
        Command::SelectPose {
            subject: PATCHED,
            frame: 3,
            play: false,
        },
    );
    let mut settings = harness.state().state().document.thickening;
    settings.thickening.border = 0.5;
    for command in [
        Command::SetThickening(settings),
        Command::SetInBetweens(0),
        Command::ToggleAtoms,
        Command::ToggleEpicardium,
        Command::SetQuantity(Quantity::AreaRatio),
        Command::SetColourLimits(Some([0.7, 1.4])),
        Command::ViewFrom(cardiomorph::picture::AnatomicalView::Lateral),
        Command::SelectPart(Some(WallPart::Patch(0))),
        Command::SetBullsEye(BullsEyeQuantity::Ratio),
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
        Command::ExportPatchFigure(Some(path.clone())),
        &path,
    );
    let shown = document(&harness);
    for command in [
        Command::SelectSubject(2),
        Command::ToggleAtoms,
        Command::ToggleWireframe,
        Command::SetQuantity(Quantity::Tissue),
        Command::FrameAll,
        Command::ResetThickening,
        Command::SetBullsEye(BullsEyeQuantity::Thickening),
        Command::SetViewMode(ViewMode::AllPhases),
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
        restored.look.half_height.is_some(),
        "zoomed as the picture is"
    );
    assert!(harness.state().state().errors.is_empty());
    // The picture of the restored view is the same picture.
    let again = folder.path().join("again.png");
    wait_for_verdicts(&mut harness);
    written(
        &mut harness,
        Command::ExportPatchFigure(Some(again.clone())),
        &again,
    );
    let other = differing(&path, &again);
    assert!(other < 1e-3, "{other} of all pixels differ");
    give(&mut harness, Command::Undo);
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
    assert!(card.message.contains("carries no view"), "{card:?}");
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
            Command::ExportPatchFigure(Some(path.clone())),
            &path,
        );
        assert!(std::fs::read(&path).unwrap().starts_with(start), "{name}");
        wait(&mut harness, "the end of the export", |app| !app.busy());
    }
    let wrong = folder.path().join("a.docx");
    give(
        &mut harness,
        Command::ExportPatchFigure(Some(wrong.clone())),
    );
    let card = harness.state().state().errors[0].clone();
    assert!(
        card.message.contains("must end in .png, .svg or .pdf"),
        "{card:?}"
    );
    assert!(!wrong.exists());
}
