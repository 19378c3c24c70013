//! Lines and numbers of text files, each error with its line.

use super::ReadMeshError;
use super::mesh_draft::FilePosition;

/// The lines of a text, numbered from 1; ends of lines as Unix, Windows and old Macs write them.
#[derive(Clone, Debug)]
pub(super) struct TextLines<'a> {
    rest: &'a [u8],
    line: usize,
}

impl<'a> TextLines<'a> {
    /// From the first line on.
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Self {
            rest: bytes,
            line: 0,
        }
    }

    /// Number of the line that came last.
    pub(super) fn line(&self) -> usize {
        self.line
    }

    /// What follows the line that came last.
    pub(super) fn rest(&self) -> &'a [u8] {
        self.rest
    }
}

impl<'a> Iterator for TextLines<'a> {
    type Item = (usize, &'a [u8]);

    fn next(&mut self) -> Option<Self::Item> {
        if self.rest.is_empty() {
            return None;
        }
        self.line += 1;
        let end = self.rest.iter().position(|&b| b == b'\n' || b == b'\r');
        let (text, rest) = match end {
            None => (self.rest, &self.rest[self.rest.len()..]),
            Some(end) => {
                let ending = if self.rest[end..].starts_with(b"\r\n") {
                    2
                } else {
                    1
                };
                (&self.rest[..end], &self.rest[end + ending..])
            }
        };
        self.rest = rest;
        Some((self.line, text))
    }
}

/// The words of a text one after the other, on whichever lines they stand.
#[derive(Clone, Debug)]
pub(super) struct TextWords<'a> {
    lines: TextLines<'a>,
    rest_of_line: &'a [u8],
}

impl<'a> TextWords<'a> {
    /// From the line on that comes next.
    pub(super) fn new(lines: TextLines<'a>) -> Self {
        Self {
            lines,
            rest_of_line: &[],
        }
    }

    /// Number of the line that the last word stands on.
    pub(super) fn line(&self) -> usize {
        self.lines.line().max(1)
    }

    /// The line that the last word stands on.
    pub(super) fn place(&self) -> FilePosition {
        FilePosition::Line(self.line())
    }

    /// Whether another word stands on the line of the last one.
    pub(super) fn more_on_line(&self) -> bool {
        !self.rest_of_line.trim_ascii_start().is_empty()
    }

    /// The next word of the line of the last one.
    pub(super) fn next_on_line(&mut self) -> Option<&'a [u8]> {
        let rest = self.rest_of_line.trim_ascii_start();
        let end = rest.iter().position(u8::is_ascii_whitespace);
        let (word, rest) = rest.split_at(end.unwrap_or(rest.len()));
        self.rest_of_line = rest;
        (!word.is_empty()).then_some(word)
    }

    /// Goes past all words on the line of the last one.
    pub(super) fn skip_line(&mut self) {
        self.rest_of_line = &[];
    }

    /// Goes to the line of the next word; false if there is none.
    pub(super) fn go_to_next(&mut self) -> bool {
        while !self.more_on_line() {
            match self.lines.next() {
                Some((_, text)) => self.rest_of_line = text,
                None => return false,
            }
        }
        true
    }

    /// Bytes from the next word on.
    pub(super) fn bytes_left(&self) -> usize {
        let rest = self.rest_of_line.trim_ascii();
        rest.len() + self.lines.rest().trim_ascii().len()
    }
}

impl<'a> Iterator for TextWords<'a> {
    type Item = &'a [u8];

    fn next(&mut self) -> Option<Self::Item> {
        if self.go_to_next() {
            self.next_on_line()
        } else {
            None
        }
    }
}

/// The words of a line.
pub(super) fn words(text: &[u8]) -> impl Iterator<Item = &[u8]> {
    text.split(u8::is_ascii_whitespace)
        .filter(|word| !word.is_empty())
}

/// A word as a number, finite or not: decimal digits with a point, an exponent of `e`, `nan`, `inf` and `infinity` in
/// any case, with a sign. What C libraries print beside these (`-1.#IND`, `nan(ind)`, `1.#QNAN`), exponents of Fortran
/// (`1.0D+00`), stars of a field too narrow, decimal commas and units are errors, never the number that they begin with.
pub(super) fn number(word: &[u8], place: FilePosition) -> Result<f64, ReadMeshError> {
    std::str::from_utf8(word)
        .ok()
        .and_then(|text| text.parse().ok())
        .ok_or_else(|| place.error(format!("{} is not a number", shown(word))))
}

/// A word as a whole number, also as programs write it that know numbers of one type alone: `1.0`, `1.000e+00`.
pub(super) fn whole_number(word: &[u8], place: FilePosition) -> Result<i64, ReadMeshError> {
    // Nearly all words: a few digits, which no sum of them overflows.
    if matches!(word.len(), 1..=9) && word.iter().all(u8::is_ascii_digit) {
        return Ok((word.iter()).fold(0, |number, digit| 10 * number + i64::from(digit - b'0')));
    }
    std::str::from_utf8(word)
        .ok()
        .and_then(|text| text.parse().ok().or_else(|| whole(text)))
        .ok_or_else(|| place.error(format!("{} is not a whole number", shown(word))))
}

