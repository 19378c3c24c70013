//! The map of the medial shape space and the ways of measuring thickness: from a click to what every view shows.

use super::*;
use cardiomorph::engine::MedialMapQuery;
use cardiomorph::panes::{PlaybackCommand, SelectCommand, WindowCommand, WorkCommand};

use cardiomorph::analysis::medial_map::MedialMap;

fn medial_map(app: &App) -> Option<Arc<MedialMap>> {
    let document = &app.state().document;
    app.known(&MedialMapQuery {
        thickening: document.thickening,
        method: document.map.method,
    })
}

/// A window with the map in front.
fn medial_window() -> Harness<'static, App> {
    let mut harness = cohort_window();
    give(
        &mut harness,
        Command::Window(WindowCommand::ShowPane(Pane::MEDIAL_MAP)),
    );
    wait(&mut harness, "the medial map", |app| {
        medial_map(app).is_some() && !app.busy()
    });
    harness.run();
    harness
}

/// The screen position of a row of the map, by the lens that the map begins with.
fn place_of(harness: &Harness<'_, App>, row: usize) -> egui::Pos2 {
    let map = medial_map(harness.state()).unwrap();
    place_of_row(harness, "Medial map", &map.embedding, row)
}

#[test]
fn the_medial_map_is_made_when_it_is_seen_and_says_how_far_it_can_be_trusted() {
    let mut harness = mapped_window();
    wait(&mut harness, "rest", |app| !app.busy());
    assert!(medial_map(harness.state()).is_none(), "nobody looks at it");
    give(
        &mut harness,
        Command::Window(WindowCommand::ShowPane(Pane::MEDIAL_MAP)),
    );
    wait(&mut harness, "the medial map", |app| {
        medial_map(app).is_some() && !app.busy()
    });
    let map = medial_map(harness.state()).unwrap();
    assert!(map.poses.len() > 100, "{} poses", map.poses.len());
    let state = harness.state().state();
    let patch_of = |subject: usize| {
        (map.spreads.iter())
            .any(|spread| spread.subject == subject && spread.part.patch().is_some())
    };
    let subjects = &state.document.study().subjects;
    let two = subjects.iter().position(|s| s.id == "P05").unwrap();
    assert!(patch_of(two) && !patch_of(0));
    harness.get_by_label_contains(&format!("stress {:.2}", map.embedding.stress.unwrap()));
    harness.get_by_label("Medial map");
}

#[test]
fn a_click_on_a_step_selects_its_heart_and_the_frame_at_which_it_begins() {
    let mut harness = medial_window();
    let map = medial_map(harness.state()).unwrap();
    // The loneliest step has no neighbour within reach of the click.
    let place: Vec<egui::Pos2> = (0..map.poses.len())
        .map(|row| place_of(&harness, row))
        .collect();
    let apart = |row: usize| {
        let others = (0..place.len()).filter(|other| *other != row);
        let nearest = others.map(|other| (place[other] - place[row]).length());
        nearest.fold(f32::INFINITY, f32::min)
    };
    let begins_later = |row: &usize| map.poses[*row].step_from > 0;
    let row = (0..place.len())
        .filter(begins_later)
        .max_by(|a, b| apart(*a).total_cmp(&apart(*b)))
        .unwrap();
    click_at(&mut harness, place[row]);
    harness.step();
    let (subject, frame) = (map.poses[row].subject, map.poses[row].step_from);
    let document = &harness.state().state().document;
    assert_eq!(document.subject, subject);
    let began = document.position;
    assert!((began - frame as f64).abs() < 0.5, "began at {began}");
    assert!(harness.state().state().play.playing, "as on the other maps");
    wait(&mut harness, "that heart", |app| {
        app.hearts_on_screen().first().map(|heart| heart.0) == Some(subject)
    });
    give(&mut harness, Command::Playback(PlaybackCommand::TogglePlay));
}

