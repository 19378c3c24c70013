//! The formats of outlines: how a file is recognised, and its reader. Adding a format is one file, and an entry here.

use super::outline::OutlineFile;
use super::{cvi42, guide_points, markups, structures, sunnybrook};
use crate::io::dicom::looks_like_dicom;
use crate::io::{Limits, ReadImageError};

/// First bytes that formats are recognised by.
pub(super) const HEAD: u64 = 4096;

/// A format of outlines.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ContourFormat {
    Cvi42,
    GuidePoints,
    Markups,
    Structures,
    Sunnybrook,
}

impl ContourFormat {
    /// The format of a file by its name and its first bytes; `None` if it holds no outlines.
    pub(super) fn of(name: &str, head: &[u8]) -> Option<Self> {
        if looks_like_dicom(head) {
            return structures::recognises(head).then_some(Self::Structures);
        }
        if sunnybrook::named(name).is_some() {
            Some(Self::Sunnybrook)
        } else if guide_points::recognises(head) {
            Some(Self::GuidePoints)
        } else if cvi42::recognises(head) {
            Some(Self::Cvi42)
        } else {
            markups::recognises(head).then_some(Self::Markups)
        }
    }

    /// Reads all outlines of a file.
    ///
    /// # Errors
    /// With the line, byte or field that is wrong, and why.
    pub(super) fn read(
        self,
        name: &str,
        bytes: Vec<u8>,
        limits: &Limits,
    ) -> Result<OutlineFile, ReadImageError> {
        let size = bytes.len() as u64;
        if size > limits.file_bytes {
            return Err(ReadImageError::TooLarge {
                size,
                most: limits.file_bytes,
            });
        }
        if self == Self::Structures {
            return structures::read_structures(name, bytes, limits);
        }
        let text = std::str::from_utf8(&bytes).map_err(|error| ReadImageError::AtByte {
            byte: error.valid_up_to() as u64,
            reason: "not UTF-8 text".to_owned(),
        })?;
        let text = text.strip_prefix('\u{feff}').unwrap_or(text);
        match self {
            Self::Cvi42 => cvi42::read_cvi42(text, limits),
            Self::GuidePoints => guide_points::read_guide_points(text, limits),
            Self::Markups => markups::read_markups(name, text, limits),
            Self::Sunnybrook | Self::Structures => sunnybrook::read_sunnybrook(name, text, limits),
        }
    }
}
