//! Figures of panes: maps, bull's-eye and curves hold what was on screen at their command.

use super::*;
use cardiomorph::panes::WindowCommand;

/// What a picture says of itself under a word.
fn said(path: &Path, word: &str) -> String {
    let file = std::fs::File::open(path).unwrap();
    let text = png_text(std::io::BufReader::new(file), word).unwrap();
    text.unwrap_or_default()
}

fn export(pane: Pane, path: Option<PathBuf>) -> Command {
    Command::File(FileCommand::ExportPaneFigure(pane, path))
}

/// The name that the dialog proposes.
fn suggested(harness: &mut Harness<'_, App>, dialog: &Dialog) -> String {
    match question(harness, dialog) {
        PathQuestion::SaveFigure { suggested, .. } => suggested,
        asked => panic!("{asked:?}"),
    }
}

#[test]
fn a_figure_of_a_pane_holds_the_subject_of_its_command_while_another_one_is_clicked() {
    let folder = tempfile::tempdir().unwrap();
    for (pane, name, title) in [
        (Pane::BULLS_EYE, "P05_bulls_eye.png", "Bull's-eye · P05"),
        (
            Pane::CURVES,
            "P05_volume.png",
            "Volume over the cardiac cycle · P05",
        ),
    ] {
        let (mut harness, dialog) = asking_window();
        give(&mut harness, export(pane, None));
        assert_eq!(suggested(&mut harness, &dialog), name);
        let other = place_on_map(&harness, 15, 0);
        click_at(&mut harness, other);
        wait(&mut harness, "P07 on screen", |app| {
            app.hearts_on_screen()[0].0 == 15
        });
        let path = folder.path().join(name);
        dialog.answer.send(path.clone()).unwrap();
        wait(&mut harness, "the figure", |_| path.exists());
        assert_eq!(said(&path, "Title"), title);
        assert!(harness.state().state().errors.is_empty());
    }
}

#[test]
fn a_figure_of_a_map_names_the_metric_and_method_of_its_command_while_others_are_chosen() {
    let folder = tempfile::tempdir().unwrap();
    let (mut harness, dialog) = asking_window();
    give(&mut harness, export(Pane::POSE_MAP, None));
    assert_eq!(suggested(&mut harness, &dialog), "pose_map.png");
    let other = place_on_map(&harness, 15, 0);
    click_at(&mut harness, other);
    let metric = MapCommand::SetMetric(MetricKind::Isometric);
    give(&mut harness, Command::Map(metric));
    wait(&mut harness, "the other map", |app| !app.busy());
    let path = folder.path().join("pose_map.png");
    dialog.answer.send(path.clone()).unwrap();
    wait(&mut harness, "the figure", |_| path.exists());
    let title = "Pose map · Displacement metric · SMACOF";
    assert_eq!(said(&path, "Title"), title);
    // As text in a drawing, with every subject that has room; P05 was selected at the command.
    let drawing = folder.path().join("now.svg");
    give(&mut harness, export(Pane::POSE_MAP, Some(drawing.clone())));
    wait(&mut harness, "the drawing", |_| drawing.exists());
    let drawing = std::fs::read_to_string(drawing).unwrap();
    for wanted in [
        "Pose map · Isometric metric · SMACOF",
        "Emphasised: P07",
        "Coordinate 1 of the embedding (no unit)",
        "N01",
        "normal 9",
        "Built-in cohort",
    ] {
        assert!(drawing.contains(wanted), "{wanted}");
    }
}

#[test]
fn a_map_that_is_not_computed_has_no_figure_and_a_card_says_so() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("map.png");
    let mut harness = mapped_window();
    give(&mut harness, export(Pane::MEDIAL_MAP, Some(path.clone())));
    let card = harness.state().state().errors[0].clone();
    assert_eq!(card.title, "No figure of the medial map");
    assert!(card.message.contains("not computed yet"), "{card:?}");
    // Settings that were chosen in the same frame have no map yet either.
    let metric = MapCommand::SetMetric(MetricKind::Isometric);
    harness.state_mut().push(Command::Map(metric));
    give(&mut harness, export(Pane::POSE_MAP, Some(path.clone())));
    let titles = harness.state().state().errors.iter();
    assert!(
        titles
            .into_iter()
            .any(|card| card.title == "No figure of the pose map")
    );
    assert!(!path.exists());
}

#[test]
fn every_pane_with_a_figure_writes_it_in_every_format_from_the_menu_export() {
    let folder = tempfile::tempdir().unwrap();
    let (mut harness, dialog) = asking_window();
    give(
        &mut harness,
        Command::Window(WindowCommand::ShowPane(Pane::MEDIAL_MAP)),
    );
    wait(&mut harness, "the medial map", |app| !app.busy());
    give(&mut harness, Command::View(ViewCommand::FitView));
    for (pane, ending, start) in [
        (Pane::POSE_MAP, "svg", &b"<svg"[..]),
        (Pane::DEFORMATION_MAP, "pdf", b"%PDF"),
        (Pane::MEDIAL_MAP, "png", b"\x89PNG"),
        (Pane::BULLS_EYE, "svg", b"<svg"),
        (Pane::CURVES, "pdf", b"%PDF"),
    ] {
        let path = folder.path().join(format!("{}.{ending}", pane.word()));
        give(&mut harness, export(pane, Some(path.clone())));
        let errors = &harness.state().state().errors;
        assert!(errors.is_empty(), "{errors:?}");
        wait(&mut harness, "the figure", |_| path.exists());
        wait(&mut harness, "the end of the export", |app| !app.busy());
        assert!(std::fs::read(&path).unwrap().starts_with(start));
    }
    for line in ["Export", "Figure of a pane", "Deformation map…"] {
        harness.get_by_label_contains(line).click();
        harness.run_steps(3);
    }
    assert_eq!(suggested(&mut harness, &dialog), "deformation_map.png");
    let shown = harness.state().state().document.subject;
    assert_eq!(shown, PATCHED, "an export changes nothing that is shown");
}
