//! The window driven with no display: what a person does, and what must follow in every view.

#[cfg(test)]
mod around;
#[cfg(test)]
mod beats;
#[cfg(test)]
mod early_figures;
#[cfg(test)]
mod edited_studies;
#[cfg(test)]
mod editing;
#[cfg(test)]
mod faults;
#[cfg(test)]
mod figure_looks;
#[cfg(test)]
mod figures;
#[cfg(test)]
mod ground;
#[cfg(test)]
mod images;
#[cfg(test)]
mod maps;
#[cfg(test)]
mod medial;
#[cfg(test)]
mod pictures;
#[cfg(test)]
mod reading;
#[cfg(test)]
mod reading_figures;
#[cfg(test)]
mod typed_paths;
#[cfg(test)]
mod verdicts;
#[cfg(test)]
mod walls;

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant};

use cardiomorph::analysis::embedding::Embedding;
use cardiomorph::analysis::metrics::{MetricKind, MetricParams};
use cardiomorph::app::{App, AppOptions};
use cardiomorph::document::ViewMode;
use cardiomorph::engine::{PoseMapQuery, Topic};
use cardiomorph::panes::{Command, MapCommand, Pane, PlaybackCommand, SelectCommand, WorkCommand};
use cardiomorph::study::built_in::BuiltInParams;
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT, Queryable};

/// A cohort that is made and mapped quickly: the fewest vertices that make a heart.
fn small() -> BuiltInParams {
    BuiltInParams {
        vertices: 400,
        ..BuiltInParams::default()
    }
}

fn window(options: AppOptions) -> Harness<'static, App> {
    Harness::builder()
        .with_size([1400.0, 900.0])
        .with_max_steps(64)
        .with_step_dt(1.0 / 30.0)
        .build_eframe(move |cc| App::new(cc, options).unwrap())
}

/// Steps until `done`; fails after half a minute, which is long even for a busy machine.
fn wait(harness: &mut Harness<'_, App>, what: &str, done: impl Fn(&App) -> bool) {
    wait_up_to(30, harness, what, done);
    harness.run_steps(2);
}

/// Steps until `done`; fails after so many seconds.
fn wait_up_to(
    limit_s: u64,
    harness: &mut Harness<'_, App>,
    what: &str,
    done: impl Fn(&App) -> bool,
) {
    let begin = Instant::now();
    while !done(harness.state()) {
        assert!(
            begin.elapsed() < Duration::from_secs(limit_s),
            "waited for {what}"
        );
        harness.step();
        std::thread::sleep(Duration::from_millis(3));
    }
}

fn wait_for_heart(harness: &mut Harness<'_, App>) {
    wait(harness, "a heart on screen", |app| {
        !app.hearts_on_screen().is_empty() && app.state().measures().is_some()
    });
}

fn cohort_window() -> Harness<'static, App> {
    let mut harness = window(AppOptions::built_in(small()));
    wait_for_heart(&mut harness);
    harness
}

fn mapped_window() -> Harness<'static, App> {
    let mut harness = cohort_window();
    wait(&mut harness, "the map", |app| {
        app.state().map().is_some() && !app.busy()
    });
    harness.run();
    harness
}

/// A file let go over the window.
#[derive(Debug)]
struct Dropped(PathBuf);

impl egui::DroppedFile for Dropped {
    fn path(&self) -> &Path {
        &self.0
    }

    fn bytes(&self) -> Result<Vec<u8>, String> {
        std::fs::read(&self.0).map_err(|error| error.to_string())
    }
}

fn give(harness: &mut Harness<'_, App>, command: Command) {
    harness.state_mut().push(command);
    harness.run_steps(2);
}

/// The screen position of a pose on the map, by the lens that the map begins with.
fn place_on_map(harness: &Harness<'_, App>, subject: usize, frame: usize) -> egui::Pos2 {
    let map = harness.state().state().map().unwrap().clone();
    let poses = map.distances.poses.iter();
    let row = poses
        .map(|pose| (pose.subject, pose.frame))
        .position(|pose| pose == (subject, frame));
    place_of_row(harness, "Pose map", &map.embedding, row.unwrap())
}

