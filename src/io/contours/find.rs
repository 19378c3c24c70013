//! Which outlines and images lie below paths, and which belong together.

use std::collections::{BTreeMap, HashSet};
use std::fs;
use std::path::{Path, PathBuf};

use super::formats::{ContourFormat, HEAD};
use crate::io::dicom::looks_like_dicom;
use crate::io::mask_study::is_mask_name;
use crate::io::open::unique_ids;
use crate::io::{Limits, OpenError, is_image_head, read_head};
use crate::progress::{Progress, Stopped};
use crate::study::{Notice, natural_order};

/// Images of one subject, and the files of outlines that were drawn in them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ContourStudy {
    /// Pseudonym: the name of the folder, or of the file of outlines where it stands alone.
    pub id: String,
    /// The folder that holds the images and the outlines.
    pub folder: PathBuf,
    /// Files of images, in natural order: none where outlines stand in the world without any.
    pub images: Vec<PathBuf>,
    /// Files of outlines, in natural order; at least one.
    pub contours: Vec<PathBuf>,
    /// What there is to say about its id.
    pub notices: Vec<Notice>,
}

/// Folders within folders that are looked into.
const DEEPEST: usize = 8;

/// Subjects with outlines among paths and in the folders below them, in natural order. Files are recognised by content, and
/// those of Sunnybrook by name. Outlines belong to the images of the nearest folder around them that has some; where none has,
/// to all images of the paths. Links are followed only if `limits` says so. Paths without outlines give nothing: they may
/// hold something else.
///
/// # Errors
/// Only [`Stopped`]. What cannot be used is in the second list.
pub fn find_contour_studies(
    paths: &[PathBuf],
    limits: &Limits,
    progress: &Progress,
) -> Result<(Vec<ContourStudy>, Vec<OpenError>), Stopped> {
    let mut walk = Walk {
        limits,
        progress,
        looked_at: 0,
        seen: HashSet::new(),
        images: Vec::new(),
        contours: Vec::new(),
        errors: Vec::new(),
    };
    for path in paths {
        if path.is_dir() {
            walk.folder(path, 0)?;
        } else {
            walk.file(path);
        }
    }
    let roots: Vec<&Path> = paths.iter().map(PathBuf::as_path).collect();
    Ok((studies(walk.contours, &walk.images, &roots), walk.errors))
}

struct Walk<'a> {
    limits: &'a Limits,
    progress: &'a Progress,
    looked_at: usize,
    seen: HashSet<PathBuf>,
    images: Vec<PathBuf>,
    contours: Vec<PathBuf>,
    errors: Vec<OpenError>,
}

impl Walk<'_> {
    fn fail(&mut self, path: &Path, reason: impl Into<String>) {
        self.errors.push(OpenError {
            subject: None,
            path: path.to_owned(),
            reason: reason.into(),
        });
    }

    fn folder(&mut self, folder: &Path, depth: usize) -> Result<(), Stopped> {
        let real = folder.canonicalize().unwrap_or_else(|_| folder.to_owned());
        if !self.seen.insert(real) {
            return Ok(());
        }
        if depth > DEEPEST {
            self.fail(
                folder,
                format!("more than {DEEPEST} folders within folders"),
            );
            return Ok(());
        }
        let entries = match fs::read_dir(folder) {
            Ok(entries) => entries,
            Err(error) => {
                self.fail(folder, error.kind().to_string());
                return Ok(());
            }
        };
        let mut names: Vec<(String, PathBuf)> = Vec::new();
        for entry in entries.flatten() {
            self.progress.check()?;
            if self.looked_at >= self.limits.image_files {
                self.fail(
                    folder,
                    "too many files and folders: not all of them were looked at; open a smaller folder",
                );
                break;
            }
            self.looked_at += 1;
            let name = entry.file_name().to_string_lossy().into_owned();
            names.push((name, entry.path()));
        }
        names.sort_by(|(a, _), (b, _)| natural_order(a, b).then_with(|| a.cmp(b)));
        for (name, path) in names {
            self.progress.check()?;
            if name.starts_with('.') || (path.is_symlink() && !self.limits.follow_links) {
                continue;
            }
            match path.is_dir() {
                true => self.folder(&path, depth + 1)?,
                false => self.file(&path),
            }
        }
        Ok(())
    }

    fn file(&mut self, path: &Path) {
        let real = path.canonicalize().unwrap_or_else(|_| path.to_owned());
        if !self.seen.insert(real) {
            return;
        }
        let head = match read_head(path, HEAD) {
            Ok(head) => head,
            Err(error) => return self.errors.push(error),
        };
        let name = name_of(path);
        if ContourFormat::of(&name, &head).is_some() {
            self.contours.push(path.to_owned());
        } else if looks_like_dicom(&head)
            || head.starts_with(b"PK\x03\x04")
            || (is_image_head(&head) && !is_mask_name(&name))
        {
            self.images.push(path.to_owned());
        }
    }
}

