//! The bull's-eye: the polar map of 17 AHA segments, anterior up and septum left, linked with all views.

pub(crate) mod data;
mod draw;
mod figure;
mod layout;
pub(crate) mod spec;
#[cfg(test)]
mod tests;

mod values;

pub use values::*;

use egui::{Role, Sense, Ui, WidgetInfo};

use crate::analysis::segments::Segment;
use crate::panes::commands::{Command, WallCommand};
use crate::panes::work_state::WorkState;
use crate::panes::work_ui::{WALL_WORK, work_pane_ui};
use crate::picture::{BullsEyeQuantity, WallPart};
use crate::ui::controls::{choices_ui, chooser_ui, empty_pane_ui};
use crate::ui::named_parts::{named_part, names_are_read};
use crate::ui::theme::space;

/// Draws the pane.
pub fn bulls_eye_ui(ui: &mut Ui, view: &BullsEyeView, commands: &mut Vec<Command>) {
    if view.flat.points.is_empty() {
        without_map_ui(ui, view, commands);
        return;
    }
    let frame = egui::Frame::new().inner_margin(egui::Margin {
        left: space::LARGE as i8,
        right: space::LARGE as i8,
        top: space::SMALL as i8,
        bottom: space::MEDIUM as i8,
    });
    frame.show(ui, |ui| {
        choosers_ui(ui, view, commands);
        map_ui(ui, view, commands);
    });
}

fn without_map_ui(ui: &mut Ui, view: &BullsEyeView, commands: &mut Vec<Command>) {
    let what = "Wall thickness and thickening by AHA segment are shown here";
    match (&view.state, view.without_axis) {
        (WorkState::Ready, Some(why)) => {
            empty_pane_ui(ui, "The bull's-eye could not be computed", why, |_| {});
        }
        (state, _) => work_pane_ui(ui, state, &WALL_WORK, ["No bull's-eye", what], commands),
    }
}

/// Width of the button of segment values with its short name.
const SHORT_BUTTON: f32 = 64.0;

fn choosers_ui(ui: &mut Ui, view: &BullsEyeView, commands: &mut Vec<Command>) {
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = space::SMALL;
        let room = ui.available_width() - SHORT_BUTTON;
        ui.scope(|ui| {
            ui.set_max_width(room.max(50.0));
            chooser_ui(ui, "Bull's-eye", view.scale.quantity.name(), |ui| {
                let quantities = BullsEyeQuantity::ALL.map(|quantity| (quantity, quantity.name()));
                let chosen = choices_ui(ui, quantities, view.scale.quantity);
                let command = chosen.map(WallCommand::SetBullsEye);
                commands.extend(command.map(Command::from));
            })
            .on_hover_text("PT: thickness ratio to end-diastole (Taimouri, table 4.1)");
        });
        let narrow = ui.available_width() < 110.0;
        let name = if narrow { "AHA 17" } else { "Segment values" };
        let segments = egui::Button::new(name).selected(view.by_segment);
        let response = ui.add(segments);
        response.widget_info(|| {
            WidgetInfo::selected(Role::Button, true, view.by_segment, "Segment values")
        });
        let hint = "One value for each of the 17 AHA segments (Cerqueira et al., Circulation 2002)";
        if response.on_hover_text(hint).clicked() {
            commands.push(WallCommand::ToggleBullsEyeSegments.into());
        }
    });
}

fn map_ui(ui: &mut Ui, view: &BullsEyeView, commands: &mut Vec<Command>) {
    let (area, response) = ui.allocate_exact_size(ui.available_size(), Sense::click());
    response.widget_info(|| WidgetInfo::labeled(Role::Canvas, true, "Bull's-eye map"));
    let (disc, bar) = layout::places(area, view.flat.oriented);
    if disc.radius < 20.0 {
        return;
    }
    let pointed = |at: Option<egui::Pos2>| disc.segment_at(at?).filter(|_| view.flat.oriented);
    let border = |at: Option<egui::Pos2>| patch_at(view, &disc, at?);
    let on_border = border(response.hover_pos());
    let hovered = pointed(response.hover_pos()).filter(|_| on_border.is_none());
    draw::plot(ui, view, &disc, hovered);
    draw::names(ui, view, &disc, area);
    draw::subject(ui, view, &disc, area);
    draw::colour_bar(ui, view, bar);
    if view.flat.oriented && names_are_read(&response) {
        name_segments(ui, view, &disc, &response, commands);
    }
    if response.clicked()
        && let Some(patch) = border(response.interact_pointer_pos())
    {
        let again = view.patches[patch].selected;
        let part = (!again).then_some(WallPart::Patch(patch));
        commands.push(WallCommand::SelectPart(part).into());
    } else if response.clicked() {
        let clicked = pointed(response.interact_pointer_pos());
        // The selected one again, or beside the plot: nothing is selected.
        let part = clicked
            .filter(|segment| view.selected != Some(*segment))
            .map(WallPart::Segment);
        if view.flat.oriented && (part.is_some() || view.selected.is_some()) {
            commands.push(WallCommand::SelectPart(part).into());
        }
    }
    if let Some(patch) = on_border {
        response
            .on_hover_cursor(egui::CursorIcon::PointingHand)
            .on_hover_text_at_pointer(&view.patches[patch].name);
    } else if let Some(segment) = hovered {
        response.on_hover_text_at_pointer(hover_text(view, segment));
    }
}

/// Names segments and patches for whoever does not see them; asked to click one, it is selected.
fn name_segments(
    ui: &Ui,
    view: &BullsEyeView,
    disc: &layout::Disc,
    canvas: &egui::Response,
    commands: &mut Vec<Command>,
) {
    let mut name = |id: egui::Id, at, selected, name: &str, part| {
        let rect = egui::Rect::from_center_size(at, egui::Vec2::splat(10.0));
        if named_part(ui, id, rect, selected, name) {
            commands.push(WallCommand::SelectPart(Some(part)).into());
        }
    };
    for segment in Segment::all() {
        let (at, words) = (disc.middle_of(segment), hover_text(view, segment));
        let selected = view.selected == Some(segment);
        let part = WallPart::Segment(segment);
        name(canvas.id.with(segment.number()), at, selected, &words, part);
    }
    for (index, patch) in view.patches.iter().enumerate() {
        if let Some(middle) = patch.shape.middle {
            let (id, at) = (canvas.id.with(("patch", index)), disc.at(middle));
            name(id, at, patch.selected, &patch.name, WallPart::Patch(index));
        }
    }
}

/// The patch whose border is at a place.
fn patch_at(view: &BullsEyeView, disc: &layout::Disc, at: egui::Pos2) -> Option<usize> {
    const REACH: f32 = 5.0;
    let distance = |patch: &BullsEyePatch| disc.distance_to_borders(&patch.shape.borders, at);
    let near = view.patches.iter().map(distance).enumerate();
    near.filter(|(_, distance)| *distance <= REACH)
        .min_by(|a, b| a.1.total_cmp(&b.1))
        .map(|(patch, _)| patch)
}

/// "12 mid anterolateral · PT 1.52 × at ES".
fn hover_text(view: &BullsEyeView, segment: Segment) -> String {
    let name = format!("{} {}", segment.number(), segment.name());
    let value = view.shown.segments[segment.index()];
    match value {
        None => format!("{name} · no value"),
        Some(value) => format!("{name} · {}", view.scale.words(value, view.moment)),
    }
}
