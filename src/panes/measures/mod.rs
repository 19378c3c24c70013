//! The clinical measures of the selected subject, with units and, where one is defensible, the normal range.

pub(crate) mod spec;
mod view;

use egui::text::{LayoutJob, TextFormat};
use egui::{Align, RichText, Ui};

use crate::analysis::measures::{
    EDV_RANGE, EF_RANGE, ESV_RANGE, MASS_RANGE, ReferenceRange, SV_RANGE,
};
use crate::panes::buttons::command_button_ui;
use crate::panes::commands::{Command, EditCommand, Phase, PhaseFrame, Whose};
use crate::report::{Digits, NO_VALUE, SubjectRow};
use crate::ui::controls::{chooser_ui, no_subject_ui};
use crate::ui::style::{medium, medium_font, note, note_font, text_font, title_font};
use crate::ui::text::text_width;
use crate::ui::theme::{colours, space};
use crate::units::LengthUnit;

/// What the measures card shows.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MeasuresView<'a> {
    /// The selected subject; `None` when nothing is selected.
    pub subject: Option<&'a str>,
    /// Whether measures are still to come.
    pub computing: bool,
    /// Its measures; empty where they are not known.
    pub measures: SubjectRow,
    /// The frame that is shown now.
    pub current_frame: usize,
}

/// From this height on each name stands above its value.
const ROOMY_HEIGHT: f32 = 245.0;

/// Draws the card.
pub fn measures_card_ui(ui: &mut Ui, view: &MeasuresView, commands: &mut Vec<Command>) {
    if view.subject.is_none() {
        return no_subject_ui(ui, "Select a subject to see its measures");
    }
    let low = ui.available_height() < ROOMY_HEIGHT;
    let mut margin = egui::Margin::same(space::LARGE as i8);
    if low {
        margin.top = space::SMALL as i8;
    }
    let frame = egui::Frame::new().inner_margin(margin);
    // What does not fit is told by the bar of scrolling, before anybody points at it.
    let scroll = &mut ui.spacing_mut().scroll;
    (
        scroll.dormant_handle_opacity,
        scroll.dormant_background_opacity,
    ) = (0.6, 0.3);
    egui::ScrollArea::vertical()
        .id_salt("measures")
        .show(ui, |ui| {
            frame.show(ui, |ui| {
                ui.spacing_mut().item_spacing.y = 1.0;
                ejection_fraction_ui(ui, view);
                ui.add_space(space::MEDIUM);
                let row = &view.measures;
                let volumes = [SubjectRow::EDV, SubjectRow::ESV];
                let heading = volumes.each_ref().map(|column| column.heading).join(" · ");
                let [edv, esv, sv] = volume_texts(row);
                let unit = row.unit.volume_symbol();
                let both = format!("{edv} · {esv}");
                let width =
                    text_width(ui, &both, medium_font()) + text_width(ui, unit, text_font());
                let fit = width + space::SMALL <= ui.available_width();
                let mut value_ui =
                    |names: &[&str], value: &str, unit: &str, ranges: &[ReferenceRange]| {
                        value_ui(ui, names, [value, unit], ranges, low);
                    };
                if fit {
                    value_ui(&[&heading], &both, unit, &[EDV_RANGE, ESV_RANGE]);
                } else {
                    value_ui(&[SubjectRow::EDV.heading], &edv, unit, &[EDV_RANGE]);
                    value_ui(&[SubjectRow::ESV.heading], &esv, unit, &[ESV_RANGE]);
                }
                value_ui(&[SubjectRow::SV.heading, "SV"], &sv, unit, &[SV_RANGE]);
                // A mass needs a volume in ml.
                if row.unit == LengthUnit::Millimetre {
                    let mass = SubjectRow::MASS_G;
                    let unit = mass.unit.symbol(row.unit);
                    value_ui(&[mass.heading], &mass.shown(row), unit, &[MASS_RANGE]);
                }
                ui.add_space(space::SMALL);
                phases_ui(ui, view, commands);
            });
        });
}

