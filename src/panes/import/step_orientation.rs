//! The step "Orientation": apex, base, septum and blood, marked by clicks into the slices.

use egui::Ui;

use super::controls::sentence_ui;
use super::current::Current;
use super::tools::tool_words;
use crate::analysis::preparation::Road;
use crate::document::ImageTool;
use crate::image::MarkedPoints;
use crate::mesh::Point3;
use crate::panes::commands::{Command, ImagesCommand, ImportCommand};
use crate::panes::pane_context::PaneContext;
use crate::ui::style::note;
use crate::ui::theme::{colours, space};

/// One of the points.
type PointOf = fn(&MarkedPoints) -> Option<Point3>;

/// The points, with the tools that mark them.
pub const POINTS: [(ImageTool, PointOf); 4] = [
    (ImageTool::Apex, |points| points.apex),
    (ImageTool::Base, |points| points.base),
    (ImageTool::Septum, |points| points.septum),
    (ImageTool::Blood, |points| points.blood),
];

/// Draws the step.
pub fn ui(ui: &mut Ui, cx: &PaneContext<'_>, current: &Current, commands: &mut Vec<Command>) {
    let road = current.settings.road;
    sentence_ui(
        ui,
        match road {
            Road::Cine => {
                "Click apex, base and blood in the slices. The septum is found from the right ventricle, or clicked."
            }
            Road::Spect => {
                "Found in the image. A click corrects what is wrong; the septum is needed for its name alone."
            }
            Road::Masks(_) | Road::Contours => {
                "Found from the tissues. A click corrects what is wrong."
            }
        },
    );
    let found = cx
        .known(&current.tissues_query())
        .map(|tissues| tissues.points);
    for (tool, place) in POINTS {
        if tool == ImageTool::Blood && road != Road::Cine {
            continue;
        }
        let marked = place(&current.settings.points);
        let found = found.as_ref().and_then(place);
        point_ui(ui, cx, current, (tool, marked, found), commands);
    }
}

fn point_ui(
    ui: &mut Ui,
    cx: &PaneContext<'_>,
    current: &Current,
    (tool, marked, found): (ImageTool, Option<Point3>, Option<Point3>),
    commands: &mut Vec<Command>,
) {
    let [name, what] = tool_words(tool);
    let in_hand = cx.state().image_tool == Some(tool);
    ui.horizontal(|ui| {
        let button = egui::Button::new(format!("Mark {}", name.to_lowercase())).selected(in_hand);
        if ui.add(button).on_hover_text(what).clicked() {
            commands.push(ImportCommand::UseTool(Some(tool)).into());
        }
        let (words, at) = match (marked, found) {
            (Some(at), _) => ("marked", Some(at)),
            (None, Some(at)) => ("found", Some(at)),
            (None, None) => ("not marked", None),
        };
        let colour = match marked.is_some() {
            true => colours(ui).normal,
            false => colours(ui).muted,
        };
        let shown = egui::Button::new(note(words).color(colour)).frame(false);
        let shown = ui.add_enabled(at.is_some(), shown);
        if let Some(at) = at.filter(|_| shown.on_hover_text("Show where").clicked()) {
            commands.push(ImagesCommand::MoveTo(at).into());
        }
        if marked.is_some() {
            let clear = egui::Button::new(note("Clear")).frame(false);
            if ui.add(clear).clicked() {
                commands.extend(without(current, tool));
            }
        }
    });
    if in_hand {
        sentence_ui(ui, format!("{what}; Enter marks the crosshair"));
        ui.add_space(space::SMALL);
    }
}

fn without(current: &Current, tool: ImageTool) -> Option<Command> {
    current.changed(false, |settings| {
        let points = &mut settings.points;
        match tool {
            ImageTool::Apex => points.apex = None,
            ImageTool::Base => points.base = None,
            ImageTool::Septum => points.septum = None,
            ImageTool::Blood => points.blood = None,
            ImageTool::Eraser | ImageTool::Cut | ImageTool::Keep => {}
        }
    })
}
