//! Deformation maps, the spatiotemporal plot, and their settings: from a click to what every view shows.

use super::*;
use cardiomorph::panes::{EditCommand, MapCommand, PlaybackCommand, WindowCommand, WorkCommand};

use cardiomorph::analysis::deformations::Comparison;
use cardiomorph::analysis::embedding::MapMethod;
use cardiomorph::analysis::metrics::{MetricKind, MetricParams};
use cardiomorph::engine::{PoseMapQuery, Topic};

fn with_deformations() -> Harness<'static, App> {
    let mut harness = mapped_window();
    wait(&mut harness, "deformations and classes", |app| {
        app.state().deformations().is_some() && app.state().classes().is_some() && !app.busy()
    });
    harness.run();
    harness
}

fn shown(harness: &mut Harness<'_, App>, pane: Pane) {
    give(harness, Command::Window(WindowCommand::ShowPane(pane)));
    harness.run();
}

fn subject(harness: &Harness<'_, App>) -> usize {
    harness.state().state().document.subject
}

#[test]
fn every_subject_is_a_point_and_accuracies_stand_beside_the_permutation_mean() {
    let mut harness = with_deformations();
    let state = harness.state().state();
    let map = state.deformations().unwrap();
    assert_eq!(map.subjects.len(), 23);
    assert_eq!(map.embedding.len(), 23);
    assert!(map.embedding.reconstruction_error.is_some());
    let accuracy = state.classes().unwrap().nearest_neighbour.unwrap();
    assert_eq!(accuracy.of, 23);
    let said = format!(
        "Nearest neighbour: {} of 23 · permutation mean",
        accuracy.correct
    );
    shown(&mut harness, Pane::DEFORMATION_MAP);
    harness.get_by_label_contains(&said);
    harness.get_by_label("Deformation of N01, normal");
    harness.get_by_label("Deformation of P14, abnormal");
}

#[test]
fn a_click_on_a_deformation_plays_that_heart() {
    let mut harness = with_deformations();
    shown(&mut harness, Pane::DEFORMATION_MAP);
    // The outermost heart has no neighbour within reach of the click.
    let map = harness.state().state().deformations().unwrap().clone();
    let far = |row: usize| map.embedding.point(row)[0].hypot(map.embedding.point(row)[1]);
    let row = (0..23).max_by(|a, b| far(*a).total_cmp(&far(*b))).unwrap();
    let wanted = map.subjects[row];
    let state = harness.state().state();
    let heart = state.document.study().subjects[wanted].clone();
    let class = cardiomorph::ui::class_name(state.document.study().class_of(&heart));
    let name = format!("Deformation of {}, {class}", heart.id);
    harness.get_by_label(&name).click();
    harness.step();
    harness.step();
    assert_eq!(subject(&harness), wanted);
    assert!(harness.state().state().play.playing);
    wait(&mut harness, "that heart", |app| {
        app.hearts_on_screen().first().map(|heart| heart.0) == Some(wanted)
    });
    give(&mut harness, Command::Playback(PlaybackCommand::TogglePlay));
}

#[test]
fn a_click_on_a_curve_through_time_plays_that_heart() {
    let mut harness = with_deformations();
    shown(&mut harness, Pane::SPATIOTEMPORAL);
    let canvas = harness.get_by_label("Spatiotemporal plot").rect();
    // The uppermost curve at mid-beat is not crossed there by another.
    let study = harness.state().state().document.study().clone();
    let middle = |index: usize| {
        let heart = &study.subjects[index];
        let class = cardiomorph::ui::class_name(study.class_of(heart));
        let name = format!("Curve of {}, {class}", heart.id);
        harness.get_by_label(&name).rect().center()
    };
    let apart = |index: usize| {
        let others = (0..23).filter(|other| *other != index);
        let nearest = others.map(|other| (middle(other) - middle(index)).length());
        nearest.fold(f32::INFINITY, f32::min)
    };
    let lonely = (0..23)
        .max_by(|a, b| apart(*a).total_cmp(&apart(*b)))
        .unwrap();
    let at = middle(lonely);
    assert!(canvas.contains(at));
    click_at(&mut harness, at);
    harness.step();
    assert_eq!(subject(&harness), lonely);
    assert!(harness.state().state().play.playing);
    give(&mut harness, Command::Playback(PlaybackCommand::TogglePlay));
}

