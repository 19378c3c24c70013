//! Which masks lie below paths, and to whom they belong.

use std::collections::{BTreeMap, HashMap, HashSet};
use std::fs;
use std::path::{Path, PathBuf};

use super::name::{MaskName, MaskRole, mask_name, stem};
use super::segmentation::is_segmentation;
use crate::io::open::unique_ids;
use crate::io::{Limits, OpenError};
use crate::progress::{Progress, Stopped};
use crate::study::{Notice, natural_order};

/// Masks of one subject.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MaskFiles {
    /// Pseudonym: what its files have in common in their names.
    pub id: String,
    /// Where they lie.
    pub folder: PathBuf,
    /// The files.
    pub kind: MaskKind,
    /// Whether no other subject's masks lie in the folder, so that what is said there is said of this one.
    pub alone: bool,
    /// What there is to say about its id.
    pub notices: Vec<Notice>,
}

/// How masks are kept.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum MaskKind {
    /// One file of labels for each frame, or one for all of them, with the numbers that their names have.
    Labels(Vec<(Option<u32>, PathBuf)>),
    /// One of the cavity, and one of the whole ventricle.
    Pair {
        /// Everything within the endocardium.
        endo: PathBuf,
        /// Everything within the epicardium.
        epi: PathBuf,
    },
}

/// Folders within folders that are looked into.
const DEEPEST: usize = 8;

/// Subjects of paths and of the folders among them, in natural order of their folders and names. Files are recognised by
/// name; a file that is a path itself is taken for labels whatever its name. Links are followed only if `limits` says so.
///
/// # Errors
/// Only [`Stopped`]. What cannot be used is in the second list.
pub fn find_mask_studies(
    paths: &[PathBuf],
    limits: &Limits,
    progress: &Progress,
) -> Result<(Vec<MaskFiles>, Vec<OpenError>), Stopped> {
    let mut walk = Walk {
        limits,
        progress,
        looked_at: 0,
        seen: HashSet::new(),
        groups: BTreeMap::new(),
        errors: Vec::new(),
    };
    for path in paths {
        let before = walk.groups.len() + walk.errors.len();
        if path.is_dir() {
            walk.folder(path, 0)?;
            if walk.groups.len() + walk.errors.len() == before {
                walk.fail(
                    path,
                    "no masks were found here: their names end in _gt, _seg, _mask or _label, or in pairs in _endo and _epi",
                );
            }
        } else {
            walk.named(path);
        }
    }
    Ok(walk.subjects())
}

/// Whether a file is one of masks by its name, or a segmentation of DICOM.
pub fn is_mask_file(path: &Path) -> bool {
    let name = path.file_name().map(|name| name.to_string_lossy());
    let named = name.is_some_and(|name| mask_name(&name).is_some());
    named || is_segmentation(path)
}

/// Files of one subject.
#[derive(Default)]
struct Group {
    labels: Vec<(Option<u32>, PathBuf)>,
    endo: Option<PathBuf>,
    epi: Option<PathBuf>,
}

