//! Looks for words in all the ways in which a file may hold them: plain, as wide letters, in hexadecimal, in base 64, and
//! within what is packed.

use std::fs;
use std::io::Read;
use std::path::Path;

use base64::Engine;
use base64::engine::general_purpose::{STANDARD_NO_PAD, URL_SAFE_NO_PAD};
use flate2::read::{DeflateDecoder, MultiGzDecoder, ZlibDecoder};

use super::pdf_text::shown_texts;

/// What must not be found: words of letters, which may be parted in any way, and words of digits, which stand alone.
#[derive(Clone, Debug)]
pub struct Words(Vec<String>);

/// Packed parts are unpacked so far.
const MOST_UNPACKED: u64 = 64 << 20;
/// Packed parts within packed parts.
const DEEPEST: usize = 3;

impl Words {
    /// Words in any case, with anything but letters and digits between their parts.
    pub fn new<'a>(words: impl IntoIterator<Item = &'a str>) -> Self {
        let parts = |word: &str| letters_of(word.as_bytes());
        Self(words.into_iter().map(parts).collect())
    }

    /// Where words are found in bytes, each with how it is written there.
    pub fn within(&self, bytes: &[u8]) -> Vec<String> {
        self.below(bytes, 0)
    }

    fn below(&self, bytes: &[u8], depth: usize) -> Vec<String> {
        let mut found = self.plain(bytes);
        for order in [0, 1] {
            // Wide letters: those of Latin words have a zero beside them.
            let narrow: Vec<u8> = bytes.iter().copied().skip(order).step_by(2).collect();
            found.extend(
                self.plain(&narrow)
                    .into_iter()
                    .map(|w| format!("{w} as wide letters")),
            );
        }
        found.extend(
            self.in_runs(bytes, |byte| byte.is_ascii_hexdigit(), from_hex)
                .map(|w| format!("{w} in hexadecimal")),
        );
        let of_base64 = |byte: u8| byte.is_ascii_alphanumeric() || b"+/-_".contains(&byte);
        found.extend(
            self.in_runs(bytes, of_base64, from_base64)
                .map(|w| format!("{w} in base 64")),
        );
        if depth < DEEPEST {
            let parts = unpacked_parts(bytes);
            if bytes.starts_with(b"%PDF") {
                for text in shown_texts(&parts) {
                    let shown = self.plain(text.as_bytes()).into_iter();
                    found.extend(shown.map(|word| format!("{word} as glyphs")));
                }
            }
            for part in parts {
                let inside = self.below(&part, depth + 1).into_iter();
                found.extend(inside.map(|word| format!("{word}, packed")));
            }
        }
        found
    }

    /// Words as they are, in any case.
    fn plain(&self, bytes: &[u8]) -> Vec<String> {
        let (letters, gaps) = squeezed(bytes);
        let mut found = Vec::new();
        for word in &self.0 {
            let wanted = word.as_bytes();
            let places = positions(&letters, wanted);
            let numeric = wanted.iter().all(u8::is_ascii_digit);
            let here = places.into_iter().any(|at| {
                let end = at + wanted.len();
                // Between the parts of a word stands little; digits of a longer number, or beyond a point, are no date.
                let spread = gaps[end - 1] - gaps[at];
                let (before, after) = bytes.split_at(gaps[at]);
                let after = &after[spread + 1..];
                let digit = u8::is_ascii_digit;
                let alone = match (before.last(), after) {
                    (Some(b'.' | b'0'..=b'9'), _) => false,
                    (_, [b'.', next, ..] | [next, ..]) => !digit(next),
                    _ => true,
                };
                // The fewer letters, the sooner packed bytes happen to hold them.
                let gaps = if numeric {
                    2
                } else {
                    wanted.len().saturating_sub(4).min(8)
                };
                let in_word = |byte: Option<&u8>| {
                    byte.is_some_and(|byte| byte.is_ascii_alphanumeric() || b"+/".contains(byte))
                };
                // A picture in base 64 holds every word of four letters sooner or later.
                let parted =
                    wanted.len() > 4 || !(in_word(before.last()) || in_word(after.first()));
                spread < wanted.len() + gaps && (!numeric || alone) && parted
            });
            if here {
                found.push(word.clone());
            }
        }
        found
    }

    fn in_runs<'a>(
        &'a self,
        bytes: &'a [u8],
        belongs: impl Fn(u8) -> bool + Copy + 'a,
        decoded: fn(&[u8]) -> Vec<Vec<u8>>,
    ) -> impl Iterator<Item = String> + 'a {
        let shortest = 10;
        // Lines of one text are one text.
        let joined: Vec<u8> = (bytes.iter().copied())
            .filter(|byte| !matches!(byte, b'\n' | b'\r'))
            .collect();
        let mut runs = Vec::new();
        for run in joined.split(|byte| !belongs(*byte)) {
            if run.len() >= shortest {
                runs.extend(decoded(run));
            }
        }
        runs.into_iter().flat_map(|run| {
            let narrow: Vec<u8> = run.iter().copied().filter(|byte| *byte != 0).collect();
            [self.plain(&run), self.plain(&narrow)].concat()
        })
    }
}

