//! How figures look: size, background, theme. What is chosen holds for every figure from now on.

use egui::Ui;

use crate::panes::commands::{Command, FileCommand, WindowCommand};
use crate::picture::figure::{FigureBackground, FigureLook, FigureTheme, check_figure_size};
use crate::ui::controls::{chooser_ui, dialog_ui};
use crate::ui::number_field::{NumberField, number_field_ui};
use crate::ui::style::note;
use crate::ui::theme::space;

/// Sizes that are chosen by name, with their pixels.
const SIZES: [(&str, Option<[u32; 2]>); 5] = [
    ("Usual", None),
    ("Screen", Some([1920, 1080])),
    ("Slide", Some([2560, 1440])),
    ("Poster", Some([4800, 3600])),
    ("Square", Some([2400, 2400])),
];

/// What is typed beside a size that is not set yet.
const TYPED_FROM: [u32; 2] = [2400, 1800];

/// Draws the sheet; Esc or its cross closes it.
pub fn figure_sheet_ui(ui: &mut Ui, look: FigureLook, commands: &mut Vec<Command>) {
    let ctx = ui.ctx().clone();
    let size = egui::vec2(470.0, 250.0);
    let mut chosen = look;
    let mut exported = None;
    let closed = dialog_ui(&ctx, "Figure settings", size, false, |ui| {
        ui.set_width(446.0);
        ui.spacing_mut().item_spacing.y = space::MEDIUM;
        size_ui(ui, &mut chosen);
        choices_line_ui(
            ui,
            "Background",
            FigureBackground::ALL,
            &mut chosen.background,
            FigureBackground::name,
        );
        let own_colours = matches!(
            chosen.background,
            FigureBackground::White | FigureBackground::Black
        );
        ui.add_enabled_ui(!own_colours, |ui| {
            choices_line_ui(
                ui,
                "Theme",
                FigureTheme::ALL,
                &mut chosen.theme,
                FigureTheme::name,
            );
        });
        if own_colours {
            ui.label(note(
                "White and black bring their own colours of words and marks",
            ));
        }
        ui.separator();
        ui.horizontal(|ui| {
            for (name, command) in [
                ("Save patch figure…", FileCommand::ExportPatchFigure(None)),
                (
                    "Save figure of the 3D view…",
                    FileCommand::ExportFigure(None),
                ),
            ] {
                if ui.button(name).clicked() {
                    exported = Some(command);
                }
            }
        });
    });
    if chosen != look {
        commands.push(FileCommand::SetFigureLook(chosen).into());
    }
    if closed || exported.is_some() {
        commands.push(WindowCommand::ToggleFigureSheet.into());
    }
    commands.extend(exported.map(Command::from));
}

fn size_ui(ui: &mut Ui, look: &mut FigureLook) {
    let named = SIZES.iter().find(|(_, size)| *size == look.size);
    let shown = named.map_or("Typed", |(name, _)| name);
    ui.horizontal(|ui| {
        ui.label("Size");
        let chooser = chooser_ui(ui, "Size", shown, |ui| {
            for (name, size) in SIZES {
                let pixels = size.map_or_else(
                    || "2000 × 1500, patch figures 2400 × 1800".to_owned(),
                    |[width, height]| format!("{width} × {height}"),
                );
                if ui
                    .radio(look.size == size, format!("{name}: {pixels}"))
                    .clicked()
                {
                    look.size = size;
                    ui.close();
                }
            }
        });
        // Tab steps through the sheet, not through subjects.
        if ui.memory(|memory| memory.focused().is_none()) {
            chooser.request_focus();
        }
    });
    for (axis, name) in ["Width", "Height"].into_iter().enumerate() {
        let field = NumberField {
            name,
            unit: "px",
            what: "Of the whole picture; patch figures need 800 × 600",
            range: [[320.0, 240.0][axis], 8192.0],
            value: look.size.map(|size| f64::from(size[axis])),
            automatic: Some("usual"),
            enabled: true,
        };
        let others = look.size.unwrap_or(TYPED_FROM);
        let accept = |typed: Option<f64>| {
            let Some(pixels) = typed else {
                return Ok(None);
            };
            if pixels.fract() != 0.0 || !(0.0..=1e6).contains(&pixels) {
                return Err("a whole number of pixels".to_owned());
            }
            let mut size = others;
            size[axis] = pixels as u32;
            let fits = check_figure_size(size, false);
            fits.map(|()| Some(size)).map_err(|error| error.to_string())
        };
        if let Some(size) = number_field_ui(ui, &field, accept) {
            look.size = size;
        }
    }
}

