//! Pixels packed as runs of equal bytes (PS3.5, annex G).

use crate::io::image_file::ReadImageError;

/// The words of one frame of `count` pixels: one segment for each byte of a word, the highest byte first.
///
/// # Errors
/// If there are more or fewer segments than a word has bytes, or one of them holds too few.
pub(super) fn unpacked_rle(
    bytes: &[u8],
    count: usize,
    allocated: u32,
) -> Result<Vec<u32>, ReadImageError> {
    let number = |n: usize| {
        let bytes = bytes.get(4 * n..)?.first_chunk()?;
        Some(u32::from_le_bytes(*bytes) as usize)
    };
    let wanted = allocated.div_ceil(8) as usize;
    let segments = number(0).unwrap_or(0);
    if segments != wanted {
        return Err(ReadImageError::InField {
            field: "PixelData",
            reason: format!("{segments} segments of runs for words of {wanted} bytes"),
        });
    }
    // A run makes at most 128 bytes from two.
    if count > bytes.len().saturating_mul(64) {
        return Err(cut(count, bytes.len() * 64));
    }
    let mut words = vec![0_u32; count];
    for segment in 0..segments {
        let start = number(1 + segment).unwrap_or(usize::MAX);
        let end = match segment + 1 < segments {
            true => number(2 + segment).unwrap_or(0),
            false => bytes.len(),
        };
        let mut words = words.iter_mut();
        let mut put = |byte: u8| {
            if let Some(word) = words.next() {
                *word = *word << 8 | u32::from(byte);
            }
        };
        let mut rest = bytes.get(start..end).unwrap_or_default().iter();
        while let Some(&head) = rest.next() {
            match head as i8 {
                -128 => {}
                repeats @ ..0 => {
                    let Some(&byte) = rest.next() else { break };
                    (0..=-i16::from(repeats)).for_each(|_| put(byte));
                }
                copies => {
                    (0..=copies).for_each(|_| rest.next().into_iter().for_each(|&b| put(b)));
                }
            }
        }
        let missing = words.len();
        if missing > 0 {
            return Err(cut(count, count - missing));
        }
    }
    Ok(words)
}

fn cut(expected: usize, present: usize) -> ReadImageError {
    ReadImageError::Truncated {
        expected: expected as u64,
        present: present as u64,
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used)] // A test that fails here says so.
mod tests {
    use super::*;

    fn frame(segments: &[&[u8]]) -> Vec<u8> {
        let mut bytes = (segments.len() as u32).to_le_bytes().to_vec();
        let mut at = 64_u32;
        for segment in segments {
            bytes.extend(at.to_le_bytes());
            at += segment.len() as u32;
        }
        bytes.resize(64, 0);
        bytes.extend(segments.concat());
        bytes
    }

    /// <https://github.com/Enet4/dicom-rs/issues/457>: bytes of words were mixed up.
    #[test]
    fn the_first_segment_holds_the_high_bytes() {
        let packed = frame(&[&[0xfe, 0x12, 0], &[2, 0x34, 0x56, 0x78]]);
        let words = unpacked_rle(&packed, 3, 16).unwrap();
        assert_eq!(words, [0x1234, 0x1256, 0x1278]);
    }

    #[test]
    fn too_few_bytes_and_wrong_counts_are_refused() {
        let packed = frame(&[&[0xfe, 0x12], &[1, 0x34, 0x56]]);
        assert!(unpacked_rle(&packed, 3, 16).is_err());
        assert!(unpacked_rle(&packed, 2, 8).is_err());
        assert!(unpacked_rle(&packed, usize::MAX, 16).is_err());
        assert!(unpacked_rle(&[], 1, 8).is_err());
    }
}
