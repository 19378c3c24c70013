//! Wall thickness by each method: box strips on one axis, and differences from the medial spheres.

pub(crate) mod spec;
mod strips;
#[cfg(test)]
mod tests;
pub(crate) mod view;

mod values;

pub use values::{Difference, ThicknessPanelView, ThicknessRow, ThicknessState, ThicknessStrip};

use egui::{Margin, ScrollArea, Ui};

use crate::engine::{PoseThickness, Topic};
use crate::panes::commands::{Command, WorkCommand};
use crate::ui::controls::{empty_pane_ui, progress_bar_ui};
use crate::ui::style::note;
use crate::ui::theme::space;

/// Draws the pane.
pub fn thickness_panel_ui(ui: &mut Ui, view: &ThicknessPanelView, commands: &mut Vec<Command>) {
    if view.subject.is_none() {
        empty_pane_ui(
            ui,
            "No subject selected",
            "Select a subject to measure its wall thickness by five methods",
            |_| {},
        );
        return;
    }
    ScrollArea::vertical()
        .id_salt("thickness panel")
        .auto_shrink(false)
        .show(ui, |ui| {
            let margin = Margin::symmetric(space::LARGE as i8, space::SMALL as i8);
            egui::Frame::new().inner_margin(margin).show(ui, |ui| {
                ui.spacing_mut().item_spacing.y = 2.0;
                state_ui(ui, view, commands);
                if view.rows.iter().any(|row| !row.strips.is_empty()) {
                    strips::axis_ui(ui, view);
                }
                for row in view.rows {
                    strips::row_ui(ui, view, row);
                }
                if !view.rows.is_empty() {
                    ui.add(egui::Label::new(note(footnote(view))).wrap());
                }
            });
        });
}

fn footnote(view: &ThicknessPanelView) -> String {
    format!(
        "Median (5–95 % of vertices) in {}; right: mean difference from medial spheres ± standard \
         deviation at {}",
        view.unit, view.moment
    )
}

fn state_ui(ui: &mut Ui, view: &ThicknessPanelView, commands: &mut Vec<Command>) {
    match view.state {
        ThicknessState::Computing { fraction, moment } => {
            ui.horizontal(|ui| {
                let width = (ui.available_width() - 130.0).clamp(30.0, 120.0);
                progress_bar_ui(ui, width, *fraction, "Measuring wall thickness");
                ui.label(note(format!("{moment}, {:.0} %", 100.0 * fraction)));
                if ui.button(note("Cancel")).clicked() {
                    commands.push(Command::Work(WorkCommand::Cancel(
                        Topic::of::<PoseThickness>(),
                    )));
                }
            });
        }
        ThicknessState::Stopped => {
            ui.horizontal(|ui| {
                ui.label(note("Stopped"));
                if ui.button(note("Measure")).clicked() {
                    commands.push(Command::Work(WorkCommand::Retry(
                        Topic::of::<PoseThickness>(),
                    )));
                }
            });
        }
        ThicknessState::Failed(why) => {
            ui.add(egui::Label::new(note(why)).wrap());
        }
        ThicknessState::Empty | ThicknessState::Ready => {}
    }
}
