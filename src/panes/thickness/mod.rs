//! Wall thickness by each method: box strips on one axis, and differences from the medial spheres.

pub(crate) mod spec;
mod strips;
#[cfg(test)]
mod tests;
mod values;
pub(crate) mod view;

pub use values::*;

use egui::{Label, Margin, Ui};

use crate::engine::{PoseThicknessQuery, Topic};
use crate::panes::buttons::command_button_ui;
use crate::panes::commands::{Command, WorkCommand};
use crate::panes::work_state::WorkState;
use crate::ui::controls::{no_subject_ui, progress_bar_ui, scrolled_ui};
use crate::ui::style::note;
use crate::ui::theme::space;

/// Draws the pane.
pub fn thickness_panel_ui(ui: &mut Ui, view: &ThicknessPanelView, commands: &mut Vec<Command>) {
    if view.subject.is_none() {
        let what = "Select a subject to measure its wall thickness by five methods";
        return no_subject_ui(ui, what);
    }
    let margin = Margin::symmetric(space::LARGE as i8, space::SMALL as i8);
    scrolled_ui(ui, "thickness panel", margin, |ui| {
        state_ui(ui, view, commands);
        if view.rows.iter().any(|row| !row.strips.is_empty()) {
            strips::axis_ui(ui, view);
        }
        for row in &view.rows {
            strips::row_ui(ui, view, row);
        }
        if !view.rows.is_empty() {
            ui.add(Label::new(note(footnote(view))).wrap());
        }
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
    let topic = Topic::of::<PoseThicknessQuery>();
    match &view.state {
        WorkState::Computing {
            fraction, phase, ..
        } => {
            ui.horizontal(|ui| {
                let width = (ui.available_width() - 130.0).clamp(30.0, 120.0);
                progress_bar_ui(ui, width, *fraction, "Measuring wall thickness");
                ui.label(note(format!("{phase}, {:.0} %", 100.0 * fraction)));
                command_button_ui(ui, note("Cancel"), WorkCommand::Cancel(topic), commands);
            });
        }
        WorkState::Stopped => {
            ui.horizontal(|ui| {
                ui.label(note("Stopped"));
                command_button_ui(ui, note("Measure"), WorkCommand::Retry(topic), commands);
            });
        }
        WorkState::Failed(why) => {
            ui.add(Label::new(note(why)).wrap());
        }
        _ => {}
    }
}
