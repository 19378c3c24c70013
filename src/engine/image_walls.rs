//! Images on disk to a study of walls in correspondence: each study by the road that fits it.

mod chosen;
mod contoured;
mod made;
mod masked;
mod settings;
mod studies;
mod subject;
#[cfg(test)]
mod tests;

use std::path::PathBuf;

use rayon::prelude::*;

use crate::analysis::preparation::Road;
use crate::engine::mask_walls::{label_classes, study_name};
use crate::io::{Limits, PassedOver, read_images_beside};
use crate::progress::{Progress, Stopped};
use made::made_of;
use studies::image_studies;

pub use settings::{ImageWallSettings, ImageWalls};
pub use subject::{prepared_subject, series_facts};

/// Makes the walls of all images below paths: outlines of other programs with the images that they were drawn in, masks known by
/// their names, then all other images, each DICOM study and each file being a study of its own. Where somebody must say more
/// first, the images come without walls. A study that cannot be made is one error, and the rest goes on.
///
/// # Errors
/// Only if it was asked to stop.
pub fn image_walls(
    paths: &[PathBuf],
    settings: &ImageWallSettings,
    limits: &Limits,
    progress: &Progress,
) -> Result<ImageWalls, Stopped> {
    let road = settings.road();
    let mut walls = ImageWalls::default();
    let mut passed_over = PassedOver::default();
    if matches!(road, None | Some(Road::Contours)) {
        let part = progress.part("looking for outlines", 0.0, 0.2);
        contoured::add(paths, settings, limits, &part, &mut walls, &mut passed_over)?;
    }
    let mut of_masks = Vec::new();
    if matches!(road, None | Some(Road::Masks(_))) {
        let part = progress.part("walls from masks", 0.2, 0.5);
        of_masks = masked::add(paths, settings, limits, &part, &mut walls, &mut passed_over)?;
    }
    let only_masks =
        matches!(road, Some(Road::Masks(_))) && !walls.opened.study.subjects.is_empty();
    if !only_masks {
        let part = progress.part("reading images", 0.5, 0.6);
        let (found, report) = read_images_beside(paths, &passed_over, limits, &part)?;
        // What is wrong with a mask is said once.
        let said = |path: &PathBuf| of_masks.contains(path);
        let errors = report.errors.into_iter().filter(|error| !said(&error.path));
        walls.opened.errors.extend(errors);
        walls.opened.notices.extend(report.notices);
        let studies = image_studies(found, settings, &walls);
        progress.begin_phase("walls from images", 0.6, 1.0);
        progress.expect_steps(studies.len());
        let made: Vec<_> = (studies.into_par_iter())
            .map(|study| {
                let made = made_of(study, settings, &progress.within())?;
                progress.step()?;
                Ok(made)
            })
            .collect::<Result<_, Stopped>>()?;
        for made in made {
            made.add_to(&mut walls);
        }
    }
    let study = &mut walls.opened.study;
    study.name = study_name(paths);
    study.label_classes = label_classes(&study.subjects);
    Ok(walls)
}
