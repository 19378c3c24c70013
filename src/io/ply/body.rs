//! The numbers of a PLY body, text or binary, one element at a time.

use crate::io::ReadMeshError;
use crate::io::binary_cursor::{BinaryCursor, ByteOrder, Scalar};
use crate::io::mesh_draft::Place;
use crate::io::text_lines::{TextLines, number};

/// Elements one after the other, each a run of numbers.
pub(super) trait Body {
    /// Begins the next element, one of those called `name`.
    fn begin(&mut self, name: &str) -> Result<(), ReadMeshError>;
    /// The next number of this element.
    fn number(&mut self, scalar: Scalar) -> Result<f64, ReadMeshError>;
    /// Ends the element.
    fn end(&mut self) -> Result<(), ReadMeshError>;
    /// Where it is.
    fn place(&self) -> Place;
    /// Bytes that are left.
    fn bytes_left(&self) -> usize;
}

/// One line for each element.
pub(super) struct TextBody<'a> {
    lines: TextLines<'a>,
    rest_of_line: &'a [u8],
}

impl<'a> TextBody<'a> {
    pub(super) fn new(lines: TextLines<'a>) -> Self {
        Self {
            lines,
            rest_of_line: &[],
        }
    }

    fn next_word(&mut self) -> Option<&'a [u8]> {
        let rest = self.rest_of_line.trim_ascii_start();
        if rest.is_empty() {
            return None;
        }
        let end = rest.iter().position(u8::is_ascii_whitespace);
        let (word, rest) = rest.split_at(end.unwrap_or(rest.len()));
        self.rest_of_line = rest;
        Some(word)
    }
}

impl Body for TextBody<'_> {
    fn begin(&mut self, name: &str) -> Result<(), ReadMeshError> {
        for (_, text) in self.lines.by_ref() {
            if !text.trim_ascii().is_empty() {
                self.rest_of_line = text;
                return Ok(());
            }
        }
        let reason = format!("the file ends where an element \"{name}\" is expected");
        Err(self.place().error(reason))
    }

    fn number(&mut self, _: Scalar) -> Result<f64, ReadMeshError> {
        let place = self.place();
        let word = self
            .next_word()
            .ok_or_else(|| place.error("fewer numbers than the header announces"))?;
        number(word, place)
    }

    fn end(&mut self) -> Result<(), ReadMeshError> {
        if self.rest_of_line.trim_ascii().is_empty() {
            return Ok(());
        }
        Err(self.place().error("more numbers than the header announces"))
    }

    fn place(&self) -> Place {
        Place::Line(self.lines.line())
    }

    fn bytes_left(&self) -> usize {
        self.lines.rest().trim_ascii().len()
    }
}

/// Numbers without anything between them.
pub(super) struct BinaryBody<'a> {
    cursor: BinaryCursor<'a>,
    order: ByteOrder,
}

impl<'a> BinaryBody<'a> {
    /// The body that begins at byte `start` of the file.
    pub(super) fn new(bytes: &'a [u8], start: usize, order: ByteOrder) -> Self {
        Self {
            cursor: BinaryCursor::new(bytes, start),
            order,
        }
    }
}

impl Body for BinaryBody<'_> {
    fn begin(&mut self, name: &str) -> Result<(), ReadMeshError> {
        if self.cursor.rest().is_empty() {
            let reason = format!("the file ends where an element \"{name}\" is expected");
            return Err(self.place().error(reason));
        }
        Ok(())
    }

    fn number(&mut self, scalar: Scalar) -> Result<f64, ReadMeshError> {
        self.cursor.number(scalar, self.order, "a number")
    }

    fn end(&mut self) -> Result<(), ReadMeshError> {
        Ok(())
    }

    fn place(&self) -> Place {
        self.cursor.place()
    }

    fn bytes_left(&self) -> usize {
        self.cursor.rest().len()
    }
}
