//! Pixels packed by JPEG, JPEG-LS and JPEG 2000, whose own heads are checked before a byte of memory is taken for them.

use hayro_jpeg2000::{DecodeSettings, DecoderContext, Image};
use jpeg_decoder::{Decoder, PixelFormat};

use super::jpeg_ls::samples;
use super::jpeg_ls_head::JpegLsHead;
use super::layout::unsupported;
use crate::io::image_file::ReadImageError;
use crate::io::limits::{MAX_PIXELS_OF_A_BYTE, PIXELS_OF_ANY_FRAME};

/// The words of a frame of `size` (columns, rows) that is packed as JPEG with one component.
///
/// # Errors
/// If it is of another size, has colours or 12 bits with loss, or cannot be unpacked.
pub(super) fn unpacked_jpeg(bytes: &[u8], size: [usize; 2]) -> Result<Vec<u32>, ReadImageError> {
    let head = jpeg_head(bytes).ok_or_else(|| broken("JPEG", "it has no frame header"))?;
    check_size("JPEG", head.size, size, bytes.len())?;
    if head.components != 1 {
        return Err(unsupported(
            "a picture in colours (JPEG of several components)",
        ));
    }
    if !head.lossless && head.bits != 8 {
        return Err(unsupported(format!(
            "pixels packed by JPEG with loss of {} bits, of which only 8 are read",
            head.bits
        )));
    }
    let mut decoder = Decoder::new(bytes);
    decoder.set_max_decoding_buffer_size((size[0] * size[1]).saturating_mul(8));
    let decoded = decoder.decode();
    let decoded = decoded.map_err(|error| broken("JPEG", &kind_of(&error)))?;
    match decoder.info().map(|info| info.pixel_format) {
        Some(PixelFormat::L8) => Ok(decoded.into_iter().map(u32::from).collect()),
        Some(PixelFormat::L16) => Ok((decoded.as_chunks::<2>().0.iter())
            .map(|bytes| u32::from(u16::from_ne_bytes(*bytes)))
            .collect()),
        _ => Err(unsupported(
            "a picture in colours (JPEG of several components)",
        )),
    }
}

/// What went wrong, without words of the file.
fn kind_of(error: &jpeg_decoder::Error) -> String {
    match error {
        jpeg_decoder::Error::Format(_) => "its bytes are not those of the format",
        jpeg_decoder::Error::Unsupported(_) => "a feature of the format that is not read",
        jpeg_decoder::Error::Io(_) => "its bytes end too early",
        jpeg_decoder::Error::Internal(_) => "its decoder failed",
    }
    .to_owned()
}

struct JpegHead {
    size: [usize; 2],
    components: u8,
    bits: u8,
    lossless: bool,
}

/// The frame header of a JPEG stream (ITU T.81, B.2.2).
fn jpeg_head(bytes: &[u8]) -> Option<JpegHead> {
    let word = |at: usize| {
        let bytes = bytes.get(at..)?.first_chunk()?;
        Some(usize::from(u16::from_be_bytes(*bytes)))
    };
    let mut at = 2;
    loop {
        let marker = word(at)?;
        match marker {
            0xffff => at += 1,
            0xffc4 | 0xffc8 | 0xffcc | 0xffda => {
                if marker == 0xffda {
                    return None;
                }
                at += 2 + word(at + 2)?;
            }
            0xffc0..=0xffcf => {
                return Some(JpegHead {
                    bits: *bytes.get(at + 4)?,
                    size: [word(at + 7)?, word(at + 5)?],
                    components: *bytes.get(at + 9)?,
                    lossless: marker == 0xffc3,
                });
            }
            0xff01 | 0xffd0..=0xffd8 => at += 2,
            0xff02..=0xfffe => at += 2 + word(at + 2)?,
            _ => return None,
        }
    }
}

/// The words of a frame of `size` (columns, rows) that is packed as JPEG-LS with one component.
///
/// # Errors
/// If it is of another size, has several components, or cannot be unpacked.
pub(super) fn unpacked_jpeg_ls(bytes: &[u8], size: [usize; 2]) -> Result<Vec<u32>, ReadImageError> {
    const NAME: &str = "JPEG-LS";
    let head = JpegLsHead::new(bytes).ok_or_else(|| broken(NAME, "its head is not read"))?;
    check_size(NAME, head.size, size, bytes.len())?;
    if head.components != 1 {
        return Err(unsupported(
            "a picture in colours (JPEG-LS of several components)",
        ));
    }
    samples(bytes, &head).ok_or_else(|| broken(NAME, "its bytes are not those of the format"))
}

