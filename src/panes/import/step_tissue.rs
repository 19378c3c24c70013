//! The step between orientation and walls: what the wall is, by a threshold with edits, by labels, or by outlines.

use egui::Ui;

use super::controls::{SliderRow, heading_ui, sentence_ui, slider_ui};
use super::current::Current;
use super::tools::tool_words;
use crate::analysis::preparation::Road;
use crate::document::ImageTool;
use crate::engine::{ImagePreviewQuery, ImageTissuesQuery, Topic};
use crate::image::VolumeEdit;
use crate::panes::commands::{Command, ImportCommand};
use crate::panes::pane_context::PaneContext;
use crate::panes::work_state::WorkState;
use crate::panes::work_ui::{WorkWords, work_lines_ui};
use crate::ui::style::note;
use crate::ui::theme::space;

/// The share of the maximum that the slider of the threshold begins with.
const THRESHOLD: f64 = 0.5;

/// The work of the preview.
static PREVIEW: WorkWords = WorkWords {
    topic: Topic::of::<ImagePreviewQuery>(),
    computing: "Making the preview",
    meanwhile: "The surface of the threshold follows",
    stopped: "The preview was stopped",
    begin: "Make the preview",
    failed: "No surface at this threshold",
    unanswerable: "No preview",
    cancel: "Cancel the preview",
};

/// The work of the outlines.
static TISSUES: WorkWords = WorkWords {
    topic: Topic::of::<ImageTissuesQuery>(),
    computing: "Following blood and wall through the beat",
    meanwhile: "Outlines follow",
    stopped: "Finding the ventricle was stopped",
    begin: "Find the ventricle",
    failed: "The ventricle was not found",
    unanswerable: "No outlines",
    cancel: "Cancel finding the ventricle",
};

/// Draws the step.
pub fn ui(ui: &mut Ui, cx: &PaneContext<'_>, current: &Current, commands: &mut Vec<Command>) {
    match current.settings.road {
        Road::Spect => {
            sentence_ui(
                ui,
                "What is brighter than the threshold is drawn over the slices. Take away what is no heart.",
            );
            threshold_ui(ui, current, cx.pointer_held, commands);
            edits_ui(ui, cx, current, commands);
        }
        Road::Masks(_) => {
            sentence_ui(
                ui,
                "The tissues are those of the labels. Take away what is no heart.",
            );
            edits_ui(ui, cx, current, commands);
        }
        Road::Cine | Road::Contours => contours_ui(ui, cx, current, commands),
    }
    if let Some(query) = current.preview_query(&cx.state().document) {
        let showing = cx.ask(&query);
        // A preview takes a blink; only what is wrong is said.
        if showing.failure().is_some() {
            work_lines_ui(ui, &WorkState::of(Some(&showing)), &PREVIEW, None, commands);
        }
    }
}

fn threshold_ui(ui: &mut Ui, current: &Current, held: bool, commands: &mut Vec<Command>) {
    let settings = &current.settings;
    let blur = SliderRow {
        name: "Blur",
        what: "Standard deviation of the Gaussian blur before the threshold",
        unit: "mm",
        digits: 1,
        range: 0.0..=12.0,
    };
    if let Some(mm) = slider_ui(ui, &blur, settings.blur_mm) {
        commands.extend(current.changed(held, |settings| settings.blur_mm = mm));
    }
    let threshold = SliderRow {
        name: "Threshold",
        what: "What is bright, as a share of the maximum of each volume",
        unit: "%",
        digits: 0,
        range: 5.0..=95.0,
    };
    let share = 100.0 * settings.threshold.unwrap_or(THRESHOLD);
    if let Some(percent) = slider_ui(ui, &threshold, share) {
        let share = 0.01 * percent;
        commands.extend(current.changed(held, |settings| settings.threshold = Some(share)));
    }
    if settings.threshold.is_some() {
        let automatic = egui::Button::new(note("Automatic threshold")).frame(false);
        if ui.add(automatic).clicked() {
            commands.extend(current.changed(false, |settings| settings.threshold = None));
        }
    }
}

