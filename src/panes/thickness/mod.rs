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
use crate::panes::commands::Command;
use crate::panes::work_state::WorkState;
use crate::panes::work_ui::{WorkWords, work_lines_ui};
use crate::ui::controls::{no_subject_ui, scrolled_ui};
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
        let before = measured_now(view);
        work_lines_ui(ui, &view.state, &WORK, before.as_deref(), commands);
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

/// What is said while further poses are measured.
fn measured_now(view: &ThicknessPanelView) -> Option<String> {
    match &view.state {
        WorkState::Computing { phase, .. } if !view.rows.is_empty() => {
            Some(format!("Measuring {phase}"))
        }
        _ => None,
    }
}

fn footnote(view: &ThicknessPanelView) -> String {
    format!(
        "Median (5–95 % of vertices) in {}; right: mean difference from medial spheres ± standard \
         deviation at {}",
        view.unit, view.moment
    )
}

static WORK: WorkWords = WorkWords {
    topic: Topic::of::<PoseThicknessQuery>(),
    computing: "Measuring wall thickness",
    meanwhile: "By five methods, one pose after the other",
    stopped: "The measurement was stopped",
    begin: "Measure",
    failed: "Wall thickness could not be measured",
    unanswerable: "Not measured",
    cancel: "Cancel",
};
