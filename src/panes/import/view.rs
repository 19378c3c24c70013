//! The pane "Import": the steps below each other, the open one with its controls, and the way on and back.

use egui::{Frame, Margin, Rect, Sense, Ui, WidgetInfo, vec2};

use super::controls::warning_ui;
use super::current::{Current, step_name};
use super::{step_images, step_orientation, step_tissue, step_walls};
use crate::document::{ImportStep, State};
use crate::panes::buttons::command_button_ui;
use crate::panes::commands::{Command, FileCommand, ImportCommand};
use crate::panes::pane_context::PaneContext;
use crate::ui::controls::{empty_pane_ui, focus_ring};
use crate::ui::style::{medium, note, title_font};
use crate::ui::theme::{colours, line, space};

/// With so much room the button on says whereto.
const WIDE: f32 = 180.0;
/// Height of the strip with the buttons.
const FOOTER: f32 = 40.0;

/// Draws the steps, or what would fill the pane.
pub fn import_ui(ui: &mut Ui, cx: &PaneContext<'_>, commands: &mut Vec<Command>) {
    let state = cx.state();
    let Some(current) = Current::shown(cx) else {
        nothing_ui(ui, state, commands);
        return;
    };
    let whole = ui.available_rect_before_wrap();
    let (above, below) = whole.split_top_bottom_at_y(whole.bottom() - FOOTER);
    let mut steps = ui.new_child(egui::UiBuilder::new().max_rect(above));
    steps.set_clip_rect(above.intersect(ui.clip_rect()));
    crate::ui::controls::scrolled_ui(&mut steps, "import", Margin::ZERO, |ui| {
        Frame::new()
            .inner_margin(Margin::symmetric(12, 4))
            .show(ui, |ui| {
                let id = egui::RichText::new(&current.id).font(title_font());
                let title = id.color(colours(ui).strong);
                ui.add(egui::Label::new(title).truncate());
            });
        for step in ImportStep::ALL {
            step_ui(ui, cx, &current, step, commands);
        }
    });
    let mut footer = ui.new_child(egui::UiBuilder::new().max_rect(below));
    footer_ui(&mut footer, cx, &current, commands);
}

fn nothing_ui(ui: &mut Ui, state: &State, commands: &mut Vec<Command>) {
    let document = &state.document;
    if document.shown_series().is_some() {
        empty_pane_ui(ui, "Looking at the images", "", |_| {});
        return;
    }
    let heading = match document
        .selected()
        .filter(|_| !document.images().is_empty())
    {
        Some(subject) => format!("No images of {}", subject.id),
        None => "No images to import".to_owned(),
    };
    let what = "Open gated SPECT, cine MR or label images: walls in correspondence are made of them here, step by step.";
    empty_pane_ui(ui, &heading, what, |ui| {
        command_button_ui(ui, "Open folder…", FileCommand::ChooseFolder, commands);
    });
}

/// How a step stands, at the right of its name.
enum Standing {
    Done,
    Missing(String),
    Open,
    ToCome,
}

fn standing(cx: &PaneContext<'_>, current: &Current, step: ImportStep) -> Standing {
    let document = &cx.state().document;
    let missing: Vec<&str> = (current.needed().iter())
        .filter(|asked| step_images::step_of(**asked) == step)
        .map(|asked| asked.words())
        .collect();
    if !missing.is_empty() {
        return Standing::Missing(missing.join(", "));
    }
    match step {
        _ if step == document.import.step => Standing::Open,
        ImportStep::Cohort if step_walls::is_in_cohort(cx, current) => Standing::Done,
        ImportStep::Walls if cx.known(&current.walls_query()).is_some() => Standing::Done,
        _ if step < document.import.step => Standing::Done,
        _ => Standing::ToCome,
    }
}

