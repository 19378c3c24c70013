//! A number to type, with its name and unit: wrong ones are refused with a reason and change nothing.

use egui::{Key, RichText, Sense, TextEdit, Ui, vec2};

use crate::ui::controls::ends_ui;
use crate::ui::style::{note, note_font};
use crate::ui::text::{note_at, text_width};
use crate::ui::theme::{colours, space};

/// What a field shows.
#[derive(Clone, Copy, Debug)]
pub struct NumberField<'a> {
    /// "Curvature, μ".
    pub name: &'a str,
    /// Behind the number; empty for what has none.
    pub unit: &'a str,
    /// What it does, for the hover.
    pub what: &'a str,
    /// The least and the greatest number that it takes, for the hover.
    pub range: [f64; 2],
    /// The number in force; `None` where the program finds it.
    pub value: Option<f64>,
    /// What an empty field shows where the program chooses the value: "automatic: 5". Fields without it
    /// must not be empty.
    pub automatic: Option<&'a str>,
    /// Whether it plays a part now.
    pub enabled: bool,
}

/// A number among settings of the type `P`.
pub struct Setting<P> {
    /// "Curvature, μ".
    pub name: &'static str,
    /// Behind the number; empty for what has none.
    pub unit: &'static str,
    /// What it does, for the hover.
    pub what: &'static str,
    /// The least and the greatest number that it takes, for the hover; what takes only positive numbers has
    /// [`ABOVE_ZERO`] as its least, what takes numbers of any size infinity as its greatest.
    pub range: [f64; 2],
    /// The number in force; `None` where the program finds it.
    pub get: fn(&P) -> Option<f64>,
    /// Puts in what was typed, or says why it is no number of this kind.
    pub set: fn(&mut P, Option<f64>) -> Result<(), String>,
}

/// Fails unless a setting puts in its least and its greatest number, which `takes` accepts, and none beyond them.
#[cfg(test)]
pub(crate) fn assert_takes_its_range<P: Default>(setting: &Setting<P>, takes: impl Fn(&P) -> bool) {
    let taken = |number: f64| {
        let mut settings = P::default();
        (setting.set)(&mut settings, Some(number)).is_ok() && takes(&settings)
    };
    let [least, most] = setting.range;
    assert!(taken(least) && !taken(least - 1.0), "{}", setting.name);
    if most.is_finite() {
        assert!(taken(most) && !taken(most + 1.0), "{}", setting.name);
    } else {
        assert!(taken(1e9), "{}", setting.name);
    }
}

impl<P: Copy> Setting<P> {
    /// Draws the field; a number that `check` takes goes into `settings`. `automatic` is that of [`NumberField`].
    pub fn ui(
        &self,
        ui: &mut Ui,
        settings: &mut P,
        automatic: Option<&str>,
        enabled: bool,
        check: impl Fn(&P) -> Result<(), String>,
    ) {
        let field = NumberField {
            name: self.name,
            unit: self.unit,
            what: self.what,
            range: self.range,
            value: (self.get)(settings),
            automatic,
            enabled,
        };
        let accept = |typed: Option<f64>| {
            let mut wanted = *settings;
            (self.set)(&mut wanted, typed)?;
            check(&wanted)?;
            Ok(wanted)
        };
        if let Some(wanted) = number_field_ui(ui, &field, accept) {
            *settings = wanted;
        }
    }
}

/// The least number of what takes only positive ones.
pub const ABOVE_ZERO: f64 = f64::MIN_POSITIVE;

/// "What it does.\n\n0 to 100 rings": what a number does, with its range and unit.
pub fn number_words(what: &str, [least, most]: [f64; 2], unit: &str) -> String {
    let range = match (least <= ABOVE_ZERO && least > 0.0, most.is_finite()) {
        (true, true) => format!("above 0, up to {}", number_text(most)),
        (true, false) => "above 0".to_owned(),
        (false, true) => format!("{} to {}", number_text(least), number_text(most)),
        (false, false) => format!("{} or more", number_text(least)),
    };
    let unit = if unit.is_empty() {
        ", no unit"
    } else {
        &format!(" {unit}")
    };
    format!("{what}\n\nRange: {range}{unit}")
}

/// What was typed and why it was refused, while it is not the number in force.
#[derive(Clone, Debug, Default)]
struct Typed {
    text: String,
    refused: Option<String>,
}

/// Width of the field and of the unit behind it; a narrow pane has a smaller field, and no room for
/// units where there are none.
const FIELD: f32 = 84.0;
const NARROW_FIELD: f32 = 56.0;
const UNIT: f32 = 38.0;
const NARROW: f32 = 250.0;

