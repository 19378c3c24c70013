//! The whole window: once in each theme, and at the sizes of screens from small to large, where nothing may be cut or overlap.

use cardiomorph::document::{ThemeChoice, ViewMode};
use cardiomorph::panes::{Command, ViewCommand};

use super::{compare, on_reference_driver, window_after, window_at};

pub const NAMES: [&str; 8] = [
    "1024x640",
    "1366x768",
    "1600x1000_dark",
    "1600x1000_light",
    "2560x1440",
    "dark",
    "light",
    "scale_2",
];

fn compare_window(name: &str, theme: ThemeChoice, mode: ViewMode) {
    if !on_reference_driver() {
        return;
    }
    let commands = vec![Command::View(ViewCommand::SetViewMode(mode))];
    let mut harness = window_after([1280.0, 800.0], theme, commands, |_| true);
    compare(&harness.render().unwrap(), &format!("windows/{name}"));
}

#[test]
fn the_dark_window_looks_as_it_did() {
    compare_window("dark", ThemeChoice::Dark, ViewMode::Single);
}

#[test]
fn the_light_window_looks_as_it_did() {
    compare_window("light", ThemeChoice::Light, ViewMode::SideBySide);
}

/// A size in points with so many pixels to the point, in one theme.
fn compare_size(name: &str, size: [f32; 2], scale: f32, theme: ThemeChoice) {
    if !on_reference_driver() {
        return;
    }
    let mut harness = window_at(size, scale, theme, Vec::new(), |app| {
        app.state().verdict_of(super::SUBJECT).is_some()
    });
    compare(&harness.render().unwrap(), &format!("windows/{name}"));
}

#[test]
fn the_window_of_1024_by_640_looks_as_it_did() {
    compare_size("1024x640", [1024.0, 640.0], 1.0, ThemeChoice::Dark);
}

#[test]
fn the_window_of_1366_by_768_looks_as_it_did() {
    compare_size("1366x768", [1366.0, 768.0], 1.0, ThemeChoice::Light);
}

#[test]
fn the_dark_window_of_1600_by_1000_looks_as_it_did() {
    compare_size("1600x1000_dark", [1600.0, 1000.0], 1.0, ThemeChoice::Dark);
}

#[test]
fn the_light_window_of_1600_by_1000_looks_as_it_did() {
    compare_size("1600x1000_light", [1600.0, 1000.0], 1.0, ThemeChoice::Light);
}

#[test]
fn the_window_of_2560_by_1440_looks_as_it_did() {
    compare_size("2560x1440", [2560.0, 1440.0], 1.0, ThemeChoice::Dark);
}

#[test]
fn the_window_with_two_pixels_to_the_point_looks_as_it_did() {
    compare_size("scale_2", [1024.0, 640.0], 2.0, ThemeChoice::Light);
}
