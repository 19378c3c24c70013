//! Series files: `.pvd` (ParaView collections) and `.vtk.series` (JSON), which list files and times.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use serde::Deserialize;

use crate::io::formats::SERIES_EXTENSIONS;

/// Files in the order of time.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Series {
    /// Name of each part with its files; one part, except in collections of several.
    pub(super) parts: Vec<Vec<PathBuf>>,
    /// Time of each frame, in a unit that the format does not say.
    pub(super) times: Vec<f64>,
}

/// Whether a file lists other files.
pub(super) fn is_series(path: &Path) -> bool {
    path.extension().is_some_and(|ending| {
        let mut known = SERIES_EXTENSIONS.iter();
        known.any(|known| ending.eq_ignore_ascii_case(known))
    })
}

/// Reads a series file's text; `path` gives the format and the folder that names are relative to.
///
/// # Errors
/// A sentence with the line and the reason.
pub(super) fn read_series(path: &Path, text: &str) -> Result<Series, String> {
    let folder = path.parent().unwrap_or(Path::new(""));
    let is_pvd = path
        .extension()
        .is_some_and(|ending| ending.eq_ignore_ascii_case("pvd"));
    let entries = if is_pvd { pvd(text)? } else { json(text)? };
    if entries.is_empty() {
        return Err("lists no files".to_owned());
    }
    for entry in &entries {
        if !folder.join(&entry.file).is_file() {
            return Err(format!(
                "line {}: there is no file {:?}",
                entry.line, entry.file
            ));
        }
    }
    let mut by_part: BTreeMap<&str, Vec<&Entry>> = BTreeMap::new();
    for entry in &entries {
        by_part.entry(&entry.part).or_default().push(entry);
    }
    let mut times: Vec<f64> = Vec::new();
    let mut parts = Vec::new();
    for part in by_part.values_mut() {
        part.sort_by(|a, b| a.time.total_cmp(&b.time));
        let part_times: Vec<f64> = part.iter().map(|entry| entry.time).collect();
        if parts.is_empty() {
            times = part_times;
        } else if part_times != times {
            return Err("its parts have different times".to_owned());
        }
        parts.push(part.iter().map(|entry| folder.join(&entry.file)).collect());
    }
    Ok(Series { parts, times })
}

struct Entry {
    file: String,
    part: String,
    time: f64,
    line: usize,
}

fn pvd(text: &str) -> Result<Vec<Entry>, String> {
    let document = roxmltree::Document::parse(text)
        .map_err(|error| format!("line {}: {error}", error.pos().row))?;
    let line_of = |node: &roxmltree::Node| document.text_pos_at(node.range().start).row as usize;
    document
        .descendants()
        .filter(|node| node.has_tag_name("DataSet"))
        .enumerate()
        .map(|(index, node)| {
            let line = line_of(&node);
            let file = node
                .attribute("file")
                .ok_or_else(|| format!("line {line}: a DataSet without a file"))?;
            let time = match node.attribute("timestep") {
                Some(word) => finite(word)
                    .ok_or_else(|| format!("line {line}: timestep {word:?} is not a number"))?,
                None => index as f64,
            };
            let part = [node.attribute("group"), node.attribute("part")]
                .map(|word| word.unwrap_or_default())
                .join(" ");
            Ok(Entry {
                file: file.to_owned(),
                part,
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

fn json(text: &str) -> Result<Vec<Entry>, String> {
    let series: SeriesJson = serde_json::from_str(text).map_err(|error| {
        let reason = error.to_string();
        let reason = reason.split(" at line").next().unwrap_or_default();
        format!("line {}: {reason}", error.line())
    })?;
    Ok(series
        .files
        .into_iter()
        .enumerate()
        .map(|(index, entry)| Entry {
            line: line_naming(text, &entry.name),
            file: entry.name,
            part: String::new(),
            time: entry
                .time
                .filter(|time| time.is_finite())
                .unwrap_or(index as f64),
        })
        .collect())
}

fn line_naming(text: &str, name: &str) -> usize {
    text.lines()
        .position(|line| line.contains(name))
        .map_or(1, |line| line + 1)
}

fn finite(word: &str) -> Option<f64> {
    word.trim()
        .parse()
        .ok()
        .filter(|time: &f64| time.is_finite())
}

/// Seconds that a series' times mean, with the words for what was assumed; `None` where they only
/// count frames.
///
/// A beat lasts 0.3 to 2 s: times that end below 5 are seconds, others milliseconds.
pub(super) fn times_in_seconds(times: &[f64]) -> Option<(Vec<f64>, &'static str)> {
    let counts_frames = times
        .windows(2)
        .all(|pair| pair[0].fract() == 0.0 && pair[1] - pair[0] == 1.0);
    let last = times.last().copied()?;
    if counts_frames || !times.windows(2).all(|pair| pair[0] < pair[1]) || times[0] < 0.0 {
        None
    } else if last < 5.0 {
        Some((times.to_vec(), "s"))
    } else {
        Some((times.iter().map(|time| time / 1000.0).collect(), "ms"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn a_collection_lists_its_files_by_time() {
        let folder = tempfile::tempdir().unwrap();
        for name in ["a.vtp", "b.vtp"] {
            fs::write(folder.path().join(name), "").unwrap();
        }
        let text = "<VTKFile type=\"Collection\"><Collection>\n\
                    <DataSet timestep=\"0.4\" part=\"0\" file=\"a.vtp\"/>\n\
                    <DataSet timestep=\"0.1\" part=\"0\" file=\"b.vtp\"/>\n\
                    </Collection></VTKFile>";
        let path = folder.path().join("x.pvd");
        let series = read_series(&path, text).unwrap();
        assert_eq!(series.times, [0.1, 0.4]);
        assert_eq!(
            series.parts,
            [[folder.path().join("b.vtp"), folder.path().join("a.vtp")]]
        );
        let missing = text.replace("b.vtp", "c.vtp");
        assert_eq!(
            read_series(&path, &missing).unwrap_err(),
            "line 3: there is no file \"c.vtp\""
        );
        let wrong = text.replace("0.4", "soon");
        assert_eq!(
            read_series(&path, &wrong).unwrap_err(),
            "line 2: timestep \"soon\" is not a number"
        );
    }

    #[test]
    fn a_json_series_lists_its_files_by_time() {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("a.vtk"), "").unwrap();
        let path = folder.path().join("x.vtk.series");
        let text =
            "{\"file-series-version\":\"1.0\",\n\"files\":[{\"name\":\"a.vtk\",\"time\":3}]}";
        assert_eq!(read_series(&path, text).unwrap().times, [3.0]);
        let error = read_series(&path, "{\n\"files\": 3}").unwrap_err();
        assert!(error.starts_with("line 2: invalid type"), "{error}");
        assert_eq!(
            read_series(&path, "{\"files\": []}").unwrap_err(),
            "lists no files"
        );
    }

    #[test]
    fn times_are_seconds_milliseconds_or_mere_counts() {
        assert_eq!(times_in_seconds(&[0.0, 1.0, 2.0]), None);
        assert_eq!(times_in_seconds(&[0.0, 0.4]), Some((vec![0.0, 0.4], "s")));
        assert_eq!(
            times_in_seconds(&[0.0, 400.0]),
            Some((vec![0.0, 0.4], "ms"))
        );
        assert_eq!(times_in_seconds(&[]), None);
    }
}
