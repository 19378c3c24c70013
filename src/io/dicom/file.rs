//! A DICOM file: its beginning, how its elements are written and how its pixels are packed (PS3.10, PS3.5 annex A).

use std::io::Read;

use super::element::{DataSet, Encoding};
use super::tag::TRANSFER_SYNTAX;
use crate::io::image_file::ReadImageError;

/// The bytes of a file, unpacked if they were packed as a whole.
#[derive(Clone, Debug)]
pub(super) struct DicomFile {
    bytes: Vec<u8>,
    /// Where the data set begins.
    start: usize,
    pub(super) encoding: Encoding,
    pub(super) packing: Packing,
}

/// How pixels are packed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Packing {
    /// Not at all.
    Plain,
    /// Runs of equal bytes.
    Rle,
    /// JPEG of 8 bits, or without loss.
    Jpeg,
    /// JPEG-LS.
    JpegLs,
    /// JPEG 2000.
    Jpeg2000,
    /// A codec that is not read, by its name.
    Refused(&'static str),
}

const EXPLICIT: Encoding = Encoding {
    explicit: true,
    big_endian: false,
};
const IMPLICIT: Encoding = Encoding {
    explicit: false,
    big_endian: false,
};
const BIG_ENDIAN: Encoding = Encoding {
    explicit: true,
    big_endian: true,
};

/// The letters that a file begins with, after a preamble of 128 bytes.
const MAGIC: &[u8] = b"DICM";
const PREAMBLE: usize = 128;

/// Whether the first bytes of a file look like DICOM, with or without the preamble.
pub(crate) fn looks_like_dicom(head: &[u8]) -> bool {
    has_magic(head) || bare(head).is_some()
}

fn has_magic(bytes: &[u8]) -> bool {
    (bytes.get(PREAMBLE..)).is_some_and(|rest| rest.starts_with(MAGIC))
}

/// How the elements of a file without preamble are written, if they look like elements of the groups that come first.
fn bare(bytes: &[u8]) -> Option<Encoding> {
    let head = bytes.first_chunk::<8>()?;
    let lettered = head[4..6].iter().all(u8::is_ascii_uppercase);
    match (head[0], head[1]) {
        (2 | 8, 0) if lettered => Some(EXPLICIT),
        (0, 8) if lettered => Some(BIG_ENDIAN),
        // Words of the first groups are short: that tells them from most other files.
        (8, 0) => (head[5..8] == [0; 3] && head[3] < 0x30).then_some(IMPLICIT),
        _ => None,
    }
}

/// How the elements that begin at the head of these bytes are written, as far as it shows.
fn written(body: &[u8]) -> Encoding {
    let lettered = (body.get(4..6)).is_some_and(|l| l.iter().all(u8::is_ascii_uppercase));
    match (lettered, body.first()) {
        (false, _) => IMPLICIT,
        (true, Some(0)) => BIG_ENDIAN,
        (true, _) => EXPLICIT,
    }
}

/// Whether the first element has letters where an implicit one has its length.
fn is_lettered(body: &[u8]) -> bool {
    written(body).explicit && DataSet::first(body, IMPLICIT).is_none()
}

impl DicomFile {
    /// Looks at the beginning of a file. A data set that is packed as a whole is unpacked, up to `most` bytes.
    ///
    /// # Errors
    /// If it is not DICOM, or is packed as a whole and cannot be unpacked.
    pub(super) fn new(bytes: Vec<u8>, most: u64) -> Result<Self, ReadImageError> {
        let begin = if has_magic(&bytes) {
            PREAMBLE + MAGIC.len()
        } else if bytes.starts_with(MAGIC) {
            MAGIC.len()
        } else if bare(&bytes).is_some() {
            0
        } else {
            return Err(ReadImageError::UnknownFormat {
                known: "DICOM".to_owned(),
            });
        };
        let (start, syntax) = meta(&bytes, begin);
        let body = bytes.get(start..).unwrap_or_default();
        let (encoding, packing) = match syntax.as_deref() {
            None => (written(body), Packing::Plain),
            Some("1.2.840.10008.1.2.1.99") => {
                let bytes = inflated(body, most)?;
                return Ok(Self {
                    bytes,
                    start: 0,
                    encoding: EXPLICIT,
                    packing: Packing::Plain,
                });
            }
            // Some files say so and are not: letters read as a length are far longer than the file.
            Some("1.2.840.10008.1.2") if is_lettered(body) => (written(body), Packing::Plain),
            Some("1.2.840.10008.1.2") => (IMPLICIT, Packing::Plain),
            Some("1.2.840.10008.1.2.2") => (BIG_ENDIAN, Packing::Plain),
            // GE's: explicit and little endian but for the pixels.
            Some("1.2.840.113619.5.2") => (
                IMPLICIT,
                Packing::Refused("the private syntax of GE with pixels in big endian"),
            ),
            Some(syntax) => (EXPLICIT, packing(syntax)),
        };
        Ok(Self {
            bytes,
            start,
            encoding,
            packing,
        })
    }

