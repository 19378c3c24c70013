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

use egui::{Label, Margin, RichText, Ui};

use crate::engine::{Topic, VerdictQuery};
use crate::panes::buttons::command_button_ui;
use crate::panes::commands::{Command, WorkCommand};
use crate::panes::work_state::WorkState;
use crate::ui::controls::{no_subject_ui, progress_bar_ui, scrolled_ui};
use crate::ui::style::{medium, note};
use crate::ui::text::progress_text;
use crate::ui::theme::{colours, space};

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
        state_ui(ui, view, commands);
        if let Some(report) = &view.verdict {
            evidence::evidence_ui(ui, &report.evidence);
            classifier::similar_ui(ui, &report.similar, commands);
        }
        if let Some(report) = &view.classifier {
            classifier::classifier_ui(ui, report);
        }
    });
}

/// State of the work, with Cancel or Retry.
fn state_ui(ui: &mut Ui, view: &VerdictPanelView, commands: &mut Vec<Command>) {
    let first = view.verdict.is_none();
    let lines = |ui: &mut Ui, heading: &str, what: &str| {
        if first {
            ui.label(medium(heading));
        }
        ui.add(Label::new(note(what)).wrap());
    };
    let retry = WorkCommand::Retry(Topic::of::<VerdictQuery>());
    match &view.state {
        WorkState::Empty | WorkState::Ready | WorkState::Unanswerable(_) => return,
        WorkState::Waiting => lines(ui, "Not classified yet", "Starts after the maps"),
        WorkState::Computing {
            fraction,
            phase,
            seconds_left,
        } => {
            let what = match first {
                true => {
                    "Wall thickness of all subjects is measured, then a classifier is trained on the labels"
                }
                false => "Results of the previous thresholds",
            };
            lines(ui, "Classifying the subjects", what);
            let width = ui.available_width().min(180.0);
            progress_bar_ui(ui, width, *fraction, "Classifying the subjects");
            let text = progress_text(*fraction, *seconds_left);
            ui.label(note(text)).on_hover_text(phase);
            let cancel = WorkCommand::Cancel(Topic::of::<VerdictQuery>());
            command_button_ui(ui, "Cancel", cancel, commands).widget_info(|| {
                egui::WidgetInfo::labeled(egui::Role::Button, true, "Cancel classification")
            });
        }
        WorkState::Stopped => {
            lines(ui, "Not classified", "The classification was stopped");
            command_button_ui(ui, "Classify the subjects", retry, commands);
        }
        WorkState::Failed(why) => {
            let colour = colours(ui).error;
            ui.label(medium("The subjects could not be classified").color(colour));
            ui.add(Label::new(RichText::new(why).weak()).wrap());
            command_button_ui(ui, "Retry", retry, commands);
        }
    }
    ui.add_space(space::MEDIUM);
}