#[test]
fn a_changed_setting_keeps_the_old_maps_until_new_ones_move_in_and_undo_takes_it_back() {
    let mut harness = with_deformations();
    let before = harness.state().state().deformations().unwrap().clone();
    let mut settings = harness.state().state().document.deformation_map;
    settings.neighbours = Some(9);
    give(
        &mut harness,
        Command::Map(MapCommand::SetDeformationMap(settings)),
    );
    assert!(
        harness.state().state().deformations().is_some(),
        "the old map stays"
    );
    wait(&mut harness, "another map", |app| {
        app.state().deformations().unwrap().embedding.neighbours == Some(9)
    });
    give(&mut harness, Command::Edit(EditCommand::Undo));
    wait(&mut harness, "the map before", |app| {
        app.state().deformations().unwrap().embedding.neighbours == before.embedding.neighbours
            && !app.busy()
    });
    harness.run();
    let after = harness.state().state().deformations().unwrap().clone();
    for (a, b) in after
        .embedding
        .coordinates
        .iter()
        .zip(&before.embedding.coordinates)
    {
        assert!((a - b).abs() < 1e-6, "the same map lies the same way round");
    }
}

#[test]
fn points_move_to_their_new_places_and_then_rest() {
    let mut harness = with_deformations();
    shown(&mut harness, Pane::DEFORMATION_MAP);
    harness.remove_cursor();
    // The harness has animations switched off, as people can: then points are there at once.
    harness
        .ctx
        .all_styles_mut(|style| style.animation_time = 0.12);
    let places = |harness: &Harness<'_, App>| -> Vec<egui::Pos2> {
        let hearts = harness.get_all_by_label_contains("Deformation of ");
        hearts.map(|heart| heart.rect().center()).collect()
    };
    let delay = |harness: &Harness<'_, App>| {
        harness.output().viewport_output[&egui::ViewportId::ROOT].repaint_delay
    };
    let before = places(&harness);
    let shown_before = harness.state().state().deformations().unwrap().clone();
    let mut settings = harness.state().state().document.deformation_map;
    settings.neighbours = Some(4);
    harness
        .state_mut()
        .push(Command::Map(MapCommand::SetDeformationMap(settings)));
    let begin = Instant::now();
    while harness.state().state().deformations() == Some(&shown_before) {
        assert!(begin.elapsed() < Duration::from_secs(30), "no other map");
        harness.step();
    }
    let mut seen = vec![places(&harness)];
    for _ in 0..15 {
        harness.step();
        seen.push(places(&harness));
    }
    // The heart that goes farthest is the one to watch.
    let far = |heart: usize| (seen[15][heart] - seen[0][heart]).length();
    let heart = (0..before.len())
        .max_by(|a, b| far(*a).total_cmp(&far(*b)))
        .unwrap();
    let seen: Vec<egui::Pos2> = seen.iter().map(|places| places[heart]).collect();
    let (start, end) = (seen[0], seen[15]);
    assert!(far(heart) > 10.0, "another neighbourhood is another map");
    assert!(
        (start - before[heart]).length() < (start - end).length(),
        "points set out from about where they were"
    );
    let between = seen
        .iter()
        .filter(|at| (**at - start).length() > 0.2 && (**at - end).length() > 0.2)
        .count();
    assert!(between >= 3, "the way is seen, not only its ends: {seen:?}");
    wait(&mut harness, "rest", |app| !app.busy());
    harness.run();
    harness.step();
    assert_eq!(
        delay(&harness),
        Duration::MAX,
        "a map at rest asks for no repaint"
    );
}

