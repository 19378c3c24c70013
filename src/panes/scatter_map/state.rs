//! How a map stands, and what is said where it is not that of the settings.

use egui::{Rect, Ui, vec2};

use crate::panes::buttons::command_button_ui;
use crate::panes::commands::{Command, WorkCommand};
use crate::panes::work_state::WorkState;
use crate::panes::work_ui::{WorkWords, cancel_button_ui, work_pane_ui, work_progress_ui};
use crate::ui::style::note;
use crate::ui::theme::{colours, space};

use super::view::ScatterView;

fn work_words(view: &ScatterView) -> WorkWords {
    WorkWords {
        topic: view.job,
        computing: "Computing the map",
        meanwhile: "Other panes remain usable.",
        stopped: "Map computation stopped",
        begin: "Compute the map",
        failed: view.words.none,
        unanswerable: view.words.none,
        cancel: "Cancel",
    }
}

/// Draws a pane that has no map to show.
pub fn without_map_ui(ui: &mut Ui, view: &ScatterView, commands: &mut Vec<Command>) {
    let empty = [view.words.empty, view.words.what];
    work_pane_ui(ui, &view.state, &work_words(view), empty, commands);
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
                let words = work_words(view);
                work_progress_ui(ui, &view.state, &words, (width - 190.0).max(30.0));
                cancel_button_ui(ui, note("Cancel"), &words, commands);
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
