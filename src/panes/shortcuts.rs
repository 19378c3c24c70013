//! Keys that were pressed, as commands, and keys as text.

use egui::{Context, Event, Key, KeyboardShortcut, Modifiers, Plugin, RawInput};

use crate::panes::commands::Command;
use crate::panes::commands::{ACTIONS, Action, action_of};

/// The shortcut of a command as text, such as `Ctrl+K`; `None` where it has none.
pub fn shortcut_text(ctx: &Context, command: &Command) -> Option<String> {
    Some(keys_text(ctx, action_of(command)?.shortcut.as_ref()?))
}

/// Keys as they are printed on a keyboard: `?`, not the name of the key.
pub fn keys_text(ctx: &Context, shortcut: &KeyboardShortcut) -> String {
    let (text, key) = (ctx.format_shortcut(shortcut), shortcut.logical_key);
    match key.symbol_or_name() {
        // Other symbols, such as arrows, are not in every face.
        symbol if symbol.is_ascii() => text.replace(key.name(), symbol),
        _ => text,
    }
}

/// A name with its key behind it, for hints: `Next frame (Right)`.
pub fn hint(ctx: &Context, name: &str, command: &Command) -> String {
    match shortcut_text(ctx, command) {
        Some(keys) => format!("{name} ({keys})"),
        None => name.to_owned(),
    }
}

/// Commands whose keys were pressed; the keys are consumed.
///
/// Keys that would disturb typing do nothing while a text field has the keyboard, and keys that
/// move or press a control do nothing while one has it. While a menu or a form is open, plain keys belong to it.
pub fn pressed_commands(ctx: &Context) -> Vec<Command> {
    let typing = ctx.text_edit_focused();
    let on_control = ctx.memory(|memory| memory.focused()).is_some();
    let popup = ctx.any_popup_open();
    let mut by_modifiers: Vec<(&Action, KeyboardShortcut)> = ACTIONS
        .iter()
        .filter_map(|action| Some((action, reachable(action.shortcut?))))
        .collect();
    // Ctrl+Shift+Z before Ctrl+Z: a shortcut also matches with more Shift than it asks for.
    by_modifiers.sort_by_key(|(_, shortcut)| std::cmp::Reverse(modifier_count(shortcut.modifiers)));
    let mut commands = Vec::new();
    for (action, shortcut) in by_modifiers {
        let plain = !shortcut.modifiers.command && !is_function_key(shortcut.logical_key);
        let moves = matches!(
            shortcut.logical_key,
            Key::Space | Key::ArrowLeft | Key::ArrowRight | Key::ArrowUp | Key::ArrowDown
        );
        // A text field undoes its own typing.
        let undoes = shortcut.logical_key == Key::Z;
        if ((typing || popup) && plain) || (typing && undoes) || (on_control && moves) {
            continue;
        }
        if ctx.input_mut(|input| input.consume_shortcut(&shortcut)) {
            commands.push(action.command.clone());
        }
    }
    commands
}

/// Takes Tab for the next subject while no control has the keyboard, before egui moves its focus. F6 then gives the
/// keyboard to the first control, Esc takes it back. Its place is after [`crate::ui::install`], which cuts the input of
/// a frame: a Tab after Ctrl+K is for the palette.
#[derive(Debug, Default)]
pub struct TabForSubjects;

/// The key that Tab is passed on as: no keyboard has it.
const CLAIMED_TAB: Key = Key::F35;

impl Plugin for TabForSubjects {
    fn debug_name(&self) -> &'static str {
        "tab for subjects"
    }

    fn input_hook(&mut self, ctx: &Context, input: &mut RawInput) {
        if ctx.memory(|memory| memory.focused()).is_some() || ctx.any_popup_open() {
            return;
        }
        for event in &mut input.events {
            if let Event::Key { key, modifiers, .. } = event {
                match *key {
                    Key::F6 => *key = Key::Tab,
                    Key::Tab if !modifiers.command && !modifiers.alt => *key = CLAIMED_TAB,
                    _ => {}
                }
            }
        }
    }
}

/// A shortcut as it reaches the window.
fn reachable(mut shortcut: KeyboardShortcut) -> KeyboardShortcut {
    if shortcut.logical_key == Key::Tab {
        shortcut.logical_key = CLAIMED_TAB;
    }
    shortcut
}

fn modifier_count(modifiers: Modifiers) -> usize {
    [modifiers.command, modifiers.shift, modifiers.alt]
        .into_iter()
        .filter(|on| *on)
        .count()
}

