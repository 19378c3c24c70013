//! From dropped paths to a plan: folders are walked, manifests and lists are read, loose files grouped.

use std::collections::{BTreeMap, HashMap, HashSet};
use std::path::{Path, PathBuf};

use super::folder_contents::{Entries, FileRole, Loose, Sheets, folder_name, role};
use super::folders::{Folders, What};
use super::group_files::stem;
use super::plan::StudyPlan;
use super::read_file::{name_of, read_text};
use super::series_files::{Series, SeriesFault, is_series, read_series};
use crate::io::formats::MANIFEST_EXTENSION;
use crate::io::limits::{MAX_ENTRIES, MAX_MESH_FOLDER_DEPTH};
use crate::io::{Limits, OpenError, openable_extensions};
use crate::progress::{Progress, Stopped};
use crate::study::checks::counted;
use crate::study::{Notice, natural_order};

/// The walk over all paths, with what it has found so far.
pub(super) struct Search<'a> {
    pub(super) limits: &'a Limits,
    pub(super) progress: &'a Progress,
    pub(super) folders: Folders,
    seen: HashSet<PathBuf>,
    /// Lists of files that were read, each once.
    lists: HashMap<PathBuf, Result<Series, SeriesFault>>,
    /// Files that lists name, with the first list that does.
    listed: HashMap<PathBuf, PathBuf>,
    /// Image files that were passed over.
    images: usize,
    pub(super) plan: StudyPlan,
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
    pub(super) fn new(paths: &[PathBuf], limits: &'a Limits, progress: &'a Progress) -> Self {
        Self {
            limits,
            progress,
            folders: Folders::new(paths, limits.follow_links),
            seen: HashSet::new(),
            lists: HashMap::new(),
            listed: HashMap::new(),
            images: 0,
            plan: StudyPlan::default(),
        }
    }

    /// Takes every path; files of one folder that come together belong together.
    pub(super) fn paths(&mut self, paths: &[PathBuf]) -> Result<(), Stopped> {
        // Lists first: what they name is no frame by itself, in whichever folder it lies.
        let mut visited = HashSet::new();
        for path in paths {
            if path.is_dir() {
                self.note_lists(path, 0, &mut visited)?;
            } else if is_series(path) {
                self.note_list(path)?;
            }
        }
        let mut loose: BTreeMap<PathBuf, Vec<Loose>> = BTreeMap::new();
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
                let file = Loose::asked_for(path.clone());
                loose.entry(folder).or_default().push(file);
            }
        }
        for (folder, files) in loose {
            let whole_name = match files.as_slice() {
                [one] => stem(&one.path),
                _ => folder_name(&folder),
            };
            self.group(&folder, files, &whole_name)?;
        }
        if self.folders.exhausted() {
            self.plan.notices.push(Notice::warning(format!(
                "more than {MAX_ENTRIES} files and folders: not all of them were looked at; open a smaller folder"
            )));
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

    /// Reads the lists in a folder and the folders in it, except where a manifest says what they hold.
    fn note_lists(
        &mut self,
        folder: &Path,
        depth: usize,
        visited: &mut HashSet<PathBuf>,
    ) -> Result<(), Stopped> {
        if depth > MAX_MESH_FOLDER_DEPTH || !visited.insert(identity(folder)) {
            return Ok(());
        }
        let Ok(Entries { files, folders }) = self.entries(folder)? else {
            return Ok(());
        };
        if files
            .iter()
            .any(|file| role(&file.path) == FileRole::Manifest)
        {
            return Ok(());
        }
        for file in files {
            if is_series(&file.path) && file.unreadable.is_none() {
                self.note_list(&file.path)?;
            }
        }
        for folder in folders {
            self.note_lists(&folder, depth + 1, visited)?;
        }
        Ok(())
    }

    fn note_list(&mut self, list: &Path) -> Result<(), Stopped> {
        self.progress.step()?;
        let series = self.read_list(list)?;
        let files: Vec<PathBuf> = match &series {
            Ok(series) => series
                .parts
                .iter()
                .flat_map(|part| part.files.clone())
                .collect(),
            Err(fault) => fault.listed.clone(),
        };
        for file in files {
            self.listed
                .entry(identity(&file))
                .or_insert_with(|| list.to_owned());
        }
        Ok(())
    }

    /// What a list says; each is read once.
    pub(super) fn read_list(
        &mut self,
        list: &Path,
    ) -> Result<Result<Series, SeriesFault>, Stopped> {
        if let Some(known) = self.lists.get(list) {
            return Ok(known.clone());
        }
        let series = match read_text(list, self.limits) {
            Ok(text) => read_series(list, &text, &mut self.folders, self.progress)?,
            Err(reason) => Err(SeriesFault {
                reason,
                listed: Vec::new(),
            }),
        };
        self.lists.insert(list.to_owned(), series.clone());
        Ok(series)
    }

    /// The list that names a file, if one was read that does.
    pub(super) fn list_of(&self, file: &Path) -> Option<&PathBuf> {
        if self.listed.is_empty() {
            return None;
        }
        self.listed.get(&identity(file))
    }

    /// A folder: its manifest if it has one, else its files and then its folders.
    pub(super) fn folder(&mut self, folder: &Path, depth: usize) -> Result<(), Stopped> {
        if self.was_seen(folder) {
            return Ok(());
        }
        if depth > MAX_MESH_FOLDER_DEPTH {
            let text = format!(
                "folders more than {MAX_MESH_FOLDER_DEPTH} deep are not read: {}",
                folder.display()
            );
            self.plan.notices.push(Notice::warning(text));
            return Ok(());
        }
        self.seen.insert(identity(folder));
        let Some(Entries { files, folders }) = self.entries_or_fault(folder)? else {
            return Ok(());
        };
        if let Some(manifest) = files
            .iter()
            .find(|file| role(&file.path) == FileRole::Manifest)
        {
            if let Some(reason) = &manifest.unreadable {
                self.fail(None, &manifest.path, reason.clone());
                return Ok(());
            }
            let name_so_far = self.plan.name.clone();
            self.manifest(&manifest.path)?;
            if depth > 0 {
                // The name of one study among others does not name them all.
                self.plan.name = name_so_far;
            }
            return Ok(());
        }
        self.images += files
            .iter()
            .filter(|file| looks_like_image(&file.path))
            .count();
        let mut files = files;
        let Sheets {
            sheets,
            mut subjects,
        } = self.sheets(folders)?;
        if let Some(frames) = self.frame_folders(&subjects, &files)? {
            for folder in std::mem::take(&mut subjects) {
                self.seen.insert(identity(&folder));
            }
            files.extend(frames);
        }
        let mut within: BTreeMap<String, Vec<Loose>> = BTreeMap::new();
        for (sheet, origin) in sheets {
            self.seen.insert(identity(&sheet));
            let Some(entries) = self.entries_or_fault(&sheet)? else {
                continue;
            };
            files.extend(entries.files.into_iter().map(|file| file.from(origin)));
            // `endo/p1/0.obj` beside `epi/p1/0.obj`
            for subject in entries.folders {
                let Some(entries) = self.entries_or_fault(&subject)? else {
                    continue;
                };
                let files = entries.files.into_iter().map(|file| file.from(origin));
                within
                    .entry(folder_name(&subject))
                    .or_default()
                    .extend(files);
            }
        }
        self.group(folder, files, &folder_name(folder))?;
        for (name, files) in within {
            self.group(folder, files, &name)?;
        }
        for folder in subjects {
            self.folder(&folder, depth + 1)?;
        }
        Ok(())
    }

    /// What lies in a folder; one that cannot be listed is an error of the study.
    fn entries_or_fault(&mut self, folder: &Path) -> Result<Option<Entries>, Stopped> {
        match self.entries(folder)? {
            Ok(entries) => Ok(Some(entries)),
            Err(reason) => {
                self.fail(None, folder, reason);
                Ok(None)
            }
        }
    }

    /// Files and folders of a folder in natural order, without hidden ones.
    pub(super) fn entries(&mut self, folder: &Path) -> Result<Result<Entries, String>, Stopped> {
        let listing = match self.folders.list(folder, self.progress)? {
            Ok(listing) => listing,
            Err(reason) => return Ok(Err(reason)),
        };
        let (mut files, mut folders) = (Vec::new(), Vec::new());
        for entry in &listing.entries {
            if entry.name.starts_with('.') || entry.name == "__MACOSX" {
                continue;
            }
            match self.folders.followed(entry) {
                What::Folder | What::LinkedFolder => folders.push(entry.path.clone()),
                What::File => files.push(Loose::new(entry.path.clone(), None)),
                What::Unusable(why) => files.push(Loose::new(entry.path.clone(), Some(why))),
                What::Link => {}
            }
        }
        files.sort_by(|a, b| natural_order(&name_of(&a.path), &name_of(&b.path)));
        folders.sort_by(|a, b| natural_order(&name_of(a), &name_of(b)));
        Ok(Ok(Entries { files, folders }))
    }
}

/// One path for all ways to a file or folder.
pub(super) fn identity(path: &Path) -> PathBuf {
    path.canonicalize().unwrap_or_else(|_| path.to_owned())
}

/// Whether the ending of a file is that of an image.
pub fn looks_like_image(path: &Path) -> bool {
    let name = name_of(path).to_ascii_lowercase();
    [".nii", ".nii.gz", ".dcm", ".nrrd", ".nhdr", ".mha", ".mhd"]
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
