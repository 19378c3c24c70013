//! Masks in a DICOM segmentation: a volume of labels, with what each label is.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use crate::io::dicom::{is_segmentation_head, read_dicom_bytes, segment_parts};
use crate::io::{ImageSeries, Limits, Modality, OpenError, ReadImageError, read_head};
use crate::progress::{Progress, Stopped};

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

/// Labels, and which tissues they are.
pub(super) type LabelsOfFile = (ImageSeries, Option<NamedLabels>);

/// Reads the labels of a segmentation, and which tissues they are; or what is wrong with it.
///
/// # Errors
/// If it was asked to stop.
pub(super) fn read_segmentation(
    path: &Path,
    limits: &Limits,
    progress: &Progress,
) -> Result<Result<LabelsOfFile, OpenError>, Stopped> {
    let wrong = |reason: String| OpenError {
        subject: None,
        path: path.to_owned(),
        reason,
    };
    let (bytes, parts) = match bytes_and_parts(path, limits) {
        Ok(read) => read,
        Err(reason) => return Ok(Err(wrong(reason))),
    };
    let reading = read_dicom_bytes("", bytes.into(), limits, progress)?;
    if let [out, ..] = reading.left_out.as_slice() {
        return Ok(Err(wrong(out.reason.to_string())));
    }
    let mut series = reading.series;
    Ok(match (series.pop(), series.is_empty()) {
        (Some(one), true) if one.modality == Some(Modality::Segmentation) => {
            Ok((one, named(&parts)))
        }
        _ => Err(wrong(
            "its segments overlap or are fractions: one label for each voxel is needed".to_owned(),
        )),
    })
}

/// Segments with what they are.
type Parts = Vec<(u32, Option<&'static str>)>;

fn bytes_and_parts(path: &Path, limits: &Limits) -> Result<(Vec<u8>, Parts), String> {
    let mut bytes = Vec::new();
    // One byte more than may be read tells that there are too many.
    let read = File::open(path).and_then(|file| {
        let most = limits.file_bytes.saturating_add(1);
        file.take(most).read_to_end(&mut bytes)
    });
    read.map_err(|error| error.kind().to_string())?;
    let (size, most) = (bytes.len() as u64, limits.file_bytes);
    if size > most {
        return Err(ReadImageError::TooLarge { size, most }.to_string());
    }
    let parts = segment_parts(bytes.clone(), limits).map_err(|error| error.to_string())?;
    Ok((bytes, parts))
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