#[test]
fn a_stopped_medial_map_stays_stopped_until_it_is_asked_for_again() {
    let mut harness = cohort_window();
    give(
        &mut harness,
        Command::Window(WindowCommand::ShowPane(Pane::MEDIAL_MAP)),
    );
    give(
        &mut harness,
        Command::Work(WorkCommand::Cancel(Topic::of::<MedialMapQuery>())),
    );
    wait(&mut harness, "rest", |app| !app.busy());
    assert!(medial_map(harness.state()).is_none());
    harness.get_by_label("Map computation stopped");
    harness.get_by_label("Compute the map").click();
    harness.step();
    wait(&mut harness, "the medial map", |app| {
        medial_map(app).is_some() && !app.busy()
    });
}

#[test]
fn the_ways_of_measuring_thickness_are_told_for_the_phases_and_the_pose_on_screen() {
    let mut harness = cohort_window();
    give(
        &mut harness,
        Command::Select(SelectCommand::SelectPose {
            subject: 2,
            frame: 1,
            play: false,
        }),
    );
    wait(&mut harness, "rest", |app| !app.busy());
    assert!(
        harness
            .query_by_label_contains("Medial spheres, ")
            .is_none(),
        "nobody looks at it"
    );
    give(
        &mut harness,
        Command::Window(WindowCommand::ShowPane(Pane::THICKNESS)),
    );
    wait_for_row(&mut harness, "Laplace field lines, ED ", ", frame 1 ");
    for way in [
        "Medial spheres, ED ",
        "Nearest distance, ED ",
        "Laplace field lines, ED ",
        "Volume over area, ED ",
    ] {
        let row = harness.get_by_label_contains(way);
        let said = row.accesskit_node().label().unwrap_or_default();
        assert!(
            said.contains(" mm, ES ") && said.contains(", frame 1 "),
            "{said}"
        );
        let compared = said.contains(" from medial spheres at frame 1 over ");
        assert_eq!(compared, !way.starts_with("Medial"), "{said}");
    }
    // The next frame is measured, too; what was known stays.
    give(
        &mut harness,
        Command::Playback(PlaybackCommand::StepFrame(1)),
    );
    wait_for_row(&mut harness, "Laplace field lines, ED ", ", frame 2 ");
}

/// Waits until a row of the thickness pane tells a pose: poses are measured one after the other, and between one and the
/// next nothing runs.
fn wait_for_row(harness: &mut Harness<'_, App>, way: &str, pose: &str) {
    let begin = Instant::now();
    loop {
        let row = harness.query_by_label_contains(way);
        let said = row.and_then(|row| row.accesskit_node().label());
        if said.is_some_and(|said| said.contains(pose)) {
            break;
        }
        assert!(begin.elapsed() < Duration::from_secs(30), "{way}{pose}");
        harness.step();
        std::thread::sleep(Duration::from_millis(3));
    }
    wait(harness, "all ways", |app| !app.busy());
}

#[test]
fn a_blood_pool_alone_has_neither_medial_map_nor_thickness_and_is_told_why() {
    let (_folder, manifest) = cohort_on_disk();
    let text = std::fs::read_to_string(&manifest).unwrap();
    let hollow: Vec<String> = (text.lines())
        .filter(|line| !line.starts_with("epi"))
        .map(|line| {
            let line = line.replace("surface = \"endo+epi\"", "surface = \"cavity\"");
            match line.strip_prefix("endo") {
                Some(rest) => format!("cavity{rest}"),
                None => line,
            }
        })
        .collect();
    std::fs::write(&manifest, hollow.join("\n")).unwrap();
    let mut harness = window(AppOptions::opening(vec![manifest]));
    wait_for_heart(&mut harness);
    give(
        &mut harness,
        Command::Window(WindowCommand::ShowPane(Pane::MEDIAL_MAP)),
    );
    give(
        &mut harness,
        Command::Window(WindowCommand::ShowPane(Pane::THICKNESS)),
    );
    wait(&mut harness, "rest", |app| !app.busy());
    harness.get_by_label_contains("0 poses of 0 subjects whose wall can be assessed");
    assert!(
        harness
            .get_all_by_label_contains("Not applicable: no wall")
            .count()
            >= 4
    );
}
