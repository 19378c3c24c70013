//! The verdict on the selected subject, its evidence, the most similar subjects, and the classifier.

mod classifier;
mod evidence;
pub(crate) mod evidence_rows;
mod found;
mod pair;
pub(crate) mod spec;
#[cfg(test)]
mod tests;
mod values;
pub(crate) mod view;

use pair::pair_ui;
pub use values::*;

use egui::{Margin, Ui};

use crate::engine::{Topic, VerdictQuery};
use crate::panes::commands::Command;
use crate::panes::work_ui::{PREVIOUS_THRESHOLDS, WorkWords, work_lines_ui};
use crate::ui::controls::{no_subject_ui, scrolled_ui};
use crate::ui::theme::space;

/// Draws the pane.
pub fn verdict_panel_ui(ui: &mut Ui, view: &VerdictPanelView, commands: &mut Vec<Command>) {
    if view.subject.is_none() {
        return no_subject_ui(ui, "Select a subject to see its verdict and the evidence");
    }
    let margin = Margin::same(space::LARGE as i8);
    scrolled_ui(ui, "verdict panel", margin, |ui| {
        if let Some(report) = &view.verdict {
            found::verdict_ui(ui, report);
        }
        let before = view.verdict.as_ref().map(|_| PREVIOUS_THRESHOLDS);
        work_lines_ui(ui, &view.state, &WORK, before, commands);
        if let Some(report) = &view.verdict {
            evidence::evidence_ui(ui, &report.evidence);
            classifier::similar_ui(ui, &report.similar, commands);
        }
        if let Some(report) = &view.classifier {
            classifier::classifier_ui(ui, report);
        }
    });
}

static WORK: WorkWords = WorkWords {
    topic: Topic::of::<VerdictQuery>(),
    computing: "Classifying the subjects",
    meanwhile: "Wall thickness of all subjects is measured, then a classifier is trained on the labels",
    stopped: "The classification was stopped",
    begin: "Classify the subjects",
    failed: "The subjects could not be classified",
    unanswerable: "Not classified",
    cancel: "Cancel classification",
};