/// A line of choices, one of which holds.
fn choices_line_ui<T: Copy + PartialEq>(
    ui: &mut Ui,
    title: &str,
    all: impl IntoIterator<Item = T>,
    now: &mut T,
    name: fn(T) -> &'static str,
) {
    ui.horizontal_wrapped(|ui| {
        ui.label(title);
        for choice in all {
            let radio = ui.radio(*now == choice, name(choice));
            if radio.clicked() {
                *now = choice;
            }
        }
    });
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui_kittest::{Harness, kittest::Queryable as _};

    fn sheet(look: FigureLook) -> Harness<'static, Vec<Command>> {
        let mut harness = Harness::builder()
            .with_size([800.0, 600.0])
            .with_context_setup(|ctx| crate::ui::style::apply(ctx, true))
            .build_ui_state(
                move |ui, commands: &mut Vec<Command>| figure_sheet_ui(ui, look, commands),
                Vec::new(),
            );
        harness.run();
        harness
    }

    fn look_of(commands: &[Command]) -> Option<FigureLook> {
        commands.iter().find_map(|command| match command {
            Command::File(FileCommand::SetFigureLook(look)) => Some(*look),
            _ => None,
        })
    }

    #[test]
    fn background_and_theme_are_chosen_by_name() {
        for (name, background, theme) in [
            ("Black", FigureBackground::Black, FigureTheme::Window),
            (
                "Transparent",
                FigureBackground::Transparent,
                FigureTheme::Window,
            ),
            ("Light", FigureBackground::Theme, FigureTheme::Light),
        ] {
            let mut harness = sheet(FigureLook::default());
            harness.get_by_label(name).click();
            harness.step();
            harness.step();
            let look = look_of(harness.state()).unwrap();
            assert_eq!((look.background, look.theme), (background, theme), "{name}");
        }
    }

    #[test]
    fn a_typed_width_beyond_the_limits_changes_nothing_and_says_why() {
        for (typed, size) in [("1600", Some([1600, 1800])), ("9000", None), ("12.5", None)] {
            let mut harness = sheet(FigureLook::default());
            let role = egui::accesskit::Role::TextInput;
            harness.get_by_role_and_label(role, "Width").focus();
            harness.run();
            harness
                .get_by_role_and_label(role, "Width")
                .type_text(typed);
            harness.run();
            harness.key_press(egui::Key::Enter);
            harness.step();
            harness.step();
            assert_eq!(
                look_of(harness.state()).and_then(|look| look.size),
                size,
                "{typed}"
            );
            if size.is_none() {
                let words = if typed == "9000" {
                    "a figure needs"
                } else {
                    "whole number"
                };
                assert!(
                    harness.query_all_by_label_contains(words).next().is_some(),
                    "{typed}"
                );
            }
        }
    }

    #[test]
    fn its_buttons_ask_for_a_place_and_close_it() {
        let mut harness = sheet(FigureLook::default());
        harness.get_by_label("Save patch figure…").click();
        harness.step();
        harness.step();
        assert_eq!(
            harness.state()[..2],
            [
                Command::Window(WindowCommand::ToggleFigureSheet),
                Command::File(FileCommand::ExportPatchFigure(None))
            ]
        );
    }
}
