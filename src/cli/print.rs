//! The one way onto standard output and standard error.

use std::borrow::Cow;
use std::io::{ErrorKind, Write};

use crate::cli::outcome::CliError;

/// Writes lines to standard output.
///
/// # Errors
/// If the reader went away, which ends the command without complaint, or the system refuses.
pub(super) fn print(text: &str) -> Result<(), CliError> {
    let mut out = std::io::stdout().lock();
    let written = out
        .write_all(harmless(text).as_bytes())
        .and_then(|()| out.write_all(b"\n"))
        .and_then(|()| out.flush());
    written.map_err(|error| match error.kind() {
        ErrorKind::BrokenPipe => CliError::OutputClosed,
        _ => CliError::Unusable(format!("standard output: {error}")),
    })
}

/// Prints one JSON object on one line of its own.
///
/// # Errors
/// As [`print()`].
pub(super) fn print_json(value: &serde_json::Value) -> Result<(), CliError> {
    print(&json_line(value))
}

/// JSON without characters that a terminal obeys: what JSON itself leaves as it is stands as an escape of JSON.
fn json_line(value: &serde_json::Value) -> String {
    let text = value.to_string();
    if !text.contains(is_harmful) {
        return text;
    }
    let mut line = String::with_capacity(text.len() + 16);
    for letter in text.chars() {
        if is_harmful(letter) {
            // All of them lie below U+FFFF.
            line.push_str(&format!("\\u{:04x}", u32::from(letter)));
        } else {
            line.push(letter);
        }
    }
    line
}

/// Says something beside the result. A closed standard error is nobody's concern.
pub(super) fn say(text: &str) {
    writeln!(std::io::stderr().lock(), "{}", harmless(text)).ok();
}

/// An id, a label or another text of the input as part of a line: on one line whatever it holds.
pub(super) fn on_one_line(text: &str) -> Cow<'_, str> {
    if text.contains('\n') {
        Cow::Owned(text.replace('\n', "\\n"))
    } else {
        Cow::Borrowed(text)
    }
}

/// Text with codes such as `\u{1b}` in place of what a terminal obeys: ids, labels and names of files may hold anything.
fn harmless(text: &str) -> Cow<'_, str> {
    if !text.contains(is_harmful) {
        return Cow::Borrowed(text);
    }
    let mut plain = String::with_capacity(text.len() + 16);
    for letter in text.chars() {
        if is_harmful(letter) {
            plain.extend(letter.escape_unicode());
        } else {
            plain.push(letter);
        }
    }
    Cow::Owned(plain)
}

/// Control characters but line ends, and characters that turn the direction of writing.
fn is_harmful(letter: char) -> bool {
    let turns = matches!(letter, '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    (letter.is_control() && letter != '\n') || turns
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_terminal_obeys_nothing_that_an_id_holds() {
        assert_eq!(
            harmless("P\u{1b}[2J\r\u{9b}1m\u{202e}\nN01"),
            "P\\u{1b}[2J\\u{d}\\u{9b}1m\\u{202e}\nN01"
        );
        assert_eq!(harmless("Jürgen 心脏"), "Jürgen 心脏");
        assert_eq!(on_one_line("a\nerror: b"), "a\\nerror: b");
    }

    #[test]
    fn json_stays_json_and_harmless() {
        let value = serde_json::json!({ "id": "a\u{9b}\u{7f}\u{202e}\u{1b}b" });
        let line = json_line(&value);
        assert!(!line.contains(is_harmful), "{line}");
        let back: serde_json::Value = serde_json::from_str(&line).unwrap();
        assert_eq!(back, value);
    }
}
