//! The formats of volume files that are not DICOM: names, how content is recognised, reader. Adding a format is one folder
//! with its reader, and one entry here.

use super::image_file::ImageSeries;
use super::image_source::{ImageSource, Sibling};
use super::packed::{Packing, unpacked_head};
use super::{Limits, ReadImageError, metaimage, nifti, nrrd};

/// One format of volume files.
struct ImageFormat {
    /// As people call it.
    name: &'static str,
    /// Whether it reads packed files itself; others are unpacked first.
    reads_packed: bool,
    /// Whether content that begins like this, unpacked, is of this format.
    recognises: fn(&[u8]) -> bool,
    /// Reads a whole file.
    read: fn(&ImageSource<'_>) -> Result<ImageSeries, ReadImageError>,
}

static FORMATS: [ImageFormat; 3] = [
    ImageFormat {
        name: "NIfTI",
        reads_packed: true,
        recognises: nifti::recognises,
        read: nifti::read_nifti,
    },
    ImageFormat {
        name: "NRRD",
        reads_packed: false,
        recognises: nrrd::recognises,
        read: nrrd::read_nrrd,
    },
    ImageFormat {
        name: "MetaImage",
        reads_packed: false,
        recognises: metaimage::recognises,
        read: metaimage::read_metaimage,
    },
];

/// First bytes, unpacked, that formats are recognised by.
const HEAD: usize = 1024;
/// First bytes of a file that surely hold as many unpacked ones.
pub(super) const PACKED_HEAD: u64 = 4096;

/// Names of all formats, as people read them in a list.
pub fn image_format_names() -> Vec<&'static str> {
    FORMATS.iter().map(|format| format.name).collect()
}

/// Whether a file with these first bytes (at least the first 4096, if it has so many) is of a format that is read here.
pub fn is_image_head(first_bytes: &[u8]) -> bool {
    format_of(first_bytes).is_some()
}

fn format_of(bytes: &[u8]) -> Option<&'static ImageFormat> {
    let head = unpacked_head(bytes, HEAD);
    FORMATS.iter().find(|format| (format.recognises)(&head))
}

/// Reads one volume file, whose format is recognised by its content.
///
/// `file_name` only serves to find the other file of a pair; `sibling` returns the content of a file beside this one by its
/// name (a relative path without `..`), or why it cannot be had.
///
/// # Errors
/// With the byte, line or field that is wrong, and why.
pub fn read_image(
    file_name: &str,
    bytes: &[u8],
    limits: &Limits,
    sibling: &Sibling<'_>,
) -> Result<ImageSeries, ReadImageError> {
    let size = bytes.len() as u64;
    if size > limits.file_bytes {
        return Err(ReadImageError::TooLarge {
            size,
            most: limits.file_bytes,
        });
    }
    let format = format_of(bytes).ok_or_else(|| ReadImageError::UnknownFormat {
        known: image_format_names().join(", "),
    })?;
    let unpacked = match Packing::of_file(bytes) {
        Packing::Plain => None,
        _ if format.reads_packed => None,
        packing => Some(unpacked(bytes, packing, limits)?),
    };
    (format.read)(&ImageSource {
        name: file_name,
        bytes: unpacked.as_deref().unwrap_or(bytes),
        limits,
        sibling,
    })
}

/// All bytes, unpacked, within the limit of a file.
fn unpacked(bytes: &[u8], packing: Packing, limits: &Limits) -> Result<Vec<u8>, ReadImageError> {
    use std::io::Read;

    let mut all = Vec::new();
    let most = limits.file_bytes;
    let read = packing
        .reader(bytes)
        .take(most.saturating_add(1))
        .read_to_end(&mut all);
    if read.is_err() {
        return Err(ReadImageError::Unpack {
            unpacked: all.len() as u64,
            reason: "the packed bytes are damaged or end too early".to_owned(),
        });
    }
    let size = all.len() as u64;
    if size > most {
        return Err(ReadImageError::TooLarge { size, most });
    }
    Ok(all)
}
