//! The part of the cycle that plays: a band above the rail with an end on either side to drag; Shift and a drag make one.

use egui::{CursorIcon, Rect, Response, Sense, Ui, WidgetInfo, pos2, vec2};

use crate::panes::commands::{Command, PlaybackCommand};
use crate::picture::share_words;
use crate::ui::controls::escaped;
use crate::ui::theme::{colours, line};

use super::values::TimeBarView;

/// Height of the band above the middle of the rail, and half the width of what an end is dragged by.
const ABOVE: f32 = 13.0;
const REACH: f32 = 7.0;

/// Where the ends of the range lie.
fn ends(view: &TimeBarView, rail: Rect) -> Option<[f32; 2]> {
    let x_at = |frame: usize| {
        let share = view.axis.share_at(frame as f64);
        egui::lerp(rail.x_range(), share as f32)
    };
    Some(view.loop_frames?.map(x_at))
}

/// Marks the part that plays.
pub(super) fn draw_band(ui: &Ui, view: &TimeBarView, rail: Rect) {
    let Some([start, end]) = ends(view, rail) else {
        return;
    };
    let (colours, y) = (colours(ui), rail.center().y);
    let band = Rect::from_min_max(pos2(start, y - ABOVE), pos2(end, y + ABOVE));
    let fill = colours.selection.gamma_multiply(0.16);
    ui.painter().rect_filled(band, 0.0, fill);
    for (x, inwards) in [(start, 5.0), (end, -5.0)] {
        let stroke = (line::STRONG, colours.selection);
        let corners = [y - ABOVE, y + ABOVE].map(|y| pos2(x, y));
        ui.painter().line_segment(corners, stroke);
        for corner in corners {
            (ui.painter()).line_segment([corner, corner + vec2(inwards, 0.0)], stroke);
        }
    }
}

/// The ends of the range, to be dragged from frame to frame.
pub(super) fn ends_ui(ui: &Ui, view: &TimeBarView, rail: Rect, commands: &mut Vec<Command>) {
    let (Some(places), Some(frames)) = (ends(view, rail), view.loop_frames) else {
        return;
    };
    for (end, name) in ["Start of the loop", "End of the loop"]
        .into_iter()
        .enumerate()
    {
        let top = pos2(places[end], rail.center().y - 0.5 * (ABOVE + REACH));
        // Above the rail only: on it, clicks are about the position.
        let rect = Rect::from_center_size(top, vec2(2.0 * REACH, ABOVE));
        let response = ui.interact(rect, ui.scope_id().with(name), Sense::drag());
        let frame = frames[end] as f64;
        response.widget_info(|| WidgetInfo::slider(true, frame, name));
        if let Some(pointer) = response
            .interact_pointer_pos()
            .filter(|_| response.dragged())
        {
            let mut wanted = frames;
            wanted[end] = frame_at(view, rail, pointer.x);
            if wanted[0] < wanted[1] && wanted != frames {
                commands.push(PlaybackCommand::SetLoopRange(Some(wanted)).into());
            }
        }
        let share = share_words(view.axis.share_at(frame), view.cycle_ms.is_some());
        let text = format!("{name}: frame {}, {share}. Drag to move it", frames[end]);
        response
            .on_hover_cursor(CursorIcon::ResizeHorizontal)
            .on_hover_text(text);
    }
}

/// Shift and a drag along the line choose the part that plays; whether that is what the pointer does.
pub(super) fn swept(
    ui: &Ui,
    view: &TimeBarView,
    rail: Rect,
    response: &Response,
    commands: &mut Vec<Command>,
) -> bool {
    let id = response.id.with("sweep");
    if response.drag_started() && ui.input(|input| input.modifiers.shift) {
        ui.data_mut(|data| data.insert_temp(id, true));
    }
    let sweeps = ui.data(|data| data.get_temp(id).unwrap_or(false));
    if !sweeps {
        return response.clicked() && ui.input(|input| input.modifiers.shift);
    }
    if !response.dragged() {
        ui.data_mut(|data| data.remove::<bool>(id));
    }
    let begin = ui.input(|input| input.pointer.press_origin());
    if let Some((begin, now)) = begin.zip(response.interact_pointer_pos()) {
        let [a, b] = [begin.x, now.x].map(|x| frame_at(view, rail, x));
        let wanted = [a.min(b), a.max(b)];
        if a != b && Some(wanted) != view.loop_frames {
            commands.push(PlaybackCommand::SetLoopRange(Some(wanted)).into());
        }
    }
    true
}

/// The frame nearest to a place on the rail; the frame after the last at its end.
fn frame_at(view: &TimeBarView, rail: Rect, x: f32) -> usize {
    let share = f64::from(egui::remap_clamp(x, rail.x_range(), 0.0..=1.0));
    view.axis.position_at(share).round() as usize
}

/// Esc plays all again, unless it closes or leaves something else.
pub(super) fn escape(ui: &Ui, view: &TimeBarView, commands: &mut Vec<Command>) {
    // Of the frame before: by now Esc has taken the keyboard from whatever had it.
    let id = ui.scope_id().with("focus before");
    let on_control = ui.ctx().memory(|memory| memory.focused()).is_some();
    let was_on_control = ui.data(|data| data.get_temp(id).unwrap_or(false));
    ui.data_mut(|data| data.insert_temp(id, on_control));
    if view.escape_ends_range && !was_on_control && escaped(ui) {
        commands.push(PlaybackCommand::SetLoopRange(None).into());
    }
}
