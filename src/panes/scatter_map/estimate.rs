//! Empty ground: Shift, or a press that is held, shows the pose that the map implies under the pointer.

use egui::{PopupAnchor, Response, Stroke, Tooltip, Ui, vec2};

use crate::panes::commands::{Command, MapCommand};
use crate::ui::style::note;
use crate::ui::theme::{colours, line};

use super::ground::Ground;
use super::view::{EstimateView, ScatterView};

/// Seconds after which a press on empty ground is held: longer than a click, shorter than patience.
const HOLD_S: f64 = 0.4;

/// Asks for the pose under the pointer while it is looked at, and for what was there before once it is not.
pub fn estimate_ui(
    ui: &Ui,
    view: &ScatterView,
    ground: &Ground,
    response: &Response,
    commands: &mut Vec<Command>,
) {
    let pointer = response.hover_pos().or(response.interact_pointer_pos());
    let wanted = view
        .ground
        .filter(|_| !view.out_of_date())
        .zip(pointer.filter(|_| is_looked_at(ui, view, ground, response)))
        .map(|(turn, at)| turn.undo(ground.lens.place_at(ground.rect, at)));
    if wanted != view.estimate.as_ref().map(|estimate| estimate.at) {
        commands.push(MapCommand::ShowEstimate(wanted).into());
    }
    if let Some(estimate) = &view.estimate {
        draw(ui, view, ground, estimate);
        words_ui(ui, response, &estimate.lines);
    }
}

/// A card at the pointer, which follows it at once.
fn words_ui(ui: &Ui, response: &Response, lines: &[String]) {
    if lines.is_empty() {
        return;
    }
    let anchor = PopupAnchor::Pointer;
    let tooltip = Tooltip::always_open(ui.ctx().clone(), ui.layer_id(), response.id, anchor);
    tooltip.gap(16.0).show(|ui| {
        // However narrow the card was before.
        ui.set_max_width(ui.spacing().tooltip_width);
        for line in lines {
            ui.label(note(line));
        }
    });
}

fn is_looked_at(ui: &Ui, view: &ScatterView, ground: &Ground, response: &Response) -> bool {
    let (shift, pressed_s, origin) = ui.input(|input| {
        let pointer = &input.pointer;
        let pressed_s = pointer.press_start_time().map(|begin| input.time - begin);
        let pressed_s = pressed_s.filter(|_| pointer.primary_down());
        (
            input.modifiers.shift_only(),
            pressed_s,
            pointer.press_origin(),
        )
    });
    let held = response.is_pointer_button_down_on();
    if shift {
        // Somebody may be typing capital letters.
        return (response.hovered() || held) && !ui.ctx().text_edit_focused();
    }
    let Some(pressed_s) = pressed_s.filter(|_| held) else {
        return false;
    };
    // What is held stays so while it moves; what moves before was a drag of the map.
    let still = view.estimate.is_some()
        || response.total_drag_delta().unwrap_or_default() == vec2(0.0, 0.0);
    let on_ground = ground.nearest(view, origin).is_none();
    if still && on_ground && pressed_s < HOLD_S {
        let left = std::time::Duration::from_secs_f64(HOLD_S - pressed_s);
        ui.ctx().request_repaint_after(left);
    }
    still && on_ground && pressed_s >= HOLD_S
}

/// A ring at the place, with a line to each point that it is estimated from, the stronger the more it counts.
fn draw(ui: &Ui, view: &ScatterView, ground: &Ground, estimate: &EstimateView) {
    let Some(turn) = view.ground else { return };
    let painter = ui.painter_at(ground.rect);
    let colours = colours(ui);
    let at = ground.on_screen(turn.apply(estimate.at));
    for (index, weight) in &estimate.sources {
        let Some(point) = view.points.get(*index) else {
            continue;
        };
        let width = line::THIN + 3.0 * *weight as f32;
        let ends = [at, ground.on_screen(point.at)];
        painter.line_segment(ends, Stroke::new(width, colours.accent));
    }
    painter.circle_filled(at, 6.5, colours.pane);
    painter.circle_stroke(at, 6.5, Stroke::new(line::STRONG, colours.accent));
    painter.circle_filled(at, 2.0, colours.accent);
}
