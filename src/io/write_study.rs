//! A study on disk: `study.toml` and a folder of numbered frames per subject.

use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::MeshFormat;
use super::formats::SeriesWriter;
use crate::progress::{Progress, Stopped};
use crate::study::{Anatomy, MeshSequence, Study, Subject, SurfaceKind};
use crate::units::LengthUnit;

/// Why a study could not be written.
#[derive(Debug, thiserror::Error)]
pub enum WriteStudyError {
    /// It was asked to stop; no error to show. Frames written so far stay.
    #[error(transparent)]
    Stopped(#[from] Stopped),
    /// A file would be taken for one of the study's when it is read again.
    #[error("this file would be read as a frame of {subject}; choose an empty folder: {}", path.display())]
    InTheWay {
        /// The subject.
        subject: String,
        /// The file that lies there already.
        path: PathBuf,
    },
    /// The system refused.
    #[error("{source}: {}", path.display())]
    Io {
        /// Why.
        source: io::Error,
        /// The file or folder.
        path: PathBuf,
    },
}

/// Writes `study.toml` and one folder per subject into `folder`, made if need be; each frame of each
/// surface is a step.
///
/// Files of the same name are written over, no others are touched. Reading the folder gives the same
/// study again: all coordinates bit by bit, directions of the anatomy but for rounding.
///
/// # Errors
/// [`WriteStudyError::InTheWay`] before anything is written, if a folder holds other frames already.
pub fn write_study(
    study: &Study,
    folder: &Path,
    format: MeshFormat,
    progress: &Progress,
) -> Result<(), WriteStudyError> {
    let order = study.in_order();
    let subjects: Vec<&Arc<Subject>> = order.iter().filter_map(|&i| study.subject(i)).collect();
    let names = folder_names(&subjects.iter().map(|s| s.id.as_str()).collect::<Vec<_>>());
    for (subject, name) in subjects.iter().zip(&names) {
        nothing_in_the_way(subject, &folder.join(name), format)?;
    }
    let steps = subjects
        .iter()
        .map(|s| s.sequence.frame_count() * s.sequence.surfaces().len())
        .sum();
    progress.expect_steps(steps);
    for (subject, name) in subjects.iter().zip(&names) {
        let place = folder.join(name);
        fs::create_dir_all(&place).map_err(at(&place))?;
        for surface in subject.sequence.surfaces() {
            for (frame, mesh) in surface.frames().iter().enumerate() {
                let path = place.join(frame_file(surface.kind(), frame, format));
                write_whole(&path, |out| (format.writer.mesh)(out, mesh))?;
                progress.step()?;
            }
            if let Some(SeriesWriter { extension, write }) = format.writer.series {
                let path = place.join(format!("{}.{extension}", key(surface.kind())));
                let entries = series_entries(subject, surface.kind(), format);
                write_whole(&path, |out| write(out, &entries))?;
            }
        }
    }
    fs::create_dir_all(folder).map_err(at(folder))?;
    let manifest = manifest(study, &names, format);
    write_whole(&folder.join("study.toml"), |out| {
        out.write_all(manifest.as_bytes())
    })
}

fn at(path: &Path) -> impl FnOnce(io::Error) -> WriteStudyError {
    let path = path.to_owned();
    |source| WriteStudyError::Io { source, path }
}

fn write_whole(
    path: &Path,
    write: impl FnOnce(&mut BufWriter<File>) -> io::Result<()>,
) -> Result<(), WriteStudyError> {
    File::create(path)
        .and_then(|file| {
            let mut out = BufWriter::new(file);
            write(&mut out)?;
            out.flush()
        })
        .map_err(at(path))
}

/// The key of a surface in the manifest, and the beginning of its files.
fn key(kind: SurfaceKind) -> &'static str {
    match kind {
        SurfaceKind::Endocardium => "endo",
        SurfaceKind::Epicardium => "epi",
        SurfaceKind::Wall => "wall",
        SurfaceKind::Cavity => "cavity",
        SurfaceKind::Other => "other",
    }
}

fn frame_file(kind: SurfaceKind, frame: usize, format: MeshFormat) -> String {
    format!("{}_{frame:03}.{}", key(kind), format.extension())
}

/// Each frame's file with its time in seconds, or with its number where times are not known.
fn series_entries(subject: &Subject, kind: SurfaceKind, format: MeshFormat) -> Vec<(f64, String)> {
    let times = subject.timing.frame_times_s.as_deref();
    (0..subject.sequence.frame_count())
        .map(|frame| {
            let time = times.and_then(|times| times.get(frame).copied());
            let file = frame_file(kind, frame, format);
            (time.unwrap_or(frame as f64), file)
        })
        .collect()
}

/// Frames that lie there and will not be written over would be read as part of the sequence.
fn nothing_in_the_way(
    subject: &Subject,
    place: &Path,
    format: MeshFormat,
) -> Result<(), WriteStudyError> {
    let Ok(entries) = fs::read_dir(place) else {
        return Ok(());
    };
    for entry in entries.flatten() {
        let name = entry.file_name().to_string_lossy().into_owned();
        for surface in subject.sequence.surfaces() {
            let kind = surface.kind();
            let looks_like_a_frame = name.starts_with(&format!("{}_", key(kind)))
                && name.ends_with(&format!(".{}", format.extension()));
            let is_ours = (0..surface.frames().len()).any(|f| name == frame_file(kind, f, format));
            if looks_like_a_frame && !is_ours {
                return Err(WriteStudyError::InTheWay {
                    subject: subject.id.clone(),
                    path: entry.path(),
                });
            }
        }
    }
    Ok(())
}

