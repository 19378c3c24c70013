//! From dropped paths to a plan: folders are walked, manifests and series are read, loose files grouped.

use std::collections::{BTreeMap, HashSet};
use std::path::{Path, PathBuf};

use super::file_name::{mesh_name, surface_of_word};
use super::group_files::{LooseFile, group_files, stem};
use super::natural_order::natural_order;
use super::plan::{SeriesTimes, StudyPlan};
use super::read_file::{name_of, read_bytes, read_mesh_at, read_text};
use super::series_files::{is_series, read_series};
use crate::io::formats::{MANIFEST_EXTENSION, format_of_extension};
use crate::io::{Limits, OpenError, openable_extensions};
use crate::progress::{Progress, Stopped};
use crate::study::SurfaceKind;
use crate::study::checks::counted;

/// Folders within folders that are followed.
const DEEPEST: usize = 8;

/// The walk over all paths, with what it has found so far.
pub(super) struct Search<'a> {
    pub(super) limits: &'a Limits,
    pub(super) progress: &'a Progress,
    seen: HashSet<PathBuf>,
    /// Image files that were passed over.
    images: usize,
    pub(super) plan: StudyPlan,
}

/// What lies in a folder.
pub(super) struct Entries {
    pub(super) files: Vec<PathBuf>,
    pub(super) folders: Vec<PathBuf>,
}

/// What a file is for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FileRole {
    Manifest,
    Series,
    Mesh,
    /// A mesh only if its content says so.
    Table,
    Other,
}

pub(super) fn role(path: &Path) -> FileRole {
    let Some(ending) = path.extension().and_then(|ending| ending.to_str()) else {
        return FileRole::Other;
    };
    if name_of(path).eq_ignore_ascii_case("study.toml") {
        FileRole::Manifest
    } else if is_series(path) {
        FileRole::Series
    } else {
        match format_of_extension(ending) {
            Some(format) if format.often_other => FileRole::Table,
            Some(_) => FileRole::Mesh,
            None => FileRole::Other,
        }
    }
}

/// Whether opening this path can bring anything: a folder, or a file with an ending that is read.
pub fn looks_openable(path: &Path) -> bool {
    path.is_dir() || role(path) != FileRole::Other || is_manifest(path)
}

fn is_manifest(path: &Path) -> bool {
    path.extension()
        .is_some_and(|ending| ending.eq_ignore_ascii_case(MANIFEST_EXTENSION))
}

impl<'a> Search<'a> {
    pub(super) fn new(limits: &'a Limits, progress: &'a Progress) -> Self {
        Self {
            limits,
            progress,
            seen: HashSet::new(),
            images: 0,
            plan: StudyPlan::default(),
        }
    }

    /// Takes every path; files of one folder that come together belong together.
    pub(super) fn paths(&mut self, paths: &[PathBuf]) -> Result<(), Stopped> {
        let mut loose: BTreeMap<PathBuf, Vec<PathBuf>> = BTreeMap::new();
        for path in paths {
            self.progress.step()?;
            if path.is_dir() {
                if self.was_seen(path) {
                    continue;
                }
                let before = self.found();
                self.folder(path, 0)?;
                if self.found() == before {
                    self.fail(None, path, nothing_here(self.images));
                }
            } else if is_manifest(path) {
                self.manifest(path)?;
            } else {
                let folder = path.parent().unwrap_or(Path::new("")).to_owned();
                loose.entry(folder).or_default().push(path.clone());
            }
        }
        for (folder, files) in loose {
            let whole_name = match files.as_slice() {
                [one] => stem(one),
                _ => folder_name(&folder),
            };
            self.group(&folder, files, Vec::new(), &whole_name)?;
        }
        Ok(())
    }

    /// Whether a folder was walked already, by this or another way to it.
    fn was_seen(&self, folder: &Path) -> bool {
        self.seen.contains(&identity(folder))
    }

    fn found(&self) -> usize {
        self.plan.subjects.len() + self.plan.errors.len()
    }

    pub(super) fn fail(&mut self, subject: Option<String>, path: &Path, reason: impl Into<String>) {
        self.plan.errors.push(OpenError {
            subject,
            path: path.to_owned(),
            reason: reason.into(),
        });
    }

    /// A folder: its manifest if it has one, else its files and then its folders.
    pub(super) fn folder(&mut self, folder: &Path, depth: usize) -> Result<(), Stopped> {
        if depth > DEEPEST || self.was_seen(folder) {
            return Ok(());
        }
        self.seen.insert(identity(folder));
        let Entries { files, folders } = match self.entries(folder)? {
            Ok(entries) => entries,
            Err(reason) => {
                self.fail(None, folder, reason);
                return Ok(());
            }
        };
        if let Some(manifest) = files.iter().find(|path| role(path) == FileRole::Manifest) {
            let name_so_far = self.plan.name.clone();
            self.manifest(manifest)?;
            if depth > 0 {
                // The name of one study among others does not name them all.
                self.plan.name = name_so_far;
            }
            return Ok(());
        }
        let (sheets, folders): (Vec<PathBuf>, Vec<PathBuf>) = folders
            .into_iter()
            .partition(|folder| surface_of_word(&folder_name(folder)).is_some());
        let mut from_sheets = Vec::new();
        for sheet in sheets {
            if let (Some(kind), Ok(Entries { files, .. })) =
                (surface_of_word(&folder_name(&sheet)), self.entries(&sheet)?)
            {
                from_sheets.extend(files.into_iter().map(|file| (file, kind)));
            }
        }
        let mut usable = Vec::new();
        for file in files {
            match role(&file) {
                FileRole::Mesh | FileRole::Series => usable.push(file),
                FileRole::Table if self.is_mesh_table(&file) => usable.push(file),
                _ => self.images += usize::from(is_image(&file)),
            }
        }
        from_sheets.retain(|(file, _)| role(file) == FileRole::Mesh);
        self.group(folder, usable, from_sheets, &folder_name(folder))?;
        for folder in folders {
            self.folder(&folder, depth + 1)?;
        }
        Ok(())
    }

