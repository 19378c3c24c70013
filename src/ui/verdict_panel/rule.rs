//! The hearts most like the selected one, and the rule with its accuracy beside chance.

use egui::{Button, Label, Role, Ui, WidgetInfo};

use crate::ui::command::Command;
use crate::ui::style::{medium, note};
use crate::ui::theme::space;
use crate::ui::verdict_panel::{AlikeHeart, RuleTold, pair_ui};

/// Draws the hearts alike as buttons that select them.
pub(super) fn alike_ui(ui: &mut Ui, alike: &[Vec<AlikeHeart>; 2], commands: &mut Vec<Command>) {
    if alike.iter().all(Vec::is_empty) {
        return;
    }
    ui.label(medium("Most similar subjects"))
        .on_hover_text("By the model features, nearest first");
    for (name, hearts) in ["Class normal", "Class abnormal"].into_iter().zip(alike) {
        if hearts.is_empty() {
            continue;
        }
        ui.label(note(name));
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing = egui::vec2(space::SMALL, space::SMALL);
            for heart in hearts {
                heart_ui(ui, heart, commands);
            }
        });
    }
    ui.add_space(space::MEDIUM);
}

fn heart_ui(ui: &mut Ui, heart: &AlikeHeart, commands: &mut Vec<Command>) {
    let button = ui.add(Button::new(heart.id.as_str()));
    let name = format!("Select {}, a similar subject", heart.id);
    button.widget_info(|| WidgetInfo::labeled(Role::Button, true, name.as_str()));
    let hover = format!(
        "{}, {} · verdict: {}\n\nSelect this subject",
        heart.id, heart.label, heart.verdict
    );
    if button.on_hover_text(hover).clicked() {
        commands.push(Command::SelectSubject(heart.subject));
    }
}

/// Draws where the rule comes from and how good it is.
pub(super) fn rule_ui(ui: &mut Ui, rule: &RuleTold) {
    ui.label(medium("Classifier"));
    ui.add(Label::new(note(rule.source.as_str())).wrap());
    for result in &rule.results {
        let response = pair_ui(ui, result.name, &result.value);
        let words = format!("{}: {}, {}", result.name, result.value, result.chance);
        let words = words.trim_end_matches(", ").to_owned();
        response.widget_info(|| WidgetInfo::labeled(Role::Label, true, words.as_str()));
        response.on_hover_text(result.what);
        if !result.chance.is_empty() {
            ui.add(Label::new(note(result.chance.as_str())).wrap())
                .on_hover_text(CHANCE);
        }
    }
    ui.add_space(space::MEDIUM);
}

/// What chance and p are.
const CHANCE: &str = "Permutation mean: mean over classifiers trained on permuted labels. p: share of \
                      permutations that reach at least the same value";
