//! The time bar: play, drag through the cardiac cycle, jump to end-diastole and end-systole.

mod range;
mod readout;
mod values;

pub use values::TimeBarView;

use egui::{
    Align, Align2, Color32, EventFilter, Key, Layout, Rect, Response, Role, Sense, Stroke, Ui,
    WidgetInfo, pos2, vec2,
};

use crate::panes::commands::{Command, PlaybackCommand};
use crate::panes::shortcuts::hint;
use crate::ui::controls::{choices_ui, chooser_ui, focus_ring, icon_button_ui};
use crate::ui::marks::{Icon, icon};
use crate::ui::text::note_at;
use crate::ui::theme::{colours, line, space};

use readout::{readout_text, readout_ui, readout_width};

/// Speeds on offer, relative to the recorded motion.
pub const SPEEDS: [f32; 8] = [0.1, 0.25, 0.5, 1.0, 1.5, 2.0, 3.0, 4.0];

/// Distance in points within which a click snaps to a frame.
const SNAP: f32 = 6.0;

/// Draws the buttons, the line and the readout.
pub fn time_bar_ui(ui: &mut Ui, view: &TimeBarView, commands: &mut Vec<Command>) {
    let playable = view.axis.frame_count() > 1;
    let width = ui.available_width();
    ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
        ui.add_space(space::LARGE);
        ui.add_enabled_ui(playable, |ui| {
            play_button_ui(ui, view.playing, commands);
            frame_buttons_ui(ui, commands);
            if width > 620.0 {
                speed_ui(ui, view.speed, commands);
                let name = hint(
                    ui.ctx(),
                    "Loop",
                    &Command::Playback(PlaybackCommand::ToggleLoop),
                );
                if icon_button_ui(ui, Icon::Loop, "Loop", &name, view.looping).clicked() {
                    commands.push(PlaybackCommand::ToggleLoop.into());
                }
            }
        });
        ui.add_space(space::LARGE);
        let readout = readout_width(ui, view, width > 820.0);
        let line_width = (ui.available_width() - readout - space::LARGE).max(60.0);
        line_ui(ui, view, line_width, commands);
        ui.add_space(space::LARGE);
        readout_ui(ui, view, commands);
    });
}

fn play_button_ui(ui: &mut Ui, playing: bool, commands: &mut Vec<Command>) {
    let (name, symbol) = if playing {
        ("Pause", Icon::Pause)
    } else {
        ("Play", Icon::Play)
    };
    let (rect, response) = ui.allocate_exact_size(vec2(30.0, 30.0), Sense::click());
    let enabled = ui.is_enabled();
    response.widget_info(|| WidgetInfo::labeled(Role::Button, enabled, name));
    let colours = colours(ui);
    let fill = match (enabled, response.hovered()) {
        (false, _) => colours.line,
        (true, true) => colours.accent.lerp_to_gamma(colours.strong, 0.15),
        (true, false) => colours.accent,
    };
    ui.painter().circle_filled(rect.center(), 14.0, fill);
    let nudge = if playing { 0.0 } else { 1.0 };
    icon(
        ui.painter(),
        rect.center() + vec2(nudge, 0.0),
        11.0,
        symbol,
        colours.on_accent,
    );
    focus_ring(ui, &response);
    let text = hint(
        ui.ctx(),
        name,
        &Command::Playback(PlaybackCommand::TogglePlay),
    );
    if response.on_hover_text(text).clicked() {
        commands.push(PlaybackCommand::TogglePlay.into());
    }
}

fn frame_buttons_ui(ui: &mut Ui, commands: &mut Vec<Command>) {
    ui.spacing_mut().item_spacing.x = 2.0;
    for (step, name, symbol) in [
        (-1, "Previous frame", Icon::StepBack),
        (1, "Next frame", Icon::StepForward),
    ] {
        let text = hint(
            ui.ctx(),
            name,
            &Command::Playback(PlaybackCommand::StepFrame(step)),
        );
        if icon_button_ui(ui, symbol, name, &text, false).clicked() {
            commands.push(PlaybackCommand::StepFrame(step).into());
        }
    }
}

fn speed_ui(ui: &mut Ui, speed: f32, commands: &mut Vec<Command>) {
    chooser_ui(ui, "Speed", speed_text(speed), |ui| {
        let now = SPEEDS
            .into_iter()
            .find(|choice| (choice - speed).abs() < 1e-3);
        let speeds = SPEEDS.map(|choice| (choice, speed_text(choice)));
        let chosen = choices_ui(ui, speeds, now.unwrap_or(speed));
        commands.extend(chosen.map(|choice| Command::from(PlaybackCommand::SetSpeed(choice))));
    })
    .on_hover_text("Times the recorded motion: 1 is real time; range: 0.1 to 4");
}

fn speed_text(speed: f32) -> String {
    let digits = if (speed * 10.0).fract().abs() < 1e-3 {
        1
    } else {
        2
    };
    format!("{speed:.digits$}×")
}