#[test]
fn the_panel_changes_the_metric_and_the_way_back_is_one_undo() {
    let mut harness = with_deformations();
    shown(&mut harness, Pane::METRIC);
    harness.get_by_label("Kind: Displacement").click();
    harness.run();
    harness.get_by_label("Quasi-conformal").click();
    harness.run_steps(3);
    let kind =
        |harness: &Harness<'_, App>| harness.state().state().document.map.distances.metric.kind;
    assert_eq!(kind(&harness), MetricKind::QuasiConformal);
    harness.get_by_label_contains("Quasi-conformal: ignores position, rotation");
    wait(&mut harness, "the shares", |app| !app.busy());
    harness.run();
    harness.get_by_label_contains("end-diastole to end-systole: change of angles");
    give(&mut harness, Command::Map(MapCommand::ResetMaps));
    assert_eq!(kind(&harness), MetricKind::Displacement);
    give(&mut harness, Command::Edit(EditCommand::Undo));
    assert_eq!(kind(&harness), MetricKind::QuasiConformal);
    // The palette reaches both without the panel.
    give(
        &mut harness,
        Command::Map(MapCommand::SetMetric(MetricKind::Isometric)),
    );
    assert_eq!(kind(&harness), MetricKind::Isometric);
    give(
        &mut harness,
        Command::Map(MapCommand::SetMapMethod(MapMethod::ISOMAP)),
    );
    wait(&mut harness, "the map by Isomap", |app| !app.busy());
    assert_eq!(
        harness.state().state().document.map.method,
        MapMethod::ISOMAP
    );
}

#[test]
fn three_hearts_have_no_deformation_map_and_are_told_so() {
    let (_folder, manifest) = cohort_on_disk();
    let text = std::fs::read_to_string(&manifest).unwrap();
    let parts: Vec<&str> = text.split("[[subject]]").collect();
    std::fs::write(&manifest, parts[..4].join("[[subject]]")).unwrap();
    let mut harness = window(AppOptions::opening(vec![manifest]));
    wait_for_heart(&mut harness);
    wait(&mut harness, "the map", |app| {
        app.state().map().is_some() && !app.busy()
    });
    assert_eq!(harness.state().state().document.study().subjects.len(), 3);
    shown(&mut harness, Pane::DEFORMATION_MAP);
    harness.get_by_label("A deformation map needs at least 4 subjects, and there are 3");
    assert!(harness.state().state().errors.is_empty());
}

#[test]
fn a_stopped_map_of_poses_stops_the_map_of_deformations_and_both_come_back() {
    let mut harness = window(AppOptions::built_in(BuiltInParams {
        vertices: 2_500,
        ..BuiltInParams::default()
    }));
    // Curves of poses stand on the pose map; where deformations are compared, their map needs none.
    give(
        &mut harness,
        Command::Map(MapCommand::SetComparison(Comparison::Poses)),
    );
    wait(&mut harness, "the map", |app| {
        app.state().deformations().is_some() && !app.busy()
    });
    shown(&mut harness, Pane::DEFORMATION_MAP);
    let before = harness.state().state().deformations().unwrap().clone();
    let mut other = harness.state().state().document.map;
    other.distances.metric = MetricParams::of(MetricKind::QuasiConformal);
    give(&mut harness, Command::Map(MapCommand::SetPoseMap(other)));
    assert!(harness.state().busy());
    harness.get_by_label("Deformation of N01, normal");
    give(
        &mut harness,
        Command::Work(WorkCommand::Cancel(Topic::of::<PoseMapQuery>())),
    );
    wait(&mut harness, "the end of the work", |app| !app.busy());
    harness.get_by_label("Stopped; the previous map is shown");
    assert_eq!(harness.state().state().deformations(), Some(&before));
    harness.get_by_label("Retry").click();
    harness.step();
    wait(&mut harness, "the new map", |app| {
        !app.busy() && app.state().deformations() != Some(&before)
    });
    harness.run();
    assert!(
        harness
            .query_by_label("Stopped; the previous map is shown")
            .is_none()
    );
}

#[test]
fn tabs_of_the_maps_come_to_the_front_from_the_palette() {
    let mut harness = with_deformations();
    harness.get_by_label("Pose map");
    harness.key_press_modifiers(egui::Modifiers::COMMAND, egui::Key::K);
    harness.run_steps(4);
    harness.event(egui::Event::Text("deformation map".to_owned()));
    harness.run_steps(4);
    harness.key_press(egui::Key::Enter);
    harness.run_steps(6);
    harness.get_by_label("Deformation map");
    assert!(harness.query_by_label("Pose map").is_none());
    assert!(!harness.state().state().sheets.palette);
}
