//! The top of the window: menus, the open study, and the command palette.

use std::path::{Path, PathBuf};

use egui::{Align, Button, Layout, RichText, Stroke, Ui, vec2};

use crate::panes::action_state::ActionState;
use crate::panes::actions::ALL_ACTIONS;
use crate::panes::commands::Menu;
use crate::panes::commands::{Command, FileCommand, WindowCommand};
use crate::panes::shortcuts::shortcut_text;
use crate::ui::style::{note, title_text_font};
use crate::ui::theme::{colours, line, space};

/// What the menu bar shows.
#[derive(Clone, Debug)]
pub struct MenuBarView<'a> {
    /// Name of the study; `None` when nothing is open.
    pub study_name: Option<&'a str>,
    /// Number of subjects.
    pub subject_count: usize,
    /// Number of poses of all subjects.
    pub pose_count: usize,
    /// Files and folders opened before, latest first.
    pub recent: &'a [PathBuf],
    /// What can be done now.
    pub actions: &'a ActionState,
}

/// Draws the menus, the study's line and the button to the palette.
pub fn menu_bar_ui(ui: &mut Ui, view: &MenuBarView, commands: &mut Vec<Command>) {
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
            ui.menu_button(menu.name(), |ui| menu_ui(ui, menu, view, commands));
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            ui.add_space(space::SMALL);
            palette_button_ui(ui, commands);
            ui.add_space(space::MEDIUM);
            if ui.available_width() > 60.0 {
                ui.add(egui::Label::new(RichText::new(study_line(view)).weak()).truncate());
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
        commands.push(Command::Window(WindowCommand::TogglePalette));
    }
}

fn menu_ui(ui: &mut Ui, menu: Menu, view: &MenuBarView, commands: &mut Vec<Command>) {
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
        if view.actions.checked(&action.command) == Some(true) {
            button = button.selected(true);
        }
        let enabled = view.actions.enabled(&action.command);
        if ui.add_enabled(enabled, button).clicked() {
            commands.push(action.command.clone());
            ui.close();
        }
        if action.command == Command::File(FileCommand::OpenBuiltIn) {
            recent_ui(ui, view.recent, commands);
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
                    commands.push(Command::File(FileCommand::Open(vec![path.clone()])));
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

fn study_line(view: &MenuBarView) -> String {
    let Some(name) = view.study_name else {
        return "No study open".to_owned();
    };
    let plural = |count: usize, one: &str, many: &str| {
        format!("{count} {}", if count == 1 { one } else { many })
    };
    format!(
        "{name} · {} · {}",
        plural(view.subject_count, "subject", "subjects"),
        plural(view.pose_count, "frame", "frames")
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui_kittest::{Harness, kittest::Queryable as _};

    fn clicked_through(menu: &str, item: &str, state: &ActionState) -> Vec<Command> {
        let mut harness = Harness::builder()
            .with_context_setup(|ctx| crate::ui::style::apply(ctx, true))
            .with_size([900.0, 700.0])
            .build_ui_state(
                |ui, commands: &mut Vec<Command>| {
                    let view = MenuBarView {
                        study_name: Some("Cohort"),
                        subject_count: 1,
                        pose_count: 8,
                        recent: &[],
                        actions: state,
                    };
                    menu_bar_ui(ui, &view, commands);
                },
                Vec::new(),
            );
        harness.run();
        harness.get_by_label("Cohort · 1 subject · 8 frames");
        harness.get_by_label(menu).click();
        harness.run();
        harness.get_by_label_contains(item).click();
        harness.run();
        harness.into_state()
    }

    #[test]
    fn a_menu_item_pushes_its_command() {
        let state = ActionState {
            has_study: true,
            ..Default::default()
        };
        assert_eq!(
            clicked_through("Export", "3D view…", &state),
            [Command::File(FileCommand::ExportFigure(None))]
        );
    }

    #[test]
    fn what_cannot_be_done_now_does_nothing() {
        assert_eq!(clicked_through("Edit", "Undo", &ActionState::default()), []);
    }
}
