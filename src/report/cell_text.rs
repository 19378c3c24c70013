//! Texts as cells of CSV files: nothing in them runs in a spreadsheet or moves the cursor of a terminal.

use std::borrow::Cow;

/// Words that stand in a cell, escaped so that a spreadsheet takes them for words.
///
/// Programs that open CSV files compute what begins with `=`, `+`, `-` or `@`, also behind a tab or a line end; such a text
/// gets an apostrophe in front, as people type it there. A text that is a number is no formula and stays as it is. Control
/// characters, among them line ends, become their codes: `\n`, `\t`, `\u{1b}`.
///
/// No two texts become one: where apostrophes stand before such a sign already, one more is added.
pub(super) fn cell_text(words: &str) -> Cow<'_, str> {
    let visible = visible(words);
    if begins_a_formula(words) {
        Cow::Owned(format!("'{visible}"))
    } else {
        visible
    }
}

fn begins_a_formula(words: &str) -> bool {
    let bare = words.trim_start_matches('\'');
    let sign = |letter| "=+-@\t\r\n＝＋－＠".contains(letter);
    let number = words.parse::<f64>().is_ok_and(f64::is_finite);
    bare.starts_with(sign) && !number
}

/// With codes in place of control characters and of those that turn the direction of writing.
fn visible(words: &str) -> Cow<'_, str> {
    let hidden = |letter: char| {
        let turns = matches!(letter, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
        letter.is_control() || turns || matches!(letter, '\u{2028}' | '\u{2029}')
    };
    if !words.contains(hidden) {
        return Cow::Borrowed(words);
    }
    let mut text = String::with_capacity(words.len() + 8);
    for letter in words.chars() {
        if !hidden(letter) {
            text.push(letter);
        } else if matches!(letter, '\n' | '\r' | '\t') {
            text.extend(letter.escape_default());
        } else {
            text.extend(letter.escape_unicode());
        }
    }
    Cow::Owned(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formulas_become_words_and_numbers_stay_numbers() {
        for (words, cell) in [
            ("=1+1", "'=1+1"),
            ("@SUM(A1)", "'@SUM(A1)"),
            ("+cmd|' /C calc'!A0", "'+cmd|' /C calc'!A0"),
            ("-2+3", "'-2+3"),
            ("\t=1", "'\\t=1"),
            ("\r=1", "'\\r=1"),
            ("＝1", "'＝1"),
            ("-2", "-2"),
            ("+3.5e-2", "+3.5e-2"),
            ("-inf", "'-inf"),
            ("P-041", "P-041"),
            ("", ""),
        ] {
            assert_eq!(cell_text(words), cell);
        }
    }

    #[test]
    fn two_texts_never_become_one() {
        let cells = ["=a", "'=a", "''=a", "'a", "a"].map(|words| cell_text(words).into_owned());
        assert_eq!(cells, ["'=a", "''=a", "'''=a", "'a", "a"]);
    }

    #[test]
    fn control_characters_become_codes() {
        assert_eq!(cell_text("a\u{1b}[2J\nb"), "a\\u{1b}[2J\\nb");
        assert_eq!(cell_text("a\u{202e}b\u{9b}"), "a\\u{202e}b\\u{9b}");
        assert_eq!(cell_text("Jürgen 心脏"), "Jürgen 心脏");
    }
}
