//! The clinical measures of the selected heart, with units and, where one is defensible, the normal range.

use egui::text::{LayoutJob, TextFormat};
use egui::{Align, RichText, Ui};

use crate::ui::command::Command;
use crate::ui::controls::{chooser_ui, empty_pane_ui};
use crate::ui::normal_ranges::{EJECTION_FRACTION, NO_VOLUME_RANGE};
use crate::ui::style::{medium, note, note_font, text_font, title_font};
use crate::ui::theme::{colours, space};

/// What the measures card shows.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MeasuresView<'a> {
    /// The selected subject; `None` when nothing is selected.
    pub subject: Option<&'a str>,
    /// Whether measures are still to come.
    pub computing: bool,
    /// Ejection fraction as a fraction.
    pub ejection_fraction: Option<f64>,
    /// End-diastolic volume in `volume_unit`.
    pub end_diastolic_volume: Option<f64>,
    /// End-systolic volume in `volume_unit`.
    pub end_systolic_volume: Option<f64>,
    /// Stroke volume in `volume_unit`.
    pub stroke_volume: Option<f64>,
    /// `ml`, or `units³` where the files do not say their unit.
    pub volume_unit: &'a str,
    /// Mass of the muscle in grams.
    pub mass_g: Option<f64>,
    /// Frame of end-diastole.
    pub end_diastole: Option<usize>,
    /// Frame of end-systole.
    pub end_systole: Option<usize>,
    /// Whether these frames were stated rather than found.
    pub phases_stated: bool,
    /// The frame that is shown now.
    pub current_frame: usize,
}

/// Draws the card.
pub fn measures_card_ui(ui: &mut Ui, view: &MeasuresView, commands: &mut Vec<Command>) {
    if view.subject.is_none() {
        empty_pane_ui(
            ui,
            "No subject selected",
            "Select a subject to see its measures",
            |_| {},
        );
        return;
    }
    let frame = egui::Frame::new().inner_margin(egui::Margin::same(space::LARGE as i8));
    egui::ScrollArea::vertical()
        .id_salt("measures")
        .show(ui, |ui| {
            frame.show(ui, |ui| {
                ui.spacing_mut().item_spacing.y = 1.0;
                ejection_fraction_ui(ui, view);
                ui.add_space(space::MEDIUM);
                let pair = format!(
                    "{} · {}",
                    number(view.end_diastolic_volume),
                    number(view.end_systolic_volume)
                );
                value_ui(ui, "EDV · ESV", &pair, view.volume_unit, NO_VOLUME_RANGE);
                value_ui(
                    ui,
                    "Stroke volume",
                    &number(view.stroke_volume),
                    view.volume_unit,
                    NO_VOLUME_RANGE,
                );
                if view.volume_unit == "ml" {
                    value_ui(ui, "Mass", &number(view.mass_g), "g", NO_VOLUME_RANGE);
                }
                ui.add_space(space::SMALL);
                phases_ui(ui, view, commands);
            });
        });
}

fn ejection_fraction_ui(ui: &mut Ui, view: &MeasuresView) {
    ui.add(egui::Label::new(note("Ejection fraction")).truncate());
    let text = match view.ejection_fraction {
        Some(ef) => format!("{:.0}", 100.0 * ef),
        None if view.computing => "…".to_owned(),
        None => "–".to_owned(),
    };
    let colours = colours(ui);
    let format = |font_id, color| TextFormat {
        font_id,
        color,
        valign: Align::BOTTOM,
        ..TextFormat::default()
    };
    let mut line = LayoutJob::default();
    line.append(&text, 0.0, format(title_font(), colours.strong));
    line.append("%", space::SMALL, format(text_font(), colours.muted));
    if ui.available_width() > 150.0 {
        line.append(
            EJECTION_FRACTION.short,
            space::MEDIUM,
            format(note_font(), colours.muted),
        );
        ui.label(line).on_hover_text(EJECTION_FRACTION.source);
    } else {
        ui.label(line).on_hover_text(EJECTION_FRACTION.source);
        ui.add(egui::Label::new(note(EJECTION_FRACTION.short)).truncate());
    }
}

fn value_ui(ui: &mut Ui, name: &str, value: &str, unit: &str, hover: &str) {
    ui.add(egui::Label::new(note(name)).truncate());
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = space::SMALL;
        ui.spacing_mut().interact_size.y = 16.0;
        ui.label(medium(value));
        if value != "–" {
            ui.label(RichText::new(unit).weak());
        }
    })
    .response
    .on_hover_text(hover);
    ui.add_space(6.0);
}

/// No more digits than a volume deserves: whole numbers, one place below ten.
fn number(value: Option<f64>) -> String {
    match value {
        None => "–".to_owned(),
        Some(value) if value.abs() < 9.95 => format!("{value:.1}"),
        Some(value) => format!("{value:.0}"),
    }
}

fn phases_ui(ui: &mut Ui, view: &MeasuresView, commands: &mut Vec<Command>) {
    let frame = |frame: Option<usize>| frame.map_or("–".to_owned(), |frame| frame.to_string());
    let stated = if view.phases_stated { " · stated" } else { "" };
    let shown = format!(
        "ED {} · ES {}{stated}",
        frame(view.end_diastole),
        frame(view.end_systole)
    );
    chooser_ui(ui, "Frames of end-diastole and end-systole", shown, |ui| {
        let here = view.current_frame;
        if ui
            .button(format!("Set end-diastole to frame {here}"))
            .clicked()
        {
            commands.push(Command::StateEndDiastole(Some(here)));
        }
        if ui
            .button(format!("Set end-systole to frame {here}"))
            .clicked()
        {
            commands.push(Command::StateEndSystole(Some(here)));
        }
        ui.separator();
        if ui.button("End-diastole from the volume curve").clicked() {
            commands.push(Command::StateEndDiastole(None));
        }
        if ui.button("End-systole from the volume curve").clicked() {
            commands.push(Command::StateEndSystole(None));
        }
    });
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui_kittest::{Harness, kittest::Queryable as _};

    #[test]
    fn numbers_carry_no_more_digits_than_they_deserve() {
        assert_eq!(number(Some(104.36)), "104");
        assert_eq!(number(Some(4.31)), "4.3");
        assert_eq!(number(Some(9.97)), "10");
        assert_eq!(number(None), "–");
    }

    #[test]
    fn the_current_frame_can_be_stated_as_end_systole() {
        let mut harness = Harness::builder()
            .with_context_setup(|ctx| crate::ui::style::apply(ctx, true))
            .build_ui_state(
                |ui, commands: &mut Vec<Command>| {
                    let view = MeasuresView {
                        subject: Some("P-041"),
                        ejection_fraction: Some(0.363),
                        end_diastolic_volume: Some(104.0),
                        end_systolic_volume: Some(66.2),
                        volume_unit: "ml",
                        end_diastole: Some(0),
                        end_systole: Some(3),
                        current_frame: 4,
                        ..Default::default()
                    };
                    measures_card_ui(ui, &view, commands);
                },
                Vec::new(),
            );
        harness.run();
        harness.get_by_label_contains("36");
        harness.get_by_label("104 · 66");
        harness.get_by_label_contains("ED 0 · ES 3").click();
        harness.run();
        harness.get_by_label("Set end-systole to frame 4").click();
        harness.run();
        assert_eq!(harness.into_state(), [Command::StateEndSystole(Some(4))]);
    }
}
