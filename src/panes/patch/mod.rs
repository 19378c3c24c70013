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

use egui::{Label, Margin, RichText, Ui};

use crate::engine::{Topic, WallThickeningQuery};
use crate::panes::buttons::command_button_ui;
use crate::panes::commands::{Command, WorkCommand};
use crate::panes::work_state::WorkState;
use crate::picture::PatchStanding;
use crate::ui::controls::{no_subject_ui, progress_bar_ui, scrolled_ui};
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
    if let WorkState::Unanswerable(why) = &view.state {
        ui.label(medium("Not assessed"));
        ui.add(Label::new(RichText::new(why).weak()).wrap());
        ui.add_space(space::LARGE);
        return;
    }
    if !view.heading.is_empty() {
        let little = view.standing == PatchStanding::LowThickening;
        let colour = match view.rows.is_empty() || little {
            true => colours(ui).strong,
            false => colours(ui).selection,
        };
        ui.add(Label::new(medium(&view.heading).color(colour)).wrap());
        ui.add(Label::new(note(&view.note)).wrap());
    }
    match view.state {
        WorkState::Computing { fraction, .. } => {
            ui.label(note(match view.heading.is_empty() {
                true => "Fitting medial spheres",
                false => "Results of the previous thresholds",
            }));
            let width = ui.available_width().min(180.0);
            progress_bar_ui(ui, width, fraction, "Fitting medial spheres");
        }
        WorkState::Stopped => {
            ui.label(note("Stopped"));
            let retry = WorkCommand::Retry(Topic::of::<WallThickeningQuery>());
            command_button_ui(ui, "Measure again", retry, commands);
        }
        _ => {}
    }
    if !view.rows.is_empty() {
        ui.add_space(space::SMALL);
        table::table_ui(ui, &view.rows, view.standing, commands);
    }
    ui.add_space(space::MEDIUM);
}
