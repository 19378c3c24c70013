//! The strip above the 3D view: number of subjects, surfaces, quantity shown in colour.

use egui::{Button, Ui};

use crate::document::ViewMode;
use crate::panes::commands::{Command, ViewCommand, WallCommand};
use crate::panes::shortcuts::hint;
use crate::picture::Quantity;
use crate::render::Shading;
use crate::ui::controls::{choice_ui, chooser_ui, pane_header_ui, tab_ui};
use crate::ui::theme::space;

/// What the header of the 3D view shows.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ViewportHeaderView {
    /// One subject, two, or all frames of one.
    pub mode: ViewMode,
    /// The quantity shown in colour.
    pub quantity: Quantity,
    /// Whether the endocardium is shown; `None` where there is none.
    pub shows_endocardium: Option<bool>,
    /// Whether the epicardium or the wall is shown; `None` where there is none.
    pub shows_epicardium: Option<bool>,
    /// Whether edges are shown.
    pub shows_wireframe: bool,
    /// Whether vertices are shown.
    pub shows_vertices: bool,
    /// Whether atoms of the medial surface are shown.
    pub shows_atoms: bool,
    /// Whether their spokes are shown.
    pub shows_spokes: bool,
    /// Whether borders of patches are shown.
    pub shows_patches: bool,
    /// Whether ANV and MP are shown.
    pub shows_direction: bool,
    /// Whether the camera rotates freely.
    pub free_camera: bool,
    /// Smooth or flat.
    pub shading: Shading,
    /// Why colours cannot show contributions to the distance; `None` if they can.
    pub no_contribution: Option<&'static str>,
    /// Why colours cannot show the difference of a transported motion; `None` if they can.
    pub no_motion_difference: Option<&'static str>,
}

/// Short name of a quantity, for buttons.
pub fn quantity_name(quantity: Quantity) -> &'static str {
    match quantity {
        Quantity::Tissue => "Tissue",
        Quantity::Displacement => "Displacement",
        Quantity::AreaRatio => "Area ratio",
        Quantity::ThicknessRatio => "Thickness ratio",
        Quantity::Contribution => "Contribution",
        Quantity::MotionDifference => "Motion difference",
    }
}

/// Draws tabs on the left, switches and the quantity on the right.
pub fn viewport_header_ui(ui: &mut Ui, view: &ViewportHeaderView, commands: &mut Vec<Command>) {
    let wide = ui.available_width() > 640.0;
    let mut pushed = Vec::new();
    let mut from_left = Vec::new();
    pane_header_ui(
        ui,
        |ui| {
            modes_ui(ui, view.mode, &mut from_left);
        },
        |ui| {
            quantity_ui(ui, view, &mut pushed);
            display_ui(ui, view, &mut pushed);
            if wide {
                switch_ui(
                    ui,
                    "Atoms",
                    Some(view.shows_atoms),
                    Command::Wall(WallCommand::ToggleAtoms),
                    &mut pushed,
                );
                switch_ui(
                    ui,
                    "Epicardium",
                    view.shows_epicardium,
                    Command::View(ViewCommand::ToggleEpicardium),
                    &mut pushed,
                );
                switch_ui(
                    ui,
                    "Endocardium",
                    view.shows_endocardium,
                    Command::View(ViewCommand::ToggleEndocardium),
                    &mut pushed,
                );
            }
        },
    );
    commands.append(&mut from_left);
    commands.append(&mut pushed);
}

/// Tabs where they fit, a menu where they do not.
fn modes_ui(ui: &mut Ui, chosen: ViewMode, commands: &mut Vec<Command>) {
    const MODES: [(ViewMode, &str); 3] = [
        (ViewMode::Single, "3D view"),
        (ViewMode::SideBySide, "Side by side"),
        (ViewMode::AllFrames, "All frames"),
    ];
    if ui.available_width() > 240.0 {
        for (mode, name) in MODES {
            if tab_ui(ui, name, chosen == mode).clicked() {
                commands.push(Command::View(ViewCommand::SetViewMode(mode)));
            }
            ui.add_space(space::SMALL);
        }
        return;
    }
    let shown = MODES.iter().find(|(mode, _)| *mode == chosen);
    chooser_ui(
        ui,
        "View",
        shown.map_or("3D view", |(_, name)| name),
        |ui| {
            for (mode, name) in MODES {
                if choice_ui(ui, name, chosen == mode) {
                    commands.push(Command::View(ViewCommand::SetViewMode(mode)));
                }
            }
        },
    );
}

fn quantity_ui(ui: &mut Ui, view: &ViewportHeaderView, commands: &mut Vec<Command>) {
    chooser_ui(ui, "Colour", quantity_name(view.quantity), |ui| {
        for choice in Quantity::ALL {
            if choice_ui(ui, quantity_name(choice), choice == view.quantity) {
                commands.push(Command::View(ViewCommand::SetQuantity(choice)));
            }
        }
        ui.separator();
        for (choice, hindrance) in [
            (Quantity::Contribution, view.no_contribution),
            (Quantity::MotionDifference, view.no_motion_difference),
        ] {
            ui.add_enabled_ui(hindrance.is_none(), |ui| {
                if choice_ui(ui, choice.name(), choice == view.quantity) {
                    commands.push(Command::View(ViewCommand::SetQuantity(choice)));
                }
            })
            .response
            .on_disabled_hover_text(hindrance.unwrap_or_default());
        }
    });
}

