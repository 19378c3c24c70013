//! Golden pictures: each of one pane in one state, and one whole window of each theme.
//!
//! The reference driver is the software Vulkan of Debian 12's Mesa, on which pictures are the same bit for bit. On any other
//! driver nothing is compared, and a message says so once. This records all of them again, to be looked at one by one:
//!
//! ```sh
//! UPDATE_SNAPSHOTS=1 cargo test --release --test it golden
//! ```

mod figures;
mod panes;
mod states;
mod windows;

use std::collections::BTreeSet;
use std::fs;
use std::io::Write;
use std::path::Path;
use std::sync::OnceLock;
use std::time::{Duration, Instant};

use cardiomorph::app::{App, AppOptions};
use cardiomorph::document::ThemeChoice;
use cardiomorph::panes::{Command, SelectCommand, WindowCommand};
use cardiomorph::render::Headless;
use cardiomorph::study::built_in::BuiltInParams;
use egui::Rect;
use egui_kittest::Harness;
use egui_kittest::wgpu::{create_render_state, default_wgpu_setup};
use image::RgbaImage;

/// Adapter and driver that the pictures were made with: eight numbers at once, as most processors can.
const REFERENCE: [&str; 2] = ["llvmpipe (LLVM 15.0.6, 256 bits)", "Mesa 22.3.6"];

/// Adapter and driver that harnesses draw with, or why there is none.
fn driver() -> Result<[String; 2], String> {
    // A harness without an adapter panics; this does not.
    Headless::new().map_err(|error| error.to_string())?;
    let options = egui_wgpu::RendererOptions::PREDICTABLE;
    let info = create_render_state(default_wgpu_setup(), options)
        .adapter
        .get_info();
    Ok([info.name, info.driver_info])
}

/// Whether pictures can be compared here; says once why not.
fn on_reference_driver() -> bool {
    static ON_REFERENCE: OnceLock<bool> = OnceLock::new();
    *ON_REFERENCE.get_or_init(|| {
        let found = driver();
        let same = |found: &[String; 2]| (found.iter().zip(REFERENCE)).all(|(f, r)| f.starts_with(r));
        let reference = found.as_ref().is_ok_and(same);
        if !reference {
            // Not captured by the test runner, so that it is seen.
            writeln!(
                std::io::stderr(),
                "golden pictures are skipped: they were made with {REFERENCE:?}, and here is {found:?}"
            )
            .ok();
        }
        reference
    })
}

/// Whether figures can be compared, too: the program may choose another adapter than a harness.
fn program_on_reference_driver() -> bool {
    let reference = |headless: Headless| headless.adapter_name().starts_with(REFERENCE[0]);
    on_reference_driver() && Headless::new().is_ok_and(reference)
}

/// Compares a picture with the golden one of this name, by the tolerance of `kittest.toml`.
fn compare(picture: &RgbaImage, name: &str) {
    egui_kittest::image_snapshot(picture, name);
}

/// Compares a part of a picture, in its pixels.
fn compare_part(picture: &RgbaImage, part: Rect, name: &str) {
    let [left, top] = [part.left(), part.top()].map(|x| x.round() as u32);
    let [width, height] = [part.width(), part.height()].map(|x| x.round() as u32);
    let part = image::imageops::crop_imm(picture, left, top, width, height);
    compare(&part.to_image(), name);
}

/// Subject and frame that all pictures show: P03, which has one patch, at end-systole.
const SUBJECT: usize = 11;
const FRAME: usize = 3;

/// The window on the built-in cohort after these commands, once `ready` says that their results are there.
fn window_after(
    size: [f32; 2],
    theme: ThemeChoice,
    commands: Vec<Command>,
    ready: impl Fn(&App) -> bool,
) -> Harness<'static, App> {
    window_at(size, 1.0, theme, commands, ready)
}

/// The same with so many pixels to the point.
fn window_at(
    size: [f32; 2],
    scale: f32,
    theme: ThemeChoice,
    commands: Vec<Command>,
    ready: impl Fn(&App) -> bool,
) -> Harness<'static, App> {
    let options = AppOptions::built_in(BuiltInParams {
        vertices: 1_000,
        ..BuiltInParams::default()
    });
    let mut harness: Harness<'_, App> = Harness::builder()
        .with_size(size)
        .with_pixels_per_point(scale)
        .with_max_steps(64)
        .wgpu()
        .build_eframe(move |cc| App::new(cc, options).unwrap());
    harness
        .state_mut()
        .push(Command::Window(WindowCommand::SetTheme(theme)));
    wait(&mut harness, "a map", |app| {
        app.state().classes().is_some() && !app.hearts_on_screen().is_empty()
    });
    harness
        .state_mut()
        .push(Command::Select(SelectCommand::SelectPose {
            subject: SUBJECT,
            frame: FRAME,
            play: false,
        }));
    for command in commands {
        harness.state_mut().push(command);
    }
    harness.remove_cursor();
    harness.run_steps(4);
    wait(&mut harness, "the heart", |app| {
        app.hearts_on_screen()[0].0 == SUBJECT && ready(app)
    });
    harness.run();
    harness
}

fn wait(harness: &mut Harness<'_, App>, what: &str, done: impl Fn(&App) -> bool) {
    let begin = Instant::now();
    while harness.state().busy() || !done(harness.state()) {
        assert!(
            begin.elapsed() < Duration::from_secs(120),
            "waited for {what}"
        );
        harness.step();
        std::thread::sleep(Duration::from_millis(5));
    }
}

/// Names of the pictures in a folder of `tests/snapshots`, without those that a failed comparison leaves.
fn recorded(folder: &str) -> BTreeSet<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("tests/snapshots")
        .join(folder);
    (fs::read_dir(folder).unwrap())
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .filter_map(|name| name.strip_suffix(".png").map(str::to_owned))
        .filter(|name| {
            ![".new", ".diff", ".old"]
                .iter()
                .any(|end| name.ends_with(end))
        })
        .collect()
}

#[test]
fn every_golden_picture_belongs_to_a_test() {
    let names = |names: &[&str]| names.iter().map(|name| (*name).to_owned()).collect();
    assert_eq!(recorded("windows"), names(&windows::NAMES));
    assert_eq!(recorded("panes"), names(&panes::NAMES));
    assert_eq!(recorded("states"), names(&states::NAMES));
    assert_eq!(recorded("figures"), names(&figures::NAMES));
}
