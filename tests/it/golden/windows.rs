//! The whole window, once in each theme.

use cardiomorph::document::{ThemeChoice, ViewMode};
use cardiomorph::panes::{Command, ViewCommand};

use super::{compare, on_reference_driver, window_after};

pub const NAMES: [&str; 2] = ["dark", "light"];

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
