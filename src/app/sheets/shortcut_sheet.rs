//! The searchable sheet of all keys (?).

use egui::{Grid, ScrollArea, TextEdit, Ui};

use crate::panes::actions::ALL_ACTIONS;
use crate::panes::commands::Menu;
use crate::panes::commands::{Command, WindowCommand};
use crate::panes::shortcuts::keys_text;
use crate::ui::controls::dialog_ui;
use crate::ui::style::{medium, note};
use crate::ui::theme::{colours, space};

/// Keys that act where the pointer is and therefore are no commands.
const ELSEWHERE: [(&str, &str); 9] = [
    ("Rotate the 3D view", "drag"),
    ("Move the 3D view", "right drag, or Shift and drag"),
    ("Zoom", "scroll"),
    ("Fit a map", "double click"),
    (
        "Estimated pose of empty ground in the pose map",
        "Shift, or hold",
    ),
    (
        "Play only a part of the cycle",
        "Shift and drag on the time bar",
    ),
    ("Focus the first control", "F6"),
    ("Next control, if one has the focus", "Tab"),
    ("Leave a field, a filter or the loop", "Esc"),
];

/// Draws the window; Esc or its cross closes it.
pub fn shortcut_sheet_ui(ui: &mut Ui, commands: &mut Vec<Command>) {
    let ctx = ui.ctx().clone();
    if dialog_ui(
        &ctx,
        "Keyboard shortcuts",
        egui::vec2(460.0, 560.0),
        true,
        sheet_ui,
    ) {
        commands.push(WindowCommand::ToggleShortcuts.into());
    }
}

fn sheet_ui(ui: &mut Ui) {
    let id = ui.scope_id().with("search");
    let pass = ui.ctx().cumulative_pass_nr();
    let kept: Option<(String, u64)> = ui.data(|data| data.get_temp(id));
    // A sheet that is opened again has an empty search, and the keyboard.
    let kept = kept.filter(|(_, last)| last + 1 >= pass);
    let opens = kept.is_none();
    let mut search = kept.map_or_else(String::new, |(search, _)| search);
    let edit = TextEdit::singleline(&mut search)
        .hint_text("Search…")
        .desired_width(f32::INFINITY);
    let field = ui.add(edit).accessible_name("Search the shortcuts");
    if opens {
        field.request_focus();
    }
    ui.add_space(space::SMALL);
    ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
        for menu in Menu::ALL {
            let lines: Vec<(&str, String)> = ALL_ACTIONS
                .iter()
                .filter(|action| action.menu == menu)
                .filter_map(|action| {
                    Some((action.name, keys_text(ui.ctx(), action.shortcut.as_ref()?)))
                })
                .collect();
            group_ui(ui, menu.name(), &lines, &search);
        }
        let lines: Vec<(&str, String)> = ELSEWHERE
            .iter()
            .map(|(name, keys)| (*name, (*keys).to_owned()))
            .collect();
        group_ui(ui, "Pointer and focus", &lines, &search);
    });
    ui.data_mut(|data| data.insert_temp(id, (search, pass)));
}

fn group_ui(ui: &mut Ui, heading: &str, lines: &[(&str, String)], search: &str) {
    let search = search.to_lowercase();
    let shown: Vec<_> = lines
        .iter()
        .filter(|(name, keys)| format!("{name} {keys}").to_lowercase().contains(&search))
        .collect();
    if shown.is_empty() {
        return;
    }
    ui.label(note(heading));
    Grid::new(heading)
        .num_columns(2)
        .min_col_width(170.0)
        .spacing([space::HUGE, space::SMALL])
        .show(ui, |ui| {
            for (name, keys) in shown {
                ui.label(*name);
                let colour = colours(ui).accent;
                ui.label(medium(keys).color(colour));
                ui.end_row();
            }
        });
    ui.add_space(space::MEDIUM);
}
