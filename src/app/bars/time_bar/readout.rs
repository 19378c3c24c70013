//! The time on screen, and the field in which another one is typed.

use egui::{CursorIcon, Key, Label, Sense, TextEdit, Ui};

use crate::panes::commands::{Command, PlaybackCommand};
use crate::picture::share_words;
use crate::ui::style::text_font;
use crate::ui::text::text_width;
use crate::ui::theme::{colours, space};

use super::values::TimeBarView;

/// What is being typed, and whether it was refused.
#[derive(Clone, Debug, Default)]
struct Typed {
    text: String,
    refused: bool,
}

/// Room for the longest readout, so that the line does not move while the motion plays.
pub(super) fn readout_width(ui: &Ui, view: &TimeBarView, with_between: bool) -> f32 {
    let mut widest = share_words(1.0, view.cycle_ms.is_some());
    if view.time_ms.is_some() {
        widest = format!("8888 ms · {widest}");
    }
    if with_between {
        widest += " · linear interpolation";
    }
    text_width(ui, &widest, text_font()) + space::LARGE
}

/// "412 ms · 53 % R-R · interpolated".
pub(super) fn readout_text(view: &TimeBarView) -> String {
    if view.axis.frame_count() == 0 {
        return "No motion".to_owned();
    }
    let share = view.axis.share_at(view.position);
    let mut text = share_words(share, view.cycle_ms.is_some());
    if let Some(time) = view.time_ms {
        text = format!("{time:.0} ms · {text}");
    }
    if let Some(between) = view.between {
        text += " · ";
        text += between;
    }
    text
}

/// Draws the time; a click turns it into a field.
pub(super) fn readout_ui(ui: &mut Ui, view: &TimeBarView, commands: &mut Vec<Command>) {
    let id = ui.scope_id().with("typed time");
    let typed: Option<Typed> = ui.data(|data| data.get_temp(id));
    if let Some(typed) = typed {
        field_ui(ui, view, typed, commands);
        return;
    }
    let typable = view.axis.frame_count() > 1;
    let label = Label::new(readout_text(view)).truncate();
    if !typable {
        ui.add(label);
        return;
    }
    let response = ui
        .add(label.sense(Sense::click()))
        .on_hover_cursor(CursorIcon::Text)
        .on_hover_text(format!(
            "Click to type a time: {}; range: {}",
            example(view),
            match view.cycle_ms {
                Some(cycle) => format!("0 to {cycle:.0} ms or 0 to 100 %"),
                None => "0 to 100 %".to_owned(),
            }
        ));
    if response.clicked() {
        ui.data_mut(|data| data.insert_temp(id, Typed::default()));
    }
}

fn field_ui(ui: &mut Ui, view: &TimeBarView, mut typed: Typed, commands: &mut Vec<Command>) {
    let id = ui.scope_id().with("typed time");
    let field = ui.scope_id().with("time field");
    let mut edit = TextEdit::singleline(&mut typed.text)
        .id(field)
        .hint_text(example(view))
        .desired_width(110.0);
    if typed.refused {
        edit = edit.text_color(colours(ui).error);
    }
    let response = ui.add(edit).accessible_name("Time in the cycle");
    let has_had_focus = ui
        .data(|data| data.get_temp::<bool>(field))
        .unwrap_or(false);
    if !has_had_focus {
        response.request_focus();
        ui.data_mut(|data| data.insert_temp(field, true));
    }
    typed.refused &= !response.changed();
    let mut open = true;
    if response.lost_focus() {
        let (entered, escaped) = ui.input(|input| {
            (
                input.key_pressed(Key::Enter),
                input.key_pressed(Key::Escape),
            )
        });
        let position = typed_position(view, &typed.text).filter(|_| !escaped);
        if let Some(position) = position {
            commands.push(PlaybackCommand::SetPosition(position).into());
        }
        typed.refused = position.is_none();
        open = entered && position.is_none();
        if open {
            response.request_focus();
        }
    }
    ui.data_mut(|data| {
        if open {
            data.insert_temp(id, typed);
        } else {
            data.remove::<Typed>(id);
            data.remove::<bool>(field);
        }
    });
}

/// What can be typed.
fn example(view: &TimeBarView) -> &'static str {
    match view.cycle_ms {
        Some(_) => "412 ms or 53 %",
        None => "53 % of the cycle",
    }
}

/// The position at a typed time: "412 ms", "53 %", "53 % R-R", "53 % of the cycle". A number alone is in ms where times are known, else in
/// percent. `None` for what is no time within the cycle.
pub(super) fn typed_position(view: &TimeBarView, text: &str) -> Option<f64> {
    let text = text.trim().to_lowercase().replace(',', ".");
    let text = text
        .trim_end_matches("r-r")
        .trim_end_matches("of the cycle");
    let text = text.trim_end();
    let (number, in_percent) = if let Some(number) = text.strip_suffix('%') {
        (number, true)
    } else if let Some(number) = text.strip_suffix("ms") {
        (number, false)
    } else {
        (text, view.cycle_ms.is_none())
    };
    let number: f64 = number.trim().parse().ok()?;
    let share = match in_percent {
        true => number / 100.0,
        false => number / view.cycle_ms?,
    };
    let within = (0.0..=1.0).contains(&share);
    within.then(|| view.axis.position_within(share))
}
