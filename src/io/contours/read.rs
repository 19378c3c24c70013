//! Reads the outlines of one subject and the images that they were drawn in.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use super::find::{ContourStudy, name_of};
use super::formats::{ContourFormat, HEAD};
use super::images::Images;
use super::outline::{Outline, OutlineFile, OutlinePlace};
use super::placing::placed;
use crate::image::{Contour, MarkedPoints};
use crate::io::{ImageSeries, Limits, OpenError, ReadImageError};
use crate::progress::{Progress, Stopped};
use crate::study::Notice;

/// What was drawn, in the world of an image.
#[derive(Clone, Debug, PartialEq)]
pub struct ContouredImage {
    /// The series that was drawn in; `None` where outlines stand in the world and no image is there.
    pub series: Option<ImageSeries>,
    /// Outlines by the instants of the series; without one, by the frames that are drawn, in their order.
    pub contours: Vec<Contour>,
    /// Landmarks among what was drawn, in the world.
    pub points: MarkedPoints,
    /// What was left out or assumed.
    pub notices: Vec<Notice>,
}

/// Why outlines of a subject cannot be read.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ContourStudyError {
    /// It was asked to stop; no error to show.
    #[error(transparent)]
    Stopped(#[from] Stopped),
    /// A file cannot be read.
    #[error(transparent)]
    File(#[from] OpenError),
    /// The files hold no outlines that walls can be made of.
    #[error("no outlines of endocardium or epicardium in slices across{}", .left_out.as_deref().map_or_else(String::new, |what| format!(" ({what})")))]
    NoOutlines {
        /// What was left out, in words.
        left_out: Option<String>,
    },
    /// Outlines name images by number or unique name, and none of those is there.
    #[error(
        "{outlines} outlines were drawn in images that are not among those that were read ({images} series)"
    )]
    NoImages {
        /// How many name an image.
        outlines: usize,
        /// Series that were read.
        images: usize,
    },
    /// Outlines stand in the world at instants that the series does not have.
    #[error(
        "{outlines} outlines are of instants that the series does not have ({instants} volumes)"
    )]
    NoInstants {
        /// How many there are.
        outlines: usize,
        /// Volumes of the series that they lie in.
        instants: usize,
    },
}

/// Reads outlines and images of a subject, and finds the series in which most of the outlines lie. Other series are left out.
///
/// # Errors
/// If a file of outlines cannot be read, there are none of the left ventricle, they were drawn in other images, or it was
/// asked to stop.
pub fn read_contours(
    study: &ContourStudy,
    limits: &Limits,
    progress: &Progress,
) -> Result<ContouredImage, ContourStudyError> {
    let mut drawn = OutlineFile::default();
    let mut points = 0;
    for path in &study.contours {
        progress.check()?;
        let file = read_outlines(path, limits)?;
        points += points_of(&file.outlines);
        unless_too_many(points, limits, path)?;
        drawn.join(file);
    }
    let mut notices = drawn.notices();
    if drawn.outlines.is_empty() {
        let left_out = notices.iter().map(|notice| notice.text.clone());
        return Err(ContourStudyError::NoOutlines {
            left_out: left_out.reduce(|all, next| all + "; " + &next),
        });
    }
    let mut images = match study.images.is_empty() {
        true => Images::default(),
        false => Images::read(&study.images, limits, progress)??,
    };
    let placed = placed(&drawn.outlines, &images);
    let series = placed.series.filter(|&series| series < images.series.len());
    if placed.contours.is_empty() {
        let outlines = drawn.outlines.len();
        return Err(match series.and_then(|series| images.series.get(series)) {
            Some(series) if placed.homeless < outlines => ContourStudyError::NoInstants {
                outlines,
                instants: series.image.volumes().len(),
            },
            _ => ContourStudyError::NoImages {
                outlines,
                images: images.series.len(),
            },
        });
    }
    notices.append(&mut images.notices);
    notices.extend(placed.notices);
    if series.is_none() && !images.series.is_empty() {
        notices.push(Notice::warning(
            "the outlines lie in none of the images: they are used without one",
        ));
    }
    Ok(ContouredImage {
        series: series.map(|series| images.series.swap_remove(series)),
        contours: placed.contours,
        points: drawn.points,
        notices,
    })
}

/// Corners of all outlines.
fn points_of(outlines: &[Outline]) -> usize {
    let each = outlines.iter().map(|outline| match &outline.place {
        OutlinePlace::InImage { corners, .. } => corners.len(),
        OutlinePlace::InWorld { points, .. } => points.len(),
    });
    each.sum()
}

/// All points together are bounded as those of one file.
fn unless_too_many(count: usize, limits: &Limits, path: &Path) -> Result<(), OpenError> {
    if count <= limits.vertices {
        return Ok(());
    }
    let error = ReadImageError::TooMany {
        what: "points of contours in all files",
        count: count as u64,
        most: limits.vertices as u64,
    };
    Err(in_file(path, error.to_string()))
}

fn in_file(path: &Path, reason: String) -> OpenError {
    OpenError {
        subject: None,
        path: path.to_owned(),
        reason,
    }
}

/// Reads a file of outlines.
fn read_outlines(path: &Path, limits: &Limits) -> Result<OutlineFile, OpenError> {
    let mut bytes = Vec::new();
    // One byte more than may be read tells that there are too many.
    let read = File::open(path).and_then(|file| {
        let most = limits.file_bytes.saturating_add(1);
        file.take(most).read_to_end(&mut bytes)
    });
    read.map_err(|error| in_file(path, error.kind().to_string()))?;
    let head = bytes
        .get(..bytes.len().min(HEAD as usize))
        .unwrap_or_default();
    let name = name_of(path);
    let format = ContourFormat::of(&name, head)
        .ok_or_else(|| in_file(path, "no format of outlines that can be read".to_owned()))?;
    (format.read(&name, bytes, limits)).map_err(|error| in_file(path, error.to_string()))
}
