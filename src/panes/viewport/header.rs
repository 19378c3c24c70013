//! The strip above the 3D view: number of subjects, surfaces, quantity shown in colour.

use egui::{Button, Ui};

use crate::document::State;
use crate::document::ViewMode;
use crate::document::differences::hindrance;
use crate::panes::action_state::is_on;
use crate::panes::commands::{Command, ViewCommand, WallCommand, action_of};
use crate::panes::shortcuts::hint;
use crate::picture::Quantity;
use crate::render::Shading;
use crate::study::SurfaceKind;
use crate::ui::controls::{choice_ui, choices_ui, chooser_ui, pane_header_ui, tab_ui};
use crate::ui::theme::space;

/// Why there is no distance of a transported motion.
const NO_TRANSPORT: &str = "Drag a subject of the cohort onto another one to transport its motion";

const ENDOCARDIUM: Command = Command::View(ViewCommand::ToggleEndocardium);
const EPICARDIUM: Command = Command::View(ViewCommand::ToggleEpicardium);
const ATOMS: Command = Command::Wall(WallCommand::ToggleAtoms);

/// What can be shown and hidden, in the order of the menu.
const SWITCHES: [Command; 9] = [
    ENDOCARDIUM,
    EPICARDIUM,
    Command::View(ViewCommand::ToggleWireframe),
    Command::View(ViewCommand::ToggleVertices),
    ATOMS,
    Command::Wall(WallCommand::ToggleSpokes),
    Command::Wall(WallCommand::TogglePatches),
    Command::Wall(WallCommand::ToggleDirection),
    Command::View(ViewCommand::ToggleFreeCamera),
];

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

/// Whether a switch is on; `None` where the subject lacks the surface that it shows.
fn shown(state: &State, switch: &Command) -> Option<bool> {
    use SurfaceKind::{Cavity, Endocardium, Epicardium, Other, Wall};
    let sequence = state.document.selected().map(|subject| &subject.sequence);
    let has = |kinds: &[SurfaceKind]| {
        let mut kinds = kinds.iter();
        sequence.is_some_and(|sequence| kinds.any(|kind| sequence.surface(*kind).is_some()))
    };
    let there = match switch {
        Command::View(ViewCommand::ToggleEndocardium) => has(&[Endocardium, Cavity, Other]),
        Command::View(ViewCommand::ToggleEpicardium) => has(&[Epicardium, Wall]),
        _ => true,
    };
    is_on(state, switch).filter(|_| there)
}

/// Draws tabs on the left, switches and the quantity on the right.
pub fn viewport_header_ui(ui: &mut Ui, state: &State, commands: &mut Vec<Command>) {
    let wide = ui.available_width() > 640.0;
    let (mut pushed, mut from_left) = (Vec::new(), Vec::new());
    pane_header_ui(
        ui,
        |ui| modes_ui(ui, state.document.view_mode, &mut from_left),
        |ui| {
            quantity_ui(ui, state, &mut pushed);
            display_ui(ui, state, &mut pushed);
            if wide {
                switch_ui(ui, "Atoms", state, ATOMS, &mut pushed);
                switch_ui(ui, "Epicardium", state, EPICARDIUM, &mut pushed);
                switch_ui(ui, "Endocardium", state, ENDOCARDIUM, &mut pushed);
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
                commands.push(ViewCommand::SetViewMode(mode).into());
            }
            ui.add_space(space::SMALL);
        }
        return;
    }
    let shown = MODES.iter().find(|(mode, _)| *mode == chosen);
    chooser_ui(ui, "View", shown.map_or("3D view", |shown| shown.1), |ui| {
        let mode = choices_ui(ui, MODES, chosen);
        commands.extend(mode.map(|mode| Command::from(ViewCommand::SetViewMode(mode))));
    });
}

