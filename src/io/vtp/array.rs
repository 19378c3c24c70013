//! One DataArray of a VTP file as numbers, each with its place in the file.

use roxmltree::Node;

use super::base64_stream::Base64Stream;
use super::encoded::{Stream, decode};
use super::file::VtpFile;
use crate::io::ReadMeshError;
use crate::io::binary_cursor::{BinaryCursor, ByteOrder, Scalar};
use crate::io::mesh_draft::FilePosition;
use crate::io::text_lines::{number, shown};

/// The numbers of an array.
#[derive(Debug)]
pub(super) struct Numbers {
    pub(super) values: Vec<f64>,
    /// Where the array stands.
    pub(super) place: FilePosition,
    /// Line of each number, as (index of the first number on it, line); empty for binary arrays.
    lines: Vec<(usize, usize)>,
}

impl Numbers {
    /// Where a number stands; the start of the array if that is binary.
    pub(super) fn place_of(&self, index: usize) -> FilePosition {
        let after = self.lines.partition_point(|&(first, _)| first <= index);
        match after.checked_sub(1).and_then(|at| self.lines.get(at)) {
            Some(&(_, line)) => FilePosition::Line(line),
            None => self.place,
        }
    }
}

impl VtpFile<'_> {
    /// Reads the array of an element, which has at most `most` numbers.
    pub(super) fn numbers(&self, node: Node<'_, '_>, most: u64) -> Result<Numbers, ReadMeshError> {
        let place = self.place(node);
        let scalar = scalar(node.attribute("type").unwrap_or_default(), place)?;
        // comments and instructions of processing may stand between the texts of an element
        let texts = node.children().filter(Node::is_text);
        let format = node.attribute("format").unwrap_or("ascii").trim();
        match format.to_ascii_lowercase().as_str() {
            "ascii" => {
                let texts = texts.map(|text| {
                    let line = self.lines.line(text.range().start);
                    (text.text().unwrap_or_default(), line)
                });
                text_numbers(texts, most, place)
            }
            "binary" => {
                let text: Vec<u8> = texts
                    .flat_map(|text| text.text().unwrap_or_default().bytes())
                    .filter(|byte| !byte.is_ascii_whitespace())
                    .collect();
                let stream = Stream::Base64(Base64Stream::new(&text, place));
                self.binary_numbers(stream, scalar, most, place)
            }
            "appended" => {
                let (stream, place) = self.appended_stream(node, place)?;
                self.binary_numbers(stream, scalar, most, place)
            }
            _ => Err(place.error(format!("unknown format {}", shown(format.as_bytes())))),
        }
    }

    fn appended_stream(
        &self,
        node: Node<'_, '_>,
        place: FilePosition,
    ) -> Result<(Stream<'_>, FilePosition), ReadMeshError> {
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
        let place = FilePosition::Byte(start);
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
        place: FilePosition,
    ) -> Result<Numbers, ReadMeshError> {
        let size = scalar.size();
        let bytes = decode(
            stream,
            self.encoding,
            most.saturating_mul(size as u64),
            &self.budget,
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

/// The numbers of texts, each text with its first line. Texts follow each other without white space: a comment may
/// stand within a number.
fn text_numbers<'t>(
    texts: impl Iterator<Item = (&'t str, usize)>,
    most: u64,
    place: FilePosition,
) -> Result<Numbers, ReadMeshError> {
    let mut joined = Vec::new();
    let mut line_starts = Vec::new();
    for (text, mut line) in texts {
        line_starts.push((joined.len(), line));
        for (at, _) in text.match_indices('\n') {
            line += 1;
            line_starts.push((joined.len() + at + 1, line));
        }
        joined.extend_from_slice(text.as_bytes());
    }
    let (mut values, mut lines) = (Vec::new(), Vec::new());
    let mut line_starts = line_starts.into_iter().peekable();
    let (mut end, mut line) = (0, 0);
    while let Some(white) = joined[end..].iter().position(|b| !b.is_ascii_whitespace()) {
        let start = end + white;
        let length = joined[start..].iter().position(u8::is_ascii_whitespace);
        end = length.map_or(joined.len(), |length| start + length);
        while let Some((_, of_word)) = line_starts.next_if(|&(first, _)| first <= start) {
            line = of_word;
        }
        if lines.last().is_none_or(|&(_, last)| last != line) {
            lines.push((values.len(), line));
        }
        let place = FilePosition::Line(line);
        if values.len() as u64 >= most {
            return Err(place.error(format!("an array of more than {most} numbers")));
        }
        values.push(number(&joined[start..end], place)?);
    }
    Ok(Numbers {
        values,
        place,
        lines,
    })
}

/// A type as the format names it.
pub(super) fn scalar(name: &str, place: FilePosition) -> Result<Scalar, ReadMeshError> {
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
pub(super) fn byte_order(name: &str, place: FilePosition) -> Result<ByteOrder, ReadMeshError> {
    match name {
        "LittleEndian" => Ok(ByteOrder::Little),
        "BigEndian" => Ok(ByteOrder::Big),
        _ => Err(place.error(format!("unknown byte order {}", shown(name.as_bytes())))),
    }
}
