//! Running and finished work, with parameters and durations, so that nothing is lost sight of.

pub(crate) mod rows;
pub(crate) mod spec;

use egui::{Label, RichText, ScrollArea, Ui};

use crate::engine::Topic;
use crate::panes::commands::{Command, WorkCommand};
use crate::ui::controls::progress_text;
use crate::ui::controls::{empty_pane_ui, progress_bar_ui};
use crate::ui::style::{medium, note};
use crate::ui::theme::{colours, space};

/// State of a job.
#[derive(Clone, Debug, PartialEq)]
pub enum WorkState {
    /// It runs.
    Running {
        /// Done share in `0..=1`.
        fraction: f32,
        /// Estimated seconds left, once there is one.
        seconds_left: Option<f64>,
    },
    /// It brought its result.
    Done,
    /// It was asked to stop.
    Stopped,
    /// It could not be done.
    Failed(String),
}

/// One piece of work.
#[derive(Clone, Debug, PartialEq)]
pub struct WorkItem {
    /// What to cancel or to do again.
    pub kind: Topic,
    /// "Quasi-conformal distances".
    pub title: String,
    /// "184 poses · additive · μ 1 · λ 0.0001".
    pub parameters: String,
    /// Seconds that it took, or takes so far.
    pub duration_s: f64,
    /// Its state.
    pub state: WorkState,
}

/// Draws the list, latest first as given.
pub fn activity_ui(ui: &mut Ui, items: &[WorkItem], commands: &mut Vec<Command>) {
    if items.is_empty() {
        empty_pane_ui(
            ui,
            "No activity yet",
            "Files opened, analyses and exports, with their duration",
            |_| {},
        );
        return;
    }
    ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
        egui::Frame::new()
            .inner_margin(egui::Margin::same(space::LARGE as i8))
            .show(ui, |ui| {
                for (index, item) in items.iter().enumerate() {
                    ui.push_id(index, |ui| item_ui(ui, item, commands));
                    if index + 1 < items.len() {
                        ui.separator();
                    }
                }
            });
    });
}

fn item_ui(ui: &mut Ui, item: &WorkItem, commands: &mut Vec<Command>) {
    ui.spacing_mut().item_spacing.y = 2.0;
    egui::Sides::new().shrink_left().truncate().show(
        ui,
        |ui| {
            ui.label(medium(&item.title));
        },
        |ui| {
            ui.label(note(duration_text(item.duration_s)));
        },
    );
    if !item.parameters.is_empty() {
        ui.add(Label::new(note(&item.parameters)).truncate());
    }
    match &item.state {
        WorkState::Running {
            fraction,
            seconds_left,
        } => {
            progress_bar_ui(ui, ui.available_width(), *fraction, &item.title);
            egui::Sides::new().shrink_left().truncate().show(
                ui,
                |ui| ui.label(note(progress_text(*fraction, *seconds_left))),
                |ui| {
                    if ui
                        .button(note("Cancel"))
                        .on_hover_text(format!("Cancel: {}", item.title))
                        .clicked()
                    {
                        commands.push(Command::Work(WorkCommand::Cancel(item.kind)));
                    }
                },
            );
        }
        WorkState::Done => {
            ui.label(note("Done"));
        }
        WorkState::Stopped => again_ui(ui, "Stopped", None, item, commands),
        WorkState::Failed(why) => again_ui(ui, why, Some(colours(ui).error), item, commands),
    }
}

fn again_ui(
    ui: &mut Ui,
    what: &str,
    colour: Option<egui::Color32>,
    item: &WorkItem,
    commands: &mut Vec<Command>,
) {
    let mut text = RichText::new(what).small();
    text = match colour {
        Some(colour) => text.color(colour),
        None => text.weak(),
    };
    egui::Sides::new().shrink_left().truncate().show(
        ui,
        |ui| ui.add(Label::new(text).truncate()),
        |ui| {
            if ui
                .button(note("Retry"))
                .on_hover_text(format!("Retry: {}", item.title))
                .clicked()
            {
                commands.push(Command::Work(WorkCommand::Retry(item.kind)));
            }
        },
    );
}

/// "0.4 s", "12 s", "3 min 5 s".
fn duration_text(seconds: f64) -> String {
    if seconds < 9.95 {
        format!("{seconds:.1} s")
    } else if seconds < 120.0 {
        format!("{seconds:.0} s")
    } else {
        format!(
            "{:.0} min {:.0} s",
            (seconds / 60.0).floor(),
            seconds % 60.0
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::PoseMapParams;
    use egui_kittest::{Harness, kittest::Queryable as _};

    fn item(state: WorkState) -> WorkItem {
        WorkItem {
            kind: Topic::of::<PoseMapParams>(),
            title: "Pose map".to_owned(),
            parameters: "184 poses".to_owned(),
            duration_s: 1.25,
            state,
        }
    }

    #[test]
    fn running_work_can_be_stopped_and_stopped_work_done_again() {
        for (state, button, command) in [
            (
                WorkState::Running {
                    fraction: 0.5,
                    seconds_left: None,
                },
                "Cancel",
                Command::Work(WorkCommand::Cancel(Topic::of::<PoseMapParams>())),
            ),
            (
                WorkState::Stopped,
                "Retry",
                Command::Work(WorkCommand::Retry(Topic::of::<PoseMapParams>())),
            ),
            (
                WorkState::Failed("no poses".to_owned()),
                "Retry",
                Command::Work(WorkCommand::Retry(Topic::of::<PoseMapParams>())),
            ),
        ] {
            let items = [item(state)];
            let mut harness = Harness::builder()
                .with_context_setup(|ctx| crate::ui::style::apply(ctx, true))
                .build_ui_state(
                    |ui, commands: &mut Vec<Command>| activity_ui(ui, &items, commands),
                    Vec::new(),
                );
            harness.run();
            harness.get_by_label(button).click();
            harness.run();
            assert_eq!(harness.into_state(), [command]);
        }
    }

    #[test]
    fn durations_have_few_digits() {
        assert_eq!(duration_text(0.44), "0.4 s");
        assert_eq!(duration_text(12.4), "12 s");
        assert_eq!(duration_text(185.0), "3 min 5 s");
    }
}
