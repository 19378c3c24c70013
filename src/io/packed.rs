//! Bytes that were packed with gzip or zlib, unpacked as they are read.

use std::io::{self, BufRead, Read};

use flate2::bufread::{GzDecoder, ZlibDecoder};

/// DEFLATE makes at most this many bytes of one (zlib, "Technical Details": 1032 to 1).
const MAX_EXPANSION: u64 = 1032;

/// How bytes are packed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Packing {
    /// Not at all.
    Plain,
    /// gzip, of one or several members.
    Gzip,
    /// zlib.
    Zlib,
}

impl Packing {
    /// Whether bytes begin as gzip does; all else counts as plain.
    pub(super) fn of_file(bytes: &[u8]) -> Self {
        if bytes.starts_with(b"\x1f\x8b") {
            Self::Gzip
        } else {
            Self::Plain
        }
    }

    /// The most bytes that so many packed ones can stand for.
    pub(super) fn max_unpacked(self, packed: usize) -> u64 {
        match self {
            Self::Plain => packed as u64,
            Self::Gzip | Self::Zlib => (packed as u64).saturating_mul(MAX_EXPANSION),
        }
    }

    /// The bytes, unpacked.
    pub(super) fn reader<'a>(self, bytes: &'a [u8]) -> Box<dyn Read + 'a> {
        match self {
            Self::Plain => Box::new(bytes),
            Self::Gzip => Box::new(Members(Some(GzDecoder::new(bytes)))),
            Self::Zlib => Box::new(ZlibDecoder::new(bytes)),
        }
    }
}

/// The members of a gzip file one after the other; what follows the last one, such as zeros of a tape, is left.
struct Members<'a>(Option<GzDecoder<&'a [u8]>>);

impl Read for Members<'_> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        while let Some(member) = &mut self.0 {
            let count = member.read(buffer)?;
            if count > 0 || buffer.is_empty() {
                return Ok(count);
            }
            let rest = *member.get_ref();
            self.0 = (Packing::of_file(rest) == Packing::Gzip).then(|| GzDecoder::new(rest));
        }
        Ok(0)
    }
}

/// Reads until `buffer` is full or nothing is left; returns how many bytes came.
///
/// # Errors
/// As the reader's; the bytes before the error are lost.
pub(super) fn fill(reader: &mut dyn Read, buffer: &mut [u8]) -> io::Result<usize> {
    let mut filled = 0;
    while filled < buffer.len() {
        match reader.read(&mut buffer[filled..]) {
            Ok(0) => break,
            Ok(count) => filled += count,
            Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
            Err(error) => return Err(error),
        }
    }
    Ok(filled)
}

/// The first bytes, unpacked, at most so many; fewer where they end or are damaged.
pub(super) fn unpacked_head(bytes: &[u8], most: usize) -> Vec<u8> {
    let mut reader =
        io::BufReader::with_capacity(most.max(1), Packing::of_file(bytes).reader(bytes));
    let mut head = Vec::new();
    while head.len() < most {
        let Ok(more) = reader.fill_buf() else { break };
        if more.is_empty() {
            break;
        }
        let count = more.len().min(most - head.len());
        head.extend_from_slice(&more[..count]);
        reader.consume(count);
    }
    head
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // A test that fails here says so.
mod tests {
    use std::io::Write;

    use flate2::Compression;
    use flate2::write::GzEncoder;

    use super::*;

    fn gzipped(bytes: &[u8]) -> Vec<u8> {
        let mut encoder = GzEncoder::new(Vec::new(), Compression::fast());
        encoder.write_all(bytes).unwrap();
        encoder.finish().unwrap()
    }

    #[test]
    fn members_are_joined_and_padding_after_them_is_left() {
        let mut packed = gzipped(b"one ");
        packed.extend(gzipped(b""));
        packed.extend(gzipped(b"two"));
        packed.extend([0; 512]);
        let mut all = String::new();
        let mut reader = Packing::of_file(&packed).reader(&packed);
        reader.read_to_string(&mut all).unwrap();
        assert_eq!(all, "one two");
        assert_eq!(unpacked_head(&packed, 5), b"one t");
        assert_eq!(unpacked_head(b"plain", 3), b"pla");
    }

    #[test]
    fn a_wrong_checksum_is_an_error() {
        let mut packed = gzipped(b"some bytes");
        let crc = packed.len() - 8;
        packed[crc] ^= 1;
        let mut all = Vec::new();
        assert!(Packing::Gzip.reader(&packed).read_to_end(&mut all).is_err());
    }
}
