//! The files of one folder before they are sorted into subjects: which are meshes, which are copies, which are listed.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use super::copies::without_copies;
use super::file_name::mesh_name;
use super::find_sequences::Search;
use super::folder_contents::{FileRole, Loose, role};
use super::folders::composed;
use super::group_files::{LooseFile, group_files, stem};
use super::read_file::{name_of, read_bytes, read_head};
use crate::progress::Stopped;
use crate::study::{Notice, SurfaceKind, natural_order};

/// Bytes in which a table of points and faces shows what it is.
const TABLE_HEAD: u64 = 64 << 10;
/// Endings that other programs put behind a mesh's: packed, or not yet whole.
const PACKED: [&str; 12] = [
    "gz",
    "bz2",
    "xz",
    "zst",
    "zip",
    "7z",
    "rar",
    "part",
    "partial",
    "crdownload",
    "download",
    "tmp",
];

impl Search<'_> {
    /// Sorts files that lie together into subjects. Files that another file lists are its frames, not their own.
    pub(super) fn group(
        &mut self,
        folder: &Path,
        files: Vec<Loose>,
        whole_name: &str,
    ) -> Result<(), Stopped> {
        let (lists, files): (Vec<Loose>, Vec<Loose>) = files
            .into_iter()
            .partition(|file| role(&file.path) == FileRole::Series);
        let mut loose = Vec::new();
        for list in lists {
            self.progress.step()?;
            match &list.unreadable {
                Some(reason) => self.fail(Some(stem(&list.path)), &list.path, reason.clone()),
                None => self.add_list(&list, &mut loose)?,
            }
        }
        let files: Vec<Loose> = files
            .into_iter()
            .filter(|file| self.list_of(&file.path).is_none())
            .collect();
        let meshes = self.meshes(files)?;
        let origins: BTreeMap<PathBuf, Loose> = meshes
            .into_iter()
            .map(|file| (file.path.clone(), file))
            .collect();
        let mut paths: Vec<PathBuf> = origins.keys().cloned().collect();
        paths.sort_by(|a, b| natural_order(&a.to_string_lossy(), &b.to_string_lossy()));
        let (named, copied) = without_copies(paths, &|a, b| self.same_content(a, b));
        loose.extend(named.into_iter().map(|file| {
            let found = origins.get(&file.path);
            let origin = found.map(|found| found.origin).unwrap_or_default();
            LooseFile {
                unreadable: found.and_then(|found| found.unreadable.clone()),
                folder_surface: origin.surface,
                folder_structure: origin.structure,
                path: file.path,
                stem: match found.and_then(|found| found.frame.as_ref()) {
                    Some(frame) => format!("{} {frame}", file.stem),
                    None => file.stem,
                },
                ..LooseFile::default()
            }
        }));
        let mut grouped = group_files(loose, folder, whole_name);
        for (file, notice) in copied {
            let of_subject = grouped.plans.iter_mut().find(|plan| {
                plan.surfaces
                    .iter()
                    .any(|surface| surface.files.contains(&file))
            });
            match of_subject {
                Some(plan) => plan.notices.push(notice),
                None => grouped.notices.push(notice),
            }
        }
        self.plan.subjects.extend(grouped.plans);
        self.plan.errors.extend(grouped.errors);
        self.plan.notices.extend(grouped.notices);
        Ok(())
    }

    /// The surfaces that a list names. Files that an earlier list names are not read again.
    fn add_list(&mut self, list: &Loose, loose: &mut Vec<LooseFile>) -> Result<(), Stopped> {
        let series = match self.read_list(&list.path)? {
            Ok(series) => series,
            Err(fault) => {
                self.fail(Some(stem(&list.path)), &list.path, fault.reason);
                return Ok(());
            }
        };
        let name = name_of(&list.path);
        let about_series = |notice: Notice| Notice {
            text: format!("{name}: {}", notice.text),
            ..notice
        };
        self.plan
            .notices
            .extend(series.notices.into_iter().map(about_series));
        let several = series.parts.len() > 1;
        for part in series.parts {
            let first = part
                .files
                .first()
                .and_then(|file| self.list_of(file))
                .cloned();
            let by_other = |file: &PathBuf| self.list_of(file).is_some_and(|own| *own != list.path);
            if let Some(first) = first
                && part.files.iter().all(by_other)
            {
                self.plan.notices.push(Notice::info(format!(
                    "{name} names files that {} names as well: they are read once",
                    name_of(&first)
                )));
                continue;
            }
            let own = mesh_name(&stem(&list.path));
            let unnamed = part.surface.is_none() && part.structure.is_none();
            loose.push(LooseFile {
                path: list.path.clone(),
                // Parts that nothing else tells apart are cases of their own.
                stem: if several && unnamed {
                    part.case
                } else {
                    stem(&list.path)
                },
                series: Some((part.files, part.times)),
                folder_surface: part.surface.or(list.origin.surface),
                own_surface: part.surface.filter(|_| several || own.surface.is_none()),
                folder_structure: part.structure.or(list.origin.structure),
                ..LooseFile::default()
            });
        }
        Ok(())
    }

    /// The files that are meshes, or were meant to be: those with a mesh's ending, and tables that hold points and faces
    /// or are named as another frame. What is neither is passed over; a frame that is packed is told.
    fn meshes(&mut self, files: Vec<Loose>) -> Result<Vec<Loose>, Stopped> {
        let (mut meshes, mut tables, mut others) = (Vec::new(), Vec::new(), Vec::new());
        for file in files {
            self.progress.check()?;
            match role(&file.path) {
                _ if file.asked_for => meshes.push(file),
                FileRole::Mesh => meshes.push(file),
                FileRole::Table if file.unreadable.is_none() && begins_as_mesh(&file.path) => {
                    meshes.push(file);
                }
                FileRole::Table => tables.push(file),
                _ => others.push(file),
            }
        }
        let name = |path: &Path| mesh_name(&composed(&stem(path)));
        let mut sheets: BTreeSet<(String, Option<SurfaceKind>)> = BTreeSet::new();
        let mut frames = Vec::new();
        for file in &meshes {
            let name = name(&file.path);
            if name.frame.is_some() {
                sheets.insert((name.case.clone(), name.surface));
            }
            frames.push(name);
        }
        let is_other_frame = |path: &Path| {
            let name = name(path);
            let known = sheets.contains(&(name.case.clone(), name.surface));
            known && name.frame.is_some() && !frames.contains(&name)
        };
        for table in tables {
            if is_other_frame(&table.path) {
                meshes.push(table);
            }
        }
        for other in others {
            let ending = other
                .path
                .extension()
                .unwrap_or_default()
                .to_string_lossy()
                .to_lowercase();
            let inner = other.path.with_extension("");
            if let Some(reason) = &other.unreadable
                && role(&other.path) == FileRole::Other
                && reason.starts_with("a link")
            {
                self.plan.notices.push(Notice::warning(format!(
                    "{}: {reason}",
                    name_of(&other.path)
                )));
            } else if PACKED.contains(&ending.as_str())
                && role(&inner) == FileRole::Mesh
                && is_other_frame(&inner)
            {
                self.plan.notices.push(Notice::warning(format!(
                    "{} is not read: packed or not whole (.{ending}); a frame is missing without it",
                    name_of(&other.path)
                )));
            }
        }
        Ok(meshes)
    }

    pub(super) fn same_content(&self, a: &Path, b: &Path) -> bool {
        let size = |path: &Path| std::fs::metadata(path).map(|facts| facts.len()).ok();
        size(a) == size(b)
            && match (read_bytes(a, self.limits), read_bytes(b, self.limits)) {
                (Ok(a), Ok(b)) => a == b,
                _ => false,
            }
    }
}

/// Whether a table begins with rows of points or faces.
fn begins_as_mesh(path: &Path) -> bool {
    let Ok(head) = read_head(path, TABLE_HEAD) else {
        return false;
    };
    let head = head.strip_prefix(b"\xef\xbb\xbf").unwrap_or(&head);
    let rows = head
        .split(|&b| b == b'\n' || b == b'\r')
        .map(<[u8]>::trim_ascii);
    // a first row of words is a header
    rows.filter(|row| !row.is_empty() && !row.starts_with(b"#"))
        .take(2)
        .any(|row| {
            let cell = row.split(|b| b",;\t".contains(b)).next();
            let cell = cell.unwrap_or_default().trim_ascii();
            row.len() > cell.len()
                && matches!(cell, b"v" | b"f" | b"V" | b"F" | b"\"v\"" | b"\"f\"")
        })
}
