//! What one file holds: planes to be stacked, or whole volumes.

use std::sync::Arc;

use super::contours::{ContouredStructure, structures};
use super::file::DicomFile;
use super::functional_groups::FunctionalGroups;
use super::layout::unsupported;
use super::nuclear::nuclear_series;
use super::pixels::Pixels;
use super::plane::{FileFacts, Plane};
use super::segmentation::segmentation_series;
use super::tag::{DIRECTORY, FRAME_TIME, FRAME_TIME_VECTOR, NUMBER_OF_FRAMES, SEGMENTATION_TYPE};
use crate::io::image_file::{ImageSeries, ReadImageError};
use crate::io::limits::Limits;

/// What one file holds.
pub(super) enum Contents {
    /// Frames, and their times where a film says them.
    Planes(Vec<Plane>, Option<Vec<f64>>),
    /// Volumes that are complete in this file.
    Volumes(Box<VolumeFile>),
    /// Contours of structures.
    Contours(Vec<ContouredStructure>),
}

/// A file of complete volumes whose pixels are still packed.
pub(super) struct VolumeFile {
    file: DicomFile,
    facts: Arc<FileFacts>,
    pixels: Arc<Pixels>,
}

impl VolumeFile {
    /// What it says of itself.
    pub(super) fn facts(&self) -> &FileFacts {
        &self.facts
    }

    /// The volumes, of `most` voxels at most.
    ///
    /// # Errors
    /// If frames and what is said of them do not make volumes, or cannot be unpacked.
    pub(super) fn series(&self, most: u64) -> Result<Vec<ImageSeries>, ReadImageError> {
        let set = self.file.data_set();
        let count = self.pixels.layout.pixels_in_all();
        if count > most {
            let what = "voxels";
            return Err(ReadImageError::TooMany { what, count, most });
        }
        if is_nuclear(&self.facts) {
            return Ok(vec![nuclear_series(&set, &self.facts, &self.pixels)?]);
        }
        let groups = FunctionalGroups::new(&set)
            .ok_or_else(|| unsupported("it does not say where its segments are"))?;
        segmentation_series(&set, &groups, &self.facts, &self.pixels, most)
    }
}

fn is_nuclear(facts: &FileFacts) -> bool {
    facts.class == NUCLEAR || facts.class == NUCLEAR_RETIRED
}

/// Nuclear medicine image storage.
const NUCLEAR: &str = "1.2.840.10008.5.1.4.1.1.20";
/// Its retired forerunner.
const NUCLEAR_RETIRED: &str = "1.2.840.10008.5.1.4.1.1.5";
/// Contours of radiotherapy (RTSTRUCT).
const STRUCTURE_SET: &str = "1.2.840.10008.5.1.4.1.1.481.3";

/// Classes that are no images, by the beginning of their names.
const NO_IMAGES: [(&str, &str); 6] = [
    (
        "1.2.840.10008.5.1.4.1.1.481.5",
        "a plan of radiotherapy (RTPLAN)",
    ),
    (
        "1.2.840.10008.5.1.4.1.1.481.8",
        "a plan of radiotherapy (RTPLAN)",
    ),
    ("1.2.840.10008.5.1.4.1.1.88.", "a report (SR)"),
    (
        "1.2.840.10008.5.1.4.1.1.11.",
        "a way of showing images (PR)",
    ),
    ("1.2.840.10008.5.1.4.1.1.104.", "a document"),
    (
        "1.2.840.10008.5.1.4.1.1.9.",
        "a curve over time (such as an ECG)",
    ),
];

/// Takes a file apart. `number` is its place in the order of the files.
///
/// # Errors
/// If it is damaged, holds no grey values, or is of a kind that is no image of a place.
pub(super) fn contents(
    bytes: Vec<u8>,
    number: usize,
    limits: &Limits,
) -> Result<Contents, ReadImageError> {
    let file = DicomFile::new(bytes, limits.file_bytes)?;
    let set = file.data_set();
    let facts = Arc::new(FileFacts::new(&set, number));
    if set.has(DIRECTORY) {
        return Err(unsupported(
            "a list of files (DICOMDIR), which is not needed",
        ));
    }
    if facts.class == STRUCTURE_SET {
        return Ok(Contents::Contours(structures(&set, limits.vertices)?));
    }
    if let Some((_, what)) = NO_IMAGES
        .iter()
        .find(|(class, _)| facts.class.starts_with(class))
    {
        return Err(unsupported(format!("{what}, not an image")));
    }
    if facts.is_kind("MOSAIC") {
        return Err(unsupported("a mosaic: slices as tiles of one picture"));
    }
    if set.has(NUMBER_OF_FRAMES) && set.count(NUMBER_OF_FRAMES).is_none() {
        return Err(ReadImageError::InField {
            field: "NumberOfFrames",
            reason: "it is no whole number".to_owned(),
        });
    }
    let most = usize::try_from(limits.voxels).unwrap_or(usize::MAX);
    let pixels = Arc::new(Pixels::new(&file, most)?);
    if is_nuclear(&facts) || set.has(SEGMENTATION_TYPE) {
        drop(set);
        let whole = VolumeFile {
            file,
            facts,
            pixels,
        };
        return Ok(Contents::Volumes(Box::new(whole)));
    }
    let groups = FunctionalGroups::new(&set);
    let frames = pixels.layout.frames;
    if let Some(groups) = groups {
        return Ok(Contents::Planes(groups.planes(&set, &facts, &pixels), None));
    }
    let mut planes: Vec<Plane> = (0..frames)
        .map(|frame| Plane::new(&facts, &pixels, frame, &[&set]))
        .collect();
    if frames > 1 {
        // One position for all frames says where none but the first of them stands, unless they are a film.
        let film = film_times(
            frames,
            set.number(FRAME_TIME),
            set.numbers(FRAME_TIME_VECTOR),
        );
        if film.is_none() {
            planes.iter_mut().for_each(|plane| plane.place = None);
        }
        return Ok(Contents::Planes(planes, film));
    }
    Ok(Contents::Planes(planes, None))
}

/// The time of each frame of a film in milliseconds: even steps, or the steps that it lists.
fn film_times(frames: usize, step: Option<f64>, steps: Option<Vec<f64>>) -> Option<Vec<f64>> {
    if let Some(step) = step.filter(|&step| step > 0.0) {
        return Some((0..frames).map(|frame| frame as f64 * step).collect());
    }
    let steps = steps.filter(|steps| steps.len() == frames)?;
    let mut time = 0.0;
    let times = steps.iter().skip(1).map(|step| {
        time += step;
        (*step > 0.0).then_some(time)
    });
    [Some(0.0)].into_iter().chain(times).collect()
}