fn is_function_key(key: Key) -> bool {
    matches!(key, Key::F2 | Key::F11)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::panes::{EditCommand, PlaybackCommand, SelectCommand, WindowCommand};

    const NONE: Modifiers = Modifiers::NONE;
    const CTRL: Modifiers = Modifiers::COMMAND;
    const SHIFT: Modifiers = Modifiers::SHIFT;

    /// A key that goes down.
    fn key_down(key: Key, modifiers: Modifiers) -> RawInput {
        RawInput {
            events: vec![Event::Key {
                key,
                physical_key: None,
                pressed: true,
                repeat: false,
                modifiers,
            }],
            ..Default::default()
        }
    }

    fn pressed(modifiers: Modifiers, key: Key) -> Vec<Command> {
        let ctx = Context::default();
        let mut commands = Vec::new();
        let output = ctx.run_ui(key_down(key, modifiers), |ui| {
            commands = pressed_commands(ui.ctx());
        });
        output.drop_without_applying_deltas();
        commands
    }

    #[test]
    fn keys_with_shift_do_not_do_what_the_plain_key_does() {
        assert_eq!(pressed(CTRL, Key::Z), [Command::Edit(EditCommand::Undo)]);
        assert_eq!(
            pressed(CTRL.plus(SHIFT), Key::Z),
            [Command::Edit(EditCommand::Redo)]
        );
        assert_eq!(
            pressed(SHIFT, Key::ArrowLeft),
            [Command::Playback(PlaybackCommand::GoToEndDiastole)]
        );
        assert_eq!(
            pressed(NONE, Key::ArrowLeft),
            [Command::Playback(PlaybackCommand::StepFrame(-1))]
        );
        assert_eq!(
            pressed(SHIFT, Key::Questionmark),
            [Command::Window(WindowCommand::ToggleShortcuts)]
        );
    }

    #[test]
    fn keys_are_written_as_they_are_printed_on_a_keyboard() {
        let ctx = Context::default();
        for action in ACTIONS.iter() {
            let Some(shortcut) = action.shortcut.as_ref() else {
                continue;
            };
            let text = keys_text(&ctx, shortcut);
            let key = text.rsplit('+').next().unwrap_or_default();
            let known = ["Space", "Tab", "Delete", "Left", "Right", "Up", "Down"].contains(&key);
            let function = key.len() > 1 && key[1..].chars().all(|c| c.is_ascii_digit());
            let printed = key.chars().count() == 1 && key.is_ascii();
            assert!(known || function || printed, "{}: {text}", action.name);
        }
        let help = Command::Window(WindowCommand::ToggleShortcuts);
        assert_eq!(shortcut_text(&ctx, &help).as_deref(), Some("?"));
        let from_here = Command::Playback(PlaybackCommand::LoopFromHere);
        assert_eq!(shortcut_text(&ctx, &from_here).as_deref(), Some("["));
    }

    #[test]
    fn tab_steps_through_subjects_until_a_control_has_the_keyboard() {
        let ctx = Context::default();
        ctx.add_plugin(TabForSubjects);
        let press = |key, modifiers, focus: bool| {
            let mut commands = Vec::new();
            let output = ctx.run_ui(key_down(key, modifiers), |ui| {
                commands = pressed_commands(ui.ctx());
                let button = ui.button("Here");
                if focus {
                    button.request_focus();
                }
            });
            output.drop_without_applying_deltas();
            commands
        };
        let step = |step| [Command::Select(SelectCommand::StepSubject(step))];
        assert_eq!(press(Key::Tab, SHIFT, false), step(-1));
        assert_eq!(press(Key::Tab, NONE, true), step(1));
        assert_eq!(press(Key::Tab, NONE, true), []);
    }

    #[test]
    fn a_text_field_keeps_the_keys_that_it_types_with() {
        let ctx = Context::default();
        let key = |key, modifiers| Event::Key {
            key,
            physical_key: None,
            pressed: true,
            repeat: false,
            modifiers,
        };
        let mut text = String::new();
        let mut commands = Vec::new();
        let keys = vec![key(Key::W, NONE), key(Key::Z, CTRL), key(Key::K, CTRL)];
        for events in [Vec::new(), keys] {
            let input = RawInput {
                events,
                ..Default::default()
            };
            let output = ctx.run_ui(input, |ui| {
                commands.extend(pressed_commands(ui.ctx()));
                ui.text_edit_singleline(&mut text).request_focus();
            });
            output.drop_without_applying_deltas();
        }
        assert_eq!(commands, [Command::Window(WindowCommand::TogglePalette)]);
    }
}