fn display_ui(ui: &mut Ui, view: &ViewportHeaderView, commands: &mut Vec<Command>) {
    chooser_ui(ui, "Display", "Display", |ui| {
        for (name, shown, command) in [
            (
                "Endocardium",
                view.shows_endocardium,
                Command::View(ViewCommand::ToggleEndocardium),
            ),
            (
                "Epicardium",
                view.shows_epicardium,
                Command::View(ViewCommand::ToggleEpicardium),
            ),
            (
                "Edges",
                Some(view.shows_wireframe),
                Command::View(ViewCommand::ToggleWireframe),
            ),
            (
                "Vertices",
                Some(view.shows_vertices),
                Command::View(ViewCommand::ToggleVertices),
            ),
            (
                "Medial atoms",
                Some(view.shows_atoms),
                Command::Wall(WallCommand::ToggleAtoms),
            ),
            (
                "Spokes of the atoms",
                Some(view.shows_spokes),
                Command::Wall(WallCommand::ToggleSpokes),
            ),
            (
                "Patch outlines",
                Some(view.shows_patches),
                Command::Wall(WallCommand::TogglePatches),
            ),
            (
                "ANV and MP of the patch",
                Some(view.shows_direction),
                Command::Wall(WallCommand::ToggleDirection),
            ),
            (
                "Free rotation",
                Some(view.free_camera),
                Command::View(ViewCommand::ToggleFreeCamera),
            ),
        ] {
            let mut on = shown.unwrap_or(false);
            let checkbox = egui::Checkbox::new(&mut on, name);
            let mut response = ui.add_enabled(shown.is_some(), checkbox);
            if let Some(hint) = display_hint(&command) {
                response = response.on_hover_text(hint);
            }
            if response.clicked() {
                commands.push(command);
            }
        }
        ui.separator();
        for (name, shading) in [
            ("Smooth shading", Shading::Smooth),
            ("Flat shading", Shading::Flat),
        ] {
            if choice_ui(ui, name, view.shading == shading) {
                commands.push(Command::View(ViewCommand::SetShading(shading)));
            }
        }
    });
}

/// What a term of the method means, with its section in Taimouri's dissertation.
fn display_hint(command: &Command) -> Option<&'static str> {
    match command {
        Command::Wall(WallCommand::ToggleAtoms) => Some(
            "A disc for each medial sphere, the sphere inscribed in the wall at an endocardial \
             vertex (Taimouri, 4.2)",
        ),
        Command::Wall(WallCommand::ToggleSpokes) => Some(
            "Lines from the centre of a medial sphere to its points of contact with the wall \
             (Taimouri, 4.2)",
        ),
        Command::Wall(WallCommand::TogglePatches) => {
            Some("Outlines of regional wall-thickening abnormalities (Taimouri, 4.6.2)")
        }
        Command::Wall(WallCommand::ToggleDirection) => {
            Some("ANV: average normal vector; MP: mean position (Taimouri, 4.4.1)")
        }
        _ => None,
    }
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
        .on_disabled_hover_text("This subject has no such surface");
    if response.clicked() {
        commands.push(command);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui_kittest::{Harness, kittest::Queryable as _};

    fn clicked(width: f32, names: &[&str]) -> Vec<Command> {
        let mut harness = Harness::builder()
            .with_size([width, 400.0])
            .with_context_setup(|ctx| crate::ui::style::apply(ctx, true))
            .build_ui_state(
                |ui, commands: &mut Vec<Command>| {
                    let view = ViewportHeaderView {
                        shows_endocardium: Some(true),
                        no_motion_difference: Some("No motion is transported"),
                        ..Default::default()
                    };
                    viewport_header_ui(ui, &view, commands);
                },
                Vec::new(),
            );
        harness.run();
        for name in names {
            harness.get_by_label(name).click();
            harness.run();
        }
        harness.into_state()
    }

    #[test]
    fn tabs_become_a_menu_where_they_do_not_fit() {
        let wanted = [Command::View(ViewCommand::SetViewMode(
            ViewMode::SideBySide,
        ))];
        assert_eq!(clicked(800.0, &["Side by side"]), wanted);
        assert_eq!(clicked(360.0, &["View: 3D view", "Side by side"]), wanted);
    }

    #[test]
    fn a_surface_that_is_not_there_cannot_be_shown() {
        let commands = clicked(800.0, &["Epicardium", "Endocardium"]);
        assert_eq!(commands, [Command::View(ViewCommand::ToggleEndocardium)]);
    }

    #[test]
    fn a_difference_can_be_chosen_where_there_is_one() {
        let names = ["Colour: Tissue", Quantity::Contribution.name()];
        let wanted = [Command::View(ViewCommand::SetQuantity(
            Quantity::Contribution,
        ))];
        assert_eq!(clicked(800.0, &names), wanted);
        let names = ["Colour: Tissue", Quantity::MotionDifference.name()];
        assert_eq!(clicked(800.0, &names), []);
    }

    #[test]
    fn the_quantity_is_chosen_from_a_menu() {
        let commands = clicked(800.0, &["Colour: Tissue", "Area ratio"]);
        assert_eq!(
            commands,
            [Command::View(ViewCommand::SetQuantity(Quantity::AreaRatio))]
        );
    }
}
