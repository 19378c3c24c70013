//! How a map stands, and what is said where it is not that of the settings.

use egui::{Rect, Ui, vec2};

use crate::engine::Topic;
use crate::panes::buttons::command_button_ui;
use crate::panes::commands::{Command, WorkCommand};
use crate::panes::work_state::WorkState;
use crate::ui::controls::{empty_pane_ui, progress_bar_ui};
use crate::ui::style::note;
use crate::ui::text::progress_text;
use crate::ui::theme::{colours, space};

use super::view::ScatterView;

/// Draws a pane that has no map to show.
pub fn without_map_ui(ui: &mut Ui, view: &ScatterView, commands: &mut Vec<Command>) {
    let (words, job) = (view.words, view.job);
    let retry = WorkCommand::Retry(job);
    match &view.state {
        WorkState::Empty | WorkState::Waiting | WorkState::Ready => {
            empty_pane_ui(ui, words.empty, words.what, |_| {});
        }
        computing @ WorkState::Computing { .. } => {
            let what = "Other panes remain usable.";
            empty_pane_ui(ui, "Computing the map", what, |ui| {
                let width = 200f32.min(ui.available_width());
                progress_ui(ui, computing, width);
                cancel_ui(ui, "Cancel", job, commands);
            });
        }
        WorkState::Stopped => empty_pane_ui(ui, "Map computation stopped", words.what, |ui| {
            command_button_ui(ui, "Compute the map", retry, commands);
        }),
        WorkState::Failed(why) => empty_pane_ui(ui, words.none, why, |ui| {
            command_button_ui(ui, "Retry", retry, commands);
        }),
        WorkState::Unanswerable(why) => empty_pane_ui(ui, words.none, why, |_| {}),
    }
}

fn progress_ui(ui: &mut Ui, state: &WorkState, width: f32) {
    if let WorkState::Computing {
        fraction,
        seconds_left,
        ..
    } = state
    {
        progress_bar_ui(ui, width, *fraction, "Computing the map");
        ui.label(note(progress_text(*fraction, *seconds_left)));
    }
}

fn cancel_ui(
    ui: &mut Ui,
    name: impl Into<egui::WidgetText>,
    job: Topic,
    commands: &mut Vec<Command>,
) {
    command_button_ui(ui, name, WorkCommand::Cancel(job), commands)
        .on_hover_text("Stop computing the map");
}

/// Draws a card over a map that is not that of the settings: the previous map is shown below.
pub fn over_map_ui(ui: &mut Ui, view: &ScatterView, rect: Rect, commands: &mut Vec<Command>) {
    if !view.out_of_date() {
        return;
    }
    let width = (rect.width() - 24.0).min(300.0);
    let card = Rect::from_min_size(
        rect.center_top() + vec2(-0.5 * width, 10.0),
        vec2(width, 30.0),
    );
    let mut child = ui.new_child(egui::UiBuilder::new().max_rect(card));
    let frame = egui::Frame::popup(child.style()).inner_margin(egui::Margin::symmetric(10, 4));
    frame.show(&mut child, |ui| {
        ui.set_width(width - 20.0);
        ui.horizontal(|ui| match &view.state {
            WorkState::Computing { .. } => {
                progress_ui(ui, &view.state, (width - 190.0).max(30.0));
                cancel_ui(ui, note("Cancel"), view.job, commands);
            }
            WorkState::Failed(why) => {
                let colour = colours(ui).error;
                command_button_ui(ui, "Retry", WorkCommand::Retry(view.job), commands);
                ui.add(egui::Label::new(egui::RichText::new(why).small().color(colour)).truncate());
            }
            WorkState::Unanswerable(why) => {
                ui.add(egui::Label::new(note(why)).truncate());
            }
            WorkState::Stopped | WorkState::Waiting | WorkState::Ready | WorkState::Empty => {
                ui.label(note("Stopped; the previous map is shown"));
                command_button_ui(ui, "Retry", WorkCommand::Retry(view.job), commands);
                ui.add_space(space::SMALL);
            }
        });
    });
}