/// Letters and digits, lower case.
fn letters_of(bytes: &[u8]) -> String {
    let (letters, _) = squeezed(bytes);
    String::from_utf8(letters).unwrap()
}

/// Letters and digits alone, lower case, each with its place.
fn squeezed(bytes: &[u8]) -> (Vec<u8>, Vec<usize>) {
    (bytes.iter().enumerate())
        .filter(|(_, byte)| byte.is_ascii_alphanumeric())
        .map(|(place, byte)| (byte.to_ascii_lowercase(), place))
        .unzip()
}

fn positions(bytes: &[u8], wanted: &[u8]) -> Vec<usize> {
    let first = wanted[0];
    (0..(bytes.len() + 1).saturating_sub(wanted.len()))
        .filter(|&at| bytes[at] == first && bytes[at..].starts_with(wanted))
        .collect()
}

fn from_hex(run: &[u8]) -> Vec<Vec<u8>> {
    let digit = |byte: u8| char::from(byte).to_digit(16).unwrap() as u8;
    let read = |from: usize| {
        let (pairs, _) = run[from..].as_chunks::<2>();
        pairs
            .iter()
            .map(|&[a, b]| 16 * digit(a) + digit(b))
            .collect()
    };
    vec![read(0), read(1)]
}

fn from_base64(run: &[u8]) -> Vec<Vec<u8>> {
    let mut all = Vec::new();
    for from in 0..4.min(run.len()) {
        let whole = &run[from..][..(run.len() - from) / 4 * 4];
        all.extend(STANDARD_NO_PAD.decode(whole));
        all.extend(URL_SAFE_NO_PAD.decode(whole));
    }
    all
}

/// What is packed by zlib or gzip, or is an entry of a ZIP archive, wherever it begins.
fn unpacked_parts(bytes: &[u8]) -> Vec<Vec<u8>> {
    let mut parts = Vec::new();
    for at in 0..bytes.len().saturating_sub(4) {
        let rest = &bytes[at..];
        let part = match rest {
            [0x1f, 0x8b, 8, ..] => unpacked(MultiGzDecoder::new(rest)),
            [0x78, flags, ..] if (0x7800 + u32::from(*flags)).is_multiple_of(31) => {
                unpacked(ZlibDecoder::new(rest))
            }
            [b'P', b'K', 3, 4, ..] if rest.len() > 30 => {
                let length = |at: usize| usize::from(u16::from_le_bytes([rest[at], rest[at + 1]]));
                let body = rest.get(30 + length(26) + length(28)..).unwrap_or_default();
                unpacked(DeflateDecoder::new(body))
            }
            _ => continue,
        };
        parts.extend((part.len() > 4).then_some(part));
    }
    parts
}

