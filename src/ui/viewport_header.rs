//! The strip above the 3D view: how many hearts, which surfaces, what colours stand for.

use egui::{Button, Ui};

use crate::picture::Quantity;
use crate::render::Shading;
use crate::ui::command::{Command, ViewMode};
use crate::ui::controls::{choice_ui, chooser_ui, pane_header_ui, tab_ui};
use crate::ui::shortcuts::hint;

/// What the header of the 3D view shows.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ViewportHeaderView {
    /// One heart, two, or all phases.
    pub mode: ViewMode,
    /// What colours stand for.
    pub quantity: Quantity,
    /// Whether the heart has an inner surface of its own; `None` greys its switch.
    pub shows_endocardium: Option<bool>,
    /// Whether it has an outer surface or wall.
    pub shows_epicardium: Option<bool>,
    /// Whether edges are shown.
    pub shows_wireframe: bool,
    /// Whether vertices are shown.
    pub shows_vertices: bool,
    /// Whether the camera rotates freely.
    pub free_camera: bool,
    /// Smooth or flat.
    pub shading: Shading,
}

/// What a quantity is called on buttons.
pub fn quantity_name(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::Tissue => "Tissue",
        Quantity::Displacement => "Displacement",
        Quantity::AreaRatio => "Area ratio",
    }
}

/// Draws tabs on the left, switches and the quantity on the right.
pub fn viewport_header_ui(ui: &mut Ui, view: &ViewportHeaderView, commands: &mut Vec<Command>) {
    let wide = ui.available_width() > 560.0;
    let mut pushed = Vec::new();
    let mut from_left = Vec::new();
    pane_header_ui(
        ui,
        |ui| {
            for (mode, name) in [
                (ViewMode::Single, "3D view"),
                (ViewMode::SideBySide, "Side by side"),
                (ViewMode::AllPhases, "All phases"),
            ] {
                if tab_ui(ui, name, view.mode == mode).clicked() {
                    from_left.push(Command::SetViewMode(mode));
                }
                ui.add_space(4.0);
            }
        },
        |ui| {
            quantity_ui(ui, view.quantity, &mut pushed);
            display_ui(ui, view, &mut pushed);
            if wide {
                switch_ui(
                    ui,
                    "Wall",
                    view.shows_epicardium,
                    Command::ToggleEpicardium,
                    &mut pushed,
                );
                switch_ui(
                    ui,
                    "Inner",
                    view.shows_endocardium,
                    Command::ToggleEndocardium,
                    &mut pushed,
                );
            }
        },
    );
    commands.append(&mut from_left);
    commands.append(&mut pushed);
}

fn quantity_ui(ui: &mut Ui, quantity: Quantity, commands: &mut Vec<Command>) {
    chooser_ui(ui, "Colour", quantity_name(quantity), |ui| {
        for choice in [
            Quantity::Tissue,
            Quantity::Displacement,
            Quantity::AreaRatio,
        ] {
            if choice_ui(ui, quantity_name(choice), choice == quantity) {
                commands.push(Command::SetQuantity(choice));
            }
        }
    });
}

fn display_ui(ui: &mut Ui, view: &ViewportHeaderView, commands: &mut Vec<Command>) {
    chooser_ui(ui, "Display", "Display", |ui| {
        for (name, shown, command) in [
            (
                "Inner surface",
                view.shows_endocardium,
                Command::ToggleEndocardium,
            ),
            ("Wall", view.shows_epicardium, Command::ToggleEpicardium),
            (
                "Edges",
                Some(view.shows_wireframe),
                Command::ToggleWireframe,
            ),
            (
                "Vertices",
                Some(view.shows_vertices),
                Command::ToggleVertices,
            ),
            (
                "Free rotation",
                Some(view.free_camera),
                Command::ToggleFreeCamera,
            ),
        ] {
            let mut on = shown.unwrap_or(false);
            let checkbox = egui::Checkbox::new(&mut on, name);
            if ui.add_enabled(shown.is_some(), checkbox).clicked() {
                commands.push(command);
            }
        }
        ui.separator();
        for (name, shading) in [
            ("Smooth shading", Shading::Smooth),
            ("Flat shading", Shading::Flat),
        ] {
            if choice_ui(ui, name, view.shading == shading) {
                commands.push(Command::SetShading(shading));
            }
        }
    });
}

fn switch_ui(
    ui: &mut Ui,
    name: &str,
    shown: Option<bool>,
    command: Command,
    commands: &mut Vec<Command>,
) {
    let button = Button::new(name).selected(shown == Some(true));
    let text = hint(
        ui.ctx(),
        &format!("Show or hide: {}", name.to_lowercase()),
        &command,
    );
    let response = ui
        .add_enabled(shown.is_some(), button)
        .on_hover_text(text)
        .on_disabled_hover_text("This heart has no such surface");
    if response.clicked() {
        commands.push(command);
    }
}
