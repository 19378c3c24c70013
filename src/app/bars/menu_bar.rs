//! The top of the window: menus, the open study, and the command palette.

use std::path::{Path, PathBuf};

use egui::{Align, Button, Layout, RichText, Stroke, Ui, vec2};

use crate::document::State;
use crate::panes::action_state::ActionState;
use crate::panes::actions::ALL_ACTIONS;
use crate::panes::commands::Menu;
use crate::panes::commands::{Command, FileCommand, WindowCommand};
use crate::panes::shortcuts::shortcut_text;
use crate::ui::style::{note, title_text_font};
use crate::ui::text::counted;
use crate::ui::theme::{colours, line, space};

/// Draws the menus, the study's line and the button to the palette.
pub fn menu_bar_ui(ui: &mut Ui, actions: &ActionState, commands: &mut Vec<Command>) {
    egui::MenuBar::new().ui(ui, |ui| {
        let strong = colours(ui).strong;
        ui.add_space(space::SMALL);
        ui.label(
            RichText::new("Cardiomorph")
                .font(title_text_font())
                .color(strong),
        );
        ui.add_space(space::SMALL);
        for menu in Menu::ALL {
            ui.menu_button(menu.name(), |ui| menu_ui(ui, menu, actions, commands));
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            ui.add_space(space::SMALL);
            palette_button_ui(ui, commands);
            ui.add_space(space::MEDIUM);
            if ui.available_width() > 60.0 {
                ui.add(
                    egui::Label::new(RichText::new(study_line(actions.state)).weak()).truncate(),
                );
            }
        });
    });
}

fn palette_button_ui(ui: &mut Ui, commands: &mut Vec<Command>) {
    let keys =
        shortcut_text(ui.ctx(), &Command::Window(WindowCommand::TogglePalette)).unwrap_or_default();
    let colours = colours(ui);
    let clicked = ui.scope(|ui| {
        ui.spacing_mut().button_padding = vec2(space::MEDIUM, 3.0);
        let button = Button::new((note("Find a command"), note(keys)))
            .gap(space::LARGE)
            .fill(colours.pane)
            .stroke(Stroke::new(line::THIN, colours.line));
        ui.add(button).clicked()
    });
    if clicked.inner {
        commands.push(WindowCommand::TogglePalette.into());
    }
}

fn menu_ui(ui: &mut Ui, menu: Menu, actions: &ActionState, commands: &mut Vec<Command>) {
    let mut group = None;
    for action in ALL_ACTIONS.iter().filter(|action| action.menu == menu) {
        if group.is_some_and(|group| group != action.group) {
            ui.separator();
        }
        group = Some(action.group);
        let mut button = Button::new(action.name);
        if let Some(shortcut) = &action.shortcut {
            button = button.shortcut_text(ui.ctx().format_shortcut(shortcut));
        }
        if actions.checked(&action.command) == Some(true) {
            button = button.selected(true);
        }
        let enabled = actions.enabled(&action.command);
        if ui.add_enabled(enabled, button).clicked() {
            commands.push(action.command.clone());
            ui.close();
        }
        if action.command == Command::File(FileCommand::OpenBuiltIn) {
            recent_ui(ui, &actions.state.recent, commands);
        }
    }
}

fn recent_ui(ui: &mut Ui, recent: &[PathBuf], commands: &mut Vec<Command>) {
    ui.add_enabled_ui(!recent.is_empty(), |ui| {
        ui.menu_button("Open recent", |ui| {
            for path in recent {
                let response = ui
                    .button(short_path(path))
                    .on_hover_text(path.display().to_string());
                if response.clicked() {
                    commands.push(FileCommand::Open(vec![path.clone()]).into());
                    ui.close();
                }
            }
        });
    });
}

/// The last two parts of a path: enough to know it by.
fn short_path(path: &Path) -> String {
    let parts: Vec<_> = path
        .iter()
        .rev()
        .take(2)
        .map(|part| part.to_string_lossy())
        .collect();
    parts.into_iter().rev().collect::<Vec<_>>().join("/")
}

fn study_line(state: &State) -> String {
    let study = state.document.study();
    if study.subjects.is_empty() {
        return "No study open".to_owned();
    }
    let frames = study
        .subjects
        .iter()
        .map(|subject| subject.sequence.frame_count());
    let (subjects, frames) = (study.subjects.len(), frames.sum());
    format!(
        "{} · {} · {}",
        study.name,
        counted(subjects, "subject"),
        counted(frames, "frame")
    )
}
