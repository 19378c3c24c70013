//! Binary arrays of VTP files: a header with sizes, then the bytes, plain or in zlib blocks.

use std::io::Read;

use flate2::read::ZlibDecoder;

use super::base64_stream::Base64Stream;
use crate::io::ReadMeshError;
use crate::io::binary_cursor::{BinaryCursor, ByteOrder, Scalar};
use crate::io::mesh_draft::Place;

/// What the file says about all its binary arrays.
#[derive(Clone, Copy, Debug)]
pub(super) struct Encoding {
    pub(super) order: ByteOrder,
    /// Type of the sizes before an array: `UInt32` or `UInt64`.
    pub(super) header: Scalar,
    pub(super) zlib: bool,
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

    fn size(&mut self, encoding: Encoding, place: Place) -> Result<u64, ReadMeshError> {
        let bytes = self.take(encoding.header.size() as u64)?;
        let size = encoding.header.number(&bytes, encoding.order);
        // sizes of 2⁵³ bytes and more are damage, and not exact in f64
        if size > 9e15 {
            return Err(place.error(format!("an array of {size:e} bytes")));
        }
        Ok(size as u64)
    }
}

/// The bytes of an array that begins at `place`; at most `max_bytes`.
pub(super) fn decode(
    mut stream: Stream<'_>,
    encoding: Encoding,
    max_bytes: u64,
    place: Place,
) -> Result<Vec<u8>, ReadMeshError> {
    let too_long = |bytes: u64| {
        place.error(format!(
            "an array of {bytes} bytes, but {max_bytes} are expected at most"
        ))
    };
    if !encoding.zlib {
        let bytes = stream.size(encoding, place)?;
        if bytes > max_bytes {
            return Err(too_long(bytes));
        }
        return stream.take(bytes);
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
    if bytes > max_bytes {
        return Err(too_long(bytes));
    }
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
