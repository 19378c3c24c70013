//! Loose mesh files of one folder, sorted into subjects, surfaces and frames by their names.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use super::file_name::{FrameName, mesh_name};
use super::natural_order::natural_order;
use super::plan::{KindPlan, SeriesTimes, Stated, SubjectPlan, SurfacePlan};
use crate::io::OpenError;
use crate::study::checks::counted;
use crate::study::{Notice, SurfaceKind};

/// A mesh file, or a series of them that another file lists.
#[derive(Clone, Debug)]
pub(super) struct LooseFile {
    /// The file whose name says what it is.
    pub(super) path: PathBuf,
    /// The files of a series in the order of time, and their times.
    pub(super) series: Option<(Vec<PathBuf>, SeriesTimes)>,
    /// Which sheet the name of its folder says it is.
    pub(super) folder_surface: Option<SurfaceKind>,
}

/// One file with what its name says.
struct Named {
    kind: KindPlan,
    frame: Option<FrameName>,
    file: LooseFile,
}

/// Sorts files into subjects. `whole_name` is the id of a subject that is alone, or has no name.
pub(super) fn group_files(
    files: Vec<LooseFile>,
    folder: &Path,
    whole_name: &str,
) -> (Vec<SubjectPlan>, Vec<OpenError>) {
    let mut cases: BTreeMap<CaseKey, Vec<Named>> = BTreeMap::new();
    for file in files {
        let name = mesh_name(&stem(&file.path));
        let kind = match name.surface.or(file.folder_surface) {
            Some(kind) => KindPlan::Known(kind),
            None if name.ventricle => KindPlan::Ventricle,
            None => KindPlan::Unnamed,
        };
        cases.entry(CaseKey(name.case)).or_default().push(Named {
            kind,
            frame: name.frame,
            file,
        });
    }
    let alone = cases.len() == 1;
    let (mut plans, mut errors) = (Vec::new(), Vec::new());
    for (CaseKey(case), members) in cases {
        let id = if alone || case.is_empty() {
            whole_name.to_owned()
        } else {
            case
        };
        match subject(&id, folder, members) {
            Ok(plan) => plans.push(plan),
            Err((path, reason)) => errors.push(OpenError {
                subject: Some(id),
                path,
                reason,
            }),
        }
    }
    (plans, errors)
}

/// Cases come in natural order.
#[derive(PartialEq, Eq)]
struct CaseKey(String);

impl Ord for CaseKey {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        natural_order(&self.0, &other.0)
    }
}

