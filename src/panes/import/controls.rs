//! Controls that several steps share.

use std::ops::RangeInclusive;

use egui::{Label, RichText, Slider, Ui};

use crate::ui::number_field::number_words;
use crate::ui::style::{medium, note};
use crate::ui::theme::{colours, space};

/// What a slider sets.
pub struct SliderRow<'a> {
    /// Its name.
    pub name: &'a str,
    /// What it does, in a sentence.
    pub what: &'a str,
    /// Unit of the number.
    pub unit: &'static str,
    /// Digits behind the point.
    pub digits: usize,
    /// Least and greatest number.
    pub range: RangeInclusive<f64>,
}

/// A name with a slider below it; the number that somebody set.
pub fn slider_ui(ui: &mut Ui, row: &SliderRow<'_>, value: f64) -> Option<f64> {
    ui.add_space(space::SMALL);
    let label = ui.label(row.name);
    let (mut shown, ends) = (value, [*row.range.start(), *row.range.end()]);
    ui.spacing_mut().slider_width = (ui.available_width() - 72.0).clamp(60.0, 240.0);
    let slider = Slider::new(&mut shown, row.range.clone())
        .smart_aim(false)
        .fixed_decimals(row.digits)
        .suffix(format!(" {}", row.unit));
    let what = number_words(row.what, ends, row.unit);
    let moved = ui.add(slider).labelled_by(label.id).on_hover_text(what);
    (moved.changed() && (shown - value).abs() > f64::EPSILON).then_some(shown)
}

/// A heading within a step.
pub fn heading_ui(ui: &mut Ui, text: &str) {
    ui.add_space(space::MEDIUM);
    ui.label(medium(text));
}

/// A sentence over the whole width.
pub fn sentence_ui(ui: &mut Ui, text: impl Into<String>) {
    ui.add(Label::new(note(text)).wrap());
}

/// A sentence that asks for attention.
pub fn warning_ui(ui: &mut Ui, text: impl Into<String>) {
    let colour = colours(ui).warning;
    let text = RichText::new(text).text_style(egui::TextStyle::Small);
    ui.add(Label::new(text.color(colour)).wrap());
}
