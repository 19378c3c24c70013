//! Base64 read piece by piece, as VTK writes it: several padded pieces one after the other.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

use crate::io::ReadMeshError;
use crate::io::mesh_draft::FilePosition;

/// Bytes from base64 text, decoded no further than they are asked for.
pub(super) struct Base64Stream<'a> {
    text: &'a [u8],
    at: usize,
    /// Decoded bytes, of which `used` have been given out.
    decoded: Vec<u8>,
    used: usize,
    place: FilePosition,
}

impl<'a> Base64Stream<'a> {
    /// From the start of `text`, which holds no white space; errors name `place`.
    pub(super) fn new(text: &'a [u8], place: FilePosition) -> Self {
        Self {
            text,
            at: 0,
            decoded: Vec::new(),
            used: 0,
            place,
        }
    }

    /// The next `count` bytes.
    pub(super) fn take(&mut self, count: u64) -> Result<Vec<u8>, ReadMeshError> {
        self.decoded.drain(..self.used);
        self.used = 0;
        while (self.decoded.len() as u64) < count {
            let missing = count - self.decoded.len() as u64;
            let rest = &self.text[self.at..];
            let wanted = missing.div_ceil(3).saturating_mul(4);
            let piece = &rest[..(rest.len() as u64).min(wanted) as usize];
            // padding ends a piece; another may follow
            let padding = piece.iter().position(|&b| b == b'=');
            let end = padding.map_or(piece.len(), |at| (at / 4 * 4 + 4).min(piece.len()));
            if end == 0 {
                return Err(self.place.error(format!(
                    "base64 ends {missing} bytes before the array that it holds"
                )));
            }
            STANDARD
                .decode_vec(&piece[..end], &mut self.decoded)
                .map_err(|error| self.place.error(format!("not valid base64: {error}")))?;
            self.at += end;
        }
        self.used = count as usize;
        Ok(self.decoded[..self.used].to_vec())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn padded_pieces_read_as_one_stream() {
        let text = STANDARD.encode([8, 0, 0, 0]) + &STANDARD.encode(b"abcdefgh");
        let mut stream = Base64Stream::new(text.as_bytes(), FilePosition::Byte(0));
        assert_eq!(stream.take(4).unwrap(), [8, 0, 0, 0]);
        assert_eq!(stream.take(3).unwrap(), b"abc");
        assert_eq!(stream.take(5).unwrap(), b"defgh");
        assert!(stream.take(1).is_err());
    }

    #[test]
    fn an_unpadded_boundary_inside_a_piece_loses_nothing() {
        let text = STANDARD.encode(b"1234abcdefgh");
        let mut stream = Base64Stream::new(text.as_bytes(), FilePosition::Byte(0));
        assert_eq!(stream.take(4).unwrap(), b"1234");
        assert_eq!(stream.take(8).unwrap(), b"abcdefgh");
    }
}