/// A word as a count or an index from 0.
pub(super) fn count(word: &[u8], place: FilePosition) -> Result<u64, ReadMeshError> {
    std::str::from_utf8(word)
        .ok()
        .and_then(|text| text.parse().ok().or_else(|| whole(text)?.try_into().ok()))
        .ok_or_else(|| place.error(format!("{} is not a count", shown(word))))
}

/// A number with a point or an exponent, if it is whole and exact.
fn whole(text: &str) -> Option<i64> {
    const EXACT: f64 = 9_007_199_254_740_992.0; // 2⁵³
    let number: f64 = text.parse().ok()?;
    (number.fract() == 0.0 && number.abs() < EXACT).then_some(number as i64)
}

/// A text without the mark of its end that DOS put behind it (Ctrl+Z).
pub(super) fn without_end_mark(bytes: &[u8]) -> &[u8] {
    bytes
        .trim_ascii_end()
        .strip_suffix(b"\x1a")
        .unwrap_or(bytes)
}

/// The next three words as coordinates.
pub(super) fn three_numbers<'a>(
    words: &mut impl Iterator<Item = &'a [u8]>,
    place: FilePosition,
) -> Result<[f64; 3], ReadMeshError> {
    let mut xyz = [0.0; 3];
    for (found, x) in xyz.iter_mut().enumerate() {
        let word = words
            .next()
            .ok_or_else(|| place.error(format!("{found} coordinates, but 3 are needed")))?;
        *x = number(word, place)?;
    }
    Ok(xyz)
}

/// A word of a file in quotes, shortened and without what a screen cannot show.
pub(super) fn shown(word: &[u8]) -> String {
    const MAX_CHARS: usize = 24;
    let text = String::from_utf8_lossy(&word[..word.len().min(4 * MAX_CHARS)]);
    let mut quoted: String = text
        .chars()
        .take(MAX_CHARS)
        .map(|c| if c.is_control() { '\u{fffd}' } else { c })
        .collect();
    if word.len() > quoted.len() {
        quoted.push('…');
    }
    format!("\"{quoted}\"")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_three_ends_of_lines_count_as_one_line_each() {
        let lines: Vec<_> = TextLines::new(b"a\nb\r\nc\rd").collect();
        let expected: [(usize, &[u8]); 4] = [(1, b"a"), (2, b"b"), (3, b"c"), (4, b"d")];
        assert_eq!(lines, expected);
    }

    #[test]
    fn words_come_from_all_lines_and_know_theirs() {
        let mut words = TextWords::new(TextLines::new(b" a b\r\n\n\tc\rd"));
        assert_eq!(words.next(), Some(&b"a"[..]));
        assert!(words.more_on_line());
        assert_eq!(words.bytes_left(), 4);
        words.skip_line();
        assert_eq!(words.next_on_line(), None);
        assert_eq!((words.next(), words.line()), (Some(&b"c"[..]), 3));
        assert_eq!((words.next(), words.line()), (Some(&b"d"[..]), 4));
        assert_eq!((words.next(), words.bytes_left()), (None, 0));
    }

    #[test]
    fn a_number_is_never_the_start_of_a_longer_word() {
        let place = FilePosition::Line(1);
        for word in [
            "1.#INF",
            "-1.#IND",
            "-1.#IND00",
            "1.#QNAN",
            "1.#SNAN",
            "nan(ind)",
            "-nan(ind)",
            "nan0x8",
            "1.0D+00",
            "1.0d0",
            "****",
            "1,5",
            "1.234,5",
            "0x1p3",
            "0x10",
            "1_000",
            "1.0f",
            "1.0mm",
            "1e",
            "1e+",
            "+",
            ".",
            "-",
            "",
            "1.2.3",
            "--1",
            "\u{2212}1",
            "1\0",
            "NaNs",
            "none",
            "#DIV/0!",
        ] {
            assert!(number(word.as_bytes(), place).is_err(), "{word}");
        }
        for word in ["nan", "-NaN", "inf", "-Infinity", "+INF", "1e999", "-1e999"] {
            assert!(
                !number(word.as_bytes(), place).unwrap().is_finite(),
                "{word}"
            );
        }
        for (word, expected) in [("-1", -1.0), ("+.5", 0.5), ("2.", 2.0), ("1E-3", 1e-3)] {
            assert_eq!(number(word.as_bytes(), place), Ok(expected));
        }
    }

    #[test]
    fn whole_numbers_may_be_written_as_others_are() {
        let place = FilePosition::Line(1);
        for (word, expected) in [("3", 3), ("-1.0", -1), ("2.000000e+00", 2), ("1e3", 1000)] {
            assert_eq!(whole_number(word.as_bytes(), place), Ok(expected));
        }
        assert_eq!(count(b"7.0", place), Ok(7));
        for word in [
            "1.5",
            "-1",
            "nan",
            "inf",
            "1e300",
            "1.0.0",
            "9007199254740993.0",
        ] {
            assert!(count(word.as_bytes(), place).is_err(), "{word}");
        }
    }

    #[test]
    fn a_long_or_binary_word_is_shown_short_and_harmless() {
        assert_eq!(shown(b"a\x07b"), "\"a\u{fffd}b\"");
        assert!(shown(&[b'x'; 5000]).len() < 40);
    }
}
