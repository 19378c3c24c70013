//! The subjects of a manifest: its patterns are looked up, and what it leaves out is found.

use std::collections::{HashMap, HashSet};
use std::path::{Path, PathBuf};

use super::copies::{NamedFile, without_copies};
use super::file_name::MeshName;
use super::find_sequences::Search;
use super::folder_contents::{Entries, folder_name};
use super::folders::{composed, existing};
use super::frame_facts::take_facts;
use super::frame_name::FrameName;
use super::group_files::{same_frames, stem};
use super::patterns::{files_of_pattern, has_wildcard, telling_names};
use super::plan::{KindPlan, Stated, SubjectPlan, SurfacePlan};
use super::read_file::{name_of, read_text};
use super::readings::read_names;
use super::series_files::is_series;
use super::study_toml::{Manifest, ManifestSubject, parse_manifest};
use crate::progress::Stopped;
use crate::study::{LabelClasses, Notice, SurfaceKind};

/// A surface of a manifest's subject, or the file that is wrong and why.
type SurfaceOrFault = Result<NamedSurface, (PathBuf, String)>;

/// A surface with the frames that the names of its files say.
struct NamedSurface {
    plan: SurfacePlan,
    /// One for each file, where all have one.
    frames: Option<Vec<FrameName>>,
    notices: Vec<Notice>,
}

