//! The steps "Walls" and "Cohort": the surfaces with how they fit, and their way into the study.

use egui::Ui;

use super::controls::{heading_ui, sentence_ui, warning_ui};
use super::current::Current;
use super::facts::{fit, needs_a_look};
use crate::analysis::preparation::BaseEnd;
use crate::engine::{ImageWallsQuery, MadeWalls, Topic};
use crate::panes::buttons::command_button_ui;
use crate::panes::commands::{Command, ImportCommand};
use crate::panes::pane_context::PaneContext;
use crate::panes::work_state::WorkState;
use crate::panes::work_ui::{WorkWords, work_lines_ui};
use crate::picture::sentence;
use crate::ui::controls::{choices_ui, chooser_ui};
use crate::ui::style::{medium, note};
use crate::ui::theme::space;

/// The work of the walls.
pub static WALLS: WorkWords = WorkWords {
    topic: Topic::of::<ImageWallsQuery>(),
    computing: "Making walls",
    meanwhile: "Volumes and fit follow",
    stopped: "Making walls was stopped",
    begin: "Make walls",
    failed: "There are no walls",
    unanswerable: "There are no walls",
    cancel: "Cancel making walls",
};

/// Draws the step "Walls".
pub fn ui(ui: &mut Ui, cx: &PaneContext<'_>, current: &Current, commands: &mut Vec<Command>) {
    let base = current.settings.base;
    ui.horizontal(|ui| {
        ui.label("Base");
        chooser_ui(ui, "Base", base_words(base), |ui| {
            let ends = [BaseEnd::Open, BaseEnd::Closed].map(|end| (end, base_words(end)));
            let chosen = choices_ui(ui, ends, base);
            commands.extend(
                chosen.and_then(|end| current.changed(false, |settings| settings.base = end)),
            );
        });
    });
    let mut correct = current.settings.correct_shifts;
    let what = "Slices of another breath-hold stand beside their neighbours";
    if ui
        .checkbox(&mut correct, "Put shifted slices back")
        .on_hover_text(what)
        .changed()
    {
        commands.extend(current.changed(false, |settings| settings.correct_shifts = correct));
    }
    let Some(showing) = current.ask_walls(cx) else {
        let missing: Vec<&str> = current.needed().iter().map(|asked| asked.words()).collect();
        warning_ui(ui, format!("Missing: {}", missing.join(", ")));
        return;
    };
    ui.add_space(space::SMALL);
    let before = showing.latest().map(|_| "Numbers of the settings before");
    work_lines_ui(ui, &WorkState::of(Some(&showing)), &WALLS, before, commands);
    if let Some(made) = showing.latest() {
        made_ui(ui, made);
    }
}

fn base_words(end: BaseEnd) -> &'static str {
    match end {
        BaseEnd::Open => "ends at the valve",
        BaseEnd::Closed => "closed by a lid",
    }
}

fn made_ui(ui: &mut Ui, made: &MadeWalls) {
    ui.label(medium(volume_words(made)));
    let fit = fit(made);
    sentence_ui(
        ui,
        format!(
            "Fit {:.1} mm mean · {:.1} mm 95th percentile, worst frame · {}",
            fit.mean_mm,
            fit.p95_mm,
            match fit.foldovers {
                0 => "no face folded over".to_owned(),
                count => format!("{count} faces folded over"),
            }
        ),
    );
    if let Some(what) = needs_a_look(made) {
        warning_ui(ui, format!("Needs a look: {what}"));
    }
    heading_ui(ui, "How they were made");
    for notice in &made.subject.notices {
        sentence_ui(ui, sentence(&notice.text));
    }
}

/// "EDV 104 ml · ESV 66 ml · EF 36 %".
fn volume_words(made: &MadeWalls) -> String {
    let measures = &made.measures;
    let unit = made.subject.unit.volume_symbol();
    let volume =
        |name: &str, value: Option<f64>| value.map(|value| format!("{name} {value:.0} {unit}"));
    let parts = [
        volume("EDV", measures.edv),
        volume("ESV", measures.esv),
        measures.ef.map(|ef| format!("EF {:.0} %", 100.0 * ef)),
    ];
    let parts: Vec<String> = parts.into_iter().flatten().collect();
    parts.join(" · ")
}

/// Whether the study has the walls of these settings.
pub fn is_in_cohort(cx: &PaneContext<'_>, current: &Current) -> bool {
    let document = &cx.state().document;
    let subject = document.subject_of_images(current.images);
    let subject = subject.and_then(|subject| document.study().subject(subject));
    let made = cx.known(&current.walls_query());
    match (subject, made) {
        (Some(subject), Some(made)) => subject.sequence.id() == made.subject.sequence.id(),
        (Some(_), None) => !document.import.settings.contains_key(&current.images),
        (None, _) => false,
    }
}

/// Draws the step "Cohort".
pub fn cohort_ui(
    ui: &mut Ui,
    cx: &PaneContext<'_>,
    current: &Current,
    commands: &mut Vec<Command>,
) {
    let document = &cx.state().document;
    if is_in_cohort(cx, current) {
        sentence_ui(
            ui,
            format!("{} is in the cohort with these walls.", current.id),
        );
        return;
    }
    let Some(showing) = current.ask_walls(cx) else {
        sentence_ui(ui, "There are no walls yet: a step above misses something.");
        return;
    };
    work_lines_ui(ui, &WorkState::of(Some(&showing)), &WALLS, None, commands);
    if showing.ready().is_none() {
        return;
    }
    let replaces = document.subject_of_images(current.images).is_some();
    let words = match replaces {
        true => format!("Replace the walls of {}", current.id),
        false => format!("Add {} to the cohort", current.id),
    };
    let add = ImportCommand::Add(vec![(current.images, current.settings.clone())]);
    command_button_ui(ui, words, add, commands);
    ui.label(note("One step of undo takes it back"));
}
