//! Studies whose outlines were drawn in another program.

use std::path::PathBuf;
use std::sync::Arc;

use super::made::{Made, Outcome, failure, walls_of};
use super::{ImageWallSettings, ImageWalls};
use crate::analysis::preparation::{Preparation, PreparationError, Road, prepared};
use crate::analysis::walls_from_contours::stack_of_contours;
use crate::image::{Image, MarkedPoints};
use crate::io::{
    ContourStudy, ContourStudyError, ContouredImage, ImageSeries, Limits, OpenedImages, PassedOver,
    Provenance, find_contour_studies, read_contours,
};
use crate::progress::{Progress, Stopped};

/// Adds the walls of all outlines below paths, and passes over their files from then on.
///
/// # Errors
/// Only if it was asked to stop.
pub(super) fn add(
    paths: &[PathBuf],
    settings: &ImageWallSettings,
    limits: &Limits,
    progress: &Progress,
    walls: &mut ImageWalls,
    passed_over: &mut PassedOver,
) -> Result<(), Stopped> {
    let (found, errors) = find_contour_studies(paths, limits, progress)?;
    progress.expect_steps(found.len());
    for study in found {
        for path in study.images.iter().chain(&study.contours) {
            match path.is_dir() {
                true => passed_over.add_files_of(path),
                false => passed_over.add_file(path),
            }
        }
        let made = made(&study, settings, limits, &progress.within())?;
        made.add_to(walls);
        progress.step()?;
    }
    for error in errors {
        passed_over.add_file(&error.path);
        walls.opened.errors.push(error);
    }
    Ok(())
}

/// Walls of one subject's outlines.
fn made(
    study: &ContourStudy,
    settings: &ImageWallSettings,
    limits: &Limits,
    progress: &Progress,
) -> Result<Made, Stopped> {
    let failed = |error: &dyn std::fmt::Display| Made {
        images: None,
        outcome: Outcome::Failed(failure(&study.id, study.folder.clone(), error)),
    };
    let read = match read_contours(study, limits, progress) {
        Ok(read) => read,
        Err(ContourStudyError::Stopped(stopped)) => return Err(stopped),
        Err(ContourStudyError::File(mut error)) => {
            error.subject = Some(study.id.clone());
            return Ok(Made {
                images: None,
                outcome: Outcome::Failed(error),
            });
        }
        Err(error) => return Ok(failed(&error)),
    };
    let preparation = settings.of(&study.id, Preparation::of_road(Road::Contours));
    let preparation = with_what_was_drawn(preparation, &read);
    let (series, is_image) = match read.series {
        Some(series) => (series, true),
        None => match empty_series(&read) {
            Ok(series) => (series, false),
            Err(reason) => return Ok(failed(&reason)),
        },
    };
    let series = Arc::new(series);
    let outcome = match prepared(&series.image, &preparation, progress) {
        Ok(mut prepared) => {
            prepared
                .notices
                .splice(0..0, study.notices.iter().chain(&read.notices).cloned());
            walls_of(&study.id, &series, preparation, prepared)
        }
        Err(PreparationError::Stopped(stopped)) => return Err(stopped),
        Err(error) => failed(&error).outcome,
    };
    let made = match &outcome {
        Outcome::Walls(subject, ..) => Some(subject.sequence.id()),
        _ => None,
    };
    let images = OpenedImages {
        id: study.id.clone(),
        series: vec![series],
        notices: read.notices,
        made,
    };
    Ok(Made {
        images: is_image.then_some(images),
        outcome,
    })
}

/// The settings with the outlines of the files, unless they have some of their own, and points where none are marked.
fn with_what_was_drawn(mut settings: Preparation, read: &ContouredImage) -> Preparation {
    if settings.contours.is_empty() {
        settings.contours = Arc::new(read.contours.clone());
    }
    let (set, found) = (settings.points, read.points);
    settings.points = MarkedPoints {
        apex: set.apex.or(found.apex),
        base: set.base.or(found.base),
        septum: set.septum.or(found.septum),
        blood: set.blood.or(found.blood),
    };
    settings
}

/// A series without an image, on the grid that the planes of the outlines make.
fn empty_series(read: &ContouredImage) -> Result<ImageSeries, String> {
    let frame = stack_of_contours(&read.contours).map_err(|error| error.to_string())?;
    let last = read.contours.iter().map(|contour| contour.instant).max();
    let empty: Arc<[f32]> = vec![0.0; frame.voxel_count()].into();
    let volumes = vec![empty; last.map_or(0, |last| last + 1)];
    Ok(ImageSeries {
        name: "outlines".to_owned(),
        format: "outlines",
        modality: None,
        image: Image::new(frame, volumes, None).map_err(|error| error.to_string())?,
        gates: None,
        spacing: Provenance::Stated,
        times: Provenance::Missing,
        position_known: true,
        notices: Vec::new(),
    })
}