/// Draws the field; a number that is confirmed (Enter, or the keyboard goes elsewhere) and that
/// `accept` takes comes back as what `accept` makes of it.
pub fn number_field_ui<T>(
    ui: &mut Ui,
    field: &NumberField,
    accept: impl Fn(Option<f64>) -> Result<T, String>,
) -> Option<T> {
    let id = ui.scope_id().with(("number field", field.name));
    let shown = field.value.map(number_text).unwrap_or_default();
    let kept: Option<Typed> = ui.data(|data| data.get_temp(id));
    let mut typed = kept.clone().unwrap_or(Typed {
        text: shown.clone(),
        refused: None,
    });
    let what = number_words(field.what, field.range, field.unit);
    let response = row_ui(ui, field.name, &what, field.enabled, |ui| {
        let narrow = ui.available_width() < NARROW;
        if !(narrow && field.unit.is_empty()) {
            // A long unit takes more room, or it would run into the field or out of the pane.
            let room = UNIT.max(text_width(ui, field.unit, note_font()));
            let (unit_rect, _) = ui.allocate_exact_size(vec2(room, 20.0), Sense::hover());
            note_at(
                ui,
                unit_rect.left_center(),
                egui::Align2::LEFT_CENTER,
                field.unit,
            );
        }
        let width = if narrow { NARROW_FIELD } else { FIELD };
        let mut edit = TextEdit::singleline(&mut typed.text)
            .desired_width(width)
            .align(egui::Align2::RIGHT_CENTER)
            .margin(vec2(6.0, 2.0));
        if let Some(hint) = field.automatic {
            edit = edit.hint_text(note(hint));
        }
        if typed.refused.is_some() {
            edit = edit.text_color(colours(ui).error);
        }
        ui.add(edit)
            .accessible_name(field.name)
            .on_hover_text(&what)
    });
    if response.changed() {
        typed.refused = None;
    }
    let mut answer = None;
    let escaped = response.has_focus() && ui.input(|input| input.key_pressed(Key::Escape));
    if escaped || !field.enabled {
        typed = Typed {
            text: shown,
            refused: None,
        };
    } else if response.lost_focus() && typed.text.trim() != shown {
        match read(&typed.text, field.automatic.is_some()).and_then(&accept) {
            Ok(value) => answer = Some(value),
            Err(why) => typed.refused = Some(why),
        }
    }
    let settled = answer.is_some()
        || escaped
        || !(response.has_focus() || response.changed() || typed.refused.is_some());
    if settled && kept.is_some() {
        ui.data_mut(|data| data.remove::<Typed>(id));
    } else if !settled {
        ui.data_mut(|data| data.insert_temp(id, typed.clone()));
    }
    if let Some(why) = typed.refused.filter(|_| answer.is_none()) {
        let text = RichText::new(why).small().color(colours(ui).error);
        ui.add(egui::Label::new(text).wrap());
    }
    answer
}

/// A name on the left and a control on the right, in one line.
pub fn row_ui<R>(
    ui: &mut Ui,
    name: &str,
    what: &str,
    enabled: bool,
    control: impl FnOnce(&mut Ui) -> R,
) -> R {
    let size = vec2(ui.available_width(), space::ROW + 2.0);
    let (row, _) = ui.allocate_exact_size(size, Sense::hover());
    let disable = |ui: &mut Ui| {
        if !enabled {
            ui.disable();
        }
    };
    let right = |ui: &mut Ui| {
        ui.spacing_mut().item_spacing.x = space::SMALL;
        disable(ui);
        control(ui)
    };
    ends_ui(ui, row, right, |ui| {
        disable(ui);
        let label = ui.add(egui::Label::new(name).truncate());
        if !what.is_empty() {
            label.on_hover_text(what);
        }
    })
}

/// A number as a person types it: as many digits as it has, powers of ten where it is small.
pub fn number_text(value: f64) -> String {
    if value != 0.0 && (value.abs() < 1e-4 || value.abs() >= 1e6) {
        return format!("{value:e}");
    }
    // Six figures are more than anybody chose; the rest is round-off.
    let digits = 5 - value.abs().max(1e-4).log10().floor() as i32;
    without_zeros(format!("{value:.*}", digits.clamp(0, 12) as usize))
}

/// A number without the zeros that end its decimal places.
pub fn without_zeros(text: String) -> String {
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}

