//! The status bar: running work, the graphics driver, the intended use.

use egui::{Align, Button, Layout, RichText, Ui};

use crate::engine::Topic;
use crate::panes::buttons::command_button_ui;
use crate::panes::commands::{Command, WindowCommand, WorkCommand};
use crate::ui::controls::progress_bar_ui;
use crate::ui::style::note;
use crate::ui::text::counted;
use crate::ui::text::progress_text;
use crate::ui::theme::{colours, space};

/// Running work.
#[derive(Clone, Debug, PartialEq)]
pub struct StatusJob {
    /// What to cancel.
    pub topic: Topic,
    /// What it is, in the words of the activity list.
    pub text: String,
    /// Done share in `0..=1`.
    pub fraction: f32,
    /// Estimated seconds left, once there is one.
    pub seconds_left: Option<f64>,
}

/// What the status bar shows.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StatusBarView<'a> {
    /// The running work; the longest, if there is more than one.
    pub job: Option<StatusJob>,
    /// How many more jobs run.
    pub more_jobs: usize,
    /// The last message, while no work runs.
    pub message: &'a str,
    /// Name of the graphics adapter.
    pub adapter: &'a str,
    /// Lines of the load report.
    pub notice_count: usize,
    /// Those of them that can affect results.
    pub warning_count: usize,
}

/// Draws progress with Cancel on the left; notes, driver and intended use on the right.
pub fn status_bar_ui(ui: &mut Ui, view: &StatusBarView, commands: &mut Vec<Command>) {
    let width = ui.available_width();
    ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
        ui.add_space(space::LARGE);
        if width > 520.0 {
            ui.label(note("Research use, not for diagnosis"));
            ui.add_space(space::MEDIUM);
        }
        if width > 760.0 && !view.adapter.is_empty() {
            ui.label(note(view.adapter))
                .on_hover_text("Graphics driver of the 3D view");
            ui.add_space(space::MEDIUM);
        }
        notices_ui(ui, view, commands);
        ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
            ui.add_space(space::LARGE);
            match &view.job {
                Some(job) => job_ui(ui, job, view.more_jobs, commands),
                None => {
                    ui.add(egui::Label::new(note(view.message)).truncate());
                }
            }
        });
    });
}

fn notices_ui(ui: &mut Ui, view: &StatusBarView, commands: &mut Vec<Command>) {
    let (text, colour) = match (view.warning_count, view.notice_count) {
        (0, 0) => return,
        (0, notes) => (counted(notes, "note"), colours(ui).muted),
        (warnings, _) => (counted(warnings, "warning"), colours(ui).warning),
    };
    let button = Button::new(RichText::new(text).small().color(colour)).frame_when_inactive(false);
    if ui
        .add(button)
        .on_hover_text("Open the load report")
        .clicked()
    {
        commands.push(WindowCommand::ToggleLoadReport.into());
    }
}

fn job_ui(ui: &mut Ui, job: &StatusJob, more: usize, commands: &mut Vec<Command>) {
    let rest = 290.0;
    let text_width = (ui.available_width() - rest).clamp(40.0, 320.0);
    let galley_width = text_width.min(ui.available_width());
    ui.scope(|ui| {
        ui.set_max_width(galley_width);
        ui.add(egui::Label::new(note(&job.text)).truncate());
    });
    if ui.available_width() > 260.0 {
        let width = (ui.available_width() - 200.0).clamp(40.0, 220.0);
        progress_bar_ui(ui, width, job.fraction, &job.text);
    }
    ui.label(note(progress_text(job.fraction, job.seconds_left)));
    command_button_ui(ui, note("Cancel"), WorkCommand::Cancel(job.topic), commands)
        .on_hover_text(format!("Cancel: {}", job.text));
    if more > 0 && ui.available_width() > 60.0 {
        ui.label(note(format!("+ {more} more")));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::PoseMapQuery;
    use egui_kittest::{Harness, kittest::Queryable as _};

    #[test]
    fn cancel_stops_the_job_that_is_shown() {
        let mut harness = Harness::builder()
            .with_context_setup(|ctx| crate::ui::style::apply(ctx, true))
            .build_ui_state(
                |ui, commands: &mut Vec<Command>| {
                    let view = StatusBarView {
                        job: Some(StatusJob {
                            topic: Topic::of::<PoseMapQuery>(),
                            text: "Quasi-conformal distances".to_owned(),
                            fraction: 0.714,
                            seconds_left: Some(3.2),
                        }),
                        warning_count: 2,
                        notice_count: 5,
                        ..Default::default()
                    };
                    status_bar_ui(ui, &view, commands);
                },
                Vec::new(),
            );
        harness.run();
        harness.get_by_label("71 % · 4 s left");
        harness.get_by_label("Cancel").click();
        harness.run();
        harness.get_by_label("2 warnings").click();
        harness.run();
        assert_eq!(
            harness.into_state(),
            [
                Command::Work(WorkCommand::Cancel(Topic::of::<PoseMapQuery>())),
                Command::Window(WindowCommand::ToggleLoadReport)
            ]
        );
    }
}
