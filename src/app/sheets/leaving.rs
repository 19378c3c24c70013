//! The question about edits that are not exported, before another study is opened or the window closes.

use egui::{Key, Modifiers, Ui};

use crate::document::Leaving;
use crate::panes::buttons::command_button_ui;
use crate::panes::commands::{Command, FileCommand};
use crate::ui::controls::dialog_ui;
use crate::ui::style::note;
use crate::ui::theme::space;

/// Draws the question. Enter exports and leaves, Esc stays.
pub fn leaving_ui(ui: &mut Ui, leaving: &Leaving, commands: &mut Vec<Command>) {
    let ctx = ui.ctx().clone();
    let (heading, leave, export_and) = match leaving {
        Leaving::Quit => (
            "Quit without exporting the edits?",
            "Quit without exporting",
            "Export study and quit…",
        ),
        Leaving::Open(_) | Leaving::FollowLinks => (
            "Open another study without exporting the edits?",
            "Open without exporting",
            "Export study and open…",
        ),
    };
    // While a button has the keyboard, Enter presses that one.
    let focused = ctx.memory(|memory| memory.focused()).is_some();
    let enter = !focused && ctx.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Enter));
    let mut export = enter;
    let stay = dialog_ui(&ctx, heading, egui::vec2(420.0, 120.0), false, |ui| {
        ui.label(
            "Labels, names, units, landmarks, phases or who belongs to the cohort were edited",
        );
        ui.label(note("Enter exports the study and then goes on, Esc stays"));
        ui.add_space(space::MEDIUM);
        ui.horizontal(|ui| {
            export |= ui.button(export_and).clicked();
            command_button_ui(ui, leave, FileCommand::Leave, commands);
            command_button_ui(ui, "Stay", FileCommand::Stay, commands);
        });
    });
    if export {
        commands.push(FileCommand::ExportAndLeave.into());
    } else if stay {
        commands.push(FileCommand::Stay.into());
    }
}
