//! A file's name cut into words, and the number that a word holds.

use super::frame_name::{FrameNumber, NumberUnit};
use super::words::{is_frame_word, meanings, phase_of_word};

/// One word of a name.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Word {
    /// As it is written.
    pub(super) text: String,
    /// The letters before the number, or the whole word if it has none.
    pub(super) letters: String,
    /// The number at its end, with its unit.
    pub(super) number: Option<FrameNumber>,
    /// Whether the number is the first of `2of4`.
    pub(super) of_total: bool,
}

/// Cuts a name into words; decimals, exponents and signs stay with their numbers.
pub(super) fn words_of(stem: &str) -> Vec<Word> {
    let letters: Vec<char> = stem.chars().collect();
    let mut words = Vec::new();
    let mut word = String::new();
    for (place, &c) in letters.iter().enumerate() {
        let next_is_digit = letters.get(place + 1).is_some_and(char::is_ascii_digit);
        let belongs = match c {
            '.' | ',' => next_is_digit && is_decimal_point(&letters, place, &word),
            '-' | '+' if word.is_empty() => {
                let before = place.checked_sub(1).map(|before| letters[before]);
                c == '-' && next_is_digit && before != Some(')')
            }
            '-' | '+' => next_is_digit && is_exponent(&word),
            c => !is_separator(c),
        };
        if belongs {
            word.push(c);
        } else {
            flush(&mut word, &mut words);
        }
    }
    flush(&mut word, &mut words);
    words
}

fn is_separator(c: char) -> bool {
    matches!(c, '_' | ' ' | '(' | ')' | '[' | ']' | '=' | '#')
}

fn flush(word: &mut String, words: &mut Vec<Word>) {
    let whole = std::mem::take(word);
    if whole.is_empty() {
        return;
    }
    match phase_in_capitals(&whole) {
        Some(parts) => words.extend(parts.iter().map(|part| parsed(part))),
        None => words.push(parsed(&whole)),
    }
}

/// Whether the point between two digits is a decimal point, not one of a date or a version.
fn is_decimal_point(letters: &[char], place: usize, word: &str) -> bool {
    let digits = word
        .trim_start_matches('-')
        .trim_end_matches(|c: char| c.is_ascii_digit());
    let has_digits = word.ends_with(|c: char| c.is_ascii_digit());
    let start = place - (word.len() - digits.len()).min(place);
    let dotted = |place: usize| matches!(letters.get(place), Some('.' | ','));
    let after_number = start >= 2 && dotted(start - 1) && letters[start - 2].is_ascii_digit();
    let decimals = letters[place + 1..]
        .iter()
        .take_while(|c| c.is_ascii_digit())
        .count();
    let end = place + 1 + decimals;
    let before_number = dotted(end) && letters.get(end + 1).is_some_and(char::is_ascii_digit);
    has_digits && names_a_frame(digits) && !after_number && !before_number
}

/// Whether the word so far is a number with the `e` of an exponent.
fn is_exponent(word: &str) -> bool {
    let Some(mantissa) = word.strip_suffix(['e', 'E']) else {
        return false;
    };
    let letters = mantissa.trim_end_matches(|c: char| c.is_ascii_digit() || matches!(c, '.' | ','));
    letters.len() < mantissa.len() && names_a_frame(letters.trim_start_matches('-'))
}

/// Whether a number behind these letters can be a frame's, with decimals and unit.
fn names_a_frame(letters: &str) -> bool {
    letters.is_empty() || is_frame_word(letters) || is_surface(letters)
}

/// Whether the letters are the word for a surface, of whichever ventricle.
pub(super) fn is_surface(letters: &str) -> bool {
    meanings(letters)
        .iter()
        .any(|meaning| matches!(meaning, super::words::Meaning::Surface(_)))
}

/// `endoED`, `ESepi`: a phase in capitals written as one with a surface or the ventricle.
fn phase_in_capitals(word: &str) -> Option<[&str; 2]> {
    let at_end = word
        .len()
        .checked_sub(2)
        .and_then(|at| word.split_at_checked(at));
    let at_start = word.split_at_checked(2);
    let is_phase = |part: &str| part == "ED" || part == "ES";
    match (at_end, at_start) {
        (Some((rest, phase)), _) if is_phase(phase) && rest.ends_with(char::is_lowercase) => {
            (!meanings(rest).is_empty()).then_some([rest, phase])
        }
        (_, Some((phase, rest))) if is_phase(phase) && !meanings(rest).is_empty() => rest
            .starts_with(char::is_lowercase)
            .then_some([phase, rest]),
        _ => None,
    }
}

