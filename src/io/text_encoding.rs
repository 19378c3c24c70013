//! Marks and encodings of text: everything becomes UTF-8, or text whose ASCII characters stand as in UTF-8.

use std::borrow::Cow;

use super::ReadMeshError;
use super::mesh_draft::FilePosition;
use super::text_lines::shown;

const UTF8_MARK: &[u8] = b"\xef\xbb\xbf";

/// A file without its byte order mark, as UTF-8 if it was UTF-16.
#[derive(Debug)]
pub(super) struct Unmarked<'a> {
    pub(super) bytes: Cow<'a, [u8]>,
    /// Bytes of the mark.
    skipped: usize,
    /// Bytes of the file for one ASCII character.
    width: usize,
}

impl Unmarked<'_> {
    /// An error about a byte of these bytes as one about the file's.
    pub(super) fn error_in_file(&self, error: ReadMeshError, file_bytes: usize) -> ReadMeshError {
        match error {
            ReadMeshError::AtByte { byte, reason } => ReadMeshError::AtByte {
                byte: (byte * self.width + self.skipped).min(file_bytes),
                reason,
            },
            other => other,
        }
    }
}

/// Looks for a byte order mark, or for the zeros of UTF-16 without one. Not to be asked about binary files, whose
/// first bytes may be anything.
///
/// # Errors
/// At the first byte that is not UTF-16 although the file begins so, and for UTF-32.
pub(super) fn without_mark(bytes: &[u8]) -> Result<Unmarked<'_>, ReadMeshError> {
    if bytes.starts_with(b"\xff\xfe\0\0") || bytes.starts_with(b"\0\0\xfe\xff") {
        let reason = "the text is encoded as UTF-32, which is not read; save it as UTF-8";
        return Err(FilePosition::Byte(0).error(reason));
    }
    let ascii = |at: usize| bytes.get(at).is_some_and(|b| (b' '..0x7f).contains(b));
    let zero = |at: usize| bytes.get(at) == Some(&0);
    let alternate = |first: usize| {
        (0..4).all(|k| ascii(2 * k + first) && zero(2 * k + 1 - first))
            && bytes.len().is_multiple_of(2)
    };
    let (skipped, word): (usize, fn([u8; 2]) -> u16) = match bytes {
        [0xff, 0xfe, ..] => (2, u16::from_le_bytes),
        [0xfe, 0xff, ..] => (2, u16::from_be_bytes),
        _ if alternate(0) => (0, u16::from_le_bytes),
        _ if alternate(1) => (0, u16::from_be_bytes),
        _ => {
            let mut rest = bytes;
            while let Some(without) = rest.strip_prefix(UTF8_MARK) {
                rest = without;
            }
            return Ok(Unmarked {
                bytes: Cow::Borrowed(rest),
                skipped: bytes.len() - rest.len(),
                width: 1,
            });
        }
    };
    let mut text = String::with_capacity(bytes.len() / 2);
    let words = bytes[skipped..].chunks(2).map(|pair| match *pair {
        [a, b] => word([a, b]),
        _ => 0xd800, // half a character: as wrong as half of a pair
    });
    for character in char::decode_utf16(words) {
        let Ok(character) = character else {
            let byte = (skipped + 2 * text.encode_utf16().count()).min(bytes.len());
            return Err(
                FilePosition::Byte(byte).error("not UTF-16 text, though the file begins as such")
            );
        };
        text.push(character);
    }
    Ok(Unmarked {
        bytes: Cow::Owned(text.trim_start_matches('\u{feff}').as_bytes().to_vec()),
        skipped,
        width: 2,
    })
}

/// XML as UTF-8, by the encoding that its first line declares. Of encodings with one byte a character only the ASCII
/// characters are sure, which are all that numbers and tags consist of; others stand for names, which nobody reads.
///
/// # Errors
/// At the first byte that is not in the encoding, or naming an encoding that is not read.
pub(super) fn xml_text(bytes: &[u8]) -> Result<Cow<'_, str>, ReadMeshError> {
    let declared = declared_encoding(bytes).unwrap_or_default();
    let name = declared.to_ascii_uppercase();
    let begins = |starts: &[&[u8]]| starts.iter().any(|start| name.starts_with(start));
    if begins(&[
        b"ISO-8859-",
        b"ISO8859-",
        b"ISO_8859-",
        b"LATIN",
        b"WINDOWS-125",
        b"CP125",
        b"US-ASCII",
        b"ASCII",
        b"KOI8",
        b"MACINTOSH",
    ]) {
        let text = if bytes.is_ascii() {
            as_utf8(bytes)?
        } else {
            bytes.iter().map(|&b| char::from(b)).collect()
        };
        return Ok(with_declaration_first(text));
    }
    // UTF-16 was made UTF-8 by its mark; without one the declaration is wrong
    let unicode = name.is_empty() || begins(&[b"UTF-8", b"UTF8", b"UTF-16", b"UTF16"]);
    if unicode || bytes.is_ascii() {
        return Ok(with_declaration_first(as_utf8(bytes)?));
    }
    Err(FilePosition::Line(1).error(format!(
        "the encoding {} is not read; save the file as UTF-8",
        shown(declared)
    )))
}