/// The screen position of a row of a map, by the lens that maps begin with: all points fit.
fn place_of_row(harness: &Harness<'_, App>, name: &str, map: &Embedding, row: usize) -> egui::Pos2 {
    let rect = harness.get_by_label(name).rect();
    let points: Vec<[f64; 2]> = (0..map.len())
        .map(|row| [map.point(row)[0], map.point(row)[1]])
        .collect();
    let bound = |axis: usize, pick: fn(f64, f64) -> f64, start: f64| {
        points.iter().map(|point| point[axis]).fold(start, pick)
    };
    let low = [0, 1].map(|axis| bound(axis, f64::min, f64::INFINITY));
    let high = [0, 1].map(|axis| bound(axis, f64::max, f64::NEG_INFINITY));
    let plot = rect.shrink2(egui::vec2(34.0, 26.0));
    let scale = (f64::from(plot.width()) / (high[0] - low[0]))
        .min(f64::from(plot.height()) / (high[1] - low[1]));
    let offset = [0, 1].map(|axis| points[row][axis] - 0.5 * (low[axis] + high[axis]));
    rect.center() + egui::vec2((offset[0] * scale) as f32, (-offset[1] * scale) as f32)
}

/// The built-in cohort in a folder, and its manifest.
fn cohort_on_disk() -> (tempfile::TempDir, PathBuf) {
    let folder = written_cohort(&["--vertices", "400"]);
    let manifest = folder.path().join("study.toml");
    (folder, manifest)
}

/// The built-in cohort in a folder of its own, as text files large enough to be shown while they are read.
fn large_cohort_on_disk() -> tempfile::TempDir {
    written_cohort(&["--vertices", "4000", "--format", "obj"])
}

fn written_cohort(options: &[&str]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let status = std::process::Command::new(env!("CARGO_BIN_EXE_cardiomorph"))
        .args(["demo", "--out"])
        .arg(folder.path())
        .args(options)
        .status()
        .unwrap();
    assert!(status.success());
    folder
}

fn click_at(harness: &mut Harness<'_, App>, at: egui::Pos2) {
    harness.hover_at(at);
    harness.step();
    harness.drag_at(at);
    harness.step();
    harness.drop_at(at);
    harness.step();
}

#[test]
fn the_built_in_cohort_opens_and_is_measured_and_mapped() {
    let mut harness = mapped_window();
    let state = harness.state().state();
    assert_eq!(state.document.study().subjects.len(), 23);
    assert_eq!(state.measures().unwrap().len(), 23);
    assert_eq!(state.map().unwrap().embedding.len(), 184);
    let normal = state.measures_of(0).unwrap().ef.unwrap();
    assert!(
        (0.5..0.75).contains(&normal),
        "a normal heart has EF {normal}"
    );
    assert!(state.errors.is_empty(), "{:?}", state.errors);
    harness.run();
    assert!(
        harness.get_all_by_label("N01").count() >= 1,
        "the table names it"
    );
    harness.get_by_label("3D viewport");
}

#[test]
fn a_click_on_the_map_is_followed_by_table_picture_and_time_bar() {
    let mut harness = mapped_window();
    // The outermost pose of the map has no neighbour within reach of the click.
    let map = harness.state().state().map().unwrap().clone();
    let outermost = (0..map.embedding.len())
        .max_by(|a, b| {
            let far = |row: usize| {
                let point = map.embedding.point(row);
                point[0].hypot(point[1])
            };
            far(*a).total_cmp(&far(*b))
        })
        .unwrap();
    let pose = map.distances.poses[outermost];
    let at = place_on_map(&harness, pose.subject, pose.frame);
    click_at(&mut harness, at);
    harness.step();
    let state = harness.state().state();
    assert_eq!(state.document.subject, pose.subject);
    assert!(state.play.playing, "a click on the map plays that heart");
    let began = state.document.position;
    assert!((began - pose.frame as f64).abs() < 0.5, "began at {began}");
    wait(&mut harness, "that heart", |app| {
        app.hearts_on_screen().first().map(|heart| heart.0) == Some(pose.subject)
    });
    give(&mut harness, Command::Playback(PlaybackCommand::TogglePlay));
    harness.run();
    let position = harness.state().state().document.position;
    assert_eq!(
        harness.state().hearts_on_screen(),
        [(pose.subject, position)]
    );
    let id = harness
        .state()
        .state()
        .document
        .selected()
        .unwrap()
        .id
        .clone();
    let row = harness
        .get_all_by_label(&id)
        .find(|node| node.accesskit_node().toggled() == Some(egui::accesskit::Toggled::True));
    assert!(row.is_some(), "the row of {id} is selected");
}

#[test]
fn a_point_is_shown_within_one_frame_when_its_heart_is_ready() {
    let mut harness = mapped_window();
    give(&mut harness, SelectCommand::SelectSubject(4).into());
    wait(&mut harness, "the fifth heart", |app| {
        app.hearts_on_screen()[0].0 == 4
    });
    give(&mut harness, SelectCommand::SelectSubject(0).into());
    harness
        .state_mut()
        .push(Command::Select(SelectCommand::SelectPose {
            subject: 4,
            frame: 3,
            play: false,
        }));
    harness.step();
    assert_eq!(harness.state().hearts_on_screen(), [(4, 3.0)]);
}

