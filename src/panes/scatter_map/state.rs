//! How a map stands, and what is said where it is not that of the settings.

use egui::{Rect, Ui, vec2};

use crate::engine::Topic;
use crate::panes::commands::{Command, WorkCommand};
use crate::ui::controls::progress_text;
use crate::ui::controls::{empty_pane_ui, progress_bar_ui};
use crate::ui::style::note;
use crate::ui::theme::{colours, space};

use super::view::{MapState, ScatterView};

/// Draws a pane that has no map to show.
pub fn without_map_ui(ui: &mut Ui, view: &ScatterView, commands: &mut Vec<Command>) {
    let (words, job) = (view.words, view.job);
    match &view.state {
        MapState::Empty | MapState::Ready => empty_pane_ui(ui, words.empty, words.what, |_| {}),
        MapState::Computing {
            fraction,
            seconds_left,
        } => {
            empty_pane_ui(
                ui,
                "Computing the map",
                "Other panes remain usable.",
                |ui| {
                    let width = 200f32.min(ui.available_width());
                    progress_bar_ui(ui, width, *fraction, "Computing the map");
                    ui.label(note(progress_text(*fraction, *seconds_left)));
                    cancel_ui(ui, "Cancel", job, commands);
                },
            );
        }
        MapState::Stopped => empty_pane_ui(ui, "Map computation stopped", words.what, |ui| {
            retry_ui(ui, "Compute the map", job, commands);
        }),
        MapState::Failed(why) => empty_pane_ui(ui, words.none, why, |ui| {
            retry_ui(ui, "Retry", job, commands);
        }),
        MapState::Unanswerable(why) => empty_pane_ui(ui, words.none, why, |_| {}),
    }
}

fn cancel_ui(
    ui: &mut Ui,
    name: impl Into<egui::WidgetText>,
    job: Topic,
    commands: &mut Vec<Command>,
) {
    let button = ui.button(name.into());
    if button.on_hover_text("Stop computing the map").clicked() {
        commands.push(Command::Work(WorkCommand::Cancel(job)));
    }
}

fn retry_ui(ui: &mut Ui, name: &str, job: Topic, commands: &mut Vec<Command>) {
    if ui.button(name).clicked() {
        commands.push(Command::Work(WorkCommand::Retry(job)));
    }
}

/// Draws a card over a map that is not that of the settings: the previous map is shown below.
pub fn over_map_ui(
    ui: &mut Ui,
    state: &MapState,
    job: Topic,
    rect: Rect,
    commands: &mut Vec<Command>,
) {
    if matches!(state, MapState::Ready | MapState::Empty) {
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
        ui.horizontal(|ui| match state {
            MapState::Computing {
                fraction,
                seconds_left,
            } => {
                let width = (width - 190.0).max(30.0);
                progress_bar_ui(ui, width, *fraction, "Computing the map");
                ui.label(note(progress_text(*fraction, *seconds_left)));
                cancel_ui(ui, note("Cancel"), job, commands);
            }
            MapState::Failed(why) => {
                let colour = colours(ui).error;
                retry_ui(ui, "Retry", job, commands);
                ui.add(egui::Label::new(egui::RichText::new(why).small().color(colour)).truncate());
            }
            MapState::Unanswerable(why) => {
                ui.add(egui::Label::new(note(why)).truncate());
            }
            MapState::Stopped | MapState::Ready | MapState::Empty => {
                ui.label(note("Stopped; the previous map is shown"));
                retry_ui(ui, "Retry", job, commands);
                ui.add_space(space::SMALL);
            }
        });
    });
}
