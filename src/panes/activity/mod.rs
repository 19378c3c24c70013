//! Running and finished work, with parameters and durations, so that nothing is lost sight of.

pub(crate) mod spec;

use egui::{Label, RichText, ScrollArea, Sides, Ui};

use crate::engine::{Activity, ActivityState};
use crate::panes::buttons::command_button_ui;
use crate::panes::commands::{Command, WorkCommand};
use crate::ui::controls::{empty_pane_ui, progress_bar_ui};
use crate::ui::style::{medium, note};
use crate::ui::text::progress_text;
use crate::ui::theme::{colours, space};

/// Draws the list, latest first as given.
pub fn activity_ui(ui: &mut Ui, items: &[Activity], commands: &mut Vec<Command>) {
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

fn item_ui(ui: &mut Ui, item: &Activity, commands: &mut Vec<Command>) {
    ui.spacing_mut().item_spacing.y = 2.0;
    let sides = || Sides::new().shrink_left().truncate();
    sides().show(
        ui,
        |ui| ui.label(medium(&item.name)),
        |ui| ui.label(note(duration_text(item.duration.as_secs_f64()))),
    );
    if !item.parameters.is_empty() {
        ui.add(Label::new(note(&item.parameters)).truncate());
    }
    let mut beside = |ui: &mut Ui, text: RichText, button: &str, command: WorkCommand| {
        sides().show(
            ui,
            |ui| ui.add(Label::new(text).truncate()),
            |ui| {
                command_button_ui(ui, note(button), command, commands)
                    .on_hover_text(format!("{button}: {}", item.name));
            },
        );
    };
    match &item.state {
        ActivityState::Running {
            fraction,
            time_left,
            ..
        } => {
            progress_bar_ui(ui, ui.available_width(), *fraction, &item.name);
            let left = time_left.map(|left| left.as_secs_f64());
            let text = note(progress_text(*fraction, left));
            beside(ui, text, "Cancel", WorkCommand::Cancel(item.topic));
        }
        ActivityState::Done => {
            ui.label(note("Done"));
        }
        ActivityState::Stopped => {
            let retry = WorkCommand::Retry(item.topic);
            beside(ui, RichText::new("Stopped").small().weak(), "Retry", retry);
        }
        ActivityState::Failed(why) => {
            let text = RichText::new(why).small().color(colours(ui).error);
            beside(ui, text, "Retry", WorkCommand::Retry(item.topic));
        }
    }
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
    use crate::engine::{PoseMapQuery, Topic};
    use egui_kittest::{Harness, kittest::Queryable as _};
    use std::time::Duration;

    fn item(state: ActivityState) -> Activity {
        Activity {
            number: 0,
            topic: Topic::of::<PoseMapQuery>(),
            name: "Pose map".to_owned(),
            parameters: "184 poses".to_owned(),
            asked_ago: Duration::from_millis(1250),
            duration: Duration::from_millis(1250),
            state,
        }
    }

    #[test]
    fn running_work_can_be_stopped_and_stopped_work_done_again() {
        for (state, button, command) in [
            (
                ActivityState::Running {
                    fraction: 0.5,
                    phase: "",
                    time_left: None,
                },
                "Cancel",
                Command::Work(WorkCommand::Cancel(Topic::of::<PoseMapQuery>())),
            ),
            (
                ActivityState::Stopped,
                "Retry",
                Command::Work(WorkCommand::Retry(Topic::of::<PoseMapQuery>())),
            ),
            (
                ActivityState::Failed("no poses".to_owned()),
                "Retry",
                Command::Work(WorkCommand::Retry(Topic::of::<PoseMapQuery>())),
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
