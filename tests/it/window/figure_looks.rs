//! How figures look: size, background and theme, chosen in the window.

use super::*;
use cardiomorph::panes::{FileCommand, WallCommand};
use cardiomorph::picture::figure::{FigureBackground, FigureLook, FigureTheme};

/// P05 has a large patch.
const PATCHED: usize = 13;

fn picture(path: &Path) -> image::RgbaImage {
    image::open(path).unwrap().into_rgba8()
}

fn exported(harness: &mut Harness<'_, App>, command: FileCommand, path: &Path) -> image::RgbaImage {
    give(harness, command.into());
    wait(harness, "the figure", |app| path.exists() && !app.busy());
    picture(path)
}

#[test]
fn size_background_and_theme_of_a_figure_are_those_chosen_in_the_sheet() {
    let folder = tempfile::tempdir().unwrap();
    let mut harness = cohort_window();
    harness.key_press_modifiers(egui::Modifiers::COMMAND, egui::Key::F2);
    harness.run_steps(4);
    harness.get_by_label("Black").click();
    harness.run_steps(3);
    let look = |harness: &Harness<'_, App>| harness.state().state().figure_look;
    assert_eq!(look(&harness).background, FigureBackground::Black);
    // By the keyboard: the next choice after it.
    harness.get_by_label("Black").focus();
    harness.run_steps(2);
    let subject = harness.state().state().document.subject;
    for key in [egui::Key::Tab, egui::Key::Space] {
        harness.key_press(key);
        harness.run_steps(2);
    }
    assert_eq!(look(&harness).background, FigureBackground::Transparent);
    assert_eq!(harness.state().state().document.subject, subject);
    harness.key_press(egui::Key::Escape);
    harness.run_steps(3);
    assert!(!harness.state().state().sheets.figure);
    for (index, (background, theme, corner)) in [
        (FigureBackground::Black, FigureTheme::Window, [0, 0, 0, 255]),
        (FigureBackground::White, FigureTheme::Dark, [255; 4]),
        (FigureBackground::Theme, FigureTheme::Light, [255; 4]),
        (
            FigureBackground::Theme,
            FigureTheme::Dark,
            [0x1a, 0x1e, 0x24, 255],
        ),
        (FigureBackground::Transparent, FigureTheme::Light, [0; 4]),
    ]
    .into_iter()
    .enumerate()
    {
        let look = FigureLook {
            size: Some([480, 360]),
            background,
            theme,
        };
        give(&mut harness, FileCommand::SetFigureLook(look).into());
        let path = folder.path().join(format!("{index}.png"));
        let command = FileCommand::ExportFigure(Some(path.clone()));
        let figure = exported(&mut harness, command, &path);
        assert_eq!(figure.dimensions(), (480, 360));
        assert_eq!(figure.get_pixel(0, 0).0, corner, "{look:?}");
        // Its name stands out from what is behind it.
        let ink = figure.pixels().map(|pixel| pixel.0).filter(|pixel| {
            let far = |channel: usize| pixel[channel].abs_diff(corner[channel]) > 140;
            far(0) && far(1) && far(2) || corner[3] == 0 && pixel[3] == 255
        });
        assert!(ink.count() > 100, "{look:?}");
    }
}

#[test]
fn a_size_too_small_for_a_patch_figure_is_refused_before_anything_is_asked_or_drawn() {
    let mut harness = cohort_window();
    let look = FigureLook {
        size: Some([640, 480]),
        ..FigureLook::default()
    };
    give(&mut harness, FileCommand::SetFigureLook(look).into());
    give(&mut harness, FileCommand::ExportPatchFigure(None).into());
    harness.run_steps(3);
    let card = harness.state().state().errors[0].clone();
    assert!(card.message.contains("needs 800 × 600"), "{card:?}");
}

