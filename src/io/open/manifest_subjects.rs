//! The subjects of a manifest: its patterns are looked up, and what it leaves out is found.

use std::path::{Path, PathBuf};

use super::find_sequences::{Entries, FileRole, Search, folder_name, role};
use super::patterns::files_of_pattern;
use super::plan::{KindPlan, SeriesTimes, Stated, SubjectPlan, SurfacePlan};
use super::read_file::read_text;
use super::series_files::{is_series, read_series};
use super::study_toml::{Manifest, ManifestSubject, parse_manifest};
use crate::progress::Stopped;
use crate::study::{LabelRoles, SurfaceKind};

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
        self.add_label_roles(manifest.label_roles);
        let folder = path.parent().unwrap_or(Path::new(""));
        let before = self.plan.subjects.len();
        if manifest.subjects.is_empty() {
            // A manifest may state units and labels' roles and leave the hearts to be found.
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
        let meshes = files
            .into_iter()
            .filter(|path| matches!(role(path), FileRole::Mesh | FileRole::Series))
            .collect();
        self.group(folder, meshes, Vec::new(), &folder_name(folder))?;
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
            stated,
            surfaces: patterns,
            notices,
        } = subject;
        let mut surfaces = Vec::new();
        for (kind, patterns) in patterns {
            let mut files = Vec::new();
            for pattern in &patterns {
                match files_of_pattern(folder, pattern) {
                    Ok(found) if found.is_empty() => {
                        let reason = format!("line {line}: no file matches {pattern:?}");
                        self.fail(Some(id), manifest, reason);
                        return Ok(());
                    }
                    Ok(found) => files.extend(found),
                    Err(reason) => {
                        self.fail(Some(id), manifest, format!("line {line}: {reason}"));
                        return Ok(());
                    }
                }
            }
            match self.with_series_read(kind, files) {
                Ok(surface) => surfaces.push(surface),
                Err((path, reason)) => {
                    self.fail(Some(id), &path, reason);
                    return Ok(());
                }
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

    /// A pattern may name a series file in the place of meshes.
    fn with_series_read(
        &self,
        kind: SurfaceKind,
        files: Vec<PathBuf>,
    ) -> Result<SurfacePlan, (PathBuf, String)> {
        let mut plan = SurfacePlan {
            kind: KindPlan::Known(kind),
            files: Vec::new(),
            times: None,
        };
        for file in files {
            if is_series(&file) {
                let series = read_text(&file, self.limits)
                    .and_then(|text| read_series(&file, &text))
                    .map_err(|reason| (file.clone(), reason))?;
                plan.files.extend(series.parts.into_iter().flatten());
                plan.times = Some(SeriesTimes(series.times));
            } else {
                plan.files.push(file);
            }
        }
        Ok(plan)
    }

    /// A subject without patterns lies in the folder that bears its id.
    fn subject_of_folder(
        &mut self,
        manifest: &Path,
        folder: &Path,
        subject: ManifestSubject,
    ) -> Result<(), Stopped> {
        let (id, line) = (subject.id, subject.line);
        let place = folder.join(&id);
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
        let mut hearts = found.subjects;
        match (hearts.pop(), hearts.len()) {
            (Some(mut heart), 0) => {
                heart.id = id;
                heart.stated = Stated {
                    end_diastole: subject.stated.end_diastole.or(heart.stated.end_diastole),
                    end_systole: subject.stated.end_systole.or(heart.stated.end_systole),
                    ..subject.stated
                };
                heart.notices.extend(subject.notices);
                self.plan.subjects.push(heart);
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

    /// Several manifests opened together share their labels' roles.
    fn add_label_roles(&mut self, roles: Option<LabelRoles>) {
        let Some(roles) = roles else { return };
        let Some(known) = &mut self.plan.label_roles else {
            self.plan.label_roles = Some(roles);
            return;
        };
        for (known, more) in [
            (&mut known.normal, roles.normal),
            (&mut known.abnormal, roles.abnormal),
        ] {
            for label in more {
                if !known.contains(&label) {
                    known.push(label);
                }
            }
        }
    }
}
