//! Texts that several panes write alike, and how much room they take.

use egui::{Align2, Color32, FontId, Pos2, Ui};

use crate::study::checks;
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

/// "1 warning", "2 warnings": of a noun with a regular plural.
pub fn counted(count: usize, what: &str) -> String {
    checks::counted(count, what, &format!("{what}s"))
}

/// First letters of a name that stay when its middle is left out, and how many last ones go before them.
const HEAD: usize = 3;
const TAIL: usize = 8;

/// A name with as little left out of its middle as makes it fit: names of one study often begin alike and differ at their
/// end or in a number.
pub fn without_middle(name: &str, fits: impl Fn(&str) -> bool) -> String {
    let letters: Vec<char> = name.chars().collect();
    if letters.len() <= HEAD + 2 || fits(name) {
        return name.to_owned();
    }
    let part = |letters: &[char]| letters.iter().collect::<String>();
    let fitting = |head: usize| {
        let shown = |from: usize| format!("{}…{}", part(&letters[..head]), part(&letters[from..]));
        let mut from = head + 1..letters.len() - 1;
        let found = from.find(|&from| fits(&shown(from)));
        let from = found.unwrap_or(letters.len() - 1);
        (letters.len() - from, shown(from))
    };
    let (tail, shown) = fitting(HEAD);
    let number = significant_number(&letters);
    let holds_number = |tail: usize| number.is_none_or(|start| letters.len() - tail <= start);
    if tail >= TAIL && holds_number(tail) {
        return shown;
    }
    // Names of one study begin alike: its letters say less than the last ones, and those less than a number.
    let (tail, shown) = fitting(1);
    if holds_number(tail) {
        return shown;
    }
    let from_number = number.and_then(|start| {
        let mut ends = (start + 1..letters.len()).rev();
        ends.find_map(|end| {
            let shown = format!("…{}…", part(&letters[start..end]));
            fits(&shown).then_some(shown)
        })
    });
    from_number.unwrap_or(shown)
}

/// Where the last number of a name begins, without the zeros in front of it.
fn significant_number(letters: &[char]) -> Option<usize> {
    let last = letters.iter().rposition(char::is_ascii_digit)?;
    let before = letters[..last].iter().rposition(|c| !c.is_ascii_digit());
    let start = before.map_or(0, |before| before + 1);
    let zeros = letters[start..last].iter().take_while(|c| **c == '0');
    Some(start + zeros.count())
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

    #[test]
    fn a_name_keeps_its_beginning_and_its_end() {
        let fits = |max: usize| move |shown: &str| shown.chars().count() <= max;
        assert_eq!(without_middle("patient015", fits(10)), "patient015");
        assert_eq!(without_middle("patient015", fits(8)), "p…ent015");
        assert_eq!(without_middle("patient015", fits(2)), "p…5");
        let long = "Patient000151_stress";
        assert_eq!(without_middle(long, fits(14)), "Pat…151_stress");
        assert_eq!(without_middle(long, fits(13)), "P…0151_stress");
        assert_eq!(without_middle(long, fits(10)), "…151_stre…");
        assert_eq!(without_middle(long, fits(6)), "…151_…");
        assert_eq!(without_middle("Patient_of_no_number", fits(9)), "P…_number");
        assert_eq!(without_middle("P03", fits(1)), "P03");
        assert_eq!(without_middle("", fits(0)), "");
    }
}