fn edits_ui(ui: &mut Ui, cx: &PaneContext<'_>, current: &Current, commands: &mut Vec<Command>) {
    heading_ui(ui, "Edits");
    let state = cx.state();
    ui.horizontal_wrapped(|ui| {
        for tool in [ImageTool::Eraser, ImageTool::Cut, ImageTool::Keep] {
            let [name, what] = tool_words(tool);
            let in_hand = state.image_tool == Some(tool);
            let button = egui::Button::new(name).selected(in_hand);
            if ui.add(button).on_hover_text(what).clicked() {
                commands.push(ImportCommand::UseTool(Some(tool)).into());
            }
        }
        for (name, edit, what) in [
            (
                "Largest part",
                VolumeEdit::LargestComponent,
                "Only the largest connected part is kept",
            ),
            (
                "Fill holes",
                VolumeEdit::FillHoles,
                "What is enclosed on all sides counts as inside",
            ),
        ] {
            if ui.button(name).on_hover_text(what).clicked() {
                commands.extend(current.changed(false, |settings| settings.edits.push(edit)));
            }
        }
    });
    if state.image_tool == Some(ImageTool::Eraser) {
        let radius = SliderRow {
            name: "Radius of the eraser",
            what: "Spheres of this radius are taken away",
            unit: "mm",
            digits: 0,
            range: 2.0..=50.0,
        };
        if let Some(mm) = slider_ui(ui, &radius, state.document.import.eraser_mm) {
            commands.push(ImportCommand::SetEraser(mm).into());
        }
    }
    if let Some(tool) = state.image_tool {
        sentence_ui(ui, tool_words(tool)[1]);
    }
    list_ui(ui, current, commands);
}

/// The edits in their order; neighbouring spheres of the eraser are one line.
fn list_ui(ui: &mut Ui, current: &Current, commands: &mut Vec<Command>) {
    let edits = &current.settings.edits;
    ui.add_space(space::SMALL);
    let mut begin = 0;
    while let Some(first) = edits.get(begin) {
        let name = edit_name(first);
        let like = edits[begin..]
            .iter()
            .take_while(|edit| edit_name(edit) == name);
        let end = begin + like.count();
        ui.horizontal(|ui| {
            let times = match end - begin {
                1 => String::new(),
                count => format!(" × {count}"),
            };
            ui.label(note(format!("{name}{times}")));
            let remove = egui::Button::new(note("Remove")).frame(false);
            if ui.add(remove).clicked() {
                commands.extend(current.changed(false, |settings| {
                    settings.edits.drain(begin..end);
                }));
            }
        });
        begin = end;
    }
}

fn edit_name(edit: &VolumeEdit) -> &'static str {
    match edit {
        VolumeEdit::CutPlane { .. } => "Cut plane",
        VolumeEdit::SphereEraser { .. } => "Erased sphere",
        VolumeEdit::LargestComponent => "Largest part kept",
        VolumeEdit::ComponentAt(_) => "Clicked part kept",
        VolumeEdit::FillHoles => "Holes filled",
    }
}

fn contours_ui(ui: &mut Ui, cx: &PaneContext<'_>, current: &Current, commands: &mut Vec<Command>) {
    if !current.needed().is_empty() {
        sentence_ui(ui, "Outlines are found once nothing is missing above.");
        return;
    }
    let showing = cx.ask_at_rest(&current.tissues_query());
    let before = showing.latest().map(|_| "Outlines of the settings before");
    work_lines_ui(
        ui,
        &WorkState::of(Some(&showing)),
        &TISSUES,
        before,
        commands,
    );
    if let Some(tissues) = showing.latest() {
        let count = tissues.contours.len();
        sentence_ui(
            ui,
            format!(
                "{count} outlines over the beat. Drag one in a slice to correct it: those beside it follow."
            ),
        );
        for notice in &tissues.notices {
            sentence_ui(ui, crate::picture::sentence(&notice.text));
        }
    }
    let drawn = current.settings.contours.len();
    if drawn > 0 {
        ui.horizontal(|ui| {
            ui.label(note(
                crate::ui::text::counted(drawn, "outline") + " drawn by you",
            ));
            let remove = egui::Button::new(note("Remove")).frame(false);
            if ui.add(remove).clicked() {
                commands.extend(current.changed(false, |settings| {
                    settings.contours = std::sync::Arc::default();
                }));
            }
        });
    }
}
