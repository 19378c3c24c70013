//! How the answer of a pane stands, drawn: once for a pane that has nothing else to show, once for lines above what it
//! shows. Every pane with work of its own uses one of the two.

use egui::{Label, Response, RichText, Role, Ui, WidgetInfo, WidgetText};

use crate::engine::{Topic, WallThickeningQuery};
use crate::panes::buttons::command_button_ui;
use crate::panes::commands::{Command, WorkCommand};
use crate::panes::work_state::WorkState;
use crate::ui::controls::{empty_pane_ui, progress_bar_ui};
use crate::ui::style::{medium, note};
use crate::ui::text::progress_text;
use crate::ui::theme::{colours, space};

/// What a pane says of its work.
#[derive(Clone, Copy, Debug)]
pub struct WorkWords {
    /// Which work Cancel stops and Retry begins again.
    pub topic: Topic,
    /// While it is computed; also what the progress bar is called.
    pub computing: &'static str,
    /// Below that.
    pub meanwhile: &'static str,
    /// After the user stopped it.
    pub stopped: &'static str,
    /// Begins it after that.
    pub begin: &'static str,
    /// Above the reason of a failure.
    pub failed: &'static str,
    /// Above the reason why there is no answer.
    pub unanswerable: &'static str,
    /// Cancel, as a screen reader says it.
    pub cancel: &'static str,
}

/// The work of all panes about how a wall thickens.
pub(crate) static WALL_WORK: WorkWords = WorkWords {
    topic: Topic::of::<WallThickeningQuery>(),
    computing: "Fitting medial spheres",
    meanwhile: "Wall thickness and thickening follow",
    stopped: "The measurement was stopped",
    begin: "Measure again",
    failed: "The wall could not be measured",
    unanswerable: "Not assessed",
    cancel: "Cancel measurement",
};

/// Of results that are shown while a threshold changes.
pub(crate) const PREVIOUS_THRESHOLDS: &str = "Results of the previous thresholds";

/// Draws a pane that has no answer to show; `empty` is said where there is nothing to compute: a heading, and what would
/// fill the pane.
pub fn work_pane_ui(
    ui: &mut Ui,
    state: &WorkState,
    words: &WorkWords,
    empty: [&str; 2],
    commands: &mut Vec<Command>,
) {
    let [heading, what] = empty;
    let retry = WorkCommand::Retry(words.topic);
    match state {
        WorkState::Empty | WorkState::Waiting | WorkState::Ready => {
            empty_pane_ui(ui, heading, what, |_| {});
        }
        WorkState::Computing { .. } => {
            empty_pane_ui(ui, words.computing, words.meanwhile, |ui| {
                let width = 200f32.min(ui.available_width());
                work_progress_ui(ui, state, words, width);
                cancel_button_ui(ui, "Cancel", words, commands);
            });
        }
        WorkState::Stopped => empty_pane_ui(ui, words.stopped, what, |ui| {
            command_button_ui(ui, words.begin, retry, commands);
        }),
        WorkState::Failed(why) => empty_pane_ui(ui, words.failed, why, |ui| {
            command_button_ui(ui, "Retry", retry, commands);
        }),
        WorkState::Unanswerable(why) => empty_pane_ui(ui, words.unanswerable, why, |_| {}),
    }
}

/// Draws lines about an answer that is not that of the settings; `before` says what is shown below them, if anything is.
pub fn work_lines_ui(
    ui: &mut Ui,
    state: &WorkState,
    words: &WorkWords,
    before: Option<&str>,
    commands: &mut Vec<Command>,
) {
    let retry = WorkCommand::Retry(words.topic);
    let lines = |ui: &mut Ui, heading: &str, what: &str| {
        if before.is_none() {
            ui.label(medium(heading));
        }
        ui.add(Label::new(note(what)).wrap());
    };
    match state {
        WorkState::Empty | WorkState::Ready => return,
        WorkState::Waiting => lines(ui, "Waiting", "Starts after the maps"),
        WorkState::Computing { .. } => {
            lines(ui, words.computing, before.unwrap_or(words.meanwhile));
            let width = ui.available_width().min(180.0);
            work_progress_ui(ui, state, words, width);
            cancel_button_ui(ui, note("Cancel"), words, commands);
        }
        WorkState::Stopped => {
            ui.label(note(words.stopped));
            command_button_ui(ui, words.begin, retry, commands);
        }
        WorkState::Failed(why) => {
            ui.label(medium(words.failed).color(colours(ui).error));
            ui.add(Label::new(RichText::new(why).weak()).wrap());
            command_button_ui(ui, "Retry", retry, commands);
        }
        WorkState::Unanswerable(why) => {
            ui.label(medium(words.unanswerable));
            ui.add(Label::new(RichText::new(why).weak()).wrap());
        }
    }
    ui.add_space(space::MEDIUM);
}

/// A bar with the share and the time left; what is being done is said by the pointer.
pub fn work_progress_ui(ui: &mut Ui, state: &WorkState, words: &WorkWords, width: f32) {
    if let WorkState::Computing {
        fraction,
        phase,
        seconds_left,
    } = state
    {
        progress_bar_ui(ui, width, *fraction, words.computing);
        let text = ui.label(note(progress_text(*fraction, *seconds_left)));
        if !phase.is_empty() {
            text.on_hover_text(phase);
        }
    }
}

/// Stops the work.
pub fn cancel_button_ui(
    ui: &mut Ui,
    text: impl Into<WidgetText>,
    words: &WorkWords,
    commands: &mut Vec<Command>,
) -> Response {
    let cancel = WorkCommand::Cancel(words.topic);
    let button = command_button_ui(ui, text, cancel, commands);
    button.widget_info(|| WidgetInfo::labeled(Role::Button, true, words.cancel));
    button
}
