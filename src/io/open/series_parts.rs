//! The surfaces that a list of files holds: by its parts, else by the names of its files.

use std::collections::{BTreeMap, BTreeSet, HashSet};
use std::path::{Path, PathBuf};

use super::file_name::{MeshName, mesh_name};
use super::group_files::stem;
use super::plan::{SeriesTimes, TimesSource};
use super::read_file::name_of;
use super::words::{structure_of_word, surface_of_word};
use crate::study::checks::counted;
use crate::study::{Notice, SurfaceKind};

/// Times of two parts are the same within this share of the larger: decimals that were printed and read again.
pub(super) const SAME_TIME: f64 = 1e-9;

/// One file of a list.
#[derive(Clone, Debug)]
pub(super) struct Entry {
    pub(super) file: PathBuf,
    /// What the list calls its part; empty if it does not.
    pub(super) part: String,
    pub(super) time: Option<f64>,
}

/// Files of one surface in the order of frames.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Part {
    pub(super) files: Vec<PathBuf>,
    /// Times, where the list gives one for each file.
    pub(super) times: Option<SeriesTimes>,
    /// Which surface its name, its files or their folder say it is.
    pub(super) surface: Option<SurfaceKind>,
    /// Which other part of the heart they say it is.
    pub(super) structure: Option<&'static str>,
    /// What the names of its files have beside surface and frame.
    pub(super) case: String,
}

/// The name of a part, and the surface and structure that its files name.
type PartKey = (String, Option<SurfaceKind>, Option<&'static str>);

/// Sorts the entries of a list into parts.
///
/// # Errors
/// A sentence, where several files stand at each time and nothing tells them apart, or parts have different times.
pub(super) fn parts_of(
    entries: Vec<Entry>,
    notices: &mut Vec<Notice>,
) -> Result<Vec<Part>, String> {
    let mut by_name: BTreeMap<PartKey, Vec<Entry>> = BTreeMap::new();
    for entry in once_each(entries, notices) {
        let name = name_of_entry(&entry);
        let key = (entry.part.clone(), name.surface, name.structure);
        by_name.entry(key).or_default().push(entry);
    }
    let mut parts = Vec::new();
    for ((word, ..), entries) in by_name {
        for entries in apart_by_case(entries)? {
            parts.push(part(&word, entries, notices));
        }
    }
    let same = |a: &Part, b: &Part| match (&a.times, &b.times) {
        (Some(a), Some(b)) if a.values.len() == b.values.len() => a
            .values
            .iter()
            .zip(&b.values)
            .all(|(a, b)| (a - b).abs() <= SAME_TIME * a.abs().max(b.abs())),
        (Some(_), Some(_)) => false,
        _ => true,
    };
    let left: Vec<&Part> = parts
        .iter()
        .filter(|part| part.structure.is_none())
        .collect();
    if left.windows(2).any(|pair| !same(pair[0], pair[1])) {
        return Err("its parts have different times".to_owned());
    }
    Ok(parts)
}

/// Entries without those that repeat another in file, part and time.
fn once_each(entries: Vec<Entry>, notices: &mut Vec<Notice>) -> Vec<Entry> {
    let mut seen = HashSet::new();
    let (mut kept, mut repeated) = (Vec::new(), Vec::new());
    for entry in entries {
        let key = (
            entry.file.clone(),
            entry.part.clone(),
            entry.time.map(f64::to_bits),
        );
        if entry.time.is_none() || seen.insert(key) {
            kept.push(entry);
        } else {
            repeated.push(name_of(&entry.file));
        }
    }
    if let Some(first) = repeated.first() {
        notices.push(Notice::warning(format!(
            "{} listed twice at the same time ({first}): read once",
            counted(repeated.len(), "file", "files")
        )));
    }
    kept
}

/// What the name of an entry's file says, else its part's name, else its folder's.
fn name_of_entry(entry: &Entry) -> MeshName {
    let mut name = mesh_name(&stem(&entry.file));
    let folder = entry.file.parent().map(name_of).unwrap_or_default();
    let words = || {
        entry
            .part
            .split([' ', '_', '-'])
            .chain(std::iter::once(folder.as_str()))
    };
    if name.surface.is_none() {
        name.surface = words().find_map(surface_of_word);
    }
    if !name.left && name.structure.is_none() {
        name.structure = words().find_map(structure_of_word);
    }
    name
}

/// Files of one part, apart where their names have as many cases as there are files at each time.
fn apart_by_case(entries: Vec<Entry>) -> Result<Vec<Vec<Entry>>, String> {
    let mut at_time: BTreeMap<u64, usize> = BTreeMap::new();
    for time in entries.iter().filter_map(|entry| entry.time) {
        *at_time.entry(time.to_bits()).or_default() += 1;
    }
    let counts: BTreeSet<usize> = at_time.values().copied().collect();
    let each = match counts.first() {
        Some(&each) if each > 1 && counts.len() == 1 => each,
        _ => return Ok(vec![entries]),
    };
    let mut cases: BTreeMap<String, Vec<Entry>> = BTreeMap::new();
    for entry in &entries {
        let case = mesh_name(&stem(&entry.file)).case;
        cases.entry(case).or_default().push(entry.clone());
    }
    let even = cases.values().all(|case| case.len() == at_time.len());
    if cases.len() == each && even {
        Ok(cases.into_values().collect())
    } else if at_time.len() > 1 {
        Err(format!(
            "{each} files at each time, which neither a part nor their names distinguish ({}, {}…)",
            name_of(&entries[0].file),
            name_of(&entries[1].file)
        ))
    } else {
        Ok(vec![entries])
    }
}

fn part(word: &str, mut entries: Vec<Entry>, notices: &mut Vec<Notice>) -> Part {
    let timed = entries.iter().filter(|entry| entry.time.is_some()).count();
    if timed != 0 && timed != entries.len() {
        notices.push(Notice::warning(format!(
            "{} of {} files listed without a time: no times are used, and the order is that of the list",
            entries.len() - timed,
            entries.len()
        )));
    }
    let mut times = None;
    if timed == entries.len() {
        let time = |entry: &Entry| entry.time.unwrap_or_default();
        if entries
            .windows(2)
            .any(|pair| time(&pair[0]) > time(&pair[1]))
        {
            notices.push(Notice::info(
                "files are not listed in the order of their times: sorted by time",
            ));
        }
        entries.sort_by(|a, b| time(a).total_cmp(&time(b)));
        times = Some(SeriesTimes {
            values: entries.iter().map(time).collect(),
            source: TimesSource::List,
        });
    }
    let name = entries.first().map(name_of_entry).unwrap_or_default();
    let first = entries.first().map_or(Path::new(""), |entry| &entry.file);
    Part {
        times,
        surface: name.surface,
        structure: name.structure,
        case: if name.case.is_empty() && name.surface.is_none() {
            format!("{}_{word}", stem(first))
        } else {
            name.case
        },
        files: entries.into_iter().map(|entry| entry.file).collect(),
    }
}
