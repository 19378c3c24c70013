//! The part of the cycle that plays, estimated poses on empty ground, classes, and names for who cannot see the window.

use cardiomorph::engine::ClassesBy;
use cardiomorph::panes::{EditCommand, MapCommand, PlaybackCommand, SelectCommand, WindowCommand};
use egui::{Event, Modifiers};

use super::*;

fn shift(harness: &mut Harness<'_, App>, modifiers: Modifiers) {
    harness.event(Event::ModifiersChanged(modifiers));
    harness.step();
}

#[test]
fn a_loop_plays_between_two_frames_and_undo_takes_it_back() {
    let mut harness = cohort_window();
    give(
        &mut harness,
        Command::Playback(PlaybackCommand::SetPosition(2.0)),
    );
    harness.key_press(egui::Key::OpenBracket);
    harness.run_steps(3);
    give(
        &mut harness,
        Command::Playback(PlaybackCommand::SetPosition(5.0)),
    );
    harness.key_press(egui::Key::CloseBracket);
    harness.run_steps(3);
    let frames = |harness: &Harness<'_, App>| harness.state().state().document.loop_frames();
    assert_eq!(frames(&harness), Some([2, 5]));
    harness.get_by_label("Start of the loop");
    give(
        &mut harness,
        Command::Playback(PlaybackCommand::SetSpeed(4.0)),
    );
    give(&mut harness, Command::Playback(PlaybackCommand::TogglePlay));
    let mut seen = Vec::new();
    for _ in 0..60 {
        harness.step();
        seen.push(harness.state().state().document.position);
    }
    assert!(seen.iter().all(|at| (2.0..5.0).contains(at)), "{seen:?}");
    assert!(
        seen.windows(2).any(|pair| pair[1] < pair[0]),
        "it starts over"
    );
    give(&mut harness, Command::Playback(PlaybackCommand::TogglePlay));
    // The same phases of a subject, and nothing that the next study knows.
    give(
        &mut harness,
        Command::Select(SelectCommand::SelectSubject(4)),
    );
    assert_eq!(frames(&harness), Some([2, 5]));
    harness.key_press(egui::Key::Escape);
    harness.run_steps(3);
    assert_eq!(frames(&harness), None);
    give(&mut harness, Command::Edit(EditCommand::Undo));
    assert_eq!(frames(&harness), Some([2, 5]));
    give(&mut harness, Command::Edit(EditCommand::Redo));
    assert_eq!(frames(&harness), None);
}

#[test]
fn esc_leaves_the_filter_before_it_ends_the_loop() {
    let mut harness = cohort_window();
    give(
        &mut harness,
        Command::Playback(PlaybackCommand::SetLoopRange(Some([1, 4]))),
    );
    let filter = cardiomorph::panes::ViewCommand::SetSearch("N".to_owned());
    give(&mut harness, Command::View(filter));
    harness.key_press(egui::Key::Escape);
    harness.run_steps(3);
    let document = &harness.state().state().document;
    assert!(document.search.is_empty() && document.loop_frames() == Some([1, 4]));
    harness.key_press(egui::Key::Escape);
    harness.run_steps(3);
    assert_eq!(harness.state().state().document.loop_frames(), None);
}

/// A place on the pose map with no point within reach, near its middle.
fn empty_ground(harness: &Harness<'_, App>) -> egui::Pos2 {
    let map = harness.state().state().map().unwrap().clone();
    let points: Vec<egui::Pos2> = (0..map.embedding.len())
        .map(|row| place_of_row(harness, "Pose map", &map.embedding, row))
        .collect();
    let rect = harness.get_by_label("Pose map").rect();
    let nearest = |at: egui::Pos2| {
        let apart = points.iter().map(|point| (*point - at).length());
        apart.fold(f32::INFINITY, f32::min)
    };
    let grid = (0..400).map(|index| {
        let share = egui::vec2((index % 20) as f32, (index / 20) as f32) / 19.0;
        rect.shrink2(0.25 * rect.size()).lerp_inside(share)
    });
    grid.filter(|at| nearest(*at) > 16.0)
        .min_by(|a, b| {
            let far = |at: &egui::Pos2| (*at - rect.center()).length();
            far(a).total_cmp(&far(b))
        })
        .unwrap()
}

