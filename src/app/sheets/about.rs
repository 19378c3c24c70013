//! About: what the program is, the method, the licences.

use egui::{RichText, Ui};

use crate::panes::commands::{Command, WindowCommand};
use crate::ui::controls::dialog_ui;
use crate::ui::style::{note, title_font};
use crate::ui::theme::{colours, space};

/// Draws the window; Esc or its cross closes it.
pub fn about_ui(ui: &mut Ui, adapter: &str, commands: &mut Vec<Command>) {
    let ctx = ui.ctx().clone();
    let size = egui::vec2(404.0, 300.0);
    if dialog_ui(&ctx, "About", size, false, |ui| text_ui(ui, adapter)) {
        commands.push(WindowCommand::ToggleAbout.into());
    }
}

fn text_ui(ui: &mut Ui, adapter: &str) {
    ui.set_width(380.0);
    let strong = colours(ui).strong;
    ui.label(
        RichText::new("Cardiomorph")
            .font(title_font())
            .color(strong),
    );
    ui.label(note(concat!("Version ", env!("CARGO_PKG_VERSION"))));
    ui.add_space(space::MEDIUM);
    ui.label("Analyses the motion of the left ventricle: volumes, wall thickening, pose and deformation maps, figures");
    ui.add_space(space::MEDIUM);
    let warning = colours(ui).warning;
    ui.label(
        RichText::new("A research tool. It makes no diagnosis and is not a medical device.")
            .color(warning),
    );
    ui.add_space(space::MEDIUM);
    ui.label("Method: V. Taimouri, Shape Analysis in Shape Space (dissertation)");
    ui.label("Typeface: Inter, SIL Open Font License 1.1");
    ui.label("Licence: MIT or Apache 2.0");
    if !adapter.is_empty() {
        ui.add_space(space::MEDIUM);
        ui.label(note(format!("Graphics driver: {adapter}")));
    }
}
