//! Which images belong to one subject, and what it is called.

use std::collections::{BTreeMap, HashSet};
use std::path::{Path, PathBuf};

use super::chosen::chosen;
use super::{ImageWallSettings, ImageWalls};
use crate::analysis::preparation::Road;
use crate::io::{FoundImage, ImageSeries, is_mask_file};

/// The images of one subject to be.
#[derive(Debug)]
pub(super) struct ImageStudy {
    /// Pseudonym: the name of the file of images; DICOM studies, whose files and folders are often named after persons, are
    /// numbered.
    pub id: String,
    /// Where they come from, where it is one file.
    pub path: PathBuf,
    /// The series, at least one: that of which walls are made comes first.
    pub series: Vec<ImageSeries>,
}

/// Images by subjects, in the order in which they were found, each with an id that no other has.
pub(super) fn image_studies(
    found: Vec<FoundImage>,
    settings: &ImageWallSettings,
    walls: &ImageWalls,
) -> Vec<ImageStudy> {
    let road = settings.road();
    let by_masks = matches!(road, None | Some(Road::Masks(_)));
    let mut groups: Vec<(Option<usize>, PathBuf, Vec<ImageSeries>)> = Vec::new();
    let mut of_study: BTreeMap<usize, usize> = BTreeMap::new();
    for FoundImage {
        path,
        study,
        series,
    } in found
    {
        let path = path.unwrap_or_default();
        // On another road masks are no images.
        if !by_masks && is_mask_file(&path) {
            continue;
        }
        let place = study.and_then(|study| of_study.get(&study).copied());
        match place.and_then(|place| groups.get_mut(place)) {
            Some((_, _, group)) => group.push(series),
            None => {
                if let Some(study) = study {
                    of_study.insert(study, groups.len());
                }
                groups.push((study, path, vec![series]));
            }
        }
    }
    let subjects = walls.opened.study.subjects.iter();
    let images = walls.opened.images.iter().map(|images| images.id.clone());
    let mut taken: HashSet<String> = subjects.map(|s| s.id.clone()).chain(images).collect();
    let mut studies = Vec::new();
    let mut numbered = 0;
    for (study, path, series) in groups {
        let name = match study {
            None => file_stem(&path),
            Some(_) => {
                numbered += 1;
                format!("study{numbered}")
            }
        };
        let subjects = chosen(series, road);
        let several = subjects.len() > 1;
        for (number, series) in (1..).zip(subjects) {
            let name = match several {
                true => format!("{name}_{number}"),
                false => name.clone(),
            };
            studies.push(ImageStudy {
                id: own_id(&name, &mut taken),
                path: path.clone(),
                series,
            });
        }
    }
    studies
}

/// The name, with a number where another has it.
fn own_id(name: &str, taken: &mut HashSet<String>) -> String {
    let mut own = name.to_owned();
    let mut number = 2;
    while !taken.insert(own.clone()) {
        own = format!("{name} ({number})");
        number += 1;
    }
    own
}

/// The name of a file without its ending, and without that of a packed file.
fn file_stem(path: &Path) -> String {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let packed = name.len().checked_sub(3).filter(|&at| {
        name.get(at..)
            .is_some_and(|end| end.eq_ignore_ascii_case(".gz"))
    });
    let name = packed.and_then(|at| name.get(..at)).unwrap_or(&name);
    match name.rsplit_once('.') {
        Some((stem, _)) if !stem.is_empty() => stem.to_owned(),
        _ => name.to_owned(),
    }
}