#[test]
fn shift_over_empty_ground_shows_an_estimated_pose_and_letting_go_brings_the_subject_back() {
    let mut harness = mapped_window();
    let at = empty_ground(&harness);
    let document = harness.state().state().document.clone();
    harness.hover_at(at);
    harness.step();
    assert!(harness.state().state().estimate_at.is_none());
    shift(&mut harness, Modifiers::SHIFT);
    wait(&mut harness, "an estimated pose", |app| {
        app.state().estimate().is_some()
    });
    let pose = harness.state().state().estimate().unwrap().clone();
    let count = pose.sources.len();
    assert!((2..=4).contains(&count));
    let sum: f64 = pose.sources.iter().map(|(_, weight)| weight).sum();
    assert!((sum - 1.0).abs() < 1e-9);
    wait(&mut harness, "its picture", |app| {
        app.hearts_on_screen() == [(0, 1.0)]
    });
    harness.get_by_label(&format!("estimated from {count} poses"));
    harness.get_by_label("Estimated pose");
    // The map does not move under a drag, and the pose follows the pointer.
    harness.drag_at(at);
    harness.step();
    harness.hover_at(at + egui::vec2(9.0, 0.0));
    harness.step();
    harness.step();
    let moved = harness.state().state().estimate_at.unwrap();
    assert!(moved != pose.at);
    harness.event(Event::PointerButton {
        pos: at + egui::vec2(9.0, 0.0),
        button: egui::PointerButton::Primary,
        pressed: false,
        modifiers: Modifiers::SHIFT,
    });
    harness.step();
    shift(&mut harness, Modifiers::NONE);
    harness.run_steps(3);
    assert!(harness.state().state().estimate_at.is_none());
    wait(&mut harness, "the subject", |app| {
        app.hearts_on_screen() == [(0, 0.0)]
    });
    assert!(harness.query_by_label("Estimated pose").is_none());
    let state = harness.state().state();
    assert_eq!(
        state.document, document,
        "nothing was changed, and there is nothing to undo"
    );
    assert!(!state.history.can_undo());
}

#[test]
fn a_press_that_is_held_estimates_and_a_click_or_a_drag_does_not() {
    let mut harness = mapped_window();
    let at = empty_ground(&harness);
    click_at(&mut harness, at);
    harness.run_steps(3);
    assert!(harness.state().state().estimate_at.is_none(), "a click");
    harness.hover_at(at);
    harness.drag_at(at);
    harness.step();
    harness.hover_at(at + egui::vec2(20.0, 4.0));
    for _ in 0..30 {
        harness.step();
    }
    assert!(harness.state().state().estimate_at.is_none(), "a drag");
    harness.drop_at(at + egui::vec2(20.0, 4.0));
    harness.run_steps(3);
    harness.hover_at(at);
    harness.step();
    harness.drag_at(at);
    for _ in 0..20 {
        harness.step();
    }
    wait(&mut harness, "an estimated pose", |app| {
        app.state().estimate().is_some()
    });
    harness.drop_at(at);
    harness.run_steps(3);
    assert!(harness.state().state().estimate_at.is_none(), "let go");
}

#[test]
fn far_from_all_poses_the_window_says_why_nothing_is_estimated() {
    let mut harness = mapped_window();
    let rect = harness.get_by_label("Pose map").rect();
    harness.hover_at(rect.left_top() + egui::vec2(4.0, 4.0));
    shift(&mut harness, Modifiers::SHIFT);
    wait(&mut harness, "a refusal", |app| {
        app.state().without_estimate().is_some()
    });
    harness.get_by_label_contains("outside of all points of the map");
    assert!(harness.state().state().estimate().is_none());
    assert_eq!(harness.state().hearts_on_screen(), [(0, 0.0)]);
    shift(&mut harness, Modifiers::NONE);
    harness.run_steps(3);
    assert!(harness.state().state().without_estimate().is_none());
}