    /// Files and folders of a folder in natural order, without hidden ones.
    pub(super) fn entries(&self, folder: &Path) -> Result<Result<Entries, String>, Stopped> {
        let entries = match std::fs::read_dir(folder) {
            Ok(entries) => entries,
            Err(error) => return Ok(Err(super::read_file::reason(&error))),
        };
        let (mut files, mut folders) = (Vec::new(), Vec::new());
        for entry in entries.flatten() {
            self.progress.step()?;
            let path = entry.path();
            if name_of(&path).starts_with('.') || name_of(&path) == "__MACOSX" {
                continue;
            }
            if path.is_dir() {
                folders.push(path);
            } else {
                files.push(path);
            }
        }
        let by_name = |a: &PathBuf, b: &PathBuf| natural_order(&name_of(a), &name_of(b));
        files.sort_by(by_name);
        folders.sort_by(by_name);
        Ok(Ok(Entries { files, folders }))
    }

    /// Whether a CSV that merely lies there holds points and faces.
    fn is_mesh_table(&self, path: &Path) -> bool {
        read_bytes(path, self.limits)
            .and_then(|bytes| read_mesh_at(path, &bytes, self.limits))
            .is_ok()
    }

    /// Loose files of one folder, with those of its folders that are named after a sheet.
    pub(super) fn group(
        &mut self,
        folder: &Path,
        files: Vec<PathBuf>,
        from_sheets: Vec<(PathBuf, SurfaceKind)>,
        whole_name: &str,
    ) -> Result<(), Stopped> {
        let (lists, meshes): (Vec<PathBuf>, Vec<PathBuf>) =
            files.into_iter().partition(|path| is_series(path));
        let mut loose = Vec::new();
        let mut listed = HashSet::new();
        for list in lists {
            self.progress.step()?;
            match read_text(&list, self.limits).and_then(|text| read_series(&list, &text)) {
                Ok(series) => {
                    listed.extend(series.parts.iter().flatten().cloned());
                    let parts = series.parts.len();
                    for files in series.parts {
                        loose.push(LooseFile {
                            path: part_name(&list, &files, parts),
                            series: Some((files, SeriesTimes(series.times.clone()))),
                            folder_surface: None,
                        });
                    }
                }
                Err(reason) => self.fail(Some(stem(&list)), &list, reason),
            }
        }
        loose.extend(
            meshes
                .into_iter()
                .filter(|path| !listed.contains(path))
                .map(|path| (path, None))
                .chain(
                    from_sheets
                        .into_iter()
                        .map(|(path, kind)| (path, Some(kind))),
                )
                .map(|(path, folder_surface)| LooseFile {
                    path,
                    series: None,
                    folder_surface,
                }),
        );
        let (plans, errors) = group_files(loose, folder, whole_name);
        self.plan.subjects.extend(plans);
        self.plan.errors.extend(errors);
        Ok(())
    }
}

/// The name that tells what a part of a series is: the list's own, or that of its first file where
/// several parts share the list or only the file says which sheet it is.
fn part_name(list: &Path, files: &[PathBuf], parts: usize) -> PathBuf {
    let says_sheet = |path: &Path| mesh_name(&stem(path)).surface.is_some();
    match files.first() {
        Some(first) if parts > 1 || (says_sheet(first) && !says_sheet(list)) => first.clone(),
        _ => list.to_owned(),
    }
}

/// One path for all ways to a folder.
fn identity(folder: &Path) -> PathBuf {
    folder.canonicalize().unwrap_or_else(|_| folder.to_owned())
}

/// The last part of a folder's path, also of `.` and `..`.
pub(super) fn folder_name(folder: &Path) -> String {
    let name = name_of(folder);
    if !name.is_empty() {
        return name;
    }
    let whole = if folder.as_os_str().is_empty() {
        Path::new(".")
    } else {
        folder
    };
    whole
        .canonicalize()
        .map(|path| name_of(&path))
        .unwrap_or_default()
}

fn is_image(path: &Path) -> bool {
    let name = name_of(path).to_ascii_lowercase();
    [".nii", ".nii.gz", ".dcm", ".nrrd", ".mha"]
        .iter()
        .any(|ending| name.ends_with(ending))
}

fn nothing_here(images: usize) -> String {
    let endings = openable_extensions().join(", ");
    let images = match images {
        0 => String::new(),
        count => format!("; {} not read", counted(count, "image is", "images are")),
    };
    format!("no meshes found ({endings}){images}")
}
