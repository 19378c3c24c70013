//! `study.toml`: what a manifest says about a cohort, before its patterns are looked up.
//!
//! ```toml
//! name = "Rest and stress"
//! units = "mm"                     # or "file" where coordinates are voxels; found from the size if absent
//! normal = ["NOR"]                 # labels that count as healthy
//! abnormal = ["MINF", "DCM"]
//!
//! [[subject]]
//! id = "n01"
//! label = "NOR"
//! surface = "endo+epi"             # or "wall", "cavity"; may be left out
//! endo = "n01/endo_*.ply"          # a pattern, or a list of them
//! epi = "n01/epi_*.ply"
//! time_ms = [0.0, 110.5, 221.0]    # after the R peak; and/or:
//! rr_ms = 890.0
//! end_diastole = 0                 # frames count from 0
//! end_systole = 1
//! height_cm = 172.0
//! weight_kg = 71.5
//! # points in the coordinates of frame 0; of the last two only the direction from the axis counts
//! orientation = { apex = [0, 0, -80], base = [0, 0, 0], septum = [30, 0, 0], anterior = [0, 30, 0] }
//! excluded = true                  # stays in the study, and no analysis of the cohort counts it
//! ```

use toml::de::{DeTable, DeValue};

use super::folders::composed;
use super::plan::{Stated, StatedUnit};
use super::plausible::without_implausible;
use super::toml_fields::{Fields, Lines};
use crate::io::limits::MAX_SUBJECTS;
use crate::mesh::Point3;
use crate::study::{Anatomy, LabelClasses, Notice, SurfaceKind};

/// Unknown keys of one table that are told one by one.
const MAX_UNKNOWN: usize = 20;

/// A manifest as text says it.
#[derive(Debug, Default)]
pub(super) struct Manifest {
    pub(super) name: Option<String>,
    pub(super) unit: Option<StatedUnit>,
    pub(super) label_classes: Option<LabelClasses>,
    pub(super) subjects: Vec<Result<ManifestSubject, SubjectError>>,
    pub(super) notices: Vec<Notice>,
}

/// One `[[subject]]`.
#[derive(Debug)]
pub(super) struct ManifestSubject {
    pub(super) id: String,
    pub(super) line: usize,
    pub(super) stated: Stated,
    /// Surfaces with their patterns; none if files are to be found out.
    pub(super) surfaces: Vec<(SurfaceKind, Vec<String>)>,
    pub(super) notices: Vec<Notice>,
}

/// Why one `[[subject]]` cannot be used.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct SubjectError {
    pub(super) id: Option<String>,
    pub(super) reason: String,
}

/// Reads a manifest's text.
///
/// # Errors
/// A sentence with the line, where the text is not TOML or a field of the whole study is wrong. A
/// wrong subject is an error among the subjects.
pub(super) fn parse_manifest(text: &str) -> Result<Manifest, String> {
    let lines = Lines::of(text);
    let document = DeTable::parse(text).map_err(|error| {
        let line = error.span().map_or(1, |span| lines.at(span.start));
        let message = error.message().lines().collect::<Vec<_>>().join(", ");
        format!("line {line}: {message}")
    })?;
    let mut fields = Fields::new(&lines, document.get_ref());
    let name = fields.string("name")?;
    let unit = unit(&mut fields)?;
    let label_classes = label_classes(&mut fields)?;
    let subjects = match fields.value("subject") {
        None => Vec::new(),
        Some(DeValue::Array(items)) => {
            if items.len() > MAX_SUBJECTS {
                return Err(format!(
                    "{} subjects; the limit is {MAX_SUBJECTS}",
                    items.len()
                ));
            }
            let mut subjects = Vec::with_capacity(items.len());
            for (index, item) in items.iter().enumerate() {
                let line = lines.at(item.span().start);
                let table = item.get_ref().as_table().ok_or_else(|| {
                    format!("line {line}: subject must be written as [[subject]]")
                })?;
                subjects.push(subject(Fields::new(&lines, table), index, line));
            }
            subjects
        }
        Some(_) => {
            let line = fields.line_of("subject").unwrap_or(1);
            return Err(format!(
                "line {line}: subject must be written as [[subject]]"
            ));
        }
    };
    let notices = unknown_keys(&fields);
    Ok(Manifest {
        name,
        unit,
        label_classes,
        subjects,
        notices,
    })
}

fn unit(fields: &mut Fields) -> Result<Option<StatedUnit>, String> {
    let Some(word) = fields.string("units")? else {
        return Ok(None);
    };
    StatedUnit::of_word(&word).map(Some).ok_or_else(|| {
        let line = fields.line_of("units").unwrap_or(1);
        format!("line {line}: units are {word:?}; \"mm\", \"cm\", \"m\" and \"file\" are known")
    })
}

fn label_classes(fields: &mut Fields) -> Result<Option<LabelClasses>, String> {
    let normal = fields.strings("normal")?;
    let abnormal = fields.strings("abnormal")?;
    if normal.is_none() && abnormal.is_none() {
        return Ok(None);
    }
    let usual = LabelClasses::default();
    let composed = |labels: Vec<String>| labels.iter().map(|label| composed(label)).collect();
    Ok(Some(LabelClasses {
        normal: normal.map_or(usual.normal, composed),
        abnormal: abnormal.map_or(usual.abnormal, composed),
    }))
}

