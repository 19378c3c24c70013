//! Makes the pictures of the README; `golden` is the test of how the window looks.
//!
//! ```sh
//! CARDIOMORPH_SCREENSHOTS=screenshots cargo test --release --test it screenshots -- --ignored
//! ```

use std::path::{Path, PathBuf};
use std::process::Command as Program;
use std::time::{Duration, Instant};

use cardiomorph::app::{App, AppOptions};
use cardiomorph::document::{ThemeChoice, ViewMode};
use cardiomorph::panes::{
    Command, Pane, PlaybackCommand, SelectCommand, TransportCommand, ViewCommand, WallCommand,
    WindowCommand,
};
use cardiomorph::picture::Quantity;
use cardiomorph::study::built_in::BuiltInParams;
use egui_kittest::Harness;

/// One picture of the window: its name, and what a person did before it was taken.
struct Shot {
    name: &'static str,
    pixels_per_point: f32,
    commands: Vec<Command>,
}

/// Where the pictures go, below the root.
fn folder() -> PathBuf {
    let folder = std::env::var_os("CARDIOMORPH_SCREENSHOTS").expect("a folder for the pictures");
    Path::new(env!("CARGO_MANIFEST_DIR")).join(folder)
}

/// Steps until all work is done. Between one piece of work and the next nothing runs for a moment, so the rest must last.
fn settle(harness: &mut Harness<'_, App>) {
    let begin = Instant::now();
    let mut quiet_steps = 0;
    while quiet_steps < 40 {
        assert!(begin.elapsed() < Duration::from_secs(120), "no picture");
        harness.step();
        std::thread::sleep(Duration::from_millis(5));
        let app = harness.state();
        let drawn = app.state().map().is_some() && !app.hearts_on_screen().is_empty();
        let settled = drawn && !app.busy();
        quiet_steps = if settled { quiet_steps + 1 } else { 0 };
    }
    harness.run();
}

fn take(shot: Shot, folder: &Path) {
    let mut harness: Harness<'_, App> = Harness::builder()
        .with_size([1600.0, 1000.0])
        .with_pixels_per_point(shot.pixels_per_point)
        .with_max_steps(64)
        .wgpu()
        .build_eframe(|cc| App::new(cc, AppOptions::built_in(BuiltInParams::default())).unwrap());
    settle(&mut harness);
    for command in shot.commands {
        harness.state_mut().push(command);
        harness.step();
    }
    harness.remove_cursor();
    harness.run();
    settle(&mut harness);
    let picture = harness.render().unwrap();
    picture.save(folder.join(shot.name)).unwrap();
}

fn pose(subject: usize, frame: usize) -> Command {
    Command::Select(SelectCommand::SelectPose {
        subject,
        frame,
        play: false,
    })
}

#[test]
#[ignore = "makes the pictures of the README where CARDIOMORPH_SCREENSHOTS says"]
fn screenshots_are_taken_when_asked_for() {
    let folder = folder();
    std::fs::create_dir_all(&folder).unwrap();
    let dark = Command::Window(WindowCommand::SetTheme(ThemeChoice::Dark));
    let light = Command::Window(WindowCommand::SetTheme(ThemeChoice::Light));
    // P07 has a very large patch, P05 a large one; frame 3 is end-systole.
    let shots = [
        Shot {
            name: "window_dark.png",
            pixels_per_point: 1.0,
            commands: vec![dark.clone(), pose(13, 3)],
        },
        Shot {
            name: "window_light.png",
            pixels_per_point: 2.0,
            commands: vec![light.clone(), pose(3, 3)],
        },
        Shot {
            name: "side_by_side.png",
            pixels_per_point: 1.0,
            commands: vec![
                dark.clone(),
                pose(15, 3),
                Command::View(ViewCommand::SetQuantity(Quantity::AreaRatio)),
                Command::View(ViewCommand::SetViewMode(ViewMode::SideBySide)),
                Command::Select(SelectCommand::CompareWith(Some(2))),
            ],
        },
        Shot {
            name: "transported_motion.png",
            pixels_per_point: 1.0,
            commands: vec![
                dark.clone(),
                Command::Transport(TransportCommand::TransportMotion { from: 15, onto: 2 }),
                Command::Playback(PlaybackCommand::TogglePlay),
                Command::Playback(PlaybackCommand::SetPosition(3.5)),
            ],
        },
        Shot {
            name: "deformations.png",
            pixels_per_point: 1.0,
            commands: vec![
                light.clone(),
                pose(15, 3),
                Command::Window(WindowCommand::ShowPane(Pane::METRIC)),
                Command::Window(WindowCommand::ShowPane(Pane::DEFORMATION_MAP)),
            ],
        },
        Shot {
            name: "poses_through_time.png",
            pixels_per_point: 2.0,
            commands: vec![
                dark.clone(),
                pose(15, 3),
                Command::Window(WindowCommand::ShowPane(Pane::SPATIOTEMPORAL)),
            ],
        },
        Shot {
            name: "patch.png",
            pixels_per_point: 1.0,
            commands: vec![
                light.clone(),
                pose(13, 3),
                Command::Window(WindowCommand::ShowPane(Pane::PATCH)),
                Command::Wall(WallCommand::ToggleAtoms),
            ],
        },
        Shot {
            name: "medial_map.png",
            pixels_per_point: 1.0,
            commands: vec![
                light.clone(),
                pose(13, 3),
                Command::Window(WindowCommand::ShowPane(Pane::MEDIAL_MAP)),
                Command::Window(WindowCommand::ShowPane(Pane::THICKNESS)),
            ],
        },
        Shot {
            name: "verdict.png",
            pixels_per_point: 1.0,
            commands: vec![
                dark,
                pose(13, 3),
                Command::Window(WindowCommand::ShowPane(Pane::VERDICT)),
            ],
        },
        Shot {
            name: "difference.png",
            pixels_per_point: 1.0,
            commands: vec![
                light.clone(),
                pose(15, 3),
                Command::View(ViewCommand::SetViewMode(ViewMode::SideBySide)),
                Command::Select(SelectCommand::CompareWith(Some(2))),
                Command::View(ViewCommand::SetQuantity(Quantity::Contribution)),
            ],
        },
        Shot {
            name: "all_phases.png",
            pixels_per_point: 1.0,
            commands: vec![
                light,
                pose(4, 3),
                Command::View(ViewCommand::SetQuantity(Quantity::Displacement)),
                Command::View(ViewCommand::SetViewMode(ViewMode::AllFrames)),
            ],
        },
    ];
    for shot in shots {
        take(shot, &folder);
    }
    let area = ["--frame", "3", "--colour", "area-ratio"];
    for (name, options) in [
        ("figure.png", &area[..]),
        ("patch_figure.png", &["--patch"]),
    ] {
        let figure = Program::new(env!("CARGO_BIN_EXE_cardiomorph"))
            .args(["figure", "--subject", "P07"])
            .args(options)
            .args(["--theme", "light", "--size", "1600x1200", "--out"])
            .arg(folder.join(name))
            .status()
            .unwrap();
        assert!(figure.success(), "{name}");
    }
}
