//! Binary arrays of VTP files: a header with sizes, then the bytes, plain or in zlib blocks.

use std::cell::Cell;
use std::io::Read;

use flate2::read::ZlibDecoder;

use super::base64_stream::Base64Stream;
use crate::io::ReadMeshError;
use crate::io::binary_cursor::{BinaryCursor, ByteOrder, Scalar};
use crate::io::mesh_draft::FilePosition;
use crate::io::text_lines::shown;

/// What the file says about all its binary arrays.
#[derive(Clone, Copy, Debug)]
pub(super) struct Encoding<'a> {
    pub(super) order: ByteOrder,
    /// Type of the sizes before an array: `UInt32` or `UInt64`.
    pub(super) header: Scalar,
    pub(super) compressor: Compressor<'a>,
}

/// How binary arrays are packed.
#[derive(Clone, Copy, Debug)]
pub(super) enum Compressor<'a> {
    None,
    Zlib,
    /// One that is not read, and where the file names it. Arrays in text are not packed by any.
    Other(&'a str, FilePosition),
}

/// Bytes as they stand, or through base64.
pub(super) enum Stream<'a> {
    Raw(BinaryCursor<'a>),
    Base64(Base64Stream<'a>),
}

impl Stream<'_> {
    fn take(&mut self, count: u64) -> Result<Vec<u8>, ReadMeshError> {
        match self {
            Self::Raw(cursor) => cursor.take(count, "an array").map(<[u8]>::to_vec),
            Self::Base64(stream) => stream.take(count),
        }
    }

    fn size(&mut self, encoding: Encoding<'_>, place: FilePosition) -> Result<u64, ReadMeshError> {
        let bytes = self.take(encoding.header.size() as u64)?;
        let size = encoding.header.number(&bytes, encoding.order);
        // sizes of 2⁵³ bytes and more are damage, and not exact in f64
        if size > 9e15 {
            return Err(place.error(format!("an array of {size:e} bytes")));
        }
        Ok(size as u64)
    }
}

/// The bytes of an array that begins at `place`; at most `max_bytes`, and no more than the budget that all arrays
/// share. Their number is known, and refused, before anything is unpacked.
pub(super) fn decode(
    mut stream: Stream<'_>,
    encoding: Encoding<'_>,
    max_bytes: u64,
    budget: &Cell<u64>,
    place: FilePosition,
) -> Result<Vec<u8>, ReadMeshError> {
    let check = |bytes: u64| {
        if bytes > max_bytes {
            return Err(place.error(format!(
                "an array of {bytes} bytes, but {max_bytes} are expected at most"
            )));
        }
        let left = budget.get().checked_sub(bytes).ok_or_else(|| {
            place.error(format!(
                "an array of {bytes} bytes: too many for so small a file, however well it is packed"
            ))
        })?;
        budget.set(left);
        Ok(())
    };
    match encoding.compressor {
        Compressor::Zlib => {}
        Compressor::None => {
            let bytes = stream.size(encoding, place)?;
            check(bytes)?;
            return stream.take(bytes);
        }
        Compressor::Other(name, place) => {
            return Err(place.error(format!(
                "compressed by {}; only vtkZLibDataCompressor or none is read",
                shown(name.as_bytes())
            )));
        }
    }
    let blocks = stream.size(encoding, place)?;
    let block_bytes = stream.size(encoding, place)?;
    let last_bytes = stream.size(encoding, place)?;
    let whole_blocks = if last_bytes == 0 {
        blocks
    } else {
        blocks.saturating_sub(1)
    };
    let bytes = whole_blocks
        .saturating_mul(block_bytes)
        .saturating_add(last_bytes);
    check(bytes)?;
    if blocks > bytes {
        return Err(place.error(format!("{blocks} blocks for {bytes} bytes")));
    }
    let mut packed_sizes = Vec::new();
    for _ in 0..blocks {
        packed_sizes.push(stream.size(encoding, place)?);
    }
    let mut unpacked = Vec::new();
    for (block, packed) in packed_sizes.into_iter().enumerate() {
        let partial = last_bytes != 0 && block as u64 + 1 == blocks;
        let expected = if partial { last_bytes } else { block_bytes };
        let packed = stream.take(packed)?;
        let before = unpacked.len() as u64;
        ZlibDecoder::new(&packed[..])
            .take(expected.saturating_add(1))
            .read_to_end(&mut unpacked)
            .map_err(|error| place.error(format!("block {block} of an array: {error}")))?;
        let held = unpacked.len() as u64 - before;
        if held != expected {
            return Err(place.error(format!(
                "block {block} of an array does not unpack to {expected} bytes"
            )));
        }
    }
    Ok(unpacked)
}
