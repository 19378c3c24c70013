//! The cell that is typed into: a label, with those that exist, or the name of a subject.

use egui::text::{CCursor, CCursorRange};
use egui::{
    Area, Context, Frame, Id, Key, Modifiers, Order, Rect, Response, Role, Sense, TextEdit, Ui,
    WidgetInfo, vec2,
};

use crate::document::{TypedField, Typing};
use crate::panes::commands::{Command, EditCommand};
use crate::study::Study;
use crate::ui::style::{note, text_font};
use crate::ui::theme::{colours, radius, space};

/// What was typed so far.
#[derive(Clone, Debug)]
struct Typed {
    typing: Typing,
    text: String,
    /// Which of the offered labels the arrows are on.
    place: Option<usize>,
    /// Where labels are offered: a press there does not end the typing.
    offers: Rect,
    /// The pass that drew it last.
    pass: u64,
}

/// Labels that are offered at once.
const MAX_OFFERS: usize = 10;

/// Draws the field into `rect`. Enter and a click elsewhere take what was typed, Esc does not.
pub(super) fn typing_ui(
    ui: &mut Ui,
    rect: Rect,
    study: &Study,
    typing: &Typing,
    commands: &mut Vec<Command>,
) {
    let ctx = ui.ctx().clone();
    let (id, field) = (Id::unique("typing"), Id::unique("typing field"));
    let pass = ctx.cumulative_pass_nr();
    let kept = ctx.data(|data| data.get_temp::<Typed>(id));
    let kept = kept.filter(|kept| kept.typing == *typing && kept.pass + 1 >= pass);
    let begins = kept.is_none();
    let mut typed = kept.unwrap_or_else(|| Typed {
        typing: typing.clone(),
        text: before(study, typing),
        place: None,
        offers: Rect::NOTHING,
        pass,
    });
    typed.pass = pass;
    let offers = offers(study, &typed);
    let [up, down, enter] = [Key::ArrowUp, Key::ArrowDown, Key::Enter].map(|key| {
        ctx.memory(|memory| memory.has_focus(field))
            && ctx.input_mut(|input| input.consume_key(Modifiers::NONE, key))
    });
    // Esc takes the keyboard from a text before anybody can ask who had it, which must not count as leaving it.
    let escape = ctx.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Escape));
    step(&mut typed, offers.len(), up, down);
    let edit = TextEdit::singleline(&mut typed.text)
        .id(field)
        .font(text_font())
        .align(egui::Align2::LEFT_CENTER)
        .margin(vec2(space::SMALL, 1.0));
    let response = ui.put(rect, edit).accessible_name(name(study, typing));
    if begins {
        select_all(&ctx, &response, typed.text.chars().count());
    }
    if response.changed() {
        typed.place = None;
    }
    let refused = match typing.field {
        TypedField::Name => study.check_id(typing.subject, &typed.text).err(),
        TypedField::Label => None,
    };
    let refused = refused.map(|why| why.to_string());
    let clicked = offers_ui(&ctx, rect, &mut typed, &offers, refused.as_deref());
    let chosen = clicked.or(typed.place.filter(|_| enter));
    let chosen = chosen.and_then(|place| offers.get(place)).cloned();
    let pressed_offer = (ctx.pointer_interact_pos()).is_some_and(|at| typed.offers.contains(at));
    let left = response.lost_focus() && !enter && !escape;
    let ends = enter && (chosen.is_some() || refused.is_none());
    if escape || (left && !pressed_offer && refused.is_some()) {
        commands.push(EditCommand::StopTyping.into());
    } else if chosen.is_some() || ends || (left && !pressed_offer) {
        let text = chosen.unwrap_or(typed.text.clone());
        commands.push(taken(study, typing, text, left));
    } else {
        if left || (enter && refused.is_some()) {
            response.request_focus();
        }
        ctx.data_mut(|data| data.insert_temp(id, typed));
        return;
    }
    ctx.memory_mut(|memory| memory.surrender_focus(field));
    ctx.data_mut(|data| data.remove::<Typed>(id));
}

/// What stands in the cell.
fn before(study: &Study, typing: &Typing) -> String {
    let subject = study.subject(typing.subject);
    let text = subject.and_then(|subject| match typing.field {
        TypedField::Label => subject.label.clone(),
        TypedField::Name => Some(subject.id.clone()),
    });
    text.unwrap_or_default()
}

