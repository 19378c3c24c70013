//! An image file to be read: its bytes, and the files beside it.

use super::{Limits, ReadImageError};

/// The content of a file in the same folder by its relative path, or why it cannot be had.
pub type Sibling<'a> = dyn Fn(&str) -> Result<Vec<u8>, String> + 'a;

/// A file to be read.
pub(super) struct ImageSource<'a> {
    /// Its name, which only serves to find the other file of a pair.
    pub name: &'a str,
    pub bytes: &'a [u8],
    pub limits: &'a Limits,
    pub sibling: &'a Sibling<'a>,
}

/// Most characters of a header's technical word that an error quotes.
const MAX_QUOTED: usize = 24;

/// A technical word of a header as an error quotes it: short, and nothing but letters, digits and `-_.`.
pub(super) fn quoted(word: &str) -> String {
    let technical = |c: char| c.is_ascii_alphanumeric() || "-_.".contains(c);
    if !word.is_empty() && word.len() <= MAX_QUOTED && word.chars().all(technical) {
        format!("`{word}`")
    } else {
        "what stands there".to_owned()
    }
}

/// A number of a header.
///
/// # Errors
/// If the word is none, with the line.
pub(super) fn number<T: std::str::FromStr>(
    word: &str,
    field: &str,
    line: usize,
) -> Result<T, ReadImageError> {
    word.parse().map_err(|_| ReadImageError::AtLine {
        line,
        reason: format!("{field}: {} is no number of its kind", quoted(word)),
    })
}

/// Lines of a header of text that is followed by binary values.
#[derive(Clone, Debug)]
pub(super) struct HeaderLines<'a> {
    bytes: &'a [u8],
    at: usize,
    line: usize,
}

impl<'a> HeaderLines<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Self {
            bytes,
            at: 0,
            line: 0,
        }
    }

    /// What follows the lines that were taken.
    pub(super) fn rest(&self) -> &'a [u8] {
        self.bytes.get(self.at..).unwrap_or_default()
    }
}

impl Iterator for HeaderLines<'_> {
    type Item = (usize, String);

    /// The next line with its number, counted from 1, without white space at its end. Bytes that are no UTF-8 are replaced.
    fn next(&mut self) -> Option<(usize, String)> {
        let rest = self.rest();
        if rest.is_empty() {
            return None;
        }
        let end = rest
            .iter()
            .position(|byte| *byte == b'\n')
            .unwrap_or(rest.len());
        self.at += (end + 1).min(rest.len());
        self.line += 1;
        let text = String::from_utf8_lossy(rest.get(..end).unwrap_or_default());
        Some((self.line, text.trim_end().to_owned()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_end_with_or_without_a_carriage_return_and_what_follows_is_kept() {
        let mut lines = HeaderLines::new(b"NRRD0004\r\ntype: short \n\n\x01\x02");
        let texts: Vec<_> = lines.by_ref().take(3).map(|(_, text)| text).collect();
        assert_eq!(texts, ["NRRD0004", "type: short", ""]);
        assert_eq!(lines.rest(), b"\x01\x02");
        assert_eq!(HeaderLines::new(b"").next(), None);
    }

    #[test]
    fn only_technical_words_are_quoted() {
        assert_eq!(quoted("MET_FOO"), "`MET_FOO`");
        assert_eq!(quoted("SEEDED^NAME 1931"), "what stands there");
        let error = number::<usize>("x y", "sizes", 3).unwrap_err();
        assert_eq!(
            error.to_string(),
            "line 3: sizes: what stands there is no number of its kind"
        );
    }
}