fn step_ui(
    ui: &mut Ui,
    cx: &PaneContext<'_>,
    current: &Current,
    step: ImportStep,
    commands: &mut Vec<Command>,
) {
    let open = cx.state().document.import.step == step;
    let standing = standing(cx, current, step);
    let name = step_name(step, current.settings.road);
    if row_ui(ui, (step, name), &standing, open) {
        commands.push(ImportCommand::GoTo(step).into());
    }
    if !open {
        return;
    }
    let margin = Margin {
        left: 16,
        right: 12,
        top: 2,
        bottom: 10,
    };
    Frame::new().inner_margin(margin).show(ui, |ui| {
        ui.spacing_mut().item_spacing.y = space::SMALL;
        if let Standing::Missing(what) = &standing {
            warning_ui(ui, format!("Missing: {what}"));
        }
        match step {
            ImportStep::Images => step_images::ui(ui, current, commands),
            ImportStep::Orientation => step_orientation::ui(ui, cx, current, commands),
            ImportStep::Tissue => step_tissue::ui(ui, cx, current, commands),
            ImportStep::Walls => step_walls::ui(ui, cx, current, commands),
            ImportStep::Cohort => step_walls::cohort_ui(ui, cx, current, commands),
        }
    });
}

/// The line of a step; whether it was clicked.
fn row_ui(ui: &mut Ui, (step, name): (ImportStep, &str), standing: &Standing, open: bool) -> bool {
    let colours = colours(ui);
    let size = vec2(ui.available_width(), space::ROW + space::MEDIUM);
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    let title = format!("{} {name}", step.number());
    response.widget_info(|| WidgetInfo::selected(egui::Role::Button, true, open, &title));
    if open || response.hovered() {
        ui.painter().rect_filled(rect, 0.0, colours.selected_row);
    }
    if open {
        let bar = Rect::from_min_size(rect.min, vec2(line::STRONG + 1.0, rect.height()));
        ui.painter().rect_filled(bar, 0.0, colours.selection);
    }
    focus_ring(ui, &response);
    let mut row = ui.new_child(
        egui::UiBuilder::new()
            .max_rect(rect.shrink2(vec2(space::LARGE, 0.0)))
            .layout(egui::Layout::left_to_right(egui::Align::Center)),
    );
    row.label(note(step.number().to_string()));
    row.label(medium(name));
    row.with_layout(egui::Layout::right_to_left(egui::Align::Center), |ui| {
        let (words, colour) = match standing {
            Standing::Done => ("done", colours.normal),
            Standing::Missing(_) => ("needed", colours.warning),
            Standing::Open => ("open", colours.selection),
            Standing::ToCome => ("", colours.muted),
        };
        let words = egui::RichText::new(words).text_style(egui::TextStyle::Small);
        ui.label(words.color(colour));
    });
    response.clicked()
}

fn footer_ui(ui: &mut Ui, cx: &PaneContext<'_>, current: &Current, commands: &mut Vec<Command>) {
    let step = cx.state().document.import.step;
    let top = ui.max_rect().top();
    let stroke = egui::Stroke::new(line::THIN, colours(ui).line);
    ui.painter().hline(ui.max_rect().x_range(), top, stroke);
    ui.with_layout(egui::Layout::left_to_right(egui::Align::Center), |ui| {
        ui.add_space(space::LARGE);
        ui.add_enabled_ui(step != ImportStep::Images, |ui| {
            command_button_ui(ui, "Back", ImportCommand::Step(-1), commands);
        });
        let Some(next) = step.stepped(1) else {
            return;
        };
        let colours = colours(ui);
        let name = step_name(next, current.settings.road).to_lowercase();
        let words = match ui.available_width() > WIDE {
            true => format!("Continue to {name}"),
            false => "Continue".to_owned(),
        };
        let text = egui::RichText::new(words).color(colours.on_accent);
        if ui
            .add(egui::Button::new(text).fill(colours.accent))
            .clicked()
        {
            commands.push(ImportCommand::Step(1).into());
        }
    });
}