fn ejection_fraction_ui(ui: &mut Ui, view: &MeasuresView) {
    // Whose numbers they are: the heart on screen may still be the one before.
    let whose = view.subject.unwrap_or_default();
    let title = egui::Label::new(note(format!("{whose} · Ejection fraction")));
    ui.add(title.truncate());
    let row = &view.measures;
    let text = match row.ef {
        None if view.computing => "…".to_owned(),
        _ => SubjectRow::EF.shown(row),
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
    let percent = SubjectRow::EF.unit.symbol(row.unit);
    line.append(percent, space::SMALL, format(text_font(), colours.muted));
    let words = ejection_fraction_words(row.ef);
    let width = text_width(ui, &text, title_font())
        + text_width(ui, percent, text_font())
        + text_width(ui, &words, note_font())
        + space::SMALL
        + space::MEDIUM;
    // Words that would wrap within themselves stand below.
    if ui.available_width() > width.max(150.0) {
        line.append(&words, space::MEDIUM, format(note_font(), colours.muted));
        ui.label(line)
            .on_hover_text(format!("Normal: {}", EF_RANGE.source));
    } else {
        ui.label(line)
            .on_hover_text(format!("Normal: {}", EF_RANGE.source));
        ui.add(egui::Label::new(note(words)).wrap());
    }
}

/// How an ejection fraction lies to its range: "below normal 52–74 %".
fn ejection_fraction_words(fraction: Option<f64>) -> String {
    let outside = fraction.and_then(|fraction| EF_RANGE.outside(100.0 * fraction));
    let side = outside.map_or(
        "",
        |outside| {
            if outside.below { "below " } else { "above " }
        },
    );
    format!("{side}normal {}", EF_RANGE.words())
}

/// "EDV normal in adults 86–214 ml: …", a line per range; ranges are in ml and g, whatever a file counts in.
fn ranges_in_words(ranges: &[ReferenceRange], unit: &str) -> String {
    let mut lines: Vec<String> = (ranges.iter())
        .map(|range| format!("{}: normal in adults {}", range.name, range.words()))
        .collect();
    match ranges.first() {
        Some(range) if range.unit == unit => lines.push(format!("Range: {}", range.source)),
        _ => return "No normal range: the unit of coordinates is not known".to_owned(),
    }
    lines.join("\n")
}

/// End-diastolic, end-systolic and stroke volume as they stand below each other: the third is the difference of the two
/// that are shown. Where rounding would tell another one, all have a decimal place.
fn volume_texts(row: &SubjectRow) -> [String; 3] {
    let columns = [&SubjectRow::EDV, &SubjectRow::ESV, &SubjectRow::SV];
    let usual = columns.map(|column| column.shown(row));
    let difference = |[edv, esv, _]: &[String; 3]| Some(shown_number(edv)? - shown_number(esv)?);
    let (Some(rounded), Some(sv)) = (difference(&usual), shown_number(&usual[2])) else {
        return usual;
    };
    if (rounded - sv).abs() < 1e-6 {
        return usual;
    }
    let digits = Digits::Places(1);
    let mut finer = columns.map(|column| column.shown_with(digits, row));
    if let Some(rounded) = difference(&finer) {
        finer[2] = digits.shown(rounded);
    }
    finer
}

/// The number that a text shows; `None` where it shows none.
fn shown_number(text: &str) -> Option<f64> {
    text.replace('−', "-").parse().ok()
}

/// A volume or a mass, with its normal range under the pointer, below the first of its names; in a `low` pane beside the
/// first one that leaves room.
fn value_ui(
    ui: &mut Ui,
    names: &[&str],
    [value, unit]: [&str; 2],
    ranges: &[ReferenceRange],
    low: bool,
) {
    let width = text_width(ui, value, medium_font()) + text_width(ui, unit, text_font());
    let free = ui.available_width() - width - 2.0 * space::SMALL;
    let mut beside = names.iter().filter(|_| low);
    let beside = beside.find(|name| text_width(ui, name, note_font()) <= free);
    if let (None, Some(name)) = (beside, names.first()) {
        ui.add(egui::Label::new(note(*name)).truncate());
    }
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = space::SMALL;
        ui.spacing_mut().interact_size.y = 16.0;
        if let Some(name) = beside {
            ui.label(note(*name));
        }
        ui.label(medium(value));
        if value != NO_VALUE {
            ui.label(RichText::new(unit).weak());
        }
    })
    .response
    .on_hover_text(ranges_in_words(ranges, unit));
    ui.add_space(3.0);
}

