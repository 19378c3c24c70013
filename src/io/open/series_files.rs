//! Lists of files: `.pvd` (ParaView collections) and `.vtk.series` (JSON), with times.

use std::path::{Path, PathBuf};

use serde::Deserialize;

use super::folders::Folders;
use super::listed_files::listed_file;
use super::series_parts::{Entry, Part, parts_of};
use crate::io::formats::SERIES_EXTENSIONS;
use crate::progress::{Progress, Stopped};
use crate::study::Notice;
use crate::study::checks::counted;

/// What a list says.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Series {
    /// One part, except in lists of several surfaces.
    pub(super) parts: Vec<Part>,
    /// What was assumed.
    pub(super) notices: Vec<Notice>,
}

/// Why a list cannot be used.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct SeriesFault {
    pub(super) reason: String,
    /// The files that it lists and that are there: they are no frames by themselves.
    pub(super) listed: Vec<PathBuf>,
}

/// Whether a file lists other files.
pub(super) fn is_series(path: &Path) -> bool {
    path.extension().is_some_and(|ending| {
        let mut known = SERIES_EXTENSIONS.iter();
        known.any(|known| ending.eq_ignore_ascii_case(known))
    })
}

/// Reads a list's text; `path` gives the format and the folder that names are relative to.
///
/// # Errors
/// Inside: a sentence with the line and the reason. Outside: [`Stopped`].
pub(super) fn read_series(
    path: &Path,
    text: &str,
    folders: &mut Folders,
    progress: &Progress,
) -> Result<Result<Series, SeriesFault>, Stopped> {
    let folder = path.parent().unwrap_or(Path::new(""));
    let is_pvd = path
        .extension()
        .is_some_and(|ending| ending.eq_ignore_ascii_case("pvd"));
    let mut listed = Vec::new();
    let fault = |reason: String, listed| Ok(Err(SeriesFault { reason, listed }));
    let written = match if is_pvd { pvd(text) } else { json(text) } {
        Ok(written) => written,
        Err(reason) => return fault(reason, listed),
    };
    if written.is_empty() {
        return fault("lists no files".to_owned(), listed);
    }
    let (mut entries, mut notices) = (Vec::new(), Vec::new());
    let (mut missing, mut moved) = (None, Vec::new());
    for Written {
        name,
        part,
        time,
        line,
    } in written
    {
        progress.check()?;
        match listed_file(folders, folder, &name, progress)? {
            Some((file, elsewhere)) => {
                if let Some(why) = folders.unusable(&file) {
                    missing = missing.or(Some(format!("line {line}: {name:?}: {why}")));
                }
                if elsewhere {
                    moved.push(name);
                }
                listed.push(file.clone());
                entries.push(Entry { file, part, time });
            }
            None if missing.is_none() => {
                missing = Some(format!("line {line}: there is no file {name:?}"));
            }
            None => {}
        }
    }
    if let Some(reason) = missing {
        return fault(reason, listed);
    }
    if let Some(first) = moved.first() {
        notices.push(Notice::info(format!(
            "{} listed by a path of another machine ({first:?}) read from beside the list",
            counted(moved.len(), "file", "files")
        )));
    }
    Ok(match parts_of(entries, &mut notices) {
        Ok(parts) => Ok(Series { parts, notices }),
        Err(reason) => Err(SeriesFault { reason, listed }),
    })
}

/// One file as a list writes it.
struct Written {
    name: String,
    part: String,
    time: Option<f64>,
    line: usize,
}

fn pvd(text: &str) -> Result<Vec<Written>, String> {
    let document = roxmltree::Document::parse(text)
        .map_err(|error| format!("line {}: {error}", error.pos().row))?;
    // the rows of nodes, counted once along the text
    let mut row = (0, 1);
    let mut line_of = |node: &roxmltree::Node| {
        let start = node.range().start;
        let between = text.as_bytes().get(row.0..start).unwrap_or_default();
        row = (
            start,
            row.1 + between.iter().filter(|&&b| b == b'\n').count(),
        );
        row.1
    };
    document
        .descendants()
        .filter(|node| node.has_tag_name("DataSet"))
        .map(|node| {
            let line = line_of(&node);
            let name = node
                .attribute("file")
                .ok_or_else(|| format!("line {line}: a DataSet without a file"))?;
            let time = match node.attribute("timestep").map(str::trim) {
                Some("") | None => None,
                Some(word) => Some(
                    finite(word)
                        .ok_or_else(|| format!("line {line}: timestep {word:?} is not a number"))?,
                ),
            };
            let part: Vec<&str> = ["group", "part", "name"]
                .iter()
                .filter_map(|key| node.attribute(*key))
                .filter(|word| !word.trim().is_empty())
                .collect();
            Ok(Written {
                name: name.to_owned(),
                part: part.join(" "),
                time,
                line,
            })
        })
        .collect()
}

#[derive(Deserialize)]
struct SeriesJson {
    files: Vec<SeriesEntry>,
}

#[derive(Deserialize)]
struct SeriesEntry {
    name: String,
    time: Option<f64>,
}

fn json(text: &str) -> Result<Vec<Written>, String> {
    let series: SeriesJson = serde_json::from_str(text).map_err(|error| {
        let reason = error.to_string();
        let reason = reason.split(" at line").next().unwrap_or_default();
        format!("line {}: {reason}", error.line())
    })?;
    let mut place = (0, 1);
    Ok(series
        .files
        .into_iter()
        .map(|entry| Written {
            line: line_naming(text, &entry.name, &mut place),
            name: entry.name,
            part: String::new(),
            time: entry.time.filter(|time| time.is_finite()),
        })
        .collect())
}

/// The line of the next place that names a file, from a place and its line on.
fn line_naming(text: &str, name: &str, (from, line): &mut (usize, usize)) -> usize {
    let rest = text.get(*from..).unwrap_or_default();
    if let Some(found) = rest.find(name) {
        *line += rest[..found].bytes().filter(|&b| b == b'\n').count();
        *from += found;
    }
    *line
}

fn finite(word: &str) -> Option<f64> {
    word.parse().ok().filter(|time: &f64| time.is_finite())
}

#[cfg(test)]
mod tests;
