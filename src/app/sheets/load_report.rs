//! The load report: per subject, what was read and what was assumed; warnings first.

use egui::{CollapsingHeader, RichText, ScrollArea, TextEdit, Ui};

use crate::panes::commands::{Command, WindowCommand};
use crate::study::{Notice, Severity};
use crate::ui::controls::dialog_ui;
use crate::ui::style::{medium, note};
use crate::ui::text::counted;
use crate::ui::theme::{colours, space};

/// What was read of one subject.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ReportSubject {
    /// Pseudonym, or the name of what could not be read.
    pub id: String,
    /// "25 frames · endo + epi · 2562 vertices · mm".
    pub summary: String,
    /// Findings.
    pub notices: Vec<Notice>,
    /// Why it could not be read; it is then not part of the study.
    pub error: Option<String>,
}

impl ReportSubject {
    fn warnings(&self) -> usize {
        self.notices
            .iter()
            .filter(|notice| notice.severity == Severity::Warning)
            .count()
    }

    /// Errors first, then warnings, then notes.
    fn rank(&self) -> u8 {
        if self.error.is_some() {
            0
        } else if self.warnings() > 0 {
            1
        } else if !self.notices.is_empty() {
            2
        } else {
            3
        }
    }

    fn matches(&self, words: &str) -> bool {
        let text = format!(
            "{} {} {} {}",
            self.id,
            self.summary,
            self.error.as_deref().unwrap_or_default(),
            self.notices
                .iter()
                .map(|notice| notice.text.as_str())
                .collect::<Vec<_>>()
                .join(" ")
        )
        .to_lowercase();
        words
            .to_lowercase()
            .split_whitespace()
            .all(|word| text.contains(word))
    }
}

/// Draws the window; Esc or its cross closes it.
pub fn load_report_ui(ui: &mut Ui, subjects: &[ReportSubject], commands: &mut Vec<Command>) {
    let ctx = ui.ctx().clone();
    let size = egui::vec2(600.0, 480.0);
    if dialog_ui(&ctx, "Load report", size, true, |ui| {
        report_ui(ui, subjects);
    }) {
        commands.push(WindowCommand::ToggleLoadReport.into());
    }
}

fn report_ui(ui: &mut Ui, subjects: &[ReportSubject]) {
    let id = ui.scope_id().with("filter");
    let (mut filter, mut only_warnings) = ui
        .data(|data| data.get_temp::<(String, bool)>(id))
        .unwrap_or_default();
    ui.horizontal(|ui| {
        let edit = TextEdit::singleline(&mut filter)
            .hint_text("Filter…")
            .desired_width(200.0);
        ui.add(edit).accessible_name("Filter the load report");
        ui.checkbox(&mut only_warnings, "Only warnings and errors");
    });
    ui.label(note(summary_text(subjects)));
    ui.separator();
    let mut shown: Vec<&ReportSubject> = subjects
        .iter()
        .filter(|subject| subject.matches(&filter) && (!only_warnings || subject.rank() < 2))
        .collect();
    shown.sort_by_key(|subject| subject.rank());
    ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
        if shown.is_empty() {
            ui.label(note("Nothing to report"));
        }
        for (index, subject) in shown.into_iter().enumerate() {
            ui.push_id((index, &subject.id), |ui| subject_ui(ui, subject));
        }
    });
    ui.data_mut(|data| data.insert_temp(id, (filter, only_warnings)));
}

fn subject_ui(ui: &mut Ui, subject: &ReportSubject) {
    let colours = colours(ui);
    let colour = match subject.rank() {
        0 => colours.error,
        1 => colours.warning,
        _ => colours.text,
    };
    CollapsingHeader::new(medium(&subject.id).color(colour))
        .default_open(subject.rank() < 2)
        .show(ui, |ui| {
            if !subject.summary.is_empty() {
                ui.label(note(&subject.summary));
            }
            if let Some(error) = &subject.error {
                ui.label(RichText::new(error).color(colours.error));
            }
            let mut notices: Vec<&Notice> = subject.notices.iter().collect();
            notices.sort_by_key(|notice| std::cmp::Reverse(notice.severity));
            for notice in notices {
                let warning = notice.severity == Severity::Warning;
                let mark = if warning { "!" } else { "·" };
                let colour = if warning {
                    colours.warning
                } else {
                    colours.muted
                };
                ui.horizontal_wrapped(|ui| {
                    ui.spacing_mut().item_spacing.x = space::MEDIUM;
                    ui.label(RichText::new(mark).strong().color(colour));
                    ui.label(&notice.text);
                });
            }
        });
}

fn summary_text(subjects: &[ReportSubject]) -> String {
    let failed = subjects
        .iter()
        .filter(|subject| subject.error.is_some())
        .count();
    let warnings: usize = subjects.iter().map(ReportSubject::warnings).sum();
    let notices: usize = subjects.iter().map(|subject| subject.notices.len()).sum();
    format!(
        "{} read · {failed} unreadable · {} · {}",
        subjects.len() - failed,
        counted(warnings, "warning"),
        counted(notices - warnings, "note")
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui_kittest::{Harness, kittest::Queryable as _};

    #[test]
    fn warnings_come_before_notes_and_can_be_seen_alone() {
        let subjects = [
            ReportSubject {
                id: "good".to_owned(),
                notices: vec![Notice::info("found units")],
                ..Default::default()
            },
            ReportSubject {
                id: "odd".to_owned(),
                notices: vec![Notice::warning("2 degenerate triangles")],
                ..Default::default()
            },
        ];
        let mut harness = Harness::builder()
            .with_size([800.0, 600.0])
            .with_context_setup(|ctx| crate::ui::style::apply(ctx, true))
            .build_ui_state(
                |ui, commands: &mut Vec<Command>| load_report_ui(ui, &subjects, commands),
                Vec::new(),
            );
        harness.run();
        harness.get_by_label("2 read · 0 unreadable · 1 warning · 1 note");
        let odd = harness.get_by_label("odd").rect();
        assert!(odd.top() < harness.get_by_label("good").rect().top());
        harness.get_by_label("2 degenerate triangles");
        harness.get_by_label("Only warnings and errors").click();
        harness.run();
        assert!(harness.query_by_label("good").is_none());
        harness.key_press(egui::Key::Escape);
        harness.run();
        assert_eq!(
            harness.into_state(),
            [Command::Window(WindowCommand::ToggleLoadReport)]
        );
    }
}