#[test]
fn classes_are_told_apart_by_label_or_by_what_the_study_calls_normal() {
    let (_folder, manifest) = cohort_on_disk();
    // A third label: P01 to P07 are infarctions, which the study calls abnormal, too.
    let text = std::fs::read_to_string(&manifest).unwrap();
    let mut abnormal = 0;
    let lines = text.lines().map(|line| {
        if line.trim() == r#"label = "abnormal""# {
            abnormal += 1;
            if abnormal % 2 == 0 {
                return r#"label = "MINF""#.to_owned();
            }
        }
        line.to_owned()
    });
    let text: Vec<String> = lines.collect();
    let mut text = text.join("\n");
    assert!(abnormal > 4, "{text}");
    // Roles stand before the first subject.
    text = text.replace(
        r#"abnormal = ["abnormal"]"#,
        r#"abnormal = ["abnormal", "MINF"]"#,
    );
    assert!(text.contains(r#""MINF"]"#), "{text}");
    std::fs::write(&manifest, &text).unwrap();
    let mut harness = window(AppOptions::opening(vec![manifest]));
    wait_for_heart(&mut harness);
    give(
        &mut harness,
        Command::Window(WindowCommand::ShowPane(Pane::DEFORMATION_MAP)),
    );
    wait(&mut harness, "classes", |app| {
        app.state().classes().is_some() && !app.busy()
    });
    let by_label = harness.state().state().classes().unwrap().clone();
    assert_eq!(by_label.names.len(), 3, "{text}");
    harness.get_by_label("Classes: by label");
    let chosen = MapCommand::SetClassesBy(ClassesBy::Class);
    give(&mut harness, Command::Map(chosen));
    wait(&mut harness, "normal and abnormal", |app| {
        app.state()
            .classes()
            .is_some_and(|classes| classes.names.len() == 2)
            && !app.busy()
    });
    harness.run();
    harness.get_by_label("Classes: normal and abnormal");
    give(&mut harness, Command::Edit(EditCommand::Undo));
    wait(&mut harness, "labels again", |app| {
        app.state()
            .classes()
            .is_some_and(|classes| classes.names.len() == 3)
    });
}

#[test]
fn rows_points_segments_tabs_and_the_time_have_names() {
    let mut harness = mapped_window();
    // A row of the table, and what its verdict is.
    let row = egui::accesskit::Role::ListBoxOption;
    harness.get_by_role_and_label(row, "N01");
    harness.get_by_label_contains("N01 · frame 0, 0 % R-R · end-diastole");
    harness.get_by_label("Position in the cardiac cycle");
    for tab in ["Cohort", "Poses", "Deformations", "Verdict", "Bull's-eye"] {
        let tabs = harness.get_all_by_role_and_label(egui::accesskit::Role::Tab, tab);
        assert_eq!(tabs.count(), 1, "{tab}");
    }
    // A reader asks to click a point: what a click does.
    let point = harness.get_by_label_contains("P05 · frame 3,");
    point.click_accesskit();
    harness.run_steps(3);
    let document = &harness.state().state().document;
    assert_eq!(document.selected().unwrap().id, "P05");
    give(&mut harness, Command::Playback(PlaybackCommand::TogglePlay));
    give(
        &mut harness,
        Command::Window(WindowCommand::ShowPane(Pane::BULLS_EYE)),
    );
    wait(&mut harness, "the wall", |app| {
        app.state().wall_of(13).is_some() && !app.busy()
    });
    harness.run();
    let segment = harness.get_by_label_contains("12 mid anterolateral");
    segment.click_accesskit();
    harness.run_steps(3);
    assert!(harness.state().state().document.part.is_some());
}
