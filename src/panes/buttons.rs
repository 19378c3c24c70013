//! Buttons that ask for something.

use egui::{Response, Ui, WidgetText};

use super::commands::Command;

/// A button that pushes a command.
pub fn command_button_ui(
    ui: &mut Ui,
    name: impl Into<WidgetText>,
    command: impl Into<Command>,
    commands: &mut Vec<Command>,
) -> Response {
    let button = ui.button(name.into());
    if button.clicked() {
        commands.push(command.into());
    }
    button
}
