//! Patches of the selected subject: heading, table and thresholds.

mod settings;
pub(crate) mod spec;
mod table;
#[cfg(test)]
mod tests;
pub(crate) mod view;
pub(crate) mod words;

mod values;

pub use values::{PatchLine, PatchPanelView, WallState};

use egui::{Margin, RichText, ScrollArea, Ui};

use crate::engine::{Topic, WallThickening};
use crate::panes::commands::{Command, WorkCommand};
use crate::picture::PatchStanding;
use crate::ui::controls::{empty_pane_ui, progress_bar_ui};
use crate::ui::style::{medium, note};
use crate::ui::theme::{colours, space};

/// Draws the pane.
pub fn patch_panel_ui(ui: &mut Ui, view: &PatchPanelView, commands: &mut Vec<Command>) {
    if view.subject.is_none() {
        empty_pane_ui(
            ui,
            "No subject selected",
            "Select a subject to see its patches (regional wall-thickening abnormalities)",
            |_| {},
        );
        return;
    }
    ScrollArea::vertical()
        .id_salt("patch panel")
        .auto_shrink(false)
        .show(ui, |ui| {
            egui::Frame::new()
                .inner_margin(Margin::same(space::LARGE as i8))
                .show(ui, |ui| {
                    ui.spacing_mut().item_spacing.y = 2.0;
                    found_ui(ui, view, commands);
                    settings::settings_ui(ui, view, commands);
                });
        });
}

fn found_ui(ui: &mut Ui, view: &PatchPanelView, commands: &mut Vec<Command>) {
    if let WallState::NotAssessed(why) = view.state {
        ui.label(medium("Not assessed"));
        ui.add(egui::Label::new(RichText::new(why.as_str()).weak()).wrap());
        ui.add_space(space::LARGE);
        return;
    }
    if !view.heading.is_empty() {
        let little = view.standing == PatchStanding::LowThickening;
        let colour = if view.rows.is_empty() || little {
            colours(ui).strong
        } else {
            colours(ui).selection
        };
        ui.add(egui::Label::new(medium(view.heading).color(colour)).wrap());
        ui.add(egui::Label::new(note(view.note)).wrap());
    }
    match view.state {
        WallState::Computing { fraction } => {
            let words = if view.heading.is_empty() {
                "Fitting medial spheres"
            } else {
                "Results of the previous thresholds"
            };
            ui.label(note(words));
            let width = ui.available_width().min(180.0);
            progress_bar_ui(ui, width, *fraction, "Fitting medial spheres");
        }
        WallState::Stopped => {
            ui.label(note("Stopped"));
            if ui.button("Measure again").clicked() {
                commands.push(Command::Work(WorkCommand::Retry(
                    Topic::of::<WallThickening>(),
                )));
            }
        }
        _ => {}
    }
    if !view.rows.is_empty() {
        ui.add_space(space::SMALL);
        table::table_ui(ui, view.rows, view.standing, commands);
    }
    ui.add_space(space::MEDIUM);
}
