//! The verdict on the selected subject, its evidence, the most similar subjects, and the classifier.

mod classifier;
mod evidence;
pub(crate) mod evidence_rows;
mod found;
pub(crate) mod spec;
#[cfg(test)]
mod tests;
pub(crate) mod view;

mod pair;
mod values;

use pair::pair_ui;
pub use values::{
    ClassifierReport, ClassifierResult, EvidenceRow, SimilarSubject, TrainingDistance,
    VerdictPanelView, VerdictReport, VerdictState,
};

use egui::{Margin, RichText, ScrollArea, Ui};

use crate::engine::{Topic, VerdictSettings};
use crate::panes::commands::{Command, WorkCommand};
use crate::ui::controls::{empty_pane_ui, progress_bar_ui, time_left_text};
use crate::ui::style::{medium, note};
use crate::ui::theme::{colours, space};

/// Draws the pane.
pub fn verdict_panel_ui(ui: &mut Ui, view: &VerdictPanelView, commands: &mut Vec<Command>) {
    if view.subject.is_none() {
        empty_pane_ui(
            ui,
            "No subject selected",
            "Select a subject to see its verdict and the evidence",
            |_| {},
        );
        return;
    }
    ScrollArea::vertical()
        .id_salt("verdict panel")
        .auto_shrink(false)
        .show(ui, |ui| {
            egui::Frame::new()
                .inner_margin(Margin::same(space::LARGE as i8))
                .show(ui, |ui| {
                    ui.spacing_mut().item_spacing.y = 2.0;
                    if let Some(report) = view.verdict {
                        found::verdict_ui(ui, report);
                    }
                    state_ui(ui, view, commands);
                    if let Some(report) = view.verdict {
                        evidence::evidence_ui(ui, &report.evidence);
                        classifier::similar_ui(ui, &report.similar, commands);
                    }
                    if let Some(report) = view.classifier {
                        classifier::classifier_ui(ui, report);
                    }
                });
        });
}

/// State of the work, with Cancel or Retry.
fn state_ui(ui: &mut Ui, view: &VerdictPanelView, commands: &mut Vec<Command>) {
    let first = view.verdict.is_none();
    let lines = |ui: &mut Ui, heading: &str, what: &str| {
        if first {
            ui.label(medium(heading));
        }
        ui.add(egui::Label::new(note(what)).wrap());
    };
    match view.state {
        VerdictState::Empty | VerdictState::Ready => return,
        VerdictState::Waiting => lines(ui, "Not classified yet", "Starts after the maps"),
        VerdictState::Computing {
            fraction,
            phase,
            seconds_left,
        } => {
            let what = if first {
                "Wall thickness of all subjects is measured, then a classifier is trained on the labels"
            } else {
                "Results of the previous thresholds"
            };
            lines(ui, "Classifying the subjects", what);
            let width = ui.available_width().min(180.0);
            progress_bar_ui(ui, width, *fraction, "Classifying the subjects");
            let left = seconds_left.map(|left| format!(" · {}", time_left_text(left)));
            let percent = format!("{:.0} %{}", 100.0 * fraction, left.unwrap_or_default());
            ui.label(note(percent)).on_hover_text(*phase);
            let cancel = ui.button("Cancel");
            cancel.widget_info(|| {
                egui::WidgetInfo::labeled(egui::Role::Button, true, "Cancel classification")
            });
            if cancel.clicked() {
                commands.push(Command::Work(WorkCommand::Cancel(Topic::of::<
                    VerdictSettings,
                >())));
            }
        }
        VerdictState::Stopped => {
            lines(ui, "Not classified", "The classification was stopped");
            if ui.button("Classify the subjects").clicked() {
                commands.push(Command::Work(WorkCommand::Retry(Topic::of::<
                    VerdictSettings,
                >())));
            }
        }
        VerdictState::Failed(why) => {
            let colour = colours(ui).error;
            ui.label(medium("The subjects could not be classified").color(colour));
            ui.add(egui::Label::new(RichText::new(why.as_str()).weak()).wrap());
            if ui.button("Retry").clicked() {
                commands.push(Command::Work(WorkCommand::Retry(Topic::of::<
                    VerdictSettings,
                >())));
            }
        }
    }
    ui.add_space(space::MEDIUM);
}