struct Walk<'a> {
    limits: &'a Limits,
    progress: &'a Progress,
    looked_at: usize,
    seen: HashSet<PathBuf>,
    /// By folder and name of the subject.
    groups: BTreeMap<(PathBuf, String), Group>,
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

    /// A file that was named itself.
    fn named(&mut self, path: &Path) {
        let Some(name) = path
            .file_name()
            .map(|name| name.to_string_lossy().into_owned())
        else {
            return self.fail(path, "this is no file");
        };
        if !path.is_file() {
            return self.fail(path, "no such file");
        }
        let plain = || {
            Some(MaskName {
                subject: stem(&name)?.to_owned(),
                role: MaskRole::Labels,
                frame: None,
            })
        };
        let segmentation = || is_segmentation(path).then(|| labels_in_dicom(&name));
        match mask_name(&name).or_else(plain).or_else(segmentation) {
            Some(found) => self.add(path, found),
            None => self.fail(
                path,
                "not a file of masks by its name (.nii, .nii.gz, .nrrd, .mha)",
            ),
        }
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
                self.fail(folder, error.to_string());
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
            names.push((
                entry.file_name().to_string_lossy().into_owned(),
                entry.path(),
            ));
        }
        names.sort_by(|(a, _), (b, _)| natural_order(a, b).then_with(|| a.cmp(b)));
        for (name, path) in names {
            if name.starts_with('.') || (path.is_symlink() && !self.limits.follow_links) {
                continue;
            }
            if path.is_dir() {
                self.folder(&path, depth + 1)?;
            } else if let Some(found) = mask_name(&name) {
                self.add(&path, found);
            } else if may_be_dicom(&name) && is_segmentation(&path) {
                self.add(&path, labels_in_dicom(&name));
            }
        }
        Ok(())
    }

    fn add(&mut self, path: &Path, found: MaskName) {
        let folder = path.parent().unwrap_or(Path::new("")).to_owned();
        // Frames of a pair in files of their own would be another subject each.
        let subject = match (found.role, found.frame) {
            (MaskRole::Labels, _) | (_, None) => found.subject,
            (_, Some(frame)) => format!("{}_{frame}", found.subject),
        };
        let group = self.groups.entry((folder, subject)).or_default();
        let place = match found.role {
            MaskRole::Labels => {
                if !group.labels.iter().any(|(_, other)| other == path) {
                    group.labels.push((found.frame, path.to_owned()));
                }
                return;
            }
            MaskRole::Endo => &mut group.endo,
            MaskRole::Epi => &mut group.epi,
        };
        place.get_or_insert_with(|| path.to_owned());
    }

    fn subjects(mut self) -> (Vec<MaskFiles>, Vec<OpenError>) {
        let groups = std::mem::take(&mut self.groups);
        let mut found = Vec::new();
        for ((folder, id), group) in groups {
            match kind(group) {
                Ok(kinds) => found.extend(kinds.into_iter().map(|kind| MaskFiles {
                    id: id.clone(),
                    folder: folder.clone(),
                    kind,
                    alone: true,
                    notices: Vec::new(),
                })),
                Err((path, reason)) => {
                    self.errors.push(OpenError {
                        subject: Some(id),
                        path,
                        reason,
                    });
                }
            }
        }
        found.sort_by(|a, b| {
            let folders = natural_order(&a.folder.to_string_lossy(), &b.folder.to_string_lossy());
            folders
                .then_with(|| natural_order(&a.id, &b.id))
                .then_with(|| a.id.cmp(&b.id))
        });
        let in_folders = counts(found.iter().map(|files| files.folder.clone()));
        for files in &mut found {
            files.alone = in_folders.get(&files.folder) == Some(&1);
        }
        distinct_ids(&mut found);
        (found, self.errors)
    }
}

/// Whether a file is looked into for a DICOM segmentation.
fn may_be_dicom(name: &str) -> bool {
    let ending = name
        .rsplit_once('.')
        .map(|(_, ending)| ending.to_ascii_lowercase());
    ending.is_none_or(|ending| ["dcm", "seg"].contains(&ending.as_str()))
}

/// What the name of a DICOM segmentation says: the subject, and the frame where a word for one is in it.
fn labels_in_dicom(name: &str) -> MaskName {
    let stem = name.rsplit_once('.').map_or(name, |(stem, _)| stem);
    // As the name that a file of labels of another format would have.
    let said = mask_name(&format!("{stem}.nii")).or_else(|| mask_name(&format!("{stem}_seg.nii")));
    said.unwrap_or_else(|| MaskName {
        subject: stem.to_owned(),
        role: MaskRole::Labels,
        frame: None,
    })
}

/// Files of labels in the order of their frames, and the pair.
fn kind(group: Group) -> Result<Vec<MaskKind>, (PathBuf, String)> {
    let mut kinds = Vec::new();
    let mut labels = group.labels;
    labels.sort_by_key(|(number, _)| *number);
    if let Some(twice) = labels.windows(2).find(|pair| pair[0].0 == pair[1].0) {
        let reason = "two files of labels of one subject at one frame".to_owned();
        return Err((twice[1].1.clone(), reason));
    }
    if !labels.is_empty() {
        kinds.push(MaskKind::Labels(labels));
    }
    match (group.endo, group.epi) {
        (Some(endo), Some(epi)) => kinds.push(MaskKind::Pair { endo, epi }),
        (Some(endo), None) => {
            return Err((
                endo,
                "a mask of the endocardium without one of the epicardium".to_owned(),
            ));
        }
        (None, Some(epi)) => {
            return Err((
                epi,
                "a mask of the epicardium without one of the endocardium".to_owned(),
            ));
        }
        (None, None) => {}
    }
    Ok(kinds)
}

/// How often each occurs.
fn counts<T: std::hash::Hash + Eq>(of: impl Iterator<Item = T>) -> HashMap<T, usize> {
    let mut counts = HashMap::new();
    for one in of {
        *counts.entry(one).or_insert(0) += 1;
    }
    counts
}

/// Ids of their own, as subjects of meshes get them.
fn distinct_ids(found: &mut [MaskFiles]) {
    let places: Vec<PathBuf> = (found.iter())
        .map(|files| match files.folder.file_name() {
            Some(name) if name.to_string_lossy() == files.id => files.folder.clone(),
            // Its own folder is the one that its files would have.
            _ => files.folder.join(&files.id),
        })
        .collect();
    let named: Vec<(&str, &Path)> = (found.iter().zip(&places))
        .map(|(files, place)| (files.id.as_str(), place.as_path()))
        .collect();
    let unique = unique_ids(&named);
    for (files, (id, notices)) in found.iter_mut().zip(unique) {
        files.id = id;
        files.notices = notices;
    }
}