fn parsed(text: &str) -> Word {
    let plain = Word {
        text: text.to_owned(),
        letters: text.to_owned(),
        number: None,
        of_total: false,
    };
    if phase_of_word(text).is_some() {
        return plain;
    }
    let numbered = |letters: &str, number: FrameNumber, of_total: bool| Word {
        letters: letters.to_owned(),
        number: Some(number),
        of_total,
        ..plain.clone()
    };
    if let Some(start) = text.find(|c: char| c.is_ascii_digit()) {
        let (letters, rest) = text.split_at(start);
        let (letters, sign) = match letters.strip_suffix('-') {
            Some(letters) => (letters, "-"),
            None => (letters, ""),
        };
        if names_a_frame(letters)
            && let Some((number, of_total)) = number_with_unit(sign, rest)
        {
            return numbered(letters, number, of_total);
        }
    }
    let letters = text.trim_end_matches(|c: char| c.is_ascii_digit());
    match FrameNumber::parse(&text[letters.len()..]) {
        Some(number) => numbered(letters, number, false),
        None => plain,
    }
}

/// `0.05s`, `25%`, `5e-02`, `0p05`, `2of4`.
fn number_with_unit(sign: &str, text: &str) -> Option<(FrameNumber, bool)> {
    let digits = |from: usize| {
        let rest = text.get(from..).unwrap_or_default();
        from + rest.bytes().take_while(u8::is_ascii_digit).count()
    };
    let mut end = digits(0);
    if text[end..].starts_with(['.', ',', 'p']) && digits(end + 1) > end + 1 {
        end = digits(end + 1);
    }
    let exponent = text[end..].strip_prefix(['e', 'E']);
    if exponent.is_some_and(|rest| rest.starts_with(['-', '+'])) && digits(end + 2) > end + 2 {
        end = digits(end + 2);
    }
    let number = FrameNumber::parse(&format!("{sign}{}", text[..end].replace('+', "")))?;
    let rest = &text[end..];
    if let Some(total) = rest.to_lowercase().strip_prefix("of")
        && !total.is_empty()
        && total.bytes().all(|b| b.is_ascii_digit())
    {
        return Some((number, true));
    }
    number.with_unit(rest).map(|number| (number, false))
}

impl Word {
    /// The unit that this word is for the number before it: `25 %`, `50 ms`.
    pub(super) fn as_unit_of(&self, number: FrameNumber) -> Option<FrameNumber> {
        let stands_alone = self.number.is_none() && self.text.to_lowercase() != "s";
        let with_unit = number.with_unit(&self.text)?;
        let new = number.unit() == NumberUnit::None && with_unit.unit() != NumberUnit::None;
        (stands_alone && new).then_some(with_unit)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn texts(stem: &str) -> Vec<String> {
        words_of(stem).into_iter().map(|word| word.text).collect()
    }

    fn number(stem: &str) -> String {
        let words = words_of(stem);
        let number = words.iter().rev().find_map(|word| word.number);
        number.map_or_else(String::new, |number| number.to_string())
    }

    #[test]
    fn decimals_stay_whole_and_dates_fall_apart() {
        for (stem, words) in [
            ("endo_0.05", vec!["endo", "0.05"]),
            ("endo.0.05", vec!["endo", "0.05"]),
            ("endo.0001", vec!["endo", "0001"]),
            ("2024.01.02_endo_3", vec!["2024", "01", "02", "endo", "3"]),
            ("heart1.0001", vec!["heart1", "0001"]),
            ("endo_t=0.05s", vec!["endo", "t", "0.05s"]),
            ("frame-04", vec!["frame", "04"]),
            ("2024-01-02", vec!["2024", "01", "02"]),
            ("endoED", vec!["endo", "ED"]),
            ("EDWARD_endo", vec!["EDWARD", "endo"]),
            ("a (2)", vec!["a", "2"]),
        ] {
            assert_eq!(texts(stem), words, "{stem}");
        }
    }

    #[test]
    fn numbers_have_signs_exponents_and_units() {
        for (stem, value) in [
            ("endo_0.05s", "0.05 s"),
            ("endo_50ms", "0.05 s"),
            ("endo_t=-0.1", "-0.1"),
            ("endo_-2", "-2"),
            ("endo-2", "2"),
            ("endo - 2", "2"),
            ("endo_5e-02", "0.05"),
            ("endo_1.5e+01", "15"),
            ("endo_0p25", "0.25"),
            ("endo_0,25", "0.25"),
            ("endo_25%", "25 %"),
            ("endo_25pct", "25 %"),
            ("endo_2of4", "2"),
            ("endo_007", "7"),
            ("endo_99999999999999999999999", ""),
            ("é", ""),
        ] {
            assert_eq!(number(stem), value, "{stem}");
        }
    }
}
