//! Patches of the selected subject: heading, table and thresholds.

mod settings;
pub(crate) mod spec;
mod table;
#[cfg(test)]
mod tests;
mod values;
pub(crate) mod view;
pub(crate) mod words;

pub use values::*;

use egui::{Label, Margin, Ui};

use crate::panes::commands::Command;
use crate::panes::work_ui::{PREVIOUS_THRESHOLDS, WALL_WORK, work_lines_ui};
use crate::picture::PatchStanding;
use crate::ui::controls::{no_subject_ui, scrolled_ui};
use crate::ui::style::{medium, note};
use crate::ui::theme::{colours, space};

/// Draws the pane.
pub fn patch_panel_ui(ui: &mut Ui, view: &PatchPanelView, commands: &mut Vec<Command>) {
    if view.subject.is_none() {
        let what = "Select a subject to see its patches (regional wall-thickening abnormalities)";
        return no_subject_ui(ui, what);
    }
    let margin = Margin::same(space::LARGE as i8);
    scrolled_ui(ui, "patch panel", margin, |ui| {
        found_ui(ui, view, commands);
        settings::settings_ui(ui, view, commands);
    });
}

fn found_ui(ui: &mut Ui, view: &PatchPanelView, commands: &mut Vec<Command>) {
    if !view.heading.is_empty() {
        let little = view.standing == PatchStanding::RegionOnly;
        let colour = match view.rows.is_empty() || little {
            true => colours(ui).strong,
            false => colours(ui).selection,
        };
        ui.add(Label::new(medium(&view.heading).color(colour)).wrap());
        ui.add(Label::new(note(&view.note)).wrap());
    }
    let before = (!view.heading.is_empty()).then_some(PREVIOUS_THRESHOLDS);
    work_lines_ui(ui, &view.state, &WALL_WORK, before, commands);
    if !view.rows.is_empty() {
        ui.add_space(space::SMALL);
        table::table_ui(ui, &view.rows, view.standing, commands);
    }
    ui.add_space(space::MEDIUM);
}
