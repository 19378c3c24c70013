//! Outlines of structures of radiotherapy (RTSTRUCT), by the words of their names.

use std::sync::Arc;

use super::outline::{FrameName, Outline, OutlineFile, OutlinePlace};
use crate::image::ContourPart;
use crate::io::dicom::{ContouredStructure, read_dicom_bytes};
use crate::io::{Limits, ReadImageError};
use crate::progress::Progress;

/// The class of a file of structures (RT Structure Set Storage), as its head names it.
const STRUCTURE_SET: &[u8] = b"1.2.840.10008.5.1.4.1.1.481.3";

/// Whether the head of a DICOM file says that it holds structures.
pub(super) fn recognises(head: &[u8]) -> bool {
    let class = STRUCTURE_SET.len();
    head.windows(class + 1).any(|window| {
        window.starts_with(STRUCTURE_SET)
            && !window[class].is_ascii_digit()
            && window[class] != b'.'
    })
}

/// Reads the structures of a file.
///
/// # Errors
/// If it cannot be read as DICOM.
pub(super) fn read_structures(
    name: &str,
    bytes: Vec<u8>,
    limits: &Limits,
) -> Result<OutlineFile, ReadImageError> {
    let reading = read_dicom_bytes(name, Arc::from(bytes), limits, &Progress::default());
    // Nobody stops a progress of its own.
    let reading = reading.map_err(|_| ReadImageError::Unsupported("stopped".to_owned()))?;
    if reading.contours.is_empty() {
        let reason = reading.left_out.into_iter().next().map(|out| out.reason);
        let none = || ReadImageError::Unsupported("it has no closed contours".to_owned());
        return Err(reason.unwrap_or_else(none));
    }
    Ok(outlines(reading.contours))
}

fn outlines(structures: Vec<ContouredStructure>) -> OutlineFile {
    let mut file = OutlineFile::default();
    for structure in structures {
        let part = match structure.part {
            Some("endocardium") => ContourPart::Endocardium,
            Some("epicardium") => ContourPart::Epicardium,
            Some("right ventricle") => ContourPart::RightCavity,
            // With or without its wall: only its author knows.
            Some("left ventricle") => {
                file.pass_over(
                    "structures of the left ventricle that are not said to be endo or epi",
                );
                continue;
            }
            _ => {
                file.pass_over("structures whose name says neither endo, epi nor right ventricle");
                continue;
            }
        };
        let images = structure.images.into_iter();
        for (points, image) in structure.polygons.into_iter().zip(images) {
            file.outlines.push(Outline {
                part,
                place: OutlinePlace::InWorld {
                    frame: image.map_or(FrameName::Unsaid, FrameName::Instance),
                    points,
                },
            });
        }
    }
    file
}
