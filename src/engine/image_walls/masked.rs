//! Masks that are known by the names of their files.

use std::collections::BTreeMap;
use std::path::PathBuf;

use super::{ImageWallSettings, ImageWalls};
use crate::analysis::preparation::{Preparation, Road};
use crate::engine::mask_walls::{MaskWallSettings, MaskWalls, mask_walls};
use crate::io::{Limits, OpenError, PassedOver, is_mask_file};
use crate::progress::{Progress, Stopped};

/// Adds the walls of all masks below paths, and passes over the files beside them from then on. A file that is a path itself is
/// one of masks if its name or its content says so, or if masks are asked for. Answers the files whose masks are wrong.
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
) -> Result<Vec<PathBuf>, Stopped> {
    let wanted = matches!(settings.road(), Some(Road::Masks(_)));
    let may_be = |path: &&PathBuf| path.is_dir() || wanted || is_mask_file(path);
    let paths: Vec<PathBuf> = paths.iter().filter(may_be).cloned().collect();
    if paths.is_empty() {
        return Ok(Vec::new());
    }
    let all = settings.of("", Preparation::default());
    let each = settings.each.iter();
    let each: BTreeMap<String, Preparation> = each
        .map(|(id, own)| (id.clone(), settings.over.over(own.clone())))
        .collect();
    let made = mask_walls(&paths, &MaskWallSettings { all, each }, limits, progress)?;
    let MaskWalls {
        study,
        fits,
        errors,
        notices,
        preparations,
        folders,
    } = made;
    for path in paths.iter().filter(|path| path.is_file()) {
        passed_over.add_file(path);
    }
    for folder in &folders {
        passed_over.add_files_of(folder);
    }
    // That a folder has no masks is no news: it may have images.
    let is_of_masks = |error: &OpenError| error.subject.is_some() || error.path.is_file();
    let of_masks: Vec<OpenError> = errors.into_iter().filter(is_of_masks).collect();
    let wrong = of_masks.iter().map(|error| error.path.clone()).collect();
    walls.opened.errors.extend(of_masks);
    walls.opened.notices.extend(notices);
    walls.opened.study.subjects.extend(study.subjects);
    walls.fits.extend(fits);
    walls.preparations.extend(preparations);
    Ok(wrong)
}