#[test]
fn a_drag_turns_the_heart_and_one_undo_takes_it_back() {
    let mut harness = cohort_window();
    harness.run();
    let before = harness.state().state().document.viewpoint;
    let centre = harness.get_by_label("3D viewport").rect().center();
    harness.hover_at(centre);
    harness.step();
    harness.drag_at(centre);
    harness.step();
    for step in 1..=5 {
        harness.hover_at(centre + egui::vec2(12.0 * step as f32, 4.0 * step as f32));
        harness.step();
    }
    harness.drop_at(centre + egui::vec2(60.0, 20.0));
    harness.step();
    harness.step();
    let turned = harness.state().state().document.viewpoint;
    assert_ne!(turned, before);
    harness.key_press_modifiers(egui::Modifiers::COMMAND, egui::Key::Z);
    harness.step();
    harness.step();
    assert_eq!(harness.state().state().document.viewpoint, before);
    assert!(!harness.state().state().history.can_undo());
    harness.key_press_modifiers(
        egui::Modifiers::COMMAND | egui::Modifiers::SHIFT,
        egui::Key::Z,
    );
    harness.step();
    harness.step();
    assert_eq!(harness.state().state().document.viewpoint, turned);
}

#[test]
fn the_wheel_zooms_and_a_double_click_fits_again() {
    let mut harness = cohort_window();
    harness.run();
    let centre = harness.get_by_label("3D viewport").rect().center();
    harness.hover_at(centre);
    harness.step();
    harness.event(egui::Event::MouseWheel {
        unit: egui::MouseWheelUnit::Point,
        delta: egui::vec2(0.0, 60.0),
        phase: egui::TouchPhase::Move,
        source: egui::MouseWheelSource::Wheel,
        modifiers: egui::Modifiers::NONE,
    });
    harness.run_steps(20);
    let zoomed = harness.state().state().document.viewpoint.half_height;
    assert!(zoomed.is_some());
    click_at(&mut harness, centre);
    click_at(&mut harness, centre);
    harness.step();
    assert_eq!(harness.state().state().document.viewpoint.half_height, None);
}

#[test]
fn space_plays_and_pauses_whatever_was_clicked_before() {
    let mut harness = cohort_window();
    harness.run();
    let row = harness.get_by_label("N03").rect().center();
    click_at(&mut harness, row);
    harness.step();
    assert_eq!(harness.state().state().document.subject, 2);
    harness.key_press(egui::Key::Space);
    harness.run_steps(5);
    assert!(harness.state().state().play.playing);
    let position = harness.state().state().document.position;
    assert!(position > 0.0, "the beat moves on");
    harness.key_press(egui::Key::Space);
    harness.run_steps(3);
    assert!(!harness.state().state().play.playing);
    let position = harness.state().state().document.position;
    harness.run_steps(3);
    assert_eq!(harness.state().state().document.position, position);
}

#[test]
fn an_idle_window_asks_for_no_repaint() {
    let mut harness = mapped_window();
    harness.remove_cursor();
    harness.run();
    for _ in 0..3 {
        harness.step();
        let delay = harness.output().viewport_output[&egui::ViewportId::ROOT].repaint_delay;
        assert_eq!(delay, Duration::MAX, "an idle window waits for events");
    }
}

#[test]
fn a_running_map_can_be_cancelled_and_asked_for_again() {
    // So many vertices that the map takes half a second, whatever the machine.
    let mut harness = window(AppOptions::built_in(BuiltInParams {
        vertices: 3_000,
        ..BuiltInParams::default()
    }));
    wait(&mut harness, "the map", |app| {
        app.state().map().is_some() && !app.busy()
    });
    let before = harness.state().state().map().unwrap().clone();
    let mut other = harness.state().state().document.map;
    other.distances.metric = MetricParams::of(MetricKind::QuasiConformal);
    harness
        .state_mut()
        .push(Command::Map(MapCommand::SetPoseMap(other)));
    harness.run_steps(2);
    assert!(harness.state().busy(), "other settings make another map");
    harness.state_mut().push(Command::Work(WorkCommand::Cancel(
        Topic::of::<PoseMapQuery>(),
    )));
    wait(&mut harness, "the end of the work", |app| !app.busy());
    assert_eq!(harness.state().state().map(), Some(&before));
    assert!(harness.state().state().errors.is_empty());
    harness.state_mut().push(Command::Work(WorkCommand::Retry(
        Topic::of::<PoseMapQuery>(),
    )));
    harness.run_steps(2);
    assert!(harness.state().busy(), "asked for again, it runs again");
}
