//! What the segments of a segmentation are, by the words that name them (PS3.3, C.8.20.4).

use super::contours::part_of;
use super::file::DicomFile;
use super::tag::{CODE_MEANING, SEGMENT_LABEL, SEGMENT_NUMBER, SEGMENT_TYPE, SEGMENTS};
use crate::io::image_file::ReadImageError;
use crate::io::limits::Limits;

/// The class of segmentations, binary and of fractions or labels, as the head of a file names it.
const SEGMENTATION: [&[u8]; 2] = [
    b"1.2.840.10008.5.1.4.1.1.66.4",
    b"1.2.840.10008.5.1.4.1.1.66.7",
];

/// Whether the head of a DICOM file says that it holds a segmentation.
pub(in crate::io) fn is_segmentation_head(head: &[u8]) -> bool {
    let is_class = |window: &[u8]| {
        let next = window.last().copied().unwrap_or_default();
        SEGMENTATION.iter().any(|class| window.starts_with(class))
            && !next.is_ascii_digit()
            && next != b'.'
    };
    super::looks_like_dicom(head) && head.windows(SEGMENTATION[0].len() + 1).any(is_class)
}

/// The number of each segment, with what it is where its name, or the type that it is coded as, says so in words of anatomy;
/// other words stay in the file.
///
/// # Errors
/// If the file is damaged.
pub(in crate::io) fn segment_parts(
    bytes: Vec<u8>,
    limits: &Limits,
) -> Result<Vec<(u32, Option<&'static str>)>, ReadImageError> {
    let file = DicomFile::new(bytes, limits.file_bytes)?;
    let set = file.data_set();
    let named = set.items(SEGMENTS).into_iter().filter_map(|item| {
        let number = item.count(SEGMENT_NUMBER)? as u32;
        let coded = item.item(SEGMENT_TYPE);
        let coded = coded.as_ref().and_then(|code| code.text(CODE_MEANING));
        let words = [item.text(SEGMENT_LABEL), coded];
        Some((number, words.into_iter().flatten().find_map(part_of)))
    });
    Ok(named.collect())
}
