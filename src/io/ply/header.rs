//! The header of a PLY file: which elements follow, how many, and how they are stored.

use crate::io::ReadMeshError;
use crate::io::binary_cursor::{ByteOrder, Scalar};
use crate::io::mesh_draft::FilePosition;
use crate::io::text_lines::{TextLines, count, shown, words};

/// How the body is stored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Encoding {
    /// One line of numbers for each element.
    Text,
    /// Numbers one after the other.
    Binary(ByteOrder),
}

/// One value, or a list of values with its length before it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Storage {
    /// One value.
    One(Scalar),
    /// A length, then as many items.
    List { length: Scalar, item: Scalar },
}

/// One property of an element.
#[derive(Clone, Debug)]
pub(super) struct Property {
    pub(super) name: String,
    pub(super) storage: Storage,
}

/// `count` things of one kind.
#[derive(Clone, Debug)]
pub(super) struct Element {
    pub(super) name: String,
    pub(super) count: u64,
    pub(super) properties: Vec<Property>,
    /// Where the header speaks of it.
    pub(super) place: FilePosition,
}

impl Element {
    /// Index of the first property that has one of these names, in any case.
    pub(super) fn property(&self, names: &[&str]) -> Option<usize> {
        self.properties.iter().position(|property| {
            names
                .iter()
                .any(|name| property.name.eq_ignore_ascii_case(name))
        })
    }

    /// The least bytes that one of these takes in the file.
    pub(super) fn min_bytes(&self, encoding: Encoding) -> usize {
        self.properties
            .iter()
            .map(|property| match (encoding, property.storage) {
                (Encoding::Text, _) => 2, // a digit and what ends it
                (_, Storage::One(scalar) | Storage::List { length: scalar, .. }) => scalar.size(),
            })
            .sum()
    }
}

/// The header and where the body begins.
#[derive(Clone, Debug)]
pub(super) struct Header<'a> {
    pub(super) encoding: Encoding,
    pub(super) elements: Vec<Element>,
    /// What follows the header, with the number of the line before it.
    pub(super) body: TextLines<'a>,
}

/// Reads up to `end_header`.
pub(super) fn read_header(bytes: &[u8]) -> Result<Header<'_>, ReadMeshError> {
    let mut lines = TextLines::new(bytes);
    let mut not_empty = lines.by_ref().map(|(_, text)| text.trim_ascii());
    let first = not_empty.find(|text| !text.is_empty());
    if !first.is_some_and(|text| text.eq_ignore_ascii_case(b"ply")) {
        return Err(FilePosition::Line(1).error("the first line is not \"ply\""));
    }
    let mut encoding = None;
    let mut elements: Vec<Element> = Vec::new();
    while let Some((line, text)) = lines.next() {
        let place = FilePosition::Line(line);
        let mut words = words(text);
        match words.next() {
            None | Some(b"comment" | b"obj_info") => {}
            Some(b"format") => encoding = Some(read_encoding(words.next(), place)?),
            Some(b"element") => {
                let (Some(name), Some(number)) = (words.next(), words.next()) else {
                    return Err(place.error("an element needs a name and a count"));
                };
                elements.push(Element {
                    name: String::from_utf8_lossy(name).into_owned(),
                    count: count(number, place)?,
                    properties: Vec::new(),
                    place,
                });
            }
            Some(b"property") => {
                let property = read_property(&mut words, place)?;
                elements
                    .last_mut()
                    .ok_or_else(|| place.error("a property before the first element"))?
                    .properties
                    .push(property);
            }
            Some(b"end_header") => {
                let encoding = encoding
                    .ok_or_else(|| place.error("the header does not say in which format it is"))?;
                return Ok(Header {
                    encoding,
                    elements,
                    body: lines,
                });
            }
            Some(word) => return Err(place.error(format!("unknown keyword {}", shown(word)))),
        }
    }
    Err(FilePosition::Line(lines.line()).error("the file ends within its header"))
}

fn read_encoding(word: Option<&[u8]>, place: FilePosition) -> Result<Encoding, ReadMeshError> {
    match word {
        Some(b"ascii") => Ok(Encoding::Text),
        Some(b"binary_little_endian") => Ok(Encoding::Binary(ByteOrder::Little)),
        Some(b"binary_big_endian") => Ok(Encoding::Binary(ByteOrder::Big)),
        other => Err(place.error(format!(
            "unknown format {}",
            shown(other.unwrap_or_default())
        ))),
    }
}

fn read_property<'a>(
    words: &mut impl Iterator<Item = &'a [u8]>,
    place: FilePosition,
) -> Result<Property, ReadMeshError> {
    let first = words.next().unwrap_or_default();
    let storage = if first == b"list" {
        Storage::List {
            length: scalar(words.next().unwrap_or_default(), place)?,
            item: scalar(words.next().unwrap_or_default(), place)?,
        }
    } else {
        Storage::One(scalar(first, place)?)
    };
    let name = words
        .next()
        .ok_or_else(|| place.error("a property needs a type and a name"))?;
    Ok(Property {
        name: String::from_utf8_lossy(name).into_owned(),
        storage,
    })
}

fn scalar(word: &[u8], place: FilePosition) -> Result<Scalar, ReadMeshError> {
    Ok(match word {
        b"char" | b"int8" => Scalar::I8,
        b"uchar" | b"uint8" => Scalar::U8,
        b"short" | b"int16" => Scalar::I16,
        b"ushort" | b"uint16" => Scalar::U16,
        b"int" | b"int32" => Scalar::I32,
        b"uint" | b"uint32" => Scalar::U32,
        b"int64" => Scalar::I64,
        b"uint64" => Scalar::U64,
        b"float" | b"float32" => Scalar::F32,
        b"double" | b"float64" => Scalar::F64,
        _ => return Err(place.error(format!("unknown type {}", shown(word)))),
    })
}