impl PartialOrd for CaseKey {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

/// Name of a file without its ending, also without the first of a double ending (`x.vtk.series`).
pub(super) fn stem(path: &Path) -> String {
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    match (path.extension(), stem.rsplit_once('.')) {
        (Some(ending), Some((stem, _))) if ending.eq_ignore_ascii_case("series") => stem.to_owned(),
        _ => stem.into_owned(),
    }
}

fn subject(id: &str, folder: &Path, members: Vec<Named>) -> Result<SubjectPlan, (PathBuf, String)> {
    let mut notices = Vec::new();
    let mut by_kind: BTreeMap<KindPlan, Vec<Named>> = BTreeMap::new();
    for member in members {
        by_kind.entry(member.kind).or_default().push(member);
    }
    let mut surfaces = Vec::new();
    let mut frames_of: Vec<(KindPlan, Vec<FrameName>)> = Vec::new();
    for (kind, members) in by_kind {
        let mut members = one_ending(members, &mut notices);
        members.sort_by(|a, b| {
            a.frame.cmp(&b.frame).then_with(|| {
                natural_order(
                    &a.file.path.to_string_lossy(),
                    &b.file.path.to_string_lossy(),
                )
            })
        });
        if let Some(pair) = members
            .windows(2)
            .find(|pair| pair[0].frame == pair[1].frame)
        {
            let first = file_name(&pair[0].file.path);
            return Err((
                pair[1].file.path.clone(),
                format!("{first} has the same surface and frame in its name"),
            ));
        }
        frames_of.push((kind, members.iter().filter_map(|m| m.frame).collect()));
        surfaces.push(surface_plan(kind, members));
    }
    same_frames(&frames_of).map_err(|reason| (folder.to_owned(), reason))?;
    let mut stated = Stated::default();
    if let Some((_, frames)) = frames_of.first() {
        notices.extend(numbering_notice(frames));
        name_phases(frames, &mut stated, &mut notices);
    }
    let place = match surfaces.as_slice() {
        [surface] if surface.files.len() == 1 => surface.files[0].clone(),
        _ => folder.to_owned(),
    };
    Ok(SubjectPlan {
        id: id.to_owned(),
        place,
        surfaces,
        stated,
        notices,
    })
}

fn surface_plan(kind: KindPlan, members: Vec<Named>) -> SurfacePlan {
    let mut plan = SurfacePlan {
        kind,
        files: Vec::new(),
        times: None,
    };
    for member in members {
        match member.file.series {
            Some((files, times)) => {
                plan.files.extend(files);
                plan.times = Some(times);
            }
            None => plan.files.push(member.file.path),
        }
    }
    plan
}

/// Keeps the files of the commonest ending where the same frame lies there in several formats.
fn one_ending(members: Vec<Named>, notices: &mut Vec<Notice>) -> Vec<Named> {
    let frames: BTreeSet<Option<FrameName>> = members.iter().map(|m| m.frame).collect();
    if frames.len() == members.len() {
        return members;
    }
    let mut by_ending: BTreeMap<String, Vec<Named>> = BTreeMap::new();
    for member in members {
        let ending = member.file.path.extension().unwrap_or_default();
        let ending = ending.to_string_lossy().to_ascii_lowercase();
        by_ending.entry(ending).or_default().push(member);
    }
    let most = by_ending.values().map(Vec::len).max().unwrap_or(0);
    let mut kept = None;
    for (ending, members) in by_ending {
        if kept.is_none() && members.len() == most {
            kept = Some(members);
        } else {
            notices.push(Notice::info(format!(
                "{} with the extension .{ending} hold the same frames and are not read",
                counted(members.len(), "file", "files")
            )));
        }
    }
    kept.unwrap_or_default()
}

/// All surfaces must have the same frames by name.
fn same_frames(frames_of: &[(KindPlan, Vec<FrameName>)]) -> Result<(), String> {
    let Some(((first_kind, first), rest)) = frames_of.split_first() else {
        return Ok(());
    };
    for (kind, frames) in rest {
        let missing = |have: &[FrameName], from: &[FrameName]| {
            from.iter().find(|frame| !have.contains(frame)).copied()
        };
        let lacks = |kind: KindPlan, frame: FrameName, other: KindPlan| {
            format!(
                "{} has no {}, which {} has",
                word_of_kind(kind),
                word_of_frame(frame),
                word_of_kind(other)
            )
        };
        if let Some(frame) = missing(frames, first) {
            return Err(lacks(*kind, frame, *first_kind));
        }
        if let Some(frame) = missing(first, frames) {
            return Err(lacks(*first_kind, frame, *kind));
        }
    }
    Ok(())
}

fn word_of_kind(kind: KindPlan) -> &'static str {
    match kind {
        KindPlan::Known(kind) => kind.name(),
        KindPlan::Ventricle => "ventricle",
        KindPlan::Unnamed => "surface",
    }
}

fn word_of_frame(frame: FrameName) -> String {
    match frame {
        FrameName::EndDiastole => "ED file".to_owned(),
        FrameName::EndSystole => "ES file".to_owned(),
        FrameName::Number(number) => format!("file {number}"),
    }
}

/// Numbers that skip some: an even step gives a note, a gap a warning.
fn numbering_notice(frames: &[FrameName]) -> Option<Notice> {
    let numbers: Vec<u64> = frames
        .iter()
        .filter_map(|frame| match frame {
            FrameName::Number(number) => Some(*number),
            _ => None,
        })
        .collect();
    let steps: BTreeSet<u64> = numbers.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let (first, last) = (numbers.first()?, numbers.last()?);
    match steps.first() {
        None | Some(1) if steps.len() <= 1 => None,
        Some(step) if steps.len() == 1 && numbers.len() > 2 => Some(Notice::info(format!(
            "files are numbered {first} to {last} in steps of {step}: {} frames, assumed evenly spaced",
            numbers.len()
        ))),
        _ => {
            let missing = last - first + 1 - numbers.len() as u64;
            let gap = numbers.windows(2).find(|pair| pair[1] - pair[0] > 1)?;
            Some(Notice::warning(format!(
                "{} missing between file {first} and file {last} (the first is {}): the motion jumps there",
                counted(missing as usize, "number is", "numbers are"),
                gap[0] + 1
            )))
        }
    }
}

/// Takes end-diastole and end-systole from names that say them.
fn name_phases(frames: &[FrameName], stated: &mut Stated, notices: &mut Vec<Notice>) {
    let place = |phase| frames.iter().position(|&frame| frame == phase);
    stated.end_diastole = place(FrameName::EndDiastole);
    stated.end_systole = place(FrameName::EndSystole);
    let text = match (stated.end_diastole, stated.end_systole) {
        (Some(diastole), Some(systole)) => format!(
            "end-diastole (frame {diastole}) and end-systole (frame {systole}) from the file names; times between them are not known"
        ),
        (Some(_), None) => "end-diastole only, by its file name".to_owned(),
        (None, Some(_)) => "end-systole only, by its file name".to_owned(),
        (None, None) => return,
    };
    notices.push(Notice::info(text));
}

fn file_name(path: &Path) -> String {
    path.file_name()
        .unwrap_or_default()
        .to_string_lossy()
        .into_owned()
}

#[cfg(test)]
mod tests;
