//! A place in a legacy VTK file, whose keywords are text and whose numbers may be binary.

use crate::io::ReadMeshError;
use crate::io::binary_cursor::{BinaryCursor, ByteOrder, Scalar};
use crate::io::mesh_draft::FilePosition;
use crate::io::text_lines::{count, number, shown};

/// Where reading is; numbers are big-endian where they are binary.
pub(super) struct LegacyCursor<'a> {
    bytes: &'a [u8],
    at: usize,
    line: usize,
    binary: bool,
}

impl<'a> LegacyCursor<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Self {
            bytes,
            at: 0,
            line: 1,
            binary: false,
        }
    }

    /// From here on numbers are binary.
    pub(super) fn set_binary(&mut self) {
        self.binary = true;
    }

    pub(super) fn is_binary(&self) -> bool {
        self.binary
    }

    /// Line or byte: lines have no meaning once binary numbers came.
    pub(super) fn place(&self) -> FilePosition {
        if self.binary {
            FilePosition::Byte(self.at)
        } else {
            FilePosition::Line(self.line)
        }
    }

    pub(super) fn rest(&self) -> &'a [u8] {
        &self.bytes[self.at..]
    }

    /// Lines end as Unix, Windows and old Macs write them.
    fn advance(&mut self, count: usize) {
        if !self.binary {
            let (from, to) = (self.at, self.at + count);
            let ends = |&at: &usize| match self.bytes[at] {
                b'\n' => true,
                b'\r' => self.bytes.get(at + 1) != Some(&b'\n'),
                _ => false,
            };
            self.line += (from..to).filter(ends).count();
        }
        self.at += count;
    }

    /// Goes to the next byte that is not white.
    pub(super) fn skip_white(&mut self) {
        let rest = self.rest();
        self.advance(rest.len() - rest.trim_ascii_start().len());
    }

    /// The rest of this line; afterwards reading is at the start of the next.
    pub(super) fn line(&mut self) -> &'a [u8] {
        let rest = self.rest();
        let end = rest.iter().position(|&b| b == b'\n' || b == b'\r');
        let end = end.unwrap_or(rest.len());
        let ending = match rest[end..] {
            [b'\r', b'\n', ..] => 2,
            [] => 0,
            _ => 1,
        };
        self.advance(end + ending);
        rest[..end].trim_ascii()
    }

    /// Whether a keyword comes next, in any case, on whichever line.
    pub(super) fn comes(&self, keyword: &[u8]) -> bool {
        Self::is_next(self.rest().trim_ascii_start(), keyword)
    }

    /// Whether a keyword comes next, in any case, without an empty line before it.
    pub(super) fn comes_on_line(&self, keyword: &[u8]) -> bool {
        Self::is_next(self.rest(), keyword)
    }

    fn is_next(rest: &[u8], keyword: &[u8]) -> bool {
        let next = rest.get(..keyword.len()).unwrap_or_default();
        let ends = rest.get(keyword.len()).is_none_or(u8::is_ascii_whitespace);
        ends && next.eq_ignore_ascii_case(keyword)
    }

    /// The next word as a count.
    pub(super) fn count(&mut self) -> Result<u64, ReadMeshError> {
        let (word, place) = self.word("a count")?;
        count(word, place)
    }

    /// Goes from the last word of a keyword to the numbers behind it: those of a text may stand on the same line.
    pub(super) fn begin_numbers(&mut self) {
        if self.binary {
            self.line();
        }
    }

    /// The next word of a text file and where it stands.
    pub(super) fn word(&mut self, what: &str) -> Result<(&'a [u8], FilePosition), ReadMeshError> {
        self.skip_white();
        let rest = self.rest();
        let place = self.place();
        if rest.is_empty() {
            return Err(place.error(format!("the file ends where {what} is expected")));
        }
        let end = rest.iter().position(u8::is_ascii_whitespace);
        self.at += end.unwrap_or(rest.len());
        Ok((&rest[..end.unwrap_or(rest.len())], place))
    }

    /// The next number, which is `what`, and where it stands.
    pub(super) fn number(
        &mut self,
        scalar: Scalar,
        what: &str,
    ) -> Result<(f64, FilePosition), ReadMeshError> {
        if !self.binary {
            let (word, place) = self.word(what)?;
            return Ok((number(word, place)?, place));
        }
        let place = self.place();
        let bytes = self.take(scalar.size() as u64, what)?;
        Ok((scalar.number(bytes, ByteOrder::Big), place))
    }

    /// The next bytes of a binary file.
    pub(super) fn take(&mut self, count: u64, what: &str) -> Result<&'a [u8], ReadMeshError> {
        let taken = BinaryCursor::new(self.bytes, self.at).take(count, what)?;
        self.at += taken.len();
        Ok(taken)
    }
}

/// A type as the format names it; none for `bit` and `string`.
pub(super) fn scalar(word: &[u8], place: FilePosition) -> Result<Scalar, ReadMeshError> {
    Ok(match word.to_ascii_lowercase().as_slice() {
        b"char" | b"signed_char" => Scalar::I8,
        b"unsigned_char" => Scalar::U8,
        b"short" => Scalar::I16,
        b"unsigned_short" => Scalar::U16,
        // legacy files store vtkIdType as int
        b"int" | b"vtkidtype" => Scalar::I32,
        b"unsigned_int" => Scalar::U32,
        b"long" | b"vtktypeint64" => Scalar::I64,
        b"unsigned_long" | b"vtktypeuint64" => Scalar::U64,
        b"float" => Scalar::F32,
        b"double" => Scalar::F64,
        _ => return Err(place.error(format!("unknown type {}", shown(word)))),
    })
}
