//! The text that a PDF shows: numbers of glyphs, by the tables that say which letters they are.

use std::collections::BTreeMap;

/// Which letters a glyph of a font stands for.
type Letters = BTreeMap<u16, String>;

/// The text of all streams of a file, unpacked, read once by the table of every font: by its own it is what is shown.
pub fn shown_texts(streams: &[Vec<u8>]) -> Vec<String> {
    let tables: Vec<Letters> = (streams.iter())
        .filter(|stream| has(stream, b"beginbfchar"))
        .map(|stream| table(&String::from_utf8_lossy(stream)))
        .collect();
    let drawn = streams.iter().filter(|stream| has(stream, b"BT"));
    let codes: Vec<Vec<u16>> = drawn.map(|stream| glyphs(stream)).collect();
    let mut texts = Vec::new();
    for letters in &tables {
        for codes in &codes {
            let letter = |code: &u16| letters.get(code).map_or("?", String::as_str);
            texts.push(codes.iter().map(letter).collect());
        }
    }
    texts
}

fn has(bytes: &[u8], word: &[u8]) -> bool {
    bytes.windows(word.len()).any(|part| part == word)
}

/// `<0001> <0074>`, line by line.
fn table(text: &str) -> Letters {
    let mut letters = Letters::new();
    for line in text.lines() {
        let fields: Vec<&str> = line
            .split(['<', '>', ' '])
            .filter(|f| !f.is_empty())
            .collect();
        let [code, rest @ ..] = &fields[..] else {
            continue;
        };
        let units: Vec<u16> = (rest.concat().as_bytes().chunks(4))
            .filter_map(|four| u16::from_str_radix(std::str::from_utf8(four).ok()?, 16).ok())
            .collect();
        if let (4, Ok(code), false) = (code.len(), u16::from_str_radix(code, 16), units.is_empty())
        {
            letters.insert(code, String::from_utf16_lossy(&units));
        }
    }
    letters
}

/// Codes of two bytes of all strings of a stream, in their order; those in hexadecimal, too.
fn glyphs(stream: &[u8]) -> Vec<u16> {
    let mut codes = Vec::new();
    let mut at = 0;
    while at < stream.len() {
        let string = match stream[at] {
            b'(' => literal(stream, &mut at),
            b'<' => hexadecimal(stream, &mut at),
            _ => {
                at += 1;
                continue;
            }
        };
        let (pairs, _) = string.as_chunks::<2>();
        codes.extend(pairs.iter().map(|pair| u16::from_be_bytes(*pair)));
    }
    codes
}

fn hexadecimal(stream: &[u8], at: &mut usize) -> Vec<u8> {
    let rest = &stream[*at + 1..];
    let length = rest
        .iter()
        .take_while(|byte| byte.is_ascii_hexdigit())
        .count();
    *at += 1 + length;
    let digit = |byte: u8| char::from(byte).to_digit(16).unwrap() as u8;
    let (pairs, _) = rest[..length].as_chunks::<2>();
    pairs
        .iter()
        .map(|&[a, b]| 16 * digit(a) + digit(b))
        .collect()
}

/// A string in brackets with its escapes (PDF 32000-1, 7.3.4.2).
fn literal(stream: &[u8], at: &mut usize) -> Vec<u8> {
    let (mut string, mut depth) = (Vec::new(), 1);
    *at += 1;
    while let Some(&byte) = stream.get(*at) {
        *at += 1;
        match byte {
            b'\\' => {
                let Some(&escaped) = stream.get(*at) else {
                    break;
                };
                *at += 1;
                match escaped {
                    b'n' => string.push(b'\n'),
                    b'r' => string.push(b'\r'),
                    b't' => string.push(b'\t'),
                    b'b' => string.push(8),
                    b'f' => string.push(12),
                    b'0'..=b'7' => {
                        let mut value = u32::from(escaped - b'0');
                        for _ in 0..2 {
                            let Some(&next @ b'0'..=b'7') = stream.get(*at) else {
                                break;
                            };
                            value = 8 * value + u32::from(next - b'0');
                            *at += 1;
                        }
                        string.push(value as u8);
                    }
                    other => string.push(other),
                }
                continue;
            }
            b'(' => depth += 1,
            b')' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            break;
        }
        string.push(byte);
    }
    string
}

#[test]
fn glyphs_are_read_back_as_letters() {
    let table =
        b"1 beginbfchar\n<0001> <0053>\n<0008> <00650065>\n<0028> <0064>\nendbfchar".to_vec();
    let drawn = b"BT /f0 9 Tf [(\\000\\001\\000\\b)-3.2(\\000\\()]TJ <0001> Tj ET".to_vec();
    assert_eq!(shown_texts(&[table, drawn]), ["SeedS"]);
}