/// The last part of a path as text.
pub(super) fn name_of(path: &Path) -> String {
    let name = path.file_name().unwrap_or_default();
    name.to_string_lossy().into_owned()
}

/// Outlines by the folder of their images.
fn studies(contours: Vec<PathBuf>, images: &[PathBuf], roots: &[&Path]) -> Vec<ContourStudy> {
    let with_images: HashSet<&Path> = images.iter().flat_map(|path| path.ancestors()).collect();
    let mut groups: BTreeMap<Option<PathBuf>, Vec<PathBuf>> = BTreeMap::new();
    for path in contours {
        let within = |folder: &&Path| roots.iter().any(|root| folder.starts_with(root));
        let mut around = path.ancestors().skip(1).take_while(within);
        let home = around.find(|folder| with_images.contains(folder));
        groups
            .entry(home.map(Path::to_owned))
            .or_default()
            .push(path);
    }
    let mut found = Vec::new();
    for (home, contours) in groups {
        let own: Vec<PathBuf> = (images.iter())
            .filter(|image| home.as_ref().is_none_or(|home| image.starts_with(home)))
            .cloned()
            .collect();
        match home {
            Some(folder) => found.push(study(name_of(&folder), folder, own, contours)),
            None if own.is_empty() => found.extend(without_images(contours)),
            None => {
                let folder = common_folder(&contours);
                found.push(study(name_of(&folder), folder, own, contours));
            }
        }
    }
    found.sort_by(|a, b| natural_order(&a.folder.to_string_lossy(), &b.folder.to_string_lossy()));
    let named: Vec<(&str, &Path)> = (found.iter())
        .map(|study| (study.id.as_str(), study.folder.as_path()))
        .collect();
    let unique = unique_ids(&named);
    for (study, (id, notices)) in found.iter_mut().zip(unique) {
        study.id = id;
        study.notices = notices;
    }
    found
}

fn study(
    id: String,
    folder: PathBuf,
    images: Vec<PathBuf>,
    contours: Vec<PathBuf>,
) -> ContourStudy {
    ContourStudy {
        id,
        folder,
        images,
        contours,
        notices: Vec::new(),
    }
}

/// Outlines without images are a subject for each folder.
fn without_images(contours: Vec<PathBuf>) -> Vec<ContourStudy> {
    let mut folders: BTreeMap<PathBuf, Vec<PathBuf>> = BTreeMap::new();
    for path in contours {
        let folder = path.parent().unwrap_or(Path::new("")).to_owned();
        folders.entry(folder).or_default().push(path);
    }
    let each = folders.into_iter();
    each.map(|(folder, contours)| study(name_of(&folder), folder, Vec::new(), contours))
        .collect()
}

/// The folder of the first file that all lie in.
fn common_folder(paths: &[PathBuf]) -> PathBuf {
    let around = paths
        .iter()
        .take(1)
        .flat_map(|path| path.ancestors().skip(1));
    let mut around = around.filter(|folder| paths.iter().all(|path| path.starts_with(folder)));
    around.next().map(Path::to_owned).unwrap_or_default()
}