/// White space before the declaration is no XML, and harmless: the declaration becomes white space, too, so that all else
/// keeps its place.
fn with_declaration_first(text: Cow<'_, str>) -> Cow<'_, str> {
    let start = text.len() - text.trim_start().len();
    let end = text[start..].find("?>").map(|end| start + end + 2);
    match end.filter(|_| start > 0 && text[start..].starts_with("<?xml ")) {
        Some(end) => {
            let blank = |c: char| if c.is_ascii_whitespace() { c } else { ' ' };
            let declaration: String = text[start..end].chars().map(blank).collect();
            Cow::Owned([&text[..start], &declaration, &text[end..]].concat())
        }
        None => text,
    }
}

fn as_utf8(bytes: &[u8]) -> Result<Cow<'_, str>, ReadMeshError> {
    std::str::from_utf8(bytes)
        .map(Cow::Borrowed)
        .map_err(|error| FilePosition::Byte(error.valid_up_to()).error("not UTF-8 text"))
}

/// The value of `encoding` in `<?xml … ?>`.
fn declared_encoding(bytes: &[u8]) -> Option<&[u8]> {
    const MAX_DECLARATION: usize = 256;
    let head = &bytes[..bytes.len().min(MAX_DECLARATION)];
    let head = head.trim_ascii_start().strip_prefix(b"<?xml")?;
    let head = &head[..head.iter().position(|&b| b == b'>')?];
    let at = head.windows(8).position(|word| word == b"encoding")?;
    let value = head[at + 8..].trim_ascii_start().strip_prefix(b"=")?;
    let (quote, value) = value.trim_ascii_start().split_first()?;
    let end = value.iter().position(|b| b == quote)?;
    Some(value[..end].trim_ascii())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn utf16(text: &str, word: fn(u16) -> [u8; 2]) -> Vec<u8> {
        text.encode_utf16().flat_map(word).collect()
    }

    #[test]
    fn marks_are_taken_off_and_utf_16_becomes_utf_8() {
        let text = "v 1 2 3\nö 🫀\n";
        let marked = format!("\u{feff}{text}");
        for bytes in [
            text.as_bytes().to_vec(),
            marked.as_bytes().to_vec(),
            format!("\u{feff}{marked}").into_bytes(),
            utf16(&marked, u16::to_le_bytes),
            utf16(&marked, u16::to_be_bytes),
            utf16(text, u16::to_le_bytes),
            utf16(text, u16::to_be_bytes),
        ] {
            let unmarked = without_mark(&bytes).unwrap();
            assert_eq!(&unmarked.bytes[..], text.as_bytes());
        }
    }

    #[test]
    fn bytes_of_errors_count_the_mark() {
        let bytes = utf16("\u{feff}abcdef", u16::to_le_bytes);
        let unmarked = without_mark(&bytes).unwrap();
        let error = unmarked.error_in_file(FilePosition::Byte(3).error("wrong"), bytes.len());
        assert_eq!(error.to_string(), "byte 8: wrong");
        let marked = without_mark(b"\xef\xbb\xbfabc").unwrap();
        let error = marked.error_in_file(FilePosition::Byte(1).error("wrong"), 6);
        assert_eq!(error.to_string(), "byte 4: wrong");
    }

    #[test]
    fn what_only_begins_as_utf_16_is_refused() {
        let cases: [(&[u8], &str); 3] = [
            (b"\xff\xfea\0\0\xd8b\0", "byte 4: not UTF-16"),
            (b"\xff\xfea\0b", "byte 4: not UTF-16"),
            (
                b"\xff\xfe\0\0a\0\0\0",
                "byte 0: the text is encoded as UTF-32",
            ),
        ];
        for (bytes, expected) in cases {
            let error = without_mark(bytes).unwrap_err().to_string();
            assert!(error.starts_with(expected), "{error}");
        }
    }

    #[test]
    fn xml_is_read_in_the_encoding_that_it_declares() {
        let text = |encoding: &str, name: &[u8]| {
            [
                format!("<?xml version='1.0' encoding = {encoding} ?><a b='").as_bytes(),
                name,
                b"'/>",
            ]
            .concat()
        };
        for (encoding, name) in [
            ("\"ISO-8859-1\"", &b"\xfc"[..]),
            ("'windows-1252'", b"\xfc"),
            ("\"latin1\"", b"\xfc"),
            ("'us-ascii'", b"\xfc"),
            ("\"UTF-8\"", b"\xc3\xbc"),
            ("\"utf-16\"", b"\xc3\xbc"),
        ] {
            let bytes = text(encoding, name);
            assert!(xml_text(&bytes).unwrap().contains("b='ü'"), "{encoding}");
        }
        assert!(xml_text(&text("\"GB2312\"", b"abc")).is_ok());
        let late = xml_text(b"\n <?xml version='1.0'?>\n<a/>")
            .unwrap()
            .into_owned();
        assert_eq!(late.trim(), "<a/>");
        assert_eq!(late.find('<'), Some(24));
        let error = |bytes: &[u8]| xml_text(bytes).unwrap_err().to_string();
        assert_eq!(
            error(&text("\"Shift_JIS\"", b"\x83\x6e")),
            "line 1: the encoding \"Shift_JIS\" is not read; save the file as UTF-8"
        );
        assert_eq!(error(b"<a b='\xfc'/>"), "byte 6: not UTF-8 text");
    }
}
