//! The images in which outlines lie: series, and which file or unique name each of their slices has.

use std::collections::HashMap;
use std::path::PathBuf;

use super::outline::ImageName;
use crate::io::dicom::looks_like_dicom;
use crate::io::dicom::{DicomReading, SliceSource, read_dicom};
use crate::io::{ImageSeries, Limits, OpenError, read_head, read_image_file};
use crate::progress::{Progress, Stopped};
use crate::study::Notice;
use crate::study::checks::counted;

/// Where the image of a slice went.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct SlicePlace {
    pub series: usize,
    pub slice: usize,
    pub instant: usize,
}

/// Series with the names of their slices.
#[derive(Default)]
pub(super) struct Images {
    pub series: Vec<ImageSeries>,
    /// `None` where two images have one name.
    names: HashMap<ImageName, Option<SlicePlace>>,
    pub notices: Vec<Notice>,
}

impl Images {
    /// Reads files of images.
    ///
    /// # Errors
    /// If it was asked to stop, or none of the files can be read.
    pub(super) fn read(
        paths: &[PathBuf],
        limits: &Limits,
        progress: &Progress,
    ) -> Result<Result<Self, OpenError>, Stopped> {
        let mut images = Self::default();
        let mut errors = Vec::new();
        let (mut dicom, mut volumes) = (Vec::new(), Vec::new());
        for path in paths {
            match read_head(path, 256) {
                Ok(head) if looks_like_dicom(&head) || head.starts_with(b"PK\x03\x04") => {
                    dicom.push(path.clone());
                }
                Ok(_) => volumes.push(path),
                Err(error) => errors.push(error),
            }
        }
        if !dicom.is_empty() {
            images.take_dicom(read_dicom(&dicom, limits, progress)?);
        }
        let mut voxels: u64 = images.series.iter().map(voxels_of).sum();
        for path in volumes {
            progress.check()?;
            match read_image_file(path, limits) {
                Ok(series) if voxels + voxels_of(&series) <= limits.voxels_in_all => {
                    voxels += voxels_of(&series);
                    images.series.push(series);
                }
                Ok(_) => errors.push(OpenError {
                    subject: None,
                    path: path.clone(),
                    reason: "too many voxels with those of the images before it".to_owned(),
                }),
                Err(error) => errors.push(error),
            }
        }
        if images.series.is_empty()
            && let Some(error) = errors.into_iter().next()
        {
            return Ok(Err(error));
        }
        Ok(Ok(images))
    }

    fn take_dicom(&mut self, reading: DicomReading) {
        for source in &reading.sources {
            self.name(ImageName::Instance(source.instance.clone()), source);
            let name = reading
                .files
                .get(source.file)
                .and_then(|name| last_number(name));
            if let Some(number) = name {
                self.name(ImageName::Number(number), source);
            }
        }
        for out in &reading.left_out {
            self.notices.push(Notice::warning(format!(
                "DICOM, {} left out: {}",
                counted(out.count, "image", "images"),
                out.reason
            )));
        }
        self.series = reading.series;
    }

    fn name(&mut self, name: ImageName, source: &SliceSource) {
        let place = SlicePlace {
            series: source.series,
            slice: source.slice,
            instant: source.instant,
        };
        let known = self.names.entry(name).or_insert(Some(place));
        if *known != Some(place) {
            *known = None;
        }
    }

    /// Where an image went; `None` if there is none of this name, or several.
    pub(super) fn place(&self, name: &ImageName) -> Option<SlicePlace> {
        self.names.get(name).copied().flatten()
    }
}

/// Voxels of all volumes.
fn voxels_of(series: &ImageSeries) -> u64 {
    let image = &series.image;
    (image.frame().voxel_count() as u64).saturating_mul(image.volumes().len() as u64)
}

/// The last number in the name of a file without its ending: 20 of `20.dcm` and of `IM-0001-0020.dcm`.
fn last_number(name: &str) -> Option<u32> {
    let stem = name.rsplit_once('.').map_or(name, |(stem, _)| stem);
    let start = stem.trim_end_matches(|c: char| c.is_ascii_digit()).len();
    stem.get(start..)?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_are_numbered_by_the_ends_of_their_names() {
        assert_eq!(last_number("20.dcm"), Some(20));
        assert_eq!(last_number("IM-0001-0020.dcm"), Some(20));
        assert_eq!(last_number("IM00007"), Some(7));
        assert_eq!(last_number("scan.dcm"), None);
        assert_eq!(last_number("99999999999999.dcm"), None);
    }
}
