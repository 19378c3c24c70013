//! Lines and numbers of text files, each error with its line.

use super::ReadMeshError;
use super::mesh_draft::Place;

/// The lines of a text, numbered from 1; ends of lines as Unix, Windows and old Macs write them.
#[derive(Clone, Debug)]
pub(super) struct TextLines<'a> {
    rest: &'a [u8],
    line: usize,
}

impl<'a> TextLines<'a> {
    /// From the first line on; a byte order mark is skipped.
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Self {
            rest: bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes),
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

/// The words of a line.
pub(super) fn words(text: &[u8]) -> impl Iterator<Item = &[u8]> {
    text.split(u8::is_ascii_whitespace)
        .filter(|word| !word.is_empty())
}

/// A word as a number, finite or not.
pub(super) fn number(word: &[u8], place: Place) -> Result<f64, ReadMeshError> {
    std::str::from_utf8(word)
        .ok()
        .and_then(|text| text.parse().ok())
        .ok_or_else(|| place.error(format!("{} is not a number", shown(word))))
}

/// A word as a whole number.
pub(super) fn whole_number(word: &[u8], place: Place) -> Result<i64, ReadMeshError> {
    std::str::from_utf8(word)
        .ok()
        .and_then(|text| text.parse().ok())
        .ok_or_else(|| place.error(format!("{} is not a whole number", shown(word))))
}

/// A word as a count or an index from 0.
pub(super) fn count(word: &[u8], place: Place) -> Result<u64, ReadMeshError> {
    std::str::from_utf8(word)
        .ok()
        .and_then(|text| text.parse().ok())
        .ok_or_else(|| place.error(format!("{} is not a count", shown(word))))
}

/// The next three words as coordinates.
pub(super) fn three_numbers<'a>(
    words: &mut impl Iterator<Item = &'a [u8]>,
    place: Place,
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
        let lines: Vec<_> = TextLines::new(b"\xef\xbb\xbfa\nb\r\nc\rd").collect();
        let expected: [(usize, &[u8]); 4] = [(1, b"a"), (2, b"b"), (3, b"c"), (4, b"d")];
        assert_eq!(lines, expected);
    }

    #[test]
    fn a_long_or_binary_word_is_shown_short_and_harmless() {
        assert_eq!(shown(b"a\x07b"), "\"a\u{fffd}b\"");
        assert!(shown(&[b'x'; 5000]).len() < 40);
    }
}