/// As much as can be unpacked; what follows or is damaged is left.
fn unpacked(reader: impl Read) -> Vec<u8> {
    let mut part = Vec::new();
    let mut reader = reader.take(MOST_UNPACKED);
    let mut buffer = [0; 1 << 14];
    while let Ok(count @ 1..) = reader.read(&mut buffer) {
        part.extend_from_slice(&buffer[..count]);
    }
    part
}

/// All files below a folder, and what is found in their names and bytes.
#[derive(Debug, Default)]
pub struct Searched {
    pub files: Vec<String>,
    pub bytes: usize,
    pub found: Vec<String>,
}

impl Searched {
    pub fn folder(words: &Words, folder: &Path) -> Self {
        let mut searched = Self::default();
        searched.look(words, folder, folder);
        searched
    }

    fn look(&mut self, words: &Words, root: &Path, folder: &Path) {
        let mut paths: Vec<_> = (fs::read_dir(folder).unwrap())
            .map(|entry| entry.unwrap().path())
            .collect();
        paths.sort();
        for path in paths {
            let name = path.strip_prefix(root).unwrap().to_str().unwrap();
            self.note(&format!("the name {name}"), &words.within(name.as_bytes()));
            if path.is_dir() {
                self.look(words, root, &path);
            } else {
                let bytes = fs::read(&path).unwrap();
                self.note(name, &words.within(&bytes));
                self.files.push(name.to_owned());
                self.bytes += bytes.len();
            }
        }
    }

    pub fn note(&mut self, place: &str, words: &[String]) {
        (self.found).extend(words.iter().map(|word| format!("{place}: {word}")));
    }
}

#[test]
fn words_are_found_however_they_are_written_and_numbers_that_hold_a_date_are_not() {
    use std::io::Write;
    let words = Words::new(["SEEDED^ALPHA", "19310723", "077Y"]);
    let packed = |bytes: &[u8]| {
        let mut encoder =
            flate2::write::ZlibEncoder::new(Vec::new(), flate2::Compression::default());
        encoder.write_all(bytes).unwrap();
        encoder.finish().unwrap()
    };
    let wide = |text: &str| {
        text.encode_utf16()
            .flat_map(u16::to_be_bytes)
            .collect::<Vec<_>>()
    };
    let hex = |bytes: &[u8]| {
        bytes
            .iter()
            .map(|byte| format!("{byte:02X}"))
            .collect::<String>()
    };
    let name = "SEEDED^ALPHA";
    let mut ways: Vec<Vec<u8>> = vec![
        b"xx seeded alpha yy".to_vec(),
        b"Seeded_Alpha.png".to_vec(),
        b"a=SeededAlpha".to_vec(),
        b"born 1931-07-23.".to_vec(),
        b"aged 077Y.".to_vec(),
        b"DA1931/07/23".to_vec(),
        wide(name),
        [b"o", &wide(name)[..]].concat(),
        hex(name.as_bytes()).into_bytes(),
        format!("<f{}>", hex(&wide(name)).to_lowercase()).into_bytes(),
        packed(b"some text with SEEDED ALPHA in it"),
        [b"stream\n", &packed(&packed(name.as_bytes()))[..]].concat(),
    ];
    for before in ["", "a", "ab"] {
        let text = format!("{before}{name} and more");
        ways.push(STANDARD_NO_PAD.encode(text).into_bytes());
    }
    for way in &ways {
        assert!(
            !words.within(way).is_empty(),
            "{}",
            String::from_utf8_lossy(way)
        );
    }
    for other in [
        "seeded",
        "alpha seeded",
        "0.19310723",
        "119310723",
        "19310723.5e3",
        "193107230",
        "1931 and 0723",
        "iVBORw0KGgo077yAAAA",
        "0\u{1}77\u{2}Y",
    ] {
        assert_eq!(
            words.within(other.as_bytes()),
            Vec::<String>::new(),
            "{other}"
        );
    }
}
