//! Masks in a DICOM segmentation: a volume of labels, with what each label is.

use std::path::Path;
use std::sync::Arc;

use crate::io::dicom::{is_segmentation_head, read_dicom_bytes, segment_parts};
use crate::io::{ImageSeries, Limits, Modality, OpenError, read_head};
use crate::progress::{Progress, Stopped};

use super::read::MaskStudyError;

/// Bytes of a head that name the class of a DICOM file.
const HEAD: u64 = 4096;

/// Which labels stand for which tissue, where names say so.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NamedLabels {
    /// Cavity of the left ventricle.
    pub cavity: i32,
    /// Myocardium.
    pub wall: i32,
    /// Cavity of the right ventricle.
    pub right: Option<i32>,
}

/// Whether a file is a DICOM segmentation.
pub(super) fn is_segmentation(path: &Path) -> bool {
    read_head(path, HEAD).is_ok_and(|head| is_segmentation_head(&head))
}

/// Reads the labels of a segmentation, and which tissues they are.
///
/// # Errors
/// If it cannot be read, segments overlap or are fractions, or it was asked to stop.
pub(super) fn read_segmentation(
    path: &Path,
    limits: &Limits,
    progress: &Progress,
) -> Result<(ImageSeries, Option<NamedLabels>), MaskStudyError> {
    let wrong = |reason: String| OpenError {
        subject: None,
        path: path.to_owned(),
        reason,
    };
    let size = std::fs::metadata(path).map_or(0, |facts| facts.len());
    if size > limits.file_bytes {
        let most = limits.file_bytes;
        return Err(wrong(format!("{size} bytes; the limit is {most}")).into());
    }
    let bytes = std::fs::read(path).map_err(|error| wrong(error.kind().to_string()))?;
    let parts = segment_parts(bytes.clone(), limits).map_err(|error| wrong(error.to_string()))?;
    let stopped = |stopped: Stopped| MaskStudyError::Stopped(stopped);
    let reading = read_dicom_bytes("", Arc::from(bytes), limits, progress).map_err(stopped)?;
    if let [out, ..] = reading.left_out.as_slice() {
        return Err(wrong(out.reason.to_string()).into());
    }
    let mut series = reading.series;
    match (series.pop(), series.is_empty()) {
        (Some(one), true) if one.modality == Some(Modality::Segmentation) => {
            Ok((one, named(&parts)))
        }
        _ => Err(wrong(
            "its segments overlap or are fractions: labels are needed, one for each voxel"
                .to_owned(),
        )
        .into()),
    }
}

/// Labels of cavity and wall by the words of anatomy, if each is said of one segment alone.
fn named(parts: &[(u32, Option<&'static str>)]) -> Option<NamedLabels> {
    let only = |words: &[&str]| {
        let own =
            |(_, part): &&(u32, Option<&'static str>)| part.is_some_and(|p| words.contains(&p));
        let mut own = parts.iter().filter(own);
        match (own.next(), own.next()) {
            (Some((number, _)), None) => i32::try_from(*number).ok(),
            _ => None,
        }
    };
    Some(NamedLabels {
        cavity: only(&["left ventricle", "endocardium"])?,
        wall: only(&["myocardium"])?,
        right: only(&["right ventricle"]),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_are_named_where_words_are_of_one_segment_each() {
        let [cavity, wall, right] = [
            (7, Some("left ventricle")),
            (2, Some("myocardium")),
            (9, Some("right ventricle")),
        ];
        let expected = NamedLabels {
            cavity: 7,
            wall: 2,
            right: Some(9),
        };
        assert_eq!(named(&[wall, right, cavity, (3, None)]), Some(expected));
        assert_eq!(named(&[wall, cavity]).and_then(|labels| labels.right), None);
        assert_eq!(named(&[wall, (3, None)]), None);
        assert_eq!(named(&[wall, cavity, (8, Some("endocardium"))]), None);
    }
}