/// Folder names that every system allows, one per subject, different even where letter case does
/// not count.
fn folder_names(ids: &[&str]) -> Vec<String> {
    let mut taken = std::collections::HashSet::new();
    ids.iter()
        .map(|id| {
            let safe: String = id
                .chars()
                .map(|c| {
                    if c.is_ascii_alphanumeric() || "-_".contains(c) {
                        c
                    } else {
                        '_'
                    }
                })
                .take(80)
                .collect();
            let safe = if safe.is_empty() {
                "_".to_owned()
            } else {
                safe
            };
            let mut name = safe.clone();
            let mut number = 2;
            while !taken.insert(name.to_lowercase()) {
                name = format!("{safe}_{number}");
                number += 1;
            }
            name
        })
        .collect()
}

fn manifest(study: &Study, names: &[String], format: MeshFormat) -> String {
    let mut text = String::new();
    let first_unit = study.subjects.first().map(|subject| subject.unit);
    let one_unit = study.all().all(|s| Some(s.unit) == first_unit);
    text += &format!("name = {}\n", quoted(&study.name));
    if let (Some(unit), true) = (first_unit, one_unit) {
        text += &format!("units = \"{}\"\n", unit_word(unit));
    }
    text += &format!("normal = {}\n", quoted_list(&study.label_classes.normal));
    text += &format!(
        "abnormal = {}\n",
        quoted_list(&study.label_classes.abnormal)
    );
    for (index, name) in study.in_order().into_iter().zip(names) {
        let Some(subject) = study.subject(index) else {
            continue;
        };
        text += "\n[[subject]]\n";
        text += &format!("id = {}\n", quoted(&subject.id));
        if !one_unit {
            text += &format!("units = \"{}\"\n", unit_word(subject.unit));
        }
        if study.is_excluded(index) {
            text += "excluded = true\n";
        }
        text += &subject_fields(subject, name, format);
    }
    text
}

fn subject_fields(subject: &Subject, folder: &str, format: MeshFormat) -> String {
    let mut text = String::new();
    if let Some(label) = &subject.label {
        text += &format!("label = {}\n", quoted(label));
    }
    if let Some(word) = surface_word(&subject.sequence) {
        text += &format!("surface = \"{word}\"\n");
    }
    for surface in subject.sequence.surfaces() {
        let key = key(surface.kind());
        text += &format!("{key} = \"{folder}/{key}_*.{}\"\n", format.extension());
    }
    if let Some(times) = &subject.timing.frame_times_s {
        let times: Vec<String> = times.iter().map(|&t| number(milliseconds(t))).collect();
        text += &format!("time_ms = [{}]\n", times.join(", "));
    }
    if let Some(rr) = subject.timing.rr {
        text += &format!("rr_ms = {}\n", number(milliseconds(rr.0)));
    }
    for (key, frame) in [
        ("end_diastole", subject.end_diastole),
        ("end_systole", subject.end_systole),
    ] {
        if let Some(frame) = frame {
            text += &format!("{key} = {frame}\n");
        }
    }
    for (key, value) in [
        ("height_cm", subject.height_cm),
        ("weight_kg", subject.weight_kg),
    ] {
        if let Some(value) = value {
            text += &format!("{key} = {}\n", number(value));
        }
    }
    if let Some(anatomy) = &subject.anatomy {
        text += &orientation(anatomy);
    }
    text
}

/// Landmarks from which the directions follow again.
fn orientation(anatomy: &Anatomy) -> String {
    let marks = anatomy.landmarks();
    let fields = [
        ("apex", marks.apex),
        ("base", marks.base),
        ("septum", marks.septum),
        ("anterior", marks.anterior),
    ];
    let fields = fields.into_iter().filter_map(|(key, point)| {
        let [x, y, z] = point?.coords.map(number).into();
        Some(format!("{key} = [{x}, {y}, {z}]"))
    });
    let fields: Vec<String> = fields.collect();
    format!("orientation = {{ {} }}\n", fields.join(", "))
}

fn surface_word(sequence: &MeshSequence) -> Option<&'static str> {
    let kinds: Vec<SurfaceKind> = sequence.surfaces().iter().map(|s| s.kind()).collect();
    match kinds.as_slice() {
        [SurfaceKind::Wall] => Some("wall"),
        [SurfaceKind::Cavity] => Some("cavity"),
        [SurfaceKind::Endocardium, SurfaceKind::Epicardium] => Some("endo+epi"),
        _ => None,
    }
}

fn unit_word(unit: LengthUnit) -> &'static str {
    match unit {
        LengthUnit::Millimetre => "mm",
        LengthUnit::FileUnit => "file",
    }
}

/// Milliseconds that give the same seconds again when divided by 1000, where there are such.
fn milliseconds(seconds: f64) -> f64 {
    let near = seconds * 1000.0;
    [near, near.next_up(), near.next_down()]
        .into_iter()
        .find(|ms| ms / 1000.0 == seconds)
        .unwrap_or(near)
}

/// A TOML float that reads back bit by bit.
fn number(value: f64) -> String {
    format!("{value:?}")
}

fn quoted(text: &str) -> String {
    toml::Value::String(text.to_owned()).to_string()
}

fn quoted_list(items: &[String]) -> String {
    let items: Vec<String> = items.iter().map(|item| quoted(item)).collect();
    format!("[{}]", items.join(", "))
}

#[cfg(test)]
mod tests;