fn phases_ui(ui: &mut Ui, view: &MeasuresView, commands: &mut Vec<Command>) {
    let row = &view.measures;
    let frames = [SubjectRow::END_DIASTOLE, SubjectRow::END_SYSTOLE];
    let frames = frames
        .each_ref()
        .map(|column| format!("{} {}", column.heading, column.shown(row)));
    let shown = frames.join(" · ");
    chooser_ui(ui, "Frames of end-diastole and end-systole", shown, |ui| {
        let here = view.current_frame;
        let phases = [Phase::EndDiastole, Phase::EndSystole];
        for phase in phases {
            let name = format!("Set {} to frame {here}", phase.name());
            let set = EditCommand::SetPhase(Whose::Selected, phase, PhaseFrame::Frame(here));
            command_button_ui(ui, name, set, commands);
        }
        ui.separator();
        for phase in phases {
            let name = crate::picture::sentence(&format!("{} from the volume curve", phase.name()));
            let found = EditCommand::SetPhase(Whose::Selected, phase, PhaseFrame::Found);
            command_button_ui(ui, name, found, commands);
        }
    });
    if row.phases_stated {
        ui.add(egui::Label::new(note("set by the user or the study")).wrap());
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui_kittest::{Harness, kittest::Queryable as _};

    #[test]
    fn the_stroke_volume_is_the_difference_of_the_volumes_that_are_shown() {
        let texts = |edv: f64, esv: f64| {
            volume_texts(&SubjectRow {
                edv: Some(edv),
                esv: Some(esv),
                sv: Some(edv - esv),
                ..SubjectRow::default()
            })
        };
        assert_eq!(texts(149.4, 82.6), ["149.4", "82.6", "66.8"]);
        assert_eq!(texts(149.0, 83.2), ["149.0", "83.2", "65.8"]);
        assert_eq!(texts(100.0, 91.7), ["100.0", "91.7", "8.3"]);
        for step in 0..2000 {
            let [edv, esv, sv] = texts(149.0 + 0.0013 * f64::from(step), 82.6);
            let [edv, esv, sv] = [edv, esv, sv].map(|text| shown_number(&text).unwrap());
            assert!((edv - esv - sv).abs() < 1e-6, "{edv} − {esv} is not {sv}");
        }
        let unknown = volume_texts(&SubjectRow::default());
        assert_eq!(unknown, [NO_VALUE; 3].map(str::to_owned));
    }

    #[test]
    fn a_measure_outside_its_range_is_called_so_and_the_range_is_that_of_the_tables() {
        assert_eq!(ejection_fraction_words(Some(0.31)), "below normal 52–74 %");
        assert_eq!(ejection_fraction_words(Some(0.80)), "above normal 52–74 %");
        assert_eq!(ejection_fraction_words(Some(0.60)), "normal 52–74 %");
        assert_eq!(ejection_fraction_words(None), "normal 52–74 %");
        let words = ranges_in_words(&[EDV_RANGE, ESV_RANGE], "ml");
        assert!(
            words.starts_with("EDV: normal in adults 86–214 ml\nESV: normal in adults 22–82 ml\n")
        );
        assert!(ranges_in_words(&[SV_RANGE], "units³").starts_with("No normal range"));
    }

    fn card(size: [f32; 2], stated: bool) -> Harness<'static, Vec<Command>> {
        Harness::builder()
            .with_size(size)
            .with_context_setup(|ctx| crate::ui::style::apply(ctx, true))
            .build_ui_state(
                move |ui, commands: &mut Vec<Command>| {
                    let view = MeasuresView {
                        subject: Some("P-041"),
                        measures: SubjectRow {
                            ef: Some(0.363),
                            edv: Some(104.0),
                            esv: Some(66.0),
                            sv: Some(38.0),
                            mass_g: Some(83.0),
                            unit: LengthUnit::Millimetre,
                            end_diastole: Some(0),
                            end_systole: Some(3),
                            phases_stated: stated,
                            ..SubjectRow::default()
                        },
                        current_frame: 4,
                        ..Default::default()
                    };
                    measures_card_ui(ui, &view, commands);
                },
                Vec::new(),
            )
    }

    #[test]
    fn a_low_pane_shows_every_measure_whole() {
        let mut harness = card([142.0, 209.0], false);
        harness.run();
        let value = harness.get_by_label("38.0").rect();
        let name = harness.get_by_label("SV").rect();
        assert!((name.center().y - value.center().y).abs() < 4.0);
        let mass = harness.get_by_label("83").rect();
        assert!(mass.bottom() < 201.0, "{mass}");
        // In a higher one its name stands above.
        let mut harness = card([170.0, 320.0], false);
        harness.run();
        let name = harness.get_by_label("Stroke volume").rect();
        assert!(name.bottom() <= harness.get_by_label("38.0").rect().top() + 2.0);
    }

    #[test]
    fn where_the_phases_come_from_is_not_cut() {
        let mut harness = card([170.0, 320.0], true);
        harness.run();
        harness.get_by_label_contains("ED 0 · ES 3");
        let source = harness.get_by_label("set by the user or the study").rect();
        assert!(source.right() < 170.0 && source.height() > 20.0, "{source}");
    }

    #[test]
    fn the_current_frame_can_be_stated_as_end_systole() {
        let mut harness = card([400.0, 400.0], false);
        harness.run();
        harness.get_by_label_contains("36");
        harness.get_by_label("104 · 66");
        harness.get_by_label_contains("ED 0 · ES 3").click();
        harness.run();
        harness.get_by_label("Set end-systole to frame 4").click();
        harness.run();
        assert_eq!(
            harness.into_state(),
            [Command::Edit(EditCommand::SetPhase(
                Whose::Selected,
                Phase::EndSystole,
                PhaseFrame::Frame(4)
            ))]
        );
    }
}
