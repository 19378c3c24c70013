//! One DataArray of a VTP file as numbers, each with its place in the file.

use std::borrow::Cow;

use roxmltree::{Document, Node};

use super::appended::Appended;
use super::base64_stream::Base64Stream;
use super::encoded::{Encoding, Stream, decode};
use crate::io::ReadMeshError;
use crate::io::binary_cursor::{BinaryCursor, ByteOrder, Scalar};
use crate::io::mesh_draft::Place;
use crate::io::text_lines::{TextLines, number, shown, words};

/// A parsed file and what its arrays need to be decoded.
pub(super) struct VtpFile<'a> {
    pub(super) document: &'a Document<'a>,
    pub(super) appended: Option<Appended<'a>>,
    pub(super) encoding: Encoding,
}

/// The numbers of an array.
#[derive(Debug)]
pub(super) struct Numbers {
    pub(super) values: Vec<f64>,
    /// Where the array stands.
    pub(super) place: Place,
    /// Line of each number, as (index of the first number on it, line); empty for binary arrays.
    lines: Vec<(usize, usize)>,
}

impl Numbers {
    /// Where a number stands; the start of the array if that is binary.
    pub(super) fn place_of(&self, index: usize) -> Place {
        let after = self.lines.partition_point(|&(first, _)| first <= index);
        match after.checked_sub(1).and_then(|at| self.lines.get(at)) {
            Some(&(_, line)) => Place::Line(line),
            None => self.place,
        }
    }
}

impl VtpFile<'_> {
    /// The line on which an element begins.
    pub(super) fn place(&self, node: Node<'_, '_>) -> Place {
        let position = self.document.text_pos_at(node.range().start);
        Place::Line(position.row as usize)
    }

    /// Reads the array of an element, which has at most `most` numbers.
    pub(super) fn numbers(&self, node: Node<'_, '_>, most: u64) -> Result<Numbers, ReadMeshError> {
        let place = self.place(node);
        let scalar = scalar(node.attribute("type").unwrap_or_default(), place)?;
        let text = || {
            let text = node.children().find(Node::is_text);
            let line = text.map_or(0, |text| {
                self.document.text_pos_at(text.range().start).row as usize
            });
            (text.and_then(|text| text.text()).unwrap_or_default(), line)
        };
        match node.attribute("format").unwrap_or("ascii") {
            "ascii" => {
                let (text, line) = text();
                text_numbers(text, line, most, place)
            }
            "binary" => {
                let text: Vec<u8> = text()
                    .0
                    .bytes()
                    .filter(|byte| !byte.is_ascii_whitespace())
                    .collect();
                let stream = Stream::Base64(Base64Stream::new(&text, place));
                self.binary_numbers(stream, scalar, most, place)
            }
            "appended" => {
                let (stream, place) = self.appended_stream(node, place)?;
                self.binary_numbers(stream, scalar, most, place)
            }
            other => Err(place.error(format!("unknown format {}", shown(other.as_bytes())))),
        }
    }

    fn appended_stream(
        &self,
        node: Node<'_, '_>,
        place: Place,
    ) -> Result<(Stream<'_>, Place), ReadMeshError> {
        let appended = self
            .appended
            .ok_or_else(|| place.error("the array is appended, but there are no appended data"))?;
        let offset = node.attribute("offset").unwrap_or_default();
        let bytes = offset
            .trim()
            .parse()
            .ok()
            .and_then(|offset: usize| appended.bytes.get(offset..).map(|rest| (offset, rest)));
        let Some((offset, rest)) = bytes else {
            return Err(place.error(format!(
                "offset {} is not within the {} bytes of appended data",
                shown(offset.as_bytes()),
                appended.bytes.len()
            )));
        };
        let start = appended.start + offset;
        let place = Place::Byte(start);
        if appended.base64 {
            return Ok((Stream::Base64(Base64Stream::new(rest, place)), place));
        }
        Ok((
            Stream::Raw(BinaryCursor::new(appended.bytes, offset)),
            place,
        ))
    }

    fn binary_numbers(
        &self,
        stream: Stream<'_>,
        scalar: Scalar,
        most: u64,
        place: Place,
    ) -> Result<Numbers, ReadMeshError> {
        let size = scalar.size();
        let bytes = decode(
            stream,
            self.encoding,
            most.saturating_mul(size as u64),
            place,
        )?;
        if bytes.len() % size != 0 {
            let reason = format!("{} bytes are not a whole number of values", bytes.len());
            return Err(place.error(reason));
        }
        Ok(Numbers {
            values: bytes
                .chunks_exact(size)
                .map(|value| scalar.number(value, self.encoding.order))
                .collect(),
            place,
            lines: Vec::new(),
        })
    }
}

fn text_numbers(
    text: &str,
    first_line: usize,
    most: u64,
    place: Place,
) -> Result<Numbers, ReadMeshError> {
    let (mut values, mut lines) = (Vec::new(), Vec::new());
    for (line, text) in TextLines::new(text.as_bytes()) {
        let line = first_line + line - 1;
        lines.push((values.len(), line));
        for word in words(text) {
            if values.len() as u64 >= most {
                let reason = format!("an array of more than {most} numbers");
                return Err(Place::Line(line).error(reason));
            }
            values.push(number(word, Place::Line(line))?);
        }
    }
    Ok(Numbers {
        values,
        place,
        lines,
    })
}

/// A type as the format names it.
pub(super) fn scalar(name: &str, place: Place) -> Result<Scalar, ReadMeshError> {
    Ok(match name {
        "Int8" => Scalar::I8,
        "UInt8" => Scalar::U8,
        "Int16" => Scalar::I16,
        "UInt16" => Scalar::U16,
        "Int32" => Scalar::I32,
        "UInt32" => Scalar::U32,
        "Int64" => Scalar::I64,
        "UInt64" => Scalar::U64,
        "Float32" => Scalar::F32,
        "Float64" => Scalar::F64,
        _ => return Err(place.error(format!("unknown type {}", shown(name.as_bytes())))),
    })
}

/// Byte order as the format names it.
pub(super) fn byte_order(name: &str, place: Place) -> Result<ByteOrder, ReadMeshError> {
    match name {
        "LittleEndian" => Ok(ByteOrder::Little),
        "BigEndian" => Ok(ByteOrder::Big),
        _ => Err(place.error(format!("unknown byte order {}", shown(name.as_bytes())))),
    }
}

/// Text of a file as UTF-8, or the byte where it is not.
pub(super) fn utf8(xml: &[u8]) -> Result<Cow<'_, str>, ReadMeshError> {
    std::str::from_utf8(xml)
        .map(Cow::Borrowed)
        .map_err(|error| Place::Byte(error.valid_up_to()).error("not UTF-8 text"))
}
