//! Pictures of the main window in both themes, compared with golden ones.
//!
//! The referee is Mesa's software Vulkan driver (llvmpipe), on which pictures are the same bit for
//! bit. On any other adapter the comparison is wide: it sees a missing heart or pane, not a pixel.
//! Record again with `UPDATE_SNAPSHOTS=1 cargo test --test it golden`, and look at the result.

use std::io::Write;
use std::time::{Duration, Instant};

use cardiomorph::analysis::segments::Segment;
use cardiomorph::app::{App, AppOptions};
use cardiomorph::picture::{BullsEyeQuantity, Quantity, WallPart};
use cardiomorph::render::Headless;
use cardiomorph::study::built_in::BuiltInParams;
use cardiomorph::ui::{Command, Pane, ThemeChoice, ViewMode};
use egui_kittest::{Harness, SnapshotOptions};

/// The adapter that pictures are drawn with; `None`, with a message, if there is none.
fn adapter() -> Option<String> {
    match Headless::new() {
        Ok(headless) => Some(headless.adapter_name().to_owned()),
        Err(error) => {
            writeln!(std::io::stderr(), "golden pictures are skipped: {error}").ok();
            None
        }
    }
}

fn tolerance(adapter: &str) -> SnapshotOptions {
    if adapter.contains("llvmpipe") {
        // Text is the same everywhere; edges of 3D surfaces may move by a rounding between
        // versions of the driver.
        SnapshotOptions::new().threshold(0.6).max_failed_pixels(60)
    } else {
        writeln!(
            std::io::stderr(),
            "golden pictures are compared loosely: {adapter} is not the referee"
        )
        .ok();
        SnapshotOptions::new()
            .threshold(6.0)
            .max_failed_pixels(60_000)
    }
}

fn compare(name: &str, theme: ThemeChoice, mode: ViewMode, in_front: &[Pane]) {
    let mut commands = vec![Command::SetViewMode(mode)];
    commands.extend(in_front.iter().map(|pane| Command::ShowPane(*pane)));
    compare_after(name, theme, commands, |_| true);
}

/// Compares the window after these commands, once `ready` says that their results are there.
fn compare_after(
    name: &str,
    theme: ThemeChoice,
    commands: Vec<Command>,
    ready: impl Fn(&App) -> bool,
) {
    let Some(adapter) = adapter() else {
        return;
    };
    let options = AppOptions::built_in(BuiltInParams {
        vertices: 1_000,
        ..BuiltInParams::default()
    });
    let mut harness: Harness<'_, App> = Harness::builder()
        .with_size([1280.0, 800.0])
        .with_max_steps(64)
        .with_options(tolerance(&adapter))
        .wgpu()
        .build_eframe(move |cc| App::new(cc, options).unwrap());
    harness.state_mut().push(Command::SetTheme(theme));
    let begin = Instant::now();
    while harness.state().state().classes().is_none()
        || harness.state().hearts_on_screen().is_empty()
        || harness.state().busy()
    {
        assert!(begin.elapsed() < Duration::from_secs(60), "no map");
        harness.step();
        std::thread::sleep(Duration::from_millis(5));
    }
    harness.state_mut().push(Command::SelectPose {
        subject: 11,
        frame: 3,
        play: false,
    });
    for command in commands {
        harness.state_mut().push(command);
    }
    harness.remove_cursor();
    harness.run_steps(4);
    while harness.state().busy()
        || harness.state().hearts_on_screen()[0].0 != 11
        || !ready(harness.state())
    {
        assert!(begin.elapsed() < Duration::from_secs(60), "no heart");
        harness.step();
        std::thread::sleep(Duration::from_millis(5));
    }
    harness.run();
    harness.snapshot(name);
}

#[test]
fn the_dark_window_looks_as_it_did() {
    compare("window_dark", ThemeChoice::Dark, ViewMode::Single, &[]);
}