/// The words of a frame of `size` (columns, rows) that is packed as JPEG 2000 with one component.
///
/// Its own head says whether its numbers have a sign, which files contradict (pydicom/pydicom#1149): the bits are
/// what counts, and what they mean is said by the file around them.
///
/// # Errors
/// If it is of another size, has several components, or cannot be unpacked.
pub(super) fn unpacked_jpeg2000(
    bytes: &[u8],
    size: [usize; 2],
) -> Result<Vec<u32>, ReadImageError> {
    const NAME: &str = "JPEG 2000";
    // The size segment (ITU T.800, A.5.1) begins the stream, which may stand within boxes.
    let begin = (bytes.windows(4)).position(|four| four == [0xff, 0x4f, 0xff, 0x51]);
    let head = begin.and_then(|at| bytes.get(at + 4..at + 4 + 39));
    let head = head.ok_or_else(|| broken(NAME, "it has no size segment"))?;
    let number = |at: usize| {
        let bytes = head.get(at..).and_then(|rest| rest.first_chunk());
        bytes.map_or(0, |bytes| u32::from_be_bytes(*bytes) as usize)
    };
    let own = [
        number(4).saturating_sub(number(12)),
        number(8).saturating_sub(number(16)),
    ];
    check_size(NAME, own, size, bytes.len())?;
    let tiles = |axis: usize| own[axis] / number(20 + 4 * axis).max(1) + 1;
    if tiles(0).saturating_mul(tiles(1)) > bytes.len() {
        return Err(broken(NAME, "it has more tiles than bytes"));
    }
    if head[36..38] != [0, 1] {
        return Err(unsupported(
            "a picture in colours (JPEG 2000 of several components)",
        ));
    }
    let (signed, bits) = (head[38] & 0x80 != 0, u32::from(head[38] & 0x7f) + 1);
    // Samples come as 32-bit floating point, which holds whole numbers of 24 bits.
    if bits > 24 {
        return Err(unsupported(format!("JPEG 2000 of {bits} bits")));
    }
    let settings = DecodeSettings {
        resolve_palette_indices: false,
        strict: true,
        target_resolution: None,
    };
    let failed = |_| broken(NAME, "its bytes are not those of the format");
    let image = Image::new(bytes, &settings).map_err(failed)?;
    let mut context = DecoderContext::default();
    let decoded = image.decode(&mut context).map_err(failed)?;
    let samples = decoded.components().first().map(|one| one.samples());
    let samples = samples.ok_or_else(|| broken(NAME, "it holds no samples"))?;
    // The decoder lifts numbers with a sign as it does those without: back, and to two's complement.
    let (lift, mask) = (
        if signed { 1 << (bits - 1) } else { 0 },
        (1_i64 << bits) - 1,
    );
    let words = samples.iter().map(|sample| {
        let number = (sample.round() as i64).clamp(0, mask) - lift;
        // All bits of a word carry the sign, since the file may say that more of them count.
        if signed {
            number as u32
        } else {
            (number & mask) as u32
        }
    });
    Ok(words.collect())
}

/// Refuses a stream whose own size is not that of the file, and one that would unpack to far more than it has bytes.
fn check_size(
    codec: &'static str,
    own: [usize; 2],
    size: [usize; 2],
    bytes: usize,
) -> Result<(), ReadImageError> {
    if own != size {
        return Err(ReadImageError::InField {
            field: "PixelData",
            reason: format!(
                "{codec} of {}×{} pixels in an image of {}×{}",
                own[0], own[1], size[0], size[1]
            ),
        });
    }
    check_share((size[0] as u64).saturating_mul(size[1] as u64), bytes)
}

/// Refuses packed bytes that would make far more pixels than any real ones do.
pub(super) fn check_share(pixels: u64, bytes: usize) -> Result<(), ReadImageError> {
    let most =
        PIXELS_OF_ANY_FRAME.saturating_add(MAX_PIXELS_OF_A_BYTE.saturating_mul(bytes as u64));
    if pixels > most {
        return Err(ReadImageError::TooMany {
            what: "pixels from so few bytes",
            count: pixels,
            most,
        });
    }
    Ok(())
}

fn broken(codec: &'static str, reason: &str) -> ReadImageError {
    unsupported(format!(
        "pixels packed by {codec} cannot be unpacked: {reason}"
    ))
}
