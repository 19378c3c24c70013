//! A path is typed where the system shows no file dialog: Tab completes folders, Enter takes it.

use egui::{Context, Id, Key, Modifiers, RichText, TextEdit, Ui, vec2};

use crate::document::PathEntry;
use crate::panes::commands::{Command, FileCommand};
use crate::ui::controls::dialog_ui;
use crate::ui::style::note;
use crate::ui::theme::{colours, space};

/// What stands in the field, and which text of the program it began with.
#[derive(Clone, Debug, Default)]
struct Typed {
    text: String,
    revision: u64,
}

/// Draws the sheet; Esc or its cross gives up.
pub fn path_sheet_ui(ui: &mut Ui, entry: &PathEntry, commands: &mut Vec<Command>) {
    let ctx = ui.ctx().clone();
    let id = Id::unique("typed path");
    let mut typed: Typed = ctx.data(|data| data.get_temp(id)).unwrap_or_default();
    let put_in = typed.revision != entry.revision;
    if put_in {
        typed = Typed {
            text: entry.text.clone(),
            revision: entry.revision,
        };
    }
    let [tab, enter] = ctx.input_mut(|input| {
        [Key::Tab, Key::Enter].map(|key| input.consume_key(Modifiers::NONE, key))
    });
    let mut clicked = false;
    let closed = dialog_ui(&ctx, &entry.title, vec2(560.0, 200.0), true, |ui| {
        field_ui(ui, &mut typed, put_in);
        let replaces = (entry.replaces.as_ref()).filter(|(text, _)| *text == typed.text);
        message_ui(ui, entry, replaces.map(|(_, words)| words.as_str()));
        ui.add_space(space::SMALL);
        let name = if replaces.is_some() {
            "Replace"
        } else {
            entry.verb
        };
        ui.horizontal(|ui| {
            clicked = ui.button(name).clicked();
            if ui.button("Cancel").clicked() {
                commands.push(FileCommand::CancelPath.into());
            }
        });
    });
    // Enter answers no question about replacing: that takes the button.
    let asked = (entry.replaces.as_ref()).is_some_and(|(text, _)| *text == typed.text);
    if closed {
        commands.push(FileCommand::CancelPath.into());
    } else if tab {
        commands.push(FileCommand::CompletePath(typed.text.clone()).into());
    } else if clicked || enter && !asked {
        commands.push(
            FileCommand::TakePath {
                text: typed.text.clone(),
                replace: clicked && asked,
            }
            .into(),
        );
    }
    ctx.data_mut(|data| data.insert_temp(id, typed));
}

fn field_ui(ui: &mut Ui, typed: &mut Typed, put_in: bool) {
    let id = ui.scope_id().with("path");
    // Tab belongs to the completion, not to the focus.
    let edit = TextEdit::singleline(&mut typed.text)
        .id(id)
        .lock_focus(true)
        .desired_width(f32::INFINITY)
        .margin(vec2(space::MEDIUM, 6.0));
    let response = ui.add(edit).accessible_name("Path");
    if put_in || !response.has_focus() && !ui.ctx().any_popup_open() {
        response.request_focus();
    }
    if put_in {
        cursor_to_end(ui.ctx(), id, typed.text.chars().count());
    }
}

fn cursor_to_end(ctx: &Context, id: Id, end: usize) {
    let mut state = TextEdit::load_state(ctx, id).unwrap_or_default();
    let end = egui::text::CCursor::new(end);
    let range = egui::text::CCursorRange::one(end);
    state.cursor.set_char_range(Some(range));
    state.store(ctx, id);
}

fn message_ui(ui: &mut Ui, entry: &PathEntry, replaces: Option<&str>) {
    if let Some(words) = replaces {
        let words = RichText::new(words).color(colours(ui).warning);
        ui.add(egui::Label::new(words).wrap());
    } else if let Some(refused) = &entry.refused {
        let words = RichText::new(refused).color(colours(ui).error);
        ui.add(egui::Label::new(words).wrap());
    } else if entry.choices.is_empty() {
        ui.label(note("Tab completes the names of folders"));
    } else {
        ui.add(egui::Label::new(note(entry.choices.join("   "))).wrap());
    }
}