impl Search<'_> {
    /// A manifest with all its subjects.
    pub(super) fn manifest(&mut self, path: &Path) -> Result<(), Stopped> {
        let parsed = read_text(path, self.limits).and_then(|text| parse_manifest(&text));
        let manifest: Manifest = match parsed {
            Ok(manifest) => manifest,
            Err(reason) => {
                self.fail(None, path, reason);
                return Ok(());
            }
        };
        self.plan.name = self.plan.name.take().or(manifest.name);
        self.plan.notices.extend(manifest.notices);
        self.add_label_classes(manifest.label_classes);
        let folder = path.parent().unwrap_or(Path::new(""));
        let before = self.plan.subjects.len();
        if manifest.subjects.is_empty() {
            // A manifest may state units and labels' classes and leave the subjects to be found.
            self.folders_beside(folder)?;
        }
        for subject in manifest.subjects {
            self.progress.step()?;
            match subject {
                Ok(subject) => self.manifest_subject(path, folder, subject)?,
                Err(error) => self.fail(error.id, path, error.reason),
            }
        }
        for subject in &mut self.plan.subjects[before..] {
            subject.stated.unit = subject.stated.unit.or(manifest.unit);
        }
        Ok(())
    }

    fn folders_beside(&mut self, folder: &Path) -> Result<(), Stopped> {
        let Ok(Entries { files, folders }) = self.entries(folder)? else {
            return Ok(());
        };
        self.group(folder, files, &folder_name(folder))?;
        for folder in folders {
            self.folder(&folder, 1)?;
        }
        Ok(())
    }

    /// One subject of a manifest: by its patterns, or by the folder that bears its id.
    fn manifest_subject(
        &mut self,
        manifest: &Path,
        folder: &Path,
        subject: ManifestSubject,
    ) -> Result<(), Stopped> {
        if subject.surfaces.is_empty() {
            return self.subject_of_folder(manifest, folder, subject);
        }
        let ManifestSubject {
            id,
            line,
            mut stated,
            surfaces: patterns,
            mut notices,
        } = subject;
        let mut surfaces = Vec::new();
        let mut frames_of = Vec::new();
        for (kind, patterns) in patterns {
            match self.surface(folder, kind, &patterns)? {
                Ok(mut surface) => {
                    notices.append(&mut surface.notices);
                    if let Some(frames) = surface.frames {
                        frames_of.push((KindPlan::Known(kind), frames));
                    }
                    surfaces.push(surface.plan);
                }
                Err((path, reason)) => {
                    let (path, reason) = if path.as_os_str().is_empty() {
                        (manifest.to_owned(), format!("line {line}: {reason}"))
                    } else {
                        (path, reason)
                    };
                    self.fail(Some(id), &path, reason);
                    return Ok(());
                }
            }
        }
        // Files are paired by the frames in their names, never by their places in the lists.
        if let Err(reason) = same_frames(&frames_of).and_then(|()| same_order(&frames_of)) {
            self.fail(Some(id), manifest, format!("line {line}: {reason}"));
            return Ok(());
        }
        if let Some((_, frames)) = frames_of.first() {
            let times = take_facts(frames, &mut stated, &mut notices);
            if let Some(surface) = surfaces.first_mut() {
                surface.times = surface.times.take().or(times);
            }
        }
        self.plan.subjects.push(SubjectPlan {
            id,
            place: manifest.to_owned(),
            surfaces,
            stated,
            notices,
        });
        Ok(())
    }

    /// The files of one surface. An error without a path is the manifest's.
    fn surface(
        &mut self,
        folder: &Path,
        kind: SurfaceKind,
        patterns: &[String],
    ) -> Result<SurfaceOrFault, Stopped> {
        let mut notices = Vec::new();
        let mut files: Vec<NamedFile> = Vec::new();
        let mut known: HashSet<PathBuf> = HashSet::new();
        for pattern in patterns {
            let found = match files_of_pattern(&mut self.folders, folder, pattern, self.progress)? {
                Ok(found) => found,
                Err(reason) => return Ok(Err((PathBuf::new(), reason))),
            };
            if found.is_empty() {
                return Ok(Err((
                    PathBuf::new(),
                    format!("no file matches {pattern:?}"),
                )));
            }
            if !has_wildcard(pattern) {
                // A file that is named is meant, a second time as well.
                files.extend(found.into_iter().map(|path| {
                    known.insert(path.clone());
                    named(path)
                }));
                continue;
            }
            let (new, again): (Vec<_>, Vec<_>) = found
                .into_iter()
                .partition(|path| known.insert(path.clone()));
            if let Some(first) = again.first() {
                notices.push(Notice::info(format!(
                    "{}: {pattern:?} matches {} once more: read once",
                    kind.name(),
                    name_of(first)
                )));
            }
            let (kept, copied) = without_copies(new, &|a, b| self.same_content(a, b));
            notices.extend(copied.into_iter().map(|(_, notice)| notice));
            files.extend(kept);
        }
        if let [one] = files.as_slice()
            && is_series(&one.path)
        {
            let list = one.path.clone();
            return Ok(self
                .listed_surface(&list, kind)?
                .map(|surface| NamedSurface {
                    notices: notices.into_iter().chain(surface.notices).collect(),
                    ..surface
                }));
        }
        Ok(named_surface(kind, &files, notices))
    }

    /// A pattern may name a list of files in the place of meshes.
    fn listed_surface(
        &mut self,
        list: &Path,
        kind: SurfaceKind,
    ) -> Result<SurfaceOrFault, Stopped> {
        let mut series = match self.read_list(list)? {
            Ok(series) => series,
            Err(fault) => return Ok(Err((list.to_owned(), fault.reason))),
        };
        // Of a list of several surfaces, the one of this kind.
        if series.parts.len() > 1 {
            series
                .parts
                .retain(|part| part.structure.is_none() && part.surface == Some(kind));
        }
        let Some(part) = series.parts.pop().filter(|_| series.parts.is_empty()) else {
            let reason = format!(
                "lists several surfaces, and not one of them is the {}",
                kind.name()
            );
            return Ok(Err((list.to_owned(), reason)));
        };
        Ok(Ok(NamedSurface {
            plan: SurfacePlan {
                kind: KindPlan::Known(kind),
                files: part.files,
                times: part.times,
            },
            frames: None,
            notices: series.notices,
        }))
    }

    /// A subject without patterns lies in the folder that bears its id.
    fn subject_of_folder(
        &mut self,
        manifest: &Path,
        folder: &Path,
        subject: ManifestSubject,
    ) -> Result<(), Stopped> {
        let (id, line) = (subject.id, subject.line);
        let place = existing(&mut self.folders, folder, &id, self.progress)?;
        if !place.is_dir() {
            let reason = format!("line {line}: no files are named, and there is no folder {id:?}");
            self.fail(Some(id), manifest, reason);
            return Ok(());
        }
        let so_far = std::mem::take(&mut self.plan);
        self.folder(&place, 1)?;
        let found = std::mem::replace(&mut self.plan, so_far);
        let failed = !found.errors.is_empty();
        self.plan.errors.extend(found.errors);
        self.plan.notices.extend(found.notices);
        let mut subjects = found.subjects;
        match (subjects.pop(), subjects.len()) {
            (Some(mut found), 0) => {
                found.id = id;
                found.stated = Stated {
                    end_diastole: subject.stated.end_diastole.or(found.stated.end_diastole),
                    end_systole: subject.stated.end_systole.or(found.stated.end_systole),
                    ..subject.stated
                };
                found.notices.extend(subject.notices);
                self.plan.subjects.push(found);
            }
            (None, _) if failed => {}
            (_, others) => {
                let reason = format!(
                    "line {line}: the folder {id:?} holds {} subjects, not one",
                    if others == 0 { 0 } else { others + 1 }
                );
                self.fail(Some(id), manifest, reason);
            }
        }
        Ok(())
    }

    /// Several manifests opened together share their labels' classes.
    fn add_label_classes(&mut self, classes: Option<LabelClasses>) {
        let Some(classes) = classes else { return };
        let Some(known) = &mut self.plan.label_classes else {
            self.plan.label_classes = Some(classes);
            return;
        };
        for (known, more) in [
            (&mut known.normal, classes.normal),
            (&mut known.abnormal, classes.abnormal),
        ] {
            for label in more {
                if !known.contains(&label) {
                    known.push(label);
                }
            }
        }
    }
}