    /// The elements.
    pub(super) fn data_set(&self) -> DataSet<'_> {
        DataSet::new(self.body(), self.encoding)
    }

    /// The bytes of the elements, in which their places are counted.
    pub(super) fn body(&self) -> &[u8] {
        self.bytes.get(self.start..).unwrap_or_default()
    }
}

/// Where the elements about the file end, and the transfer syntax that they name.
///
/// Their stated length is not used: it is missing or wrong in real files.
fn meta(bytes: &[u8], begin: usize) -> (usize, Option<String>) {
    let mut at = begin;
    let mut syntax = None;
    let byte = |at: usize| bytes.get(at).copied();
    while byte(at) == Some(2) && byte(at + 1) == Some(0) {
        let rest = bytes.get(at..).unwrap_or_default();
        let Some((tag, value)) = DataSet::first(rest, EXPLICIT) else {
            break;
        };
        if tag == TRANSFER_SYNTAX {
            let text = rest.get(value.clone()).unwrap_or_default();
            let text = String::from_utf8_lossy(text);
            syntax = Some(text.trim_matches([' ', '\0']).to_owned()).filter(|s| !s.is_empty());
        }
        at += value.end;
    }
    (at, syntax)
}

/// A data set that was packed as a whole (PS3.5, A.5).
fn inflated(body: &[u8], most: u64) -> Result<Vec<u8>, ReadImageError> {
    let mut bytes = Vec::new();
    let unpacker = flate2::read::DeflateDecoder::new(body);
    let read = unpacker
        .take(most.saturating_add(1))
        .read_to_end(&mut bytes);
    let unpacked = bytes.len() as u64;
    match read {
        Err(error) => Err(ReadImageError::Unpack {
            unpacked,
            reason: error.to_string(),
        }),
        Ok(_) if unpacked > most => Err(ReadImageError::TooLarge {
            size: unpacked,
            most,
        }),
        Ok(_) => Ok(bytes),
    }
}

/// How the pixels of a transfer syntax are packed.
fn packing(syntax: &str) -> Packing {
    let Some(own) = syntax.strip_prefix("1.2.840.10008.1.2.") else {
        return Packing::Refused("a codec of its maker (a private transfer syntax)");
    };
    match own {
        "1" => Packing::Plain,
        "5" => Packing::Rle,
        // Process 14 of any predictor, and the two with loss.
        "4.50" | "4.51" | "4.57" | "4.70" => Packing::Jpeg,
        "4.80" | "4.81" => Packing::JpegLs,
        "4.90" | "4.91" => Packing::Jpeg2000,
        "4.92" | "4.93" => Packing::Refused("JPEG 2000 part 2"),
        "4.100" | "4.101" | "4.100.1" | "4.101.1" => Packing::Refused("MPEG-2"),
        "4.102" | "4.103" | "4.104" | "4.105" | "4.106" => Packing::Refused("MPEG-4 AVC (H.264)"),
        "4.107" | "4.108" => Packing::Refused("HEVC (H.265)"),
        "4.110" | "4.111" | "4.112" => Packing::Refused("JPEG XL"),
        "4.201" | "4.202" | "4.203" => Packing::Refused("high-throughput JPEG 2000"),
        "8.1" => Packing::Refused("deflated frames"),
        "4.94" | "4.95" | "4.204" | "4.205" => Packing::Refused("JPIP (pixels on a server)"),
        _ if own.starts_with("4.") => Packing::Refused("a retired JPEG process"),
        _ => Packing::Refused("a transfer syntax that is not known here"),
    }
}