#[test]
fn the_look_is_that_of_the_command_and_so_are_the_thresholds_given_in_the_same_frame() {
    let folder = tempfile::tempdir().unwrap();
    let mut harness = cohort_window();
    let select = SelectCommand::SelectSubject(PATCHED);
    give(&mut harness, select.into());
    wait(&mut harness, "the verdicts", |app| {
        matches!(app.state().verdicts(), Some((_, true)))
            && matches!(app.state().wall_of(PATCHED), Some((Ok(_), true)))
            && app.hearts_on_screen()[0].0 == PATCHED
            && !app.busy()
    });
    let mut settings = harness.state().state().document.thickening;
    settings.patches.extent_threshold = 0.3;
    let [early, late] = ["early.png", "late.png"].map(|name| folder.path().join(name));
    let small = |background| FigureLook {
        size: Some([800, 600]),
        background,
        theme: FigureTheme::Light,
    };
    // All in one frame: what the store says is still about the thresholds before.
    for command in [
        Command::from(FileCommand::SetFigureLook(small(FigureBackground::Black))),
        WallCommand::SetThickening(settings).into(),
        FileCommand::ExportPatchFigure(Some(early.clone())).into(),
        FileCommand::SetFigureLook(small(FigureBackground::White)).into(),
    ] {
        harness.state_mut().push(command);
    }
    wait(&mut harness, "the figure", |app| {
        early.exists() && !app.busy()
    });
    assert_eq!(picture(&early).get_pixel(0, 0).0, [0, 0, 0, 255]);
    give(
        &mut harness,
        FileCommand::SetFigureLook(small(FigureBackground::Black)).into(),
    );
    let command = FileCommand::ExportPatchFigure(Some(late.clone()));
    let late = exported(&mut harness, command, &late);
    assert!(picture(&early) == late, "patches by the new thresholds");
}

#[test]
fn a_name_without_an_ending_does_not_replace_a_picture_that_nobody_was_asked_about() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path().join("heart");
    let mine = folder.path().join("heart.png");
    std::fs::write(&mine, "mine").unwrap();
    let mut options = AppOptions::built_in(small());
    options.ask_paths = Arc::new(move |_| Some(vec![place.clone()]));
    let mut harness = window(options);
    wait_for_heart(&mut harness);
    give(&mut harness, FileCommand::ExportFigure(None).into());
    wait(&mut harness, "a card", |app| !app.state().errors.is_empty());
    let card = harness.state().state().errors[0].clone();
    assert!(card.message.contains("lies there already"), "{card:?}");
    assert_eq!(std::fs::read(&mine).unwrap(), b"mine");
}

#[test]
fn tables_that_are_stopped_leave_those_of_an_earlier_run_whole() {
    let folder = tempfile::tempdir().unwrap();
    let tables = folder.path().join("tables");
    let mut harness = cohort_window();
    let export = || FileCommand::ExportTables(Some(tables.clone()));
    give(&mut harness, export().into());
    wait(&mut harness, "the tables", |app| {
        tables.join("summary.json").exists() && !app.busy()
    });
    let content = || -> Vec<(PathBuf, Vec<u8>)> {
        let entries = std::fs::read_dir(&tables).unwrap();
        let paths = entries.map(|entry| entry.unwrap().path());
        let mut files: Vec<_> = paths
            .map(|path| (path.clone(), std::fs::read(&path).unwrap()))
            .collect();
        files.sort();
        files
    };
    let before = content();
    // A folder lies where the last table goes: nothing of the new run is kept.
    give(&mut harness, SelectCommand::SelectSubject(1).into());
    std::fs::remove_file(tables.join("medial_mds.csv")).unwrap();
    std::fs::create_dir(tables.join("medial_mds.csv")).unwrap();
    std::fs::write(tables.join("frames.csv"), "of the run before").unwrap();
    give(&mut harness, export().into());
    wait(&mut harness, "a card", |app| !app.state().errors.is_empty());
    let card = harness.state().state().errors[0].clone();
    assert!(card.message.contains("medial_mds.csv"), "{card:?}");
    let frames = std::fs::read(tables.join("frames.csv")).unwrap();
    assert_eq!(frames, b"of the run before");
    let summary = tables.join("summary.json");
    assert!(before.contains(&(summary.clone(), std::fs::read(&summary).unwrap())));
    let passing = std::fs::read_dir(&tables).unwrap().any(|entry| {
        let name = entry.unwrap().file_name();
        name.to_string_lossy().ends_with(".partial")
    });
    assert!(!passing);
    // Stopped, the same holds.
    std::fs::remove_dir(tables.join("medial_mds.csv")).unwrap();
    let before = content();
    // In one frame: between two the export might end.
    harness.state_mut().push(export().into());
    give(&mut harness, WorkCommand::Cancel(Topic::EXPORT).into());
    wait(&mut harness, "the end", |app| !app.busy());
    harness.run_steps(5);
    assert!(content() == before);
}
