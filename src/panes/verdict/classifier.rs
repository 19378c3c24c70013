//! The subjects most similar to the selected one, and the classifier with its accuracy and permutation means.

use egui::{Button, Label, Role, Ui, WidgetInfo};

use crate::panes::commands::{Command, SelectCommand};
use crate::panes::verdict::{ClassifierReport, SimilarSubject, pair_ui};
use crate::ui::style::{medium, note};
use crate::ui::theme::space;

/// Draws the similar subjects as buttons that select them.
pub(super) fn similar_ui(
    ui: &mut Ui,
    similar: &[Vec<SimilarSubject>; 2],
    commands: &mut Vec<Command>,
) {
    if similar.iter().all(Vec::is_empty) {
        return;
    }
    ui.label(medium("Most similar subjects"))
        .on_hover_text("By the model features, nearest first");
    for (name, subjects) in ["Class normal", "Class abnormal"].into_iter().zip(similar) {
        if subjects.is_empty() {
            continue;
        }
        ui.label(note(name));
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing = egui::vec2(space::SMALL, space::SMALL);
            for subject in subjects {
                subject_ui(ui, subject, commands);
            }
        });
    }
    ui.add_space(space::MEDIUM);
}

fn subject_ui(ui: &mut Ui, subject: &SimilarSubject, commands: &mut Vec<Command>) {
    let button = ui.add(Button::new(subject.id.as_str()));
    let name = format!("Select {}, a similar subject", subject.id);
    button.widget_info(|| WidgetInfo::labeled(Role::Button, true, name.as_str()));
    let hover = format!(
        "{}, {} · verdict: {}\n\nSelect this subject",
        subject.id, subject.label, subject.verdict
    );
    if button.on_hover_text(hover).clicked() {
        commands.push(SelectCommand::SelectSubject(subject.subject).into());
    }
}

/// Draws how the classifier was trained, and its accuracy.
pub(super) fn classifier_ui(ui: &mut Ui, classifier: &ClassifierReport) {
    ui.label(medium("Classifier"));
    ui.add(Label::new(note(classifier.source.as_str())).wrap());
    for result in &classifier.results {
        let response = pair_ui(ui, result.name, &result.value);
        let words = format!(
            "{}: {}, {}",
            result.name, result.value, result.permutation_test
        );
        let words = words.trim_end_matches(", ").to_owned();
        response.widget_info(|| WidgetInfo::labeled(Role::Label, true, words.as_str()));
        response.on_hover_text(result.what);
        if !result.permutation_test.is_empty() {
            ui.add(Label::new(note(result.permutation_test.as_str())).wrap())
                .on_hover_text(PERMUTATION_TEST);
        }
    }
    ui.add_space(space::MEDIUM);
}

/// What the permutation mean and p are.
const PERMUTATION_TEST: &str = "Permutation mean: mean over classifiers trained on permuted labels. p: share of \
                      permutations that reach at least the same value";
