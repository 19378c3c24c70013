//! Reads the images below paths: volume files, and series of DICOM files.

use std::collections::HashSet;
use std::path::{Component, Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use rayon::prelude::*;

use super::find_images::{ImageFiles, PassedOver, find_images};
use super::read_file::{name_of, read_bytes, unless_it_panics};
use crate::io::dicom::{ContouredStructure, read_dicom};
use crate::io::image_file::ImageSeries;
use crate::io::image_formats::read_image;
use crate::io::{Limits, OpenError, ReadImageError};
use crate::progress::{Progress, Stopped};
use crate::study::Notice;
use crate::study::checks::counted;

/// One series that was found.
#[derive(Clone, Debug, PartialEq)]
pub struct FoundImage {
    /// The file that it was read from; `None` where many files make a series.
    pub path: Option<PathBuf>,
    /// The study that it belongs to, counted from 0, where files say such a thing: series of one study are of one subject.
    pub study: Option<usize>,
    /// What it holds.
    pub series: ImageSeries,
}

/// What was found beside the series.
#[derive(Clone, Debug, Default)]
pub struct ImageReport {
    /// One for each file or folder that could not be read.
    pub errors: Vec<OpenError>,
    /// What was left out, and why.
    pub notices: Vec<Notice>,
}

/// Files that are read at the same time, and their bytes: what is read but not yet handed on stays small.
const AT_ONCE: (usize, u64) = (4, 32 << 20);

/// Reads all images of paths and of the folders among them.
///
/// Formats are recognised by content. Links out of the paths are not followed unless `limits` says so. All series together
/// have at most `limits.voxels_in_all` voxels: those beyond are errors.
///
/// # Errors
/// Only [`Stopped`].
pub fn read_images(
    paths: &[PathBuf],
    limits: &Limits,
    progress: &Progress,
) -> Result<(Vec<FoundImage>, ImageReport), Stopped> {
    read_images_beside(paths, &PassedOver::default(), limits, progress)
}

/// As [`read_images`], without what something else is made of.
///
/// # Errors
/// Only [`Stopped`].
pub fn read_images_beside(
    paths: &[PathBuf],
    passed_over: &PassedOver,
    limits: &Limits,
    progress: &Progress,
) -> Result<(Vec<FoundImage>, ImageReport), Stopped> {
    let (mut found, mut held) = (Vec::new(), 0_u64);
    let mut beyond = Vec::new();
    let mut report = each_image_beside(paths, passed_over, limits, progress, &mut |image| {
        held = held.saturating_add(voxels(&image.series));
        if held <= limits.voxels_in_all {
            found.push(image);
            return;
        }
        held = held.saturating_sub(voxels(&image.series));
        let too_many = ReadImageError::TooMany {
            what: "voxels with those of the images before it",
            count: held.saturating_add(voxels(&image.series)),
            most: limits.voxels_in_all,
        };
        beyond.push(OpenError {
            subject: None,
            path: image.path.unwrap_or_default(),
            reason: too_many.to_string(),
        });
    })?;
    report.errors.append(&mut beyond);
    Ok((found, report))
}

/// As [`read_images`], with each series handed to `visit` as soon as it is read: memory is that of a few of them, whatever
/// their number. Series come in the order of the paths and names, DICOM series last.
///
/// # Errors
/// Only [`Stopped`].
pub fn each_image(
    paths: &[PathBuf],
    limits: &Limits,
    progress: &Progress,
    visit: &mut dyn FnMut(FoundImage),
) -> Result<ImageReport, Stopped> {
    each_image_beside(paths, &PassedOver::default(), limits, progress, visit)
}

fn each_image_beside(
    paths: &[PathBuf],
    passed_over: &PassedOver,
    limits: &Limits,
    progress: &Progress,
    visit: &mut dyn FnMut(FoundImage),
) -> Result<ImageReport, Stopped> {
    progress.begin_phase("looking for images", 0.0, 0.1);
    let files = find_images(paths, passed_over, limits, progress)?;
    let mut report = ImageReport {
        errors: files.errors.clone(),
        notices: Vec::new(),
    };
    progress.begin_phase("reading images", 0.1, 0.6);
    progress.expect_steps(files.volumes.len());
    let values = Mutex::new(HashSet::new());
    let mut rest = &files.volumes[..];
    while !rest.is_empty() {
        let (now, later) = rest.split_at(batch(rest));
        rest = later;
        let read: Vec<Result<ImageSeries, String>> = now
            .par_iter()
            .map(|path| read_image_at(path, limits, &values))
            .collect();
        for (path, outcome) in now.iter().zip(read) {
            progress.step()?;
            match outcome {
                Ok(series) => visit(FoundImage {
                    path: Some(path.clone()),
                    study: None,
                    series,
                }),
                Err(reason) => report.errors.push(OpenError {
                    subject: None,
                    path: path.clone(),
                    reason,
                }),
            }
        }
    }
    let values = values.into_inner().unwrap_or_else(PoisonError::into_inner);
    report.notices.extend(left_out(&files, &values));
    let dicom: Vec<PathBuf> = files
        .dicom
        .into_iter()
        .filter(|path| !values.contains(path))
        .collect();
    dicom_series(
        &dicom,
        limits,
        &progress.part("reading DICOM", 0.6, 1.0),
        &mut report,
        visit,
    )?;
    Ok(report)
}

fn voxels(series: &ImageSeries) -> u64 {
    let image = &series.image;
    (image.frame().voxel_count() as u64).saturating_mul(image.volumes().len() as u64)
}

/// How many of the next files are read at the same time.
fn batch(files: &[PathBuf]) -> usize {
    let (max_files, max_bytes) = AT_ONCE;
    let mut bytes = 0_u64;
    let fits = |path: &&PathBuf| {
        let size = std::fs::metadata(path).map_or(0, |facts| facts.len());
        bytes = bytes.saturating_add(size);
        bytes <= max_bytes
    };
    files.iter().take(max_files).take_while(fits).count().max(1)
}

/// Reads one volume file, with the files beside it that hold its values.
///
/// # Errors
/// With what is wrong and where.
pub fn read_image_file(path: &Path, limits: &Limits) -> Result<ImageSeries, OpenError> {
    read_image_at(path, limits, &Mutex::default()).map_err(|reason| OpenError {
        subject: None,
        path: path.to_owned(),
        reason,
    })
}

/// Reads one volume file and notes which files hold its values.
fn read_image_at(
    path: &Path,
    limits: &Limits,
    values: &Mutex<HashSet<PathBuf>>,
) -> Result<ImageSeries, String> {
    let bytes = read_bytes(path, limits)?;
    let folder = path.parent().unwrap_or(Path::new(""));
    let sibling = |name: &str| {
        let relative = Path::new(name);
        let stays_inside = |part| matches!(part, Component::Normal(_) | Component::CurDir);
        if !relative.components().all(stays_inside) {
            return Err("it lies in another folder: put it beside the header".to_owned());
        }
        let place: PathBuf = folder.join(relative).components().collect();
        let bytes = read_bytes(&place, limits)?;
        values
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .insert(place);
        Ok(bytes)
    };
    unless_it_panics(|| read_image(&name_of(path), &bytes, limits, &sibling))?
        .map_err(|error| error.to_string())
}

/// What was passed over in folders.
fn left_out(files: &ImageFiles, values: &HashSet<PathBuf>) -> Vec<Notice> {
    let mut notices = Vec::new();
    let others = files
        .others
        .iter()
        .filter(|path| !values.contains(*path))
        .count();
    if others > 0 {
        notices.push(Notice::info(format!(
            "{} of other formats left out",
            counted(others, "file", "files")
        )));
    }
    if files.cut_short {
        notices.push(Notice::warning(
            "too many files and folders: not all of them were looked at; open a smaller folder",
        ));
    }
    notices
}

/// What a structure of contours holds; it is no image.
fn contours(structure: &ContouredStructure) -> Notice {
    let points: usize = structure.polygons.iter().map(Vec::len).sum();
    Notice::info(format!(
        "contours {} ({}): {}, {}",
        structure.number,
        structure.part.unwrap_or("of an unknown part"),
        counted(structure.polygons.len(), "polygon", "polygons"),
        counted(points, "point", "points"),
    ))
}

/// The series of DICOM files.
fn dicom_series(
    files: &[PathBuf],
    limits: &Limits,
    progress: &Progress,
    report: &mut ImageReport,
    visit: &mut dyn FnMut(FoundImage),
) -> Result<(), Stopped> {
    let [first, ..] = files else {
        return Ok(());
    };
    let reading = read_dicom(files, limits, progress)?;
    let nothing = reading.series.is_empty() && reading.contours.is_empty();
    report.notices.extend(reading.contours.iter().map(contours));
    let path = (files.len() == 1).then(|| first.clone());
    let studies = reading.studies.iter().copied().map(Some);
    let studies = studies.chain(std::iter::repeat(None));
    for (series, study) in reading.series.into_iter().zip(studies) {
        visit(FoundImage {
            path: path.clone(),
            study,
            series,
        });
    }
    for out in reading.left_out {
        let text = format!(
            "DICOM, {} left out: {}",
            counted(out.count, "image", "images"),
            out.reason
        );
        if nothing {
            let folder = if files.len() == 1 {
                Some(first.as_path())
            } else {
                first.parent()
            };
            report.errors.push(OpenError {
                subject: None,
                path: folder.unwrap_or(first).to_owned(),
                reason: text,
            });
        } else {
            report.notices.push(Notice::warning(text));
        }
    }
    Ok(())
}
