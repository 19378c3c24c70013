//! The numbers of a PLY body, text or binary, one element at a time.

use crate::io::ReadMeshError;
use crate::io::binary_cursor::{BinaryCursor, ByteOrder, Scalar};
use crate::io::mesh_draft::FilePosition;
use crate::io::text_lines::{TextLines, TextWords, number};

/// Elements one after the other, each a run of numbers.
pub(super) trait Body {
    /// Begins the next element, one of those called `name`, the first of them if `first`.
    fn begin(&mut self, name: &str, first: bool) -> Result<(), ReadMeshError>;
    /// The next number of this element.
    fn number(&mut self, scalar: Scalar) -> Result<f64, ReadMeshError>;
    /// Goes past the next number, which need not be one in a text.
    fn skip(&mut self, scalar: Scalar) -> Result<(), ReadMeshError>;
    /// Ends the element.
    fn end(&mut self) -> Result<(), ReadMeshError>;
    /// Ends the body; how many bytes are left that may be passed over.
    fn finish(&self) -> Result<usize, ReadMeshError>;
    /// Where it is.
    fn place(&self) -> FilePosition;
    /// Bytes that are left.
    fn bytes_left(&self) -> usize;
}

/// Numbers in text. An element usually has a line for itself, which is what tells a number too few
/// or too many; but it may go on over several lines, and several may share one.
pub(super) struct TextBody<'a> {
    words: TextWords<'a>,
    begun_on: usize,
    first: bool,
    /// Whether elements of this kind share lines: the first of them does.
    shared: bool,
    /// Whether some element has not its own line, so that a number too many is only seen at the end.
    wrapped: bool,
}

impl<'a> TextBody<'a> {
    pub(super) fn new(lines: TextLines<'a>) -> Self {
        Self {
            words: TextWords::new(lines),
            begun_on: 0,
            first: true,
            shared: false,
            wrapped: false,
        }
    }

    fn word(&mut self) -> Result<&'a [u8], ReadMeshError> {
        let word = self.words.next();
        word.ok_or_else(|| {
            self.place()
                .error("fewer numbers than the header announces")
        })
    }
}

impl Body for TextBody<'_> {
    fn begin(&mut self, name: &str, first: bool) -> Result<(), ReadMeshError> {
        if first {
            self.shared = self.words.more_on_line();
        }
        self.first = first;
        if !self.words.go_to_next() {
            let reason = format!("the file ends where an element \"{name}\" is expected");
            return Err(self.place().error(reason));
        }
        self.begun_on = self.words.line();
        Ok(())
    }

    fn number(&mut self, _: Scalar) -> Result<f64, ReadMeshError> {
        let word = self.word()?;
        number(word, self.place())
    }

    fn skip(&mut self, _: Scalar) -> Result<(), ReadMeshError> {
        self.word().map(|_| ())
    }

    fn end(&mut self) -> Result<(), ReadMeshError> {
        let ends_on = self.words.line();
        self.wrapped |= ends_on != self.begun_on;
        if self.words.more_on_line() {
            self.shared |= self.first;
            self.wrapped = true;
            if !self.shared {
                let begun_on = FilePosition::Line(self.begun_on);
                return Err(begun_on.error(if ends_on == self.begun_on {
                    "more numbers than the header announces".to_owned()
                } else {
                    format!(
                        "numbers of an element end amid line {ends_on}: one is missing, or too many"
                    )
                }));
            }
        }
        Ok(())
    }

    fn finish(&self) -> Result<usize, ReadMeshError> {
        let left = self.bytes_left();
        if self.wrapped && left > 0 {
            let mut words = self.words.clone();
            words.go_to_next();
            return Err(words
                .place()
                .error("more numbers than the header announces"));
        }
        Ok(left)
    }

    fn place(&self) -> FilePosition {
        self.words.place()
    }

    fn bytes_left(&self) -> usize {
        self.words.bytes_left()
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
    fn begin(&mut self, name: &str, _: bool) -> Result<(), ReadMeshError> {
        if self.cursor.rest().is_empty() {
            let reason = format!("the file ends where an element \"{name}\" is expected");
            return Err(self.place().error(reason));
        }
        Ok(())
    }

    fn number(&mut self, scalar: Scalar) -> Result<f64, ReadMeshError> {
        self.cursor.number(scalar, self.order, "a number")
    }

    fn skip(&mut self, scalar: Scalar) -> Result<(), ReadMeshError> {
        let taken = self.cursor.take(scalar.size() as u64, "a number");
        taken.map(|_| ())
    }

    fn end(&mut self) -> Result<(), ReadMeshError> {
        Ok(())
    }

    fn finish(&self) -> Result<usize, ReadMeshError> {
        Ok(self.bytes_left())
    }

    fn place(&self) -> FilePosition {
        self.cursor.place()
    }

    fn bytes_left(&self) -> usize {
        self.cursor.rest().len()
    }
}
