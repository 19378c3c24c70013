//! How a map stands, and what is said of it where it is not that of the settings.

use egui::{Rect, Ui, vec2};

use crate::engine::Topic;
use crate::ui::command::Command;
use crate::ui::controls::{empty_pane_ui, progress_bar_ui};
use crate::ui::status_bar::progress_text;
use crate::ui::style::note;
use crate::ui::theme::{colours, space};

/// How a map stands.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum MapState {
    /// Nothing to map.
    #[default]
    Empty,
    /// The points are those of the settings.
    Ready,
    /// A new map is being computed; the points are those of the one before, if any.
    Computing {
        /// Done share in `0..=1`.
        fraction: f32,
        /// Estimated seconds left, once they can be told.
        seconds_left: Option<f64>,
    },
    /// The user stopped it.
    Stopped,
    /// It could not be computed, and why.
    Failed(String),
    /// This study has no such map, and why; trying again would change nothing.
    Unanswerable(String),
}

/// The words of one map, and the work that makes it.
#[derive(Clone, Copy, Debug)]
pub struct MapWords {
    /// What Cancel and Retry mean.
    pub job: Topic,
    /// Heading where there is nothing to map.
    pub empty: &'static str,
    /// What would fill the pane.
    pub what: &'static str,
    /// Heading where it could not be computed.
    pub none: &'static str,
}

/// Draws a pane that has no map to show.
pub fn without_map_ui(
    ui: &mut Ui,
    state: &MapState,
    words: &MapWords,
    commands: &mut Vec<Command>,
) {
    match state {
        MapState::Empty | MapState::Ready => empty_pane_ui(ui, words.empty, words.what, |_| {}),
        MapState::Computing {
            fraction,
            seconds_left,
        } => {
            empty_pane_ui(
                ui,
                "Computing the map",
                "Hearts can be looked at meanwhile.",
                |ui| {
                    let width = 200f32.min(ui.available_width());
                    progress_bar_ui(ui, width, *fraction, "Computing the map");
                    ui.label(note(progress_text(*fraction, *seconds_left)));
                    cancel_ui(ui, "Cancel", words.job, commands);
                },
            );
        }
        MapState::Stopped => empty_pane_ui(
            ui,
            "The map was stopped",
            "It can be computed again at any time.",
            |ui| retry_ui(ui, "Compute the map", words.job, commands),
        ),
        MapState::Failed(why) => empty_pane_ui(ui, words.none, why, |ui| {
            retry_ui(ui, "Retry", words.job, commands);
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
        commands.push(Command::Cancel(job));
    }
}

fn retry_ui(ui: &mut Ui, name: &str, job: Topic, commands: &mut Vec<Command>) {
    if ui.button(name).clicked() {
        commands.push(Command::Retry(job));
    }
}

/// What is said over a map that is not that of the settings: it is the one before.
pub fn over_map_ui(
    ui: &mut Ui,
    state: &MapState,
    words: &MapWords,
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
                cancel_ui(ui, note("Cancel"), words.job, commands);
            }
            MapState::Failed(why) => {
                let colour = colours(ui).error;
                retry_ui(ui, "Retry", words.job, commands);
                ui.add(egui::Label::new(egui::RichText::new(why).small().color(colour)).truncate());
            }
            MapState::Unanswerable(why) => {
                ui.add(egui::Label::new(note(why)).truncate());
            }
            _ => {
                ui.label(note("Stopped; this is the map before"));
                retry_ui(ui, "Retry", words.job, commands);
                ui.add_space(space::SMALL);
            }
        });
    });
}
