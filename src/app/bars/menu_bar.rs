//! The top of the window: menus, the open study, and the command palette.

use std::path::{Path, PathBuf};

use egui::{Align, Button, Layout, RichText, ScrollArea, Stroke, Ui, vec2};

use crate::document::State;
use crate::panes::action_state::ActionState;
use crate::panes::commands::Menu;
use crate::panes::commands::{Command, FileCommand, WindowCommand};
use crate::panes::shortcuts::{keys_text, shortcut_text};
use crate::ui::style::{note, title_text_font};
use crate::ui::text::counted;
use crate::ui::theme::{colours, line, space};

use super::menu_lines::{Item, MenuLine, menu_lines};

/// Room of the bar above a menu and of the margins around its lines.
const ABOVE_AND_BELOW: f32 = 64.0;

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
    scrolling_ui(ui, |ui| {
        for line in menu_lines(menu) {
            match line {
                MenuLine::Separator => {
                    ui.separator();
                }
                MenuLine::Action(item) => item_ui(ui, &item, actions, commands),
                MenuLine::Submenu(title, items) => {
                    ui.menu_button(title, |ui| {
                        scrolling_ui(ui, |ui| {
                            for item in &items {
                                item_ui(ui, item, actions, commands);
                            }
                        });
                    });
                }
            }
        }
    });
}

/// A menu that is higher than the window scrolls.
fn scrolling_ui(ui: &mut Ui, add: impl FnOnce(&mut Ui)) {
    // Below the bar, with the margins of the menu.
    let room = ui.ctx().content_rect().height() - ABOVE_AND_BELOW;
    let room = room.max(space::ROW);
    // A popup offers less by itself.
    ui.set_max_height(room);
    ScrollArea::vertical().max_height(room).show(ui, add);
}

fn item_ui(ui: &mut Ui, item: &Item, actions: &ActionState, commands: &mut Vec<Command>) {
    let action = item.action;
    let mut button = Button::new(item.name.as_str());
    if let Some(shortcut) = &action.shortcut {
        button = button.shortcut_text(keys_text(ui.ctx(), shortcut));
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
        return match state.document.images() {
            [] => "No study open".to_owned(),
            [one] => format!("Images of {}", one.id),
            all => format!("Images of {}", counted(all.len(), "subject")),
        };
    }
    let frames = study
        .subjects
        .iter()
        .map(|subject| subject.sequence.frame_count());
    let mut parts = vec![
        study.name.clone(),
        counted(study.subjects.len(), "subject"),
        counted(frames.sum(), "frame"),
    ];
    if !study.excluded.is_empty() {
        parts.insert(2, format!("{} excluded", study.excluded.len()));
    }
    if state.is_edited() {
        parts.push("edited".to_owned());
    }
    parts.join(" · ")
}

#[cfg(test)]
mod tests {
    use egui_kittest::{Harness, kittest::Queryable as _};

    use super::*;
    use crate::document::ThemeChoice;

    fn harness(size: [f32; 2]) -> Harness<'static, Vec<Command>> {
        let state = State::default();
        let mut harness = Harness::builder()
            .with_size(size)
            .with_context_setup(|ctx| crate::ui::style::apply(ctx, true))
            .build_ui_state(
                move |ui, commands: &mut Vec<Command>| {
                    let actions = ActionState {
                        state: &state,
                        hidden_panes: Vec::new(),
                    };
                    menu_bar_ui(ui, &actions, commands);
                },
                Vec::new(),
            );
        harness.run();
        harness
    }

    #[test]
    fn every_line_of_every_menu_is_within_a_small_window() {
        for menu in Menu::ALL {
            let mut shown = harness([1024.0, 640.0]);
            shown.get_by_label(menu.name()).click();
            shown.run();
            for line in menu_lines(menu) {
                let name = match line {
                    MenuLine::Separator => continue,
                    MenuLine::Action(item) => item.name,
                    MenuLine::Submenu(title, _) => title,
                };
                for line in shown.get_all_by_label_contains(&name) {
                    let rect = line.rect();
                    assert!(rect.bottom() <= 640.0, "{menu:?}: {name} at {rect:?}");
                }
            }
        }
    }

    #[test]
    fn the_last_theme_of_the_view_menu_can_be_chosen() {
        let mut shown = harness([1024.0, 640.0]);
        for name in ["View", "Theme", "Light"] {
            shown.get_by_label_contains(name).click();
            shown.run();
        }
        let wanted = WindowCommand::SetTheme(ThemeChoice::Light);
        assert_eq!(*shown.state(), [Command::Window(wanted)]);
    }

    #[test]
    fn a_menu_higher_than_the_window_scrolls() {
        let mut shown = harness([1024.0, 300.0]);
        shown.get_by_label("Analysis").click();
        shown.run();
        let last = |shown: &Harness<'_, _>| shown.get_by_label("Show own motion").rect();
        assert!(last(&shown).top() > 300.0);
        shown.hover_at(shown.get_by_label_contains("Playback").rect().center());
        shown.event(egui::Event::MouseWheel {
            unit: egui::MouseWheelUnit::Point,
            delta: vec2(0.0, -2000.0),
            phase: egui::TouchPhase::Move,
            modifiers: egui::Modifiers::NONE,
            source: egui::MouseWheelSource::Wheel,
        });
        shown.run_steps(30);
        assert!(last(&shown).bottom() <= 300.0, "{:?}", last(&shown));
    }
}