fn named(path: PathBuf) -> NamedFile {
    NamedFile {
        stem: composed(&stem(&path)),
        path,
    }
}

/// A surface of files in order, with what their names say: other parts of the heart among them are left out, and no two
/// may be one frame.
fn named_surface(
    kind: SurfaceKind,
    files: &[NamedFile],
    mut notices: Vec<Notice>,
) -> SurfaceOrFault {
    let paths: Vec<PathBuf> = files.iter().map(|file| file.path.clone()).collect();
    let telling = telling_names(&paths);
    let all_alike = files.windows(2).all(|pair| pair[0].stem == pair[1].stem);
    let stems: Vec<&str> = (files.iter().zip(&telling))
        .map(|(file, telling)| {
            if all_alike {
                telling.as_str()
            } else {
                file.stem.as_str()
            }
        })
        .collect();
    let (names, assumed) = read_names(&stems);
    notices.extend(assumed);
    let others = names.iter().filter(|name| name.structure.is_some()).count();
    if others == names.len() {
        notices.extend(names.first().and_then(|name| name.structure).map(|part| {
            Notice::warning(format!(
                "{}: by their names, the files are of the {part}; study.toml says otherwise",
                kind.name()
            ))
        }));
    }
    let (mut kept, mut kept_names, mut left): (Vec<PathBuf>, Vec<MeshName>, Vec<String>) =
        Default::default();
    for (path, name) in paths.into_iter().zip(names) {
        if others > 0
            && kind != SurfaceKind::Other
            && name.structure.is_some()
            && others < files.len()
        {
            left.push(name_of(&path));
        } else {
            kept.push(path);
            kept_names.push(name);
        }
    }
    if let Some(first) = left.first() {
        notices.push(Notice::warning(format!(
            "{}: {} files of other parts of the heart not read, by their names ({first})",
            kind.name(),
            left.len()
        )));
    }
    let frames: Option<Vec<FrameName>> = kept_names.iter().map(|name| name.frame).collect();
    let frames = frames.filter(|frames| frames.len() > 1 || frames.iter().any(is_phase));
    let mut file_of: HashMap<FrameName, &PathBuf> = HashMap::new();
    for (frame, path) in frames.iter().flatten().zip(&kept) {
        let first = *file_of.entry(*frame).or_insert(path);
        if first != path {
            let reason = format!(
                "{} has the same surface and frame in its name",
                name_of(first)
            );
            return Err((path.clone(), reason));
        }
    }
    let cases: HashSet<&str> = kept_names.iter().map(|name| name.case.as_str()).collect();
    if frames.is_some() && cases.len() > 1 {
        let mut cases: Vec<&str> = cases.into_iter().collect();
        cases.sort_unstable();
        notices.push(Notice::warning(format!(
            "{}: the names of its files are of several subjects ({}, {}…)",
            kind.name(),
            cases[0],
            cases[1]
        )));
    }
    Ok(NamedSurface {
        plan: SurfacePlan {
            kind: KindPlan::Known(kind),
            files: kept,
            times: None,
        },
        frames,
        notices,
    })
}

fn is_phase(frame: &FrameName) -> bool {
    !matches!(frame, FrameName::Number(_))
}

/// Surfaces with the same frames must list them in the same order.
fn same_order(frames_of: &[(KindPlan, Vec<FrameName>)]) -> Result<(), String> {
    let differs = frames_of.windows(2).any(|pair| pair[0].1 != pair[1].1);
    if differs {
        return Err("the surfaces list their frames in different orders".to_owned());
    }
    Ok(())
}