#[test]
fn the_light_window_looks_as_it_did() {
    compare(
        "window_light",
        ThemeChoice::Light,
        ViewMode::SideBySide,
        &[],
    );
}

const DEFORMATIONS: [Pane; 2] = [Pane::DeformationMap, Pane::Metric];

#[test]
fn deformations_and_settings_look_as_they_did_in_the_light_window() {
    let (light, mode) = (ThemeChoice::Light, ViewMode::SideBySide);
    compare("deformations_light", light, mode, &DEFORMATIONS);
}

#[test]
fn deformations_and_settings_look_as_they_did_in_the_dark_window() {
    let (dark, mode) = (ThemeChoice::Dark, ViewMode::Single);
    compare("deformations_dark", dark, mode, &DEFORMATIONS);
}

#[test]
fn poses_through_time_look_as_they_did_in_the_dark_window() {
    let (dark, mode) = (ThemeChoice::Dark, ViewMode::SideBySide);
    compare("space_time_dark", dark, mode, &[Pane::SpaceTime]);
}

#[test]
fn poses_through_time_look_as_they_did_in_the_light_window() {
    let (light, mode) = (ThemeChoice::Light, ViewMode::Single);
    compare("space_time_light", light, mode, &[Pane::SpaceTime]);
}

fn wall_is_known(app: &App) -> bool {
    matches!(app.state().wall_of(11), Some((Ok(_), true)))
}

#[test]
fn atoms_and_a_patch_look_as_they_did_in_the_dark_window() {
    let commands = vec![
        Command::ToggleAtoms,
        Command::SelectPart(Some(WallPart::Patch(0))),
        Command::ShowPane(Pane::Patch),
        Command::ShowPane(Pane::BullsEye),
    ];
    compare_after("atoms_dark", ThemeChoice::Dark, commands, wall_is_known);
}

#[test]
fn a_verdict_looks_as_it_did_in_the_dark_window() {
    compare_verdict("verdict_dark", ThemeChoice::Dark);
}

#[test]
fn a_verdict_looks_as_it_did_in_the_light_window() {
    compare_verdict("verdict_light", ThemeChoice::Light);
}

fn compare_verdict(name: &str, theme: ThemeChoice) {
    let commands = vec![
        Command::ShowPane(Pane::Verdict),
        Command::ShowPane(Pane::BullsEye),
    ];
    compare_after(name, theme, commands, |app| {
        wall_is_known(app) && matches!(app.state().verdicts(), Some((_, true)))
    });
}

#[test]
fn the_thickness_ratio_and_a_segment_look_as_they_did_in_the_light_window() {
    let segment = Segment::new(8).unwrap();
    let commands = vec![
        Command::SetQuantity(Quantity::ThicknessRatio),
        Command::ToggleBullsEyeSegments,
        Command::SetBullsEye(BullsEyeQuantity::Thickening),
        Command::SelectPart(Some(WallPart::Segment(segment))),
        Command::ShowPane(Pane::Patch),
        Command::ShowPane(Pane::BullsEye),
    ];
    let light = ThemeChoice::Light;
    compare_after("thickness_light", light, commands, wall_is_known);
}

#[test]
fn a_carried_beat_looks_as_it_did() {
    let commands = vec![
        Command::TransportMotion { from: 11, onto: 2 },
        Command::TogglePlay,
        Command::SetPosition(3.5),
    ];
    compare_after("carried_beat", ThemeChoice::Dark, commands, |app| {
        let in_betweens = app.state().in_betweens_of(11);
        app.state().carried_heart().is_some() && in_betweens.is_some_and(|beat| beat.complete())
    });
}

#[test]
fn the_difference_of_two_hearts_looks_as_it_did() {
    let commands = vec![
        Command::SetViewMode(ViewMode::SideBySide),
        Command::CompareWith(Some(2)),
        Command::SetQuantity(Quantity::Contribution),
    ];
    compare_after("difference", ThemeChoice::Light, commands, |app| {
        app.state().answers.difference().is_some()
    });
}
