//! The verdict on the selected subject, its evidence, the most similar subjects, and the classifier.

mod evidence;
pub(crate) mod evidence_rows;
mod found;
mod rule;
pub(crate) mod spec;
#[cfg(test)]
mod tests;
pub(crate) mod view;

use egui::{Margin, RichText, ScrollArea, Ui};

use crate::engine::{Topic, VerdictSettings};
use crate::panes::commands::{Command, WorkCommand};
use crate::panes::verdict_marks::VerdictMark;
use crate::study::LabelRole;
use crate::ui::controls::{empty_pane_ui, progress_bar_ui, time_left_text};
use crate::ui::style::{medium, note};
use crate::ui::theme::{colours, space};

/// State of the classification of all subjects.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum VerdictState {
    /// No subject is selected.
    #[default]
    Empty,
    /// It starts after the work that is on screen.
    Waiting,
    /// It runs; what is shown, if anything, belongs to the previous thresholds.
    Computing {
        /// Done share in `0..=1`.
        fraction: f32,
        /// What is being done now; may be empty.
        phase: &'static str,
        /// Estimate, once there is one.
        seconds_left: Option<f64>,
    },
    /// The user stopped it.
    Stopped,
    /// It failed, and why.
    Failed(String),
    /// What is shown belongs to the present study and thresholds.
    Ready,
}

/// The verdict on one subject, in words and numbers.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct VerdictReport {
    /// The verdict as a shape.
    pub mark: VerdictMark,
    /// "Abnormal patch · 31 % of the LV".
    pub heading: String,
    /// What that means; for a subject that is not assessed, why.
    pub sentence: String,
    /// Predicted probability of class abnormal, in `0..=1`; `None` where it is not assessed.
    pub probability: Option<f64>,
    /// Whether that number is a probability; else it is an uncalibrated score.
    pub calibrated: bool,
    /// Which classifier it is from: leave-one-out, trained on others, default thresholds.
    pub source: &'static str,
    /// Distance to the training set; `None` without one.
    pub training_distance: Option<TrainingDistance>,
    /// The features.
    pub evidence: Vec<EvidenceRow>,
    /// The most similar subjects of class normal and of class abnormal, nearest first.
    pub similar: [Vec<SimilarSubject>; 2],
}

/// Distance of a subject to the training subjects.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TrainingDistance {
    /// In a sentence.
    pub words: String,
    /// Whether it is outside the training distribution.
    pub outside: bool,
}

/// One feature of a subject beside those of the normal subjects.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct EvidenceRow {
    /// "Akinetic region".
    pub name: &'static str,
    /// What it is, for the hover.
    pub what: &'static str,
    /// With its unit; "no value" where there is none.
    pub value: String,
    /// Range of the normal subjects, with the unit; empty where there are none.
    pub normal: String,
    /// Position of the value in the range of all subjects, in `0..=1`.
    pub place: Option<f32>,
    /// Range of the normal subjects on the same scale.
    pub band: Option<[f32; 2]>,
    /// Whether the classifier uses it.
    pub model_feature: bool,
}

/// A subject similar to the selected one.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SimilarSubject {
    /// Index into the study's subjects.
    pub subject: usize,
    /// Pseudonym.
    pub id: String,
    /// Label of the study.
    pub label: String,
    /// Class of the label.
    pub role: LabelRole,
    /// Its verdict: "patch 31 %".
    pub verdict: String,
}

/// How the classifier was trained, and its accuracy.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ClassifierReport {
    /// "Logistic classifier, trained on 9 normal and 14 abnormal subjects …".
    pub source: String,
    /// Accuracy, area under the curve, errors.
    pub results: Vec<ClassifierResult>,
}

/// A measure of the quality of a classifier with its permutation test.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ClassifierResult {
    /// "Accuracy (leave-one-out)".
    pub name: &'static str,
    /// What it is, for the hover.
    pub what: &'static str,
    /// "22 of 23".
    pub value: String,
    /// "permutation mean 11.6 · p 0.005"; empty without a test.
    pub permutation_test: String,
}

/// What the pane shows.
#[derive(Clone, Copy, Debug)]
pub struct VerdictPanelView<'a> {
    /// The selected subject.
    pub subject: Option<&'a str>,
    /// State of the classification.
    pub state: &'a VerdictState,
    /// Its verdict; `None` while there is none.
    pub verdict: Option<&'a VerdictReport>,
    /// The classifier; `None` while there is none.
    pub classifier: Option<&'a ClassifierReport>,
}

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
                        rule::similar_ui(ui, &report.similar, commands);
                    }
                    if let Some(report) = view.classifier {
                        rule::classifier_ui(ui, report);
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

/// A line with a name on the left and a number on the right; a long name takes a second line.
fn pair_ui(ui: &mut Ui, name: &str, value: &str) -> egui::Response {
    use crate::ui::style::{medium_note_font, note_font};
    let colours = colours(ui);
    let painter = ui.painter().clone();
    let value = painter.layout_no_wrap(value.to_owned(), medium_note_font(), colours.text);
    let room = (ui.available_width() - value.size().x - space::MEDIUM).max(8.0);
    let name = painter.layout(name.to_owned(), note_font(), colours.muted, room);
    let size = egui::vec2(ui.available_width(), name.size().y.max(18.0));
    let (rect, response) = ui.allocate_exact_size(size, egui::Sense::hover());
    let y = |height: f32| rect.center().y - 0.5 * height;
    let left = egui::pos2(rect.left(), y(name.size().y));
    painter.galley(left, name, colours.muted);
    let right = egui::pos2(rect.right() - value.size().x, y(value.size().y));
    painter.galley(right, value, colours.text);
    response
}