/// The command that takes what was typed. Where nothing was changed none is needed; many subjects get the label of the row
/// all the same, unless the field was left for something else.
fn taken(study: &Study, typing: &Typing, text: String, left: bool) -> Command {
    let unchanged = text.trim() == before(study, typing);
    let same = unchanged && (left || typing.subjects.len() == 1);
    let command = match typing.field {
        _ if same => EditCommand::StopTyping,
        TypedField::Label => EditCommand::SetLabel {
            subjects: typing.subjects.clone(),
            label: text,
        },
        TypedField::Name => EditCommand::Rename {
            subject: typing.subject,
            id: text,
        },
    };
    command.into()
}

/// What the field is called.
fn name(study: &Study, typing: &Typing) -> String {
    let what = match typing.field {
        TypedField::Label => "Label",
        TypedField::Name => "Name",
    };
    match (typing.subjects.len(), study.subject(typing.subject)) {
        (2.., _) => format!("{what} of {} subjects", typing.subjects.len()),
        (_, Some(subject)) => format!("{what} of {}", subject.id),
        (_, None) => what.to_owned(),
    }
}

fn select_all(ctx: &Context, response: &Response, letters: usize) {
    response.request_focus();
    let mut state = TextEdit::load_state(ctx, response.id).unwrap_or_default();
    let all = CCursorRange::two(CCursor::new(0), CCursor::new(letters));
    state.cursor.set_char_range(Some(all));
    state.store(ctx, response.id);
}

/// Labels of the study that hold what was typed; all of them until something is.
fn offers(study: &Study, typed: &Typed) -> Vec<String> {
    if typed.typing.field == TypedField::Name {
        return Vec::new();
    }
    let text = typed.text.trim();
    let all = text == before(study, &typed.typing);
    let text = text.to_lowercase();
    let labels = study.labels().into_iter();
    labels
        .filter(|label| all || label.to_lowercase().contains(&text))
        .take(MAX_OFFERS)
        .map(str::to_owned)
        .collect()
}

fn step(typed: &mut Typed, count: usize, up: bool, down: bool) {
    let last = count.saturating_sub(1);
    if down && count > 0 {
        typed.place = Some(typed.place.map_or(0, |place| (place + 1).min(last)));
    }
    if up {
        typed.place = typed.place.and_then(|place| place.checked_sub(1));
    }
}

/// Draws the labels that exist, or why a name is refused, under the field; the label that was clicked.
fn offers_ui(
    ctx: &Context,
    rect: Rect,
    typed: &mut Typed,
    offers: &[String],
    refused: Option<&str>,
) -> Option<usize> {
    let mut clicked = None;
    let shown = Area::new(Id::unique("typing offers"))
        .order(Order::Foreground)
        .fixed_pos(rect.left_bottom() + vec2(0.0, 2.0))
        .show(ctx, |ui| {
            Frame::popup(ui.style()).show(ui, |ui| {
                ui.set_min_width(rect.width().max(150.0));
                ui.spacing_mut().item_spacing.y = 0.0;
                for (place, label) in offers.iter().enumerate() {
                    let current = typed.place == Some(place);
                    if offer_ui(ui, label, current).clicked() {
                        clicked = Some(place);
                    }
                }
                match (refused, typed.typing.field, typed.typing.subjects.len()) {
                    (Some(why), ..) => {
                        ui.colored_label(colours(ui).error, crate::picture::sentence(why));
                    }
                    (None, TypedField::Label, 2..) => {
                        let count = typed.typing.subjects.len();
                        ui.label(note(format!("Enter labels {count} subjects, empty: none")));
                    }
                    (None, TypedField::Label, _) => {
                        ui.label(note("Empty: no label"));
                    }
                    (None, TypedField::Name, _) => {
                        ui.label(note("Enter renames, Esc keeps the name"));
                    }
                }
            });
        });
    typed.offers = shown.response.rect;
    clicked
}

fn offer_ui(ui: &mut Ui, label: &str, current: bool) -> Response {
    let size = vec2(ui.available_width(), space::ROW);
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    response.widget_info(|| WidgetInfo::selected(Role::ListBoxOption, true, current, label));
    let colours = colours(ui);
    if current || response.hovered() {
        let fill = if current {
            colours.selected_row
        } else {
            colours.control_hovered
        };
        ui.painter()
            .rect_filled(rect, f32::from(radius::CONTROL), fill);
    }
    let inner = rect.shrink2(vec2(space::SMALL, 0.0));
    let mut line = ui.new_child(egui::UiBuilder::new().max_rect(inner));
    line.set_height(rect.height());
    line.add(egui::Label::new(label).truncate());
    response
}