/// The number that was typed; `None` for an empty field.
fn read(text: &str, may_be_empty: bool) -> Result<Option<f64>, String> {
    let text = text.trim().replace(',', ".").replace('−', "-");
    if text.is_empty() {
        return if may_be_empty {
            Ok(None)
        } else {
            Err("Enter a number".to_owned())
        };
    }
    match text.parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(Some(value)),
        _ => Err(format!("“{text}” is not a number")),
    }
}

/// A whole number from a field, or why it is none.
pub fn whole(value: f64, max: u32) -> Result<u32, String> {
    if value.fract() != 0.0 || value < 0.0 {
        return Err(format!(
            "must be a whole number, not {}",
            number_text(value)
        ));
    }
    if value > f64::from(max) {
        return Err(format!("must be at most {max}"));
    }
    Ok(value as u32)
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui_kittest::{Harness, kittest::Queryable as _};

    #[test]
    fn numbers_are_shown_as_they_are_typed() {
        for (value, text) in [
            (0.001, "0.001"),
            (3.0, "3"),
            (0.0, "0"),
            (1e-5, "1e-5"),
            (0.1 + 0.2, "0.3"),
            (1024.0, "1024"),
            (2.5e7, "2.5e7"),
        ] {
            assert_eq!(number_text(value), text);
            assert_eq!(
                read(text, false).map(|v| v.map(number_text)),
                Ok(Some(text.to_owned()))
            );
        }
        assert_eq!(read("0,5", false), Ok(Some(0.5)));
        assert_eq!(read(" ", true), Ok(None));
        assert!(read("", false).is_err() && read("x", true).is_err());
        assert!(whole(2.5, 9).is_err() && whole(10.0, 9).is_err());
    }

    #[test]
    fn a_number_is_explained_with_its_range_and_unit() {
        let words = |range, unit| number_words("Rings.", range, unit);
        assert_eq!(
            words([0.0, 100.0], "rings"),
            "Rings.\n\nRange: 0 to 100 rings"
        );
        assert_eq!(
            words([0.0, f64::INFINITY], ""),
            "Rings.\n\nRange: 0 or more, no unit"
        );
        assert_eq!(
            words([ABOVE_ZERO, 1.0], ""),
            "Rings.\n\nRange: above 0, up to 1, no unit"
        );
    }

    fn harness() -> Harness<'static, (Option<f64>, Vec<Option<f64>>)> {
        Harness::builder()
            .with_context_setup(|ctx| crate::ui::style::apply(ctx, true))
            .build_ui_state(
                |ui, (value, taken): &mut (Option<f64>, Vec<Option<f64>>)| {
                    let field = NumberField {
                        name: "Weight",
                        unit: "mm",
                        what: "",
                        range: [0.0, f64::INFINITY],
                        value: *value,
                        automatic: Some("automatic"),
                        enabled: true,
                    };
                    let accept = |number: Option<f64>| match number {
                        Some(n) if n < 0.0 => Err(format!("must not be negative, not {n}")),
                        other => Ok(other),
                    };
                    if let Some(number) = number_field_ui(ui, &field, accept) {
                        *value = number;
                        taken.push(number);
                    }
                },
                (Some(3.0), Vec::new()),
            )
    }

    fn type_into(harness: &mut Harness<'_, (Option<f64>, Vec<Option<f64>>)>, text: &str) {
        let (role, name) = (egui::accesskit::Role::TextInput, "Weight");
        harness.get_by_role_and_label(role, name).focus();
        harness.run();
        harness.key_press_modifiers(egui::Modifiers::COMMAND, Key::A);
        harness.run();
        if text.is_empty() {
            harness.key_press(Key::Delete);
        } else {
            harness.get_by_role_and_label(role, name).type_text(text);
        }
        harness.run();
        harness.key_press(Key::Enter);
        harness.run();
    }

    #[test]
    fn a_number_counts_once_it_is_confirmed() {
        let mut harness = harness();
        harness.run();
        type_into(&mut harness, "4.5");
        assert_eq!(harness.state().1, [Some(4.5)]);
        type_into(&mut harness, "");
        assert_eq!(harness.state().1, [Some(4.5), None]);
    }

    #[test]
    fn a_wrong_number_is_refused_with_a_reason_and_stays_to_be_mended() {
        let mut harness = harness();
        harness.run();
        type_into(&mut harness, "-2");
        assert!(harness.state().1.is_empty());
        harness.get_by_label("must not be negative, not -2");
        type_into(&mut harness, "two");
        harness.get_by_label("“two” is not a number");
        type_into(&mut harness, "2");
        assert_eq!(harness.state().1, [Some(2.0)]);
        assert!(harness.query_by_label_contains("not a number").is_none());
    }
}