fn unknown_keys(fields: &Fields) -> Vec<Notice> {
    let unknown = fields.unknown();
    let mut notices: Vec<Notice> = unknown
        .iter()
        .take(MAX_UNKNOWN)
        .map(|(line, key, meant)| {
            let key: String = key.chars().take(80).collect();
            let meant = meant.map_or_else(String::new, |meant| format!("; {meant} is meant?"));
            Notice::warning(format!(
                "study.toml, line {line}: unknown key {key:?}, ignored{meant}"
            ))
        })
        .collect();
    if let Some(more) = unknown
        .len()
        .checked_sub(MAX_UNKNOWN)
        .filter(|&more| more > 0)
    {
        notices.push(Notice::warning(format!(
            "study.toml: {more} more unknown keys, ignored"
        )));
    }
    notices
}

fn subject(mut fields: Fields, index: usize, line: usize) -> Result<ManifestSubject, SubjectError> {
    let id = match fields.string("id") {
        Ok(Some(id)) if !id.trim().is_empty() => composed(&id),
        Ok(_) => {
            return Err(SubjectError {
                id: None,
                reason: format!("line {line}: subject {index} has no id"),
            });
        }
        Err(reason) => return Err(SubjectError { id: None, reason }),
    };
    let mut notices = Vec::new();
    let read = |fields: &mut Fields, notices: &mut Vec<Notice>| {
        Ok((stated(fields, notices)?, surfaces(fields, line)?))
    };
    match read(&mut fields, &mut notices) {
        Ok((mut stated, surfaces)) => {
            notices.extend(without_implausible(&mut stated));
            notices.extend(unknown_keys(&fields));
            Ok(ManifestSubject {
                id,
                line,
                stated,
                surfaces,
                notices,
            })
        }
        Err(reason) => Err(SubjectError {
            id: Some(id),
            reason,
        }),
    }
}

fn stated(fields: &mut Fields, notices: &mut Vec<Notice>) -> Result<Stated, String> {
    Ok(Stated {
        label: fields.string("label")?.map(|label| composed(&label)),
        unit: unit(fields)?,
        frame_times_s: fields
            .numbers("time_ms")?
            .map(|times| times.into_iter().map(|ms| ms / 1000.0).collect()),
        rr_s: fields.positive("rr_ms")?.map(|ms| ms / 1000.0),
        end_diastole: fields.index("end_diastole")?,
        end_systole: fields.index("end_systole")?,
        height_cm: fields.positive("height_cm")?,
        weight_kg: fields.positive("weight_kg")?,
        anatomy: anatomy(fields, notices)?,
        excluded: fields.flag("excluded")?,
    })
}

fn anatomy(fields: &mut Fields, notices: &mut Vec<Notice>) -> Result<Option<Anatomy>, String> {
    let Some(mut orientation) = fields.table("orientation")? else {
        return Ok(None);
    };
    let mut landmarks = [Point3::origin(); 4];
    for (landmark, key) in landmarks
        .iter_mut()
        .zip(["apex", "base", "septum", "anterior"])
    {
        let Some([x, y, z]) = orientation.point(key)? else {
            let line = fields.line_of("orientation").unwrap_or(1);
            return Err(format!("line {line}: orientation has no {key}"));
        };
        *landmark = Point3::new(x, y, z);
    }
    notices.extend(unknown_keys(&orientation));
    let [apex, base, septum, anterior] = landmarks;
    let anatomy = Anatomy::from_landmarks(apex, base, septum, anterior);
    if anatomy.is_none() {
        notices.push(Notice::warning(
            "the orientation landmarks lie on one line or coincide: no anatomical names",
        ));
    }
    Ok(anatomy)
}

/// Surfaces with their patterns, held against what `surface` says.
fn surfaces(fields: &mut Fields, line: usize) -> Result<Vec<(SurfaceKind, Vec<String>)>, String> {
    let surface = fields.string("surface")?;
    let expected: Option<&[&str]> = match surface.as_deref() {
        None => None,
        Some("wall") => Some(&["wall"]),
        Some("endo+epi") => Some(&["endo", "epi"]),
        Some("cavity") => Some(&["cavity"]),
        Some("endo") => Some(&["endo"]),
        Some("epi") => Some(&["epi"]),
        Some("other") => Some(&["other"]),
        Some(word) => {
            let line = fields.line_of("surface").unwrap_or(line);
            return Err(format!(
                "line {line}: surface is {word:?}; \"wall\", \"endo+epi\" and \"cavity\" are known"
            ));
        }
    };
    let mut found = Vec::new();
    for (key, kind) in [
        ("endo", SurfaceKind::Endocardium),
        ("epi", SurfaceKind::Epicardium),
        ("wall", SurfaceKind::Wall),
        ("cavity", SurfaceKind::Cavity),
        ("other", SurfaceKind::Other),
    ] {
        if let Some(patterns) = fields.strings(key)? {
            found.push((key, kind, patterns));
        }
    }
    if let Some(expected) = expected
        && !found.is_empty()
        && let Some(missing) = expected
            .iter()
            .find(|key| !found.iter().any(|(name, _, _)| name == *key))
    {
        return Err(format!(
            "line {line}: surface is {:?}, but there is no {missing} = \"…\"",
            surface.unwrap_or_default()
        ));
    }
    Ok(found
        .into_iter()
        .map(|(_, kind, patterns)| (kind, patterns))
        .collect())
}

#[cfg(test)]
mod tests;
