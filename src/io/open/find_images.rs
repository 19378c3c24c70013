//! From paths to the files of images below them: volume files, and what may be DICOM; recognised by content.

use std::collections::HashSet;
use std::path::{Path, PathBuf};

use super::find_sequences::identity;
use super::folders::{Folders, What};
use super::read_file::{name_of, read_head};
use crate::io::dicom::looks_like_dicom;
use crate::io::image_formats::{PACKED_HEAD, image_format_names, is_image_head};
use crate::io::limits::MAX_IMAGE_FOLDER_DEPTH;
use crate::io::{Limits, OpenError};
use crate::progress::{Progress, Stopped};

/// Files of images, each once, in the order of the paths and then of the names.
#[derive(Debug, Default)]
pub(super) struct ImageFiles {
    pub volumes: Vec<PathBuf>,
    /// DICOM files, and archives that may hold some.
    pub dicom: Vec<PathBuf>,
    /// Files of folders that are of no format of images.
    pub others: Vec<PathBuf>,
    pub errors: Vec<OpenError>,
    /// Whether more was there than may be looked at.
    pub cut_short: bool,
}

/// What is passed over although it may be an image, because something else is made of it.
#[derive(Clone, Debug, Default)]
pub struct PassedOver {
    files: HashSet<PathBuf>,
    folders: HashSet<PathBuf>,
}

impl PassedOver {
    /// Passes over a file.
    pub fn add_file(&mut self, path: &Path) {
        self.files.insert(identity(path));
    }

    /// Passes over the files of a folder; folders within it are looked through.
    pub fn add_files_of(&mut self, folder: &Path) {
        self.folders.insert(identity(folder));
    }

    fn is_empty(&self) -> bool {
        self.files.is_empty() && self.folders.is_empty()
    }

    fn holds(&self, path: &Path) -> bool {
        let real = identity(path);
        let folder = real
            .parent()
            .is_some_and(|folder| self.folders.contains(folder));
        folder || self.files.contains(&real)
    }
}

/// Looks through paths and the folders among them. Hidden files are passed over, and so is what `passed_over` names.
///
/// # Errors
/// Only [`Stopped`].
pub(super) fn find_images(
    paths: &[PathBuf],
    passed_over: &PassedOver,
    limits: &Limits,
    progress: &Progress,
) -> Result<ImageFiles, Stopped> {
    let mut walk = Walk {
        passed_over,
        folders: Folders::new(paths, limits.follow_links),
        limits,
        progress,
        seen: HashSet::new(),
        found: ImageFiles::default(),
    };
    for path in paths {
        if path.is_dir() {
            let before = walk.found.count();
            walk.folder(path, 0)?;
            if walk.found.count() == before && passed_over.is_empty() {
                walk.fail(path, "no images were found here");
            }
        } else {
            walk.asked_for(path)?;
        }
    }
    walk.found.cut_short |= walk.folders.exhausted();
    Ok(walk.found)
}

impl ImageFiles {
    fn count(&self) -> usize {
        self.volumes.len() + self.dicom.len() + self.errors.len()
    }
}

/// What a file is, by its first bytes.
enum Role {
    Volume,
    Dicom,
    Other,
}

fn role(head: &[u8]) -> Role {
    if is_image_head(head) {
        Role::Volume
    } else if looks_like_dicom(head) || head.starts_with(b"PK\x03\x04") {
        Role::Dicom
    } else {
        Role::Other
    }
}

struct Walk<'a> {
    passed_over: &'a PassedOver,
    folders: Folders,
    limits: &'a Limits,
    progress: &'a Progress,
    /// Real paths of files and folders that were looked at.
    seen: HashSet<PathBuf>,
    found: ImageFiles,
}

impl Walk<'_> {
    fn fail(&mut self, path: &Path, reason: impl Into<String>) {
        self.found.errors.push(OpenError {
            subject: None,
            path: path.to_owned(),
            reason: reason.into(),
        });
    }

    /// Whether this is the first way to it.
    fn is_new(&mut self, path: &Path) -> bool {
        self.seen.insert(identity(path))
    }

    /// A file that was named itself: what it holds must be an image, or the values of a pair.
    fn asked_for(&mut self, path: &Path) -> Result<(), Stopped> {
        self.progress.check()?;
        if self.passed_over.holds(path) || !self.is_new(path) {
            return Ok(());
        }
        let head = match read_head(path, PACKED_HEAD) {
            Ok(head) => head,
            Err(error) => {
                self.found.errors.push(error);
                return Ok(());
            }
        };
        match (role(&head), header_of_pair(path)) {
            (Role::Volume, _) => self.found.volumes.push(path.to_owned()),
            (_, Some(header)) => {
                if self.is_new(&header) {
                    self.found.volumes.push(header);
                }
            }
            (Role::Dicom, None) => self.found.dicom.push(path.to_owned()),
            (Role::Other, None) => self.fail(
                path,
                format!(
                    "not an image format that can be read ({}, DICOM)",
                    image_format_names().join(", ")
                ),
            ),
        }
        Ok(())
    }

    fn folder(&mut self, folder: &Path, depth: usize) -> Result<(), Stopped> {
        if !self.is_new(folder) {
            return Ok(());
        }
        if depth > MAX_IMAGE_FOLDER_DEPTH {
            self.fail(
                folder,
                format!("more than {MAX_IMAGE_FOLDER_DEPTH} folders within folders"),
            );
            return Ok(());
        }
        let listing = match self.folders.list(folder, self.progress)? {
            Ok(listing) => listing,
            Err(reason) => {
                self.fail(folder, reason);
                return Ok(());
            }
        };
        for entry in &listing.entries {
            if entry.name.starts_with('.') {
                continue;
            }
            match self.folders.followed(entry) {
                What::File => self.file(&entry.path)?,
                What::Folder | What::LinkedFolder => self.folder(&entry.path, depth + 1)?,
                What::Unusable(reason) => self.fail(&entry.path, reason),
                What::Link => {}
            }
        }
        Ok(())
    }

    /// A file of a folder: others than images are counted.
    fn file(&mut self, path: &Path) -> Result<(), Stopped> {
        self.progress.check()?;
        if self.seen.len() >= self.limits.image_files {
            self.found.cut_short = true;
            return Ok(());
        }
        if self.passed_over.holds(path) || !self.is_new(path) {
            return Ok(());
        }
        match read_head(path, PACKED_HEAD) {
            Ok(head) => match role(&head) {
                Role::Volume => self.found.volumes.push(path.to_owned()),
                Role::Dicom => self.found.dicom.push(path.to_owned()),
                Role::Other => self.found.others.push(path.to_owned()),
            },
            Err(error) => self.found.errors.push(error),
        }
        Ok(())
    }
}

/// The header of a pair whose values are in this file (`.img`), if it is there.
fn header_of_pair(path: &Path) -> Option<PathBuf> {
    let name = name_of(path);
    let lower = name.to_ascii_lowercase();
    let stem = lower
        .strip_suffix(".gz")
        .unwrap_or(&lower)
        .strip_suffix(".img")?;
    let stem = name.get(..stem.len())?;
    let headers =
        ["hdr", "HDR", "hdr.gz"].map(|ending| path.with_file_name(format!("{stem}.{ending}")));
    headers.into_iter().find(|header| header.is_file())
}