fn quantity_ui(ui: &mut Ui, state: &State, commands: &mut Vec<Command>) {
    let document = &state.document;
    let now = document.quantity;
    let no_transport = document.visible_transport().is_none();
    chooser_ui(ui, "Colour", quantity_name(now), |ui| {
        let own = Quantity::ALL.map(|quantity| (quantity, quantity_name(quantity)));
        let mut chosen = choices_ui(ui, own, now);
        ui.separator();
        for (choice, hindrance) in [
            (Quantity::Contribution, hindrance(document)),
            (
                Quantity::MotionDifference,
                no_transport.then_some(NO_TRANSPORT),
            ),
        ] {
            ui.add_enabled_ui(hindrance.is_none(), |ui| {
                if choice_ui(ui, choice.name(), choice == now) {
                    chosen = Some(choice);
                }
            })
            .response
            .on_disabled_hover_text(hindrance.unwrap_or_default());
        }
        commands.extend(chosen.map(|quantity| Command::from(ViewCommand::SetQuantity(quantity))));
    });
}

fn display_ui(ui: &mut Ui, state: &State, commands: &mut Vec<Command>) {
    chooser_ui(ui, "Display", "Display", |ui| {
        for switch in SWITCHES {
            let shown = shown(state, &switch);
            let mut on = shown.unwrap_or(false);
            let name = action_of(&switch).map_or("", |action| action.name);
            let checkbox = egui::Checkbox::new(&mut on, name);
            let mut response = ui.add_enabled(shown.is_some(), checkbox);
            if let Some(hint) = display_hint(&switch) {
                response = response.on_hover_text(hint);
            }
            if response.clicked() {
                commands.push(switch);
            }
        }
        ui.separator();
        let shadings = [
            (Shading::Smooth, "Smooth shading"),
            (Shading::Flat, "Flat shading"),
        ];
        let shading = choices_ui(ui, shadings, state.document.visibility.shading);
        commands.extend(shading.map(|shading| Command::from(ViewCommand::SetShading(shading))));
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

fn switch_ui(ui: &mut Ui, name: &str, state: &State, switch: Command, commands: &mut Vec<Command>) {
    let shown = shown(state, &switch);
    let what = format!("Show or hide: {}", name.to_lowercase());
    let button = Button::new(name).selected(shown == Some(true));
    let response = ui
        .add_enabled(shown.is_some(), button)
        .on_hover_text(hint(ui.ctx(), &what, &switch))
        .on_disabled_hover_text("This subject has no such surface");
    if response.clicked() {
        commands.push(switch);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::testing::{state_of, subject_with_frames};
    use egui_kittest::{Harness, kittest::Queryable as _};

    /// What is pushed where a subject has one more beside it, and both a cavity alone.
    fn clicked(mode: ViewMode, width: f32, names: &[&str]) -> Vec<Command> {
        let mut state = state_of(["a", "b"].map(|id| subject_with_frames(id, 2)).to_vec());
        state.document.view_mode = mode;
        let mut harness = Harness::builder()
            .with_size([width, 400.0])
            .with_context_setup(|ctx| crate::ui::style::apply(ctx, true))
            .build_ui_state(
                move |ui, commands: &mut Vec<Command>| viewport_header_ui(ui, &state, commands),
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
        assert_eq!(clicked(ViewMode::Single, 800.0, &["Side by side"]), wanted);
        assert_eq!(
            clicked(ViewMode::Single, 360.0, &["View: 3D view", "Side by side"]),
            wanted
        );
    }

    #[test]
    fn a_surface_that_is_not_there_cannot_be_shown() {
        let commands = clicked(ViewMode::Single, 800.0, &["Epicardium", "Endocardium"]);
        assert_eq!(commands, [Command::View(ViewCommand::ToggleEndocardium)]);
    }

    #[test]
    fn a_difference_can_be_chosen_where_there_is_one() {
        let names = ["Colour: Tissue", Quantity::Contribution.name()];
        let wanted = [Command::View(ViewCommand::SetQuantity(
            Quantity::Contribution,
        ))];
        assert_eq!(clicked(ViewMode::SideBySide, 800.0, &names), wanted);
        let names = ["Colour: Tissue", Quantity::MotionDifference.name()];
        assert_eq!(clicked(ViewMode::SideBySide, 800.0, &names), []);
    }

    #[test]
    fn the_quantity_is_chosen_from_a_menu() {
        let commands = clicked(ViewMode::Single, 800.0, &["Colour: Tissue", "Area ratio"]);
        assert_eq!(
            commands,
            [Command::View(ViewCommand::SetQuantity(Quantity::AreaRatio))]
        );
    }
}