fn line_ui(ui: &mut Ui, view: &TimeBarView, width: f32, commands: &mut Vec<Command>) {
    let (rect, response) = ui.allocate_exact_size(vec2(width, 40.0), Sense::click_and_drag());
    let count = view.axis.frame_count();
    response.widget_info(|| {
        let mut info =
            WidgetInfo::slider(count > 1, view.position, "Position in the cardiac cycle");
        info.current_text_value = Some(readout_text(view));
        info
    });
    let rail = Rect::from_center_size(rect.center() - vec2(0.0, 3.0), vec2(width - 16.0, 3.0));
    let x_at = |share: f64| egui::lerp(rail.x_range(), share as f32);
    draw_rail(ui, view, rail, x_at);
    range::escape(ui, view, commands);
    if count == 0 {
        return;
    }
    let knob = pos2(x_at(view.axis.share_at(view.position)), rail.center().y);
    draw_knob(ui, knob, &response);
    range::ends_ui(ui, view, rail, commands);
    if range::swept(ui, view, rail, &response, commands) {
        // The position stays while a range is drawn.
    } else if let Some(pointer) = response.interact_pointer_pos() {
        let share = f64::from(egui::remap_clamp(pointer.x, rail.x_range(), 0.0..=1.0));
        let position = match (response.clicked(), response.dragged()) {
            (true, _) => Some(snapped(view, share, rail.width())),
            (false, true) => Some(view.axis.position_within(share)),
            (false, false) => None,
        };
        commands
            .extend(position.map(|position| Command::from(PlaybackCommand::SetPosition(position))));
    }
    keys(ui, &response, commands);
    response.on_hover_ui_at_pointer(|ui| {
        ui.label("Drag to move through the cardiac cycle, click near a mark to show its pose");
        ui.label(
            "Shift and drag, or the keys [ and ], to play only a part of it; Esc plays all again",
        );
        if !view.note.is_empty() {
            ui.label(crate::ui::style::note(&view.note));
        }
    });
}

/// The nearest pose where it is near enough, the very position otherwise. A frame goes before the
/// poses beside it.
fn snapped(view: &TimeBarView, share: f64, rail_width: f32) -> f64 {
    let axis = &view.axis;
    let near = |position: f64| {
        (axis.share_at(position) - share).abs() * f64::from(rail_width) <= f64::from(SNAP)
    };
    let frame = axis.position_at(share).round();
    if near(frame) {
        return if frame >= axis.frame_count() as f64 {
            0.0
        } else {
            frame
        };
    }
    let distance = |position: &f64| (axis.share_at(*position) - share).abs();
    let nearest = view
        .interpolated_poses
        .iter()
        .copied()
        .min_by(|a, b| distance(a).total_cmp(&distance(b)));
    nearest
        .filter(|position| near(*position))
        .unwrap_or_else(|| axis.position_within(share))
}

/// With the keyboard on the line, the arrows step through frames instead of controls.
fn keys(ui: &Ui, response: &Response, commands: &mut Vec<Command>) {
    if !response.has_focus() {
        return;
    }
    let filter = EventFilter {
        horizontal_arrows: true,
        ..Default::default()
    };
    ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, filter));
    for (key, step) in [(Key::ArrowLeft, -1), (Key::ArrowRight, 1)] {
        if ui.input(|input| input.key_pressed(key) && input.modifiers.is_none()) {
            commands.push(PlaybackCommand::StepFrame(step).into());
        }
    }
}

fn draw_rail(ui: &Ui, view: &TimeBarView, rail: Rect, x_at: impl Fn(f64) -> f32) {
    let colours = colours(ui);
    let painter = ui.painter();
    painter.rect_filled(rail, 1.5, colours.line);
    let here = view.axis.share_at(view.position);
    let mut done = rail;
    done.set_right(x_at(here));
    painter.rect_filled(done, 1.5, colours.accent);
    range::draw_band(ui, view, rail);
    let shade = |share: f64| {
        if share <= here {
            colours.accent
        } else {
            colours.muted
        }
    };
    let count = view.axis.frame_count();
    // Marks nearer to each other than this would run together.
    let frame_gap = rail.width() / count.max(1) as f32;
    let per_frame = view.interpolated_poses.len() as f32 / count.max(1) as f32;
    if frame_gap > 4.0 * (per_frame + 1.0) {
        for position in &view.interpolated_poses {
            let share = view.axis.share_at(*position);
            let tick = Rect::from_center_size(pos2(x_at(share), rail.center().y), vec2(1.0, 5.0));
            painter.rect_filled(tick, 0.0, shade(share));
        }
    }
    for frame in 0..=count {
        let share = view.axis.share_at(frame as f64);
        let tick = Rect::from_center_size(pos2(x_at(share), rail.center().y), vec2(2.0, 9.0));
        painter.rect_filled(tick, 1.0, shade(share));
    }
    draw_phase_names(ui, view, rail, x_at);
}

fn draw_phase_names(ui: &Ui, view: &TimeBarView, rail: Rect, x_at: impl Fn(f64) -> f32) {
    let count = view.axis.frame_count();
    let mut marks: Vec<(f32, &str)> = Vec::new();
    for (frame, name) in [(view.end_diastole, "ED"), (view.end_systole, "ES")] {
        let Some(frame) = frame else { continue };
        marks.push((x_at(view.axis.share_at(frame as f64)), name));
        if frame == 0 && count > 1 {
            marks.push((rail.right(), name));
        }
    }
    for (x, name) in marks {
        // Below the knob, which may stand on the frame.
        let at = pos2(x, rail.center().y + 9.0);
        note_at(ui, at, Align2::CENTER_TOP, name);
    }
}

fn draw_knob(ui: &Ui, centre: egui::Pos2, response: &Response) {
    let colours = colours(ui);
    let painter = ui.painter();
    painter.circle_filled(centre, 8.0, colours.pane);
    let edge = if response.hovered() || response.dragged() {
        colours.strong
    } else {
        colours.accent
    };
    painter.circle_stroke(centre, 7.0, Stroke::new(line::STRONG + 0.5, edge));
    if response.has_focus() {
        let glow: Color32 = colours.accent.gamma_multiply(0.4);
        painter.circle_stroke(centre, 11.0, Stroke::new(line::STRONG, glow));
    }
}

#[cfg(test)]
mod tests;
