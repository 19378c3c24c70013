//! Texts that several panes write alike, and how much room they take.

use egui::{Align2, Color32, FontId, Pos2, Ui};

use crate::ui::style::note_font;
use crate::ui::theme::colours;

/// How wide a text is in one line.
pub fn text_width(ui: &Ui, text: &str, font: FontId) -> f32 {
    let painter = ui.painter();
    let galley = painter.layout_no_wrap(text.to_owned(), font, Color32::PLACEHOLDER);
    galley.size().x
}

/// Writes a note of an axis or a scale: small and muted.
pub fn note_at(ui: &Ui, at: Pos2, anchor: Align2, text: impl ToString) {
    let colour = colours(ui).muted;
    ui.painter().text(at, anchor, text, note_font(), colour);
}

/// Seconds left in the words of the status bar: "4 s left", "2 min left".
pub fn time_left_text(seconds: f64) -> String {
    if seconds < 90.0 {
        format!("{} s left", seconds.ceil().max(1.0))
    } else {
        format!("{} min left", (seconds / 60.0).round())
    }
}

/// "71 % · 4 s left".
pub fn progress_text(fraction: f32, seconds_left: Option<f64>) -> String {
    let percent = format!("{:.0} %", 100.0 * fraction.clamp(0.0, 1.0));
    match seconds_left {
        Some(seconds) => format!("{percent} · {}", time_left_text(seconds)),
        None => percent,
    }
}

/// A p-value, with three places where it is small.
pub fn p_text(p: f64) -> String {
    if p < 0.001 {
        "< 0.001".to_owned()
    } else if p < 0.1 {
        format!("{p:.3}")
    } else {
        format!("{p:.2}")
    }
}

/// "1 warning", "2 warnings".
pub fn counted(count: usize, what: &str) -> String {
    let plural = if count == 1 { "" } else { "s" };
    format!("{count} {what}{plural}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn time_left_is_shown_in_seconds_or_minutes() {
        assert_eq!(time_left_text(0.2), "1 s left");
        assert_eq!(time_left_text(3.4), "4 s left");
        assert_eq!(time_left_text(130.0), "2 min left");
    }
}
