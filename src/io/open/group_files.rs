//! Loose mesh files of one folder, sorted into subjects, surfaces and frames by their names.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use super::file_name::{MeshName, NameParts, PhaseUse, Reading};
use super::frame_facts::{take_facts, word_of_frame};
use super::frame_name::FrameName;
use super::one_ending::one_ending;
use super::plan::SeriesTimes;
use super::plan::{KindPlan, Stated, SubjectPlan, SurfacePlan};
use super::read_file::name_of;
use super::readings::read_names;
use crate::io::OpenError;
use crate::study::checks::counted;
use crate::study::{Notice, SurfaceKind, natural_order};

/// A mesh file, or a series of them that another file lists.
#[derive(Clone, Debug, Default)]
pub(super) struct LooseFile {
    /// The file that is read, or the list.
    pub(super) path: PathBuf,
    /// The name that tells what it is, without an ending.
    pub(super) stem: String,
    /// The files of a series in the order of time, and their times.
    pub(super) series: Option<(Vec<PathBuf>, Option<SeriesTimes>)>,
    /// Which surface it is, whatever its name says.
    pub(super) own_surface: Option<SurfaceKind>,
    /// Which surface the name of its folder says it is, if its own does not.
    pub(super) folder_surface: Option<SurfaceKind>,
    /// Which other part of the heart the name of its folder says it is.
    pub(super) folder_structure: Option<&'static str>,
    /// Why it cannot be read, if that is known already.
    pub(super) unreadable: Option<String>,
}

/// What files of one folder make.
#[derive(Debug, Default)]
pub(super) struct Grouped {
    pub(super) plans: Vec<SubjectPlan>,
    pub(super) errors: Vec<OpenError>,
    pub(super) notices: Vec<Notice>,
}

/// One file with what its name says.
struct Named {
    kind: KindPlan,
    name: MeshName,
    file: LooseFile,
}

/// Sorts files into subjects. `whole_name` is the id of a subject that is alone, or has no name.
pub(super) fn group_files(files: Vec<LooseFile>, folder: &Path, whole_name: &str) -> Grouped {
    let mut grouped = Grouped::default();
    let stems: Vec<&str> = files.iter().map(|file| file.stem.as_str()).collect();
    let (names, notices) = read_names(&stems);
    grouped.notices = notices;
    let mut cases: BTreeMap<CaseKey, Vec<Named>> = BTreeMap::new();
    for (file, mut name) in files.into_iter().zip(names) {
        let chamber = |part: &&str| part.contains("ventricle") || part.contains("atri");
        if !name.left {
            let part = file.folder_structure;
            // A folder of valves may be named after a diagnosis.
            let part = part.filter(|part| name.surface.is_none() || chamber(part));
            name.structure = name.structure.or(part);
        }
        if file.series.is_some() {
            // Frames are those of the list: numbers in its name are part of it.
            name = name_of_list(&file.stem, &name);
        }
        let surface = file.own_surface.or(name.surface).or(file.folder_surface);
        let kind = match (name.structure, surface) {
            (Some(_), _) => KindPlan::Unnamed,
            (None, Some(kind)) => KindPlan::Known(kind),
            (None, None) if name.ventricle => KindPlan::Ventricle,
            (None, None) => KindPlan::Unnamed,
        };
        let case = CaseKey(name.case.clone());
        cases
            .entry(case)
            .or_default()
            .push(Named { kind, name, file });
    }
    let alone = cases.len() == 1;
    for (CaseKey(case), members) in cases {
        let id = if alone || case.is_empty() {
            whole_name.to_owned()
        } else {
            case
        };
        let (left, others): (Vec<Named>, Vec<Named>) = members
            .into_iter()
            .partition(|member| member.name.structure.is_none());
        if left.is_empty() {
            add_other_structures(others, folder, &id, &mut grouped);
        } else {
            let notices = left_out(&others);
            add_subject(&id, folder, left, notices, &mut grouped);
        }
    }
    grouped.notices.extend(single_frames(&grouped.plans));
    grouped
}

/// The name of a list, of which no part is a frame.
fn name_of_list(stem: &str, name: &MeshName) -> MeshName {
    let reading = Reading {
        phase: PhaseUse::Case,
        number: None,
    };
    let whole = NameParts::of(stem).name(reading);
    MeshName {
        case: whole.case,
        case_with_structure: whole.case_with_structure,
        frame: None,
        ..name.clone()
    }
}

/// Adds one subject, or why there is none.
fn add_subject(
    id: &str,
    folder: &Path,
    members: Vec<Named>,
    notices: Vec<Notice>,
    to: &mut Grouped,
) {
    match subject(id, folder, members, notices) {
        Ok(plan) => to.plans.push(plan),
        Err(reasons) => to
            .errors
            .extend(reasons.into_iter().map(|(path, reason)| OpenError {
                subject: Some(id.to_owned()),
                path,
                reason,
            })),
    }
}

/// One warning for each other part of the heart beside a left ventricle.
fn left_out(others: &[Named]) -> Vec<Notice> {
    let mut parts: BTreeMap<&str, Vec<&Named>> = BTreeMap::new();
    for other in others {
        parts
            .entry(other.name.structure.unwrap_or_default())
            .or_default()
            .push(other);
    }
    parts
        .into_iter()
        .map(|(part, files)| {
            Notice::warning(format!(
                "{} of the {part} not read, by the names ({}): only the left ventricle is measured",
                counted(files.len(), "file", "files"),
                files
                    .first()
                    .map(|file| name_of(&file.file.path))
                    .unwrap_or_default()
            ))
        })
        .collect()
}

/// Other parts of the heart without a left ventricle are shown as surfaces of no kind, one subject each.
fn add_other_structures(members: Vec<Named>, folder: &Path, id: &str, to: &mut Grouped) {
    let mut parts: BTreeMap<String, Vec<Named>> = BTreeMap::new();
    for member in members {
        let surface = member.name.surface.map_or("", SurfaceKind::name);
        let key = format!("{} {surface}", member.name.case_with_structure);
        parts.entry(key).or_default().push(member);
    }
    let alone = parts.len() == 1;
    for (key, members) in parts {
        let part = members
            .first()
            .and_then(|m| m.name.structure)
            .unwrap_or_default();
        let notice = Notice::warning(format!(
            "{part}, by the name: shown, but not measured as a left ventricle (study.toml can state that it is one)"
        ));
        let id = if alone {
            id.to_owned()
        } else {
            key.trim().to_owned()
        };
        add_subject(&id, folder, members, vec![notice], to);
    }
}

/// Subjects of one frame each whose names differ only in numbers may be frames of one.
fn single_frames(plans: &[SubjectPlan]) -> Option<Notice> {
    let mut alike: BTreeMap<String, Vec<&SubjectPlan>> = BTreeMap::new();
    for plan in plans {
        let single = plan.surfaces.iter().all(|surface| surface.files.len() == 1);
        if single && plan.id.contains(|c: char| c.is_ascii_digit()) {
            let mut name = String::new();
            for c in plan.id.chars() {
                match c {
                    c if !c.is_ascii_digit() => name.push(c),
                    _ if !name.ends_with('#') => name.push('#'),
                    _ => {}
                }
            }
            alike.entry(name).or_default().push(plan);
        }
    }
    let most = alike
        .into_values()
        .max_by_key(Vec::len)
        .filter(|plans| plans.len() > 1)?;
    Some(Notice::info(format!(
        "{} subjects of one frame each differ only in a number of their names ({}, {}…): if they are frames of one subject, name the files {{surface}}_{{number}}, or list them in a study.toml",
        most.len(),
        most[0].id,
        most[1].id
    )))
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

fn subject(
    id: &str,
    folder: &Path,
    members: Vec<Named>,
    mut notices: Vec<Notice>,
) -> Result<SubjectPlan, Vec<(PathBuf, String)>> {
    let unreadable: Vec<(PathBuf, String)> = members
        .iter()
        .filter_map(|member| Some((member.file.path.clone(), member.file.unreadable.clone()?)))
        .collect();
    if !unreadable.is_empty() {
        return Err(unreadable);
    }
    let mut by_kind: BTreeMap<KindPlan, Vec<Named>> = BTreeMap::new();
    for member in members {
        by_kind.entry(member.kind).or_default().push(member);
    }
    let mut stated = Stated::default();
    let mut surfaces = Vec::new();
    let mut frames_of: Vec<(KindPlan, Vec<FrameName>)> = Vec::new();
    for (kind, members) in by_kind {
        let frame = |member: &Named| member.name.frame;
        let mut members = one_ending(members, frame, |member| &member.file.path, &mut notices);
        members.sort_by(|a, b| {
            a.name.frame.cmp(&b.name.frame).then_with(|| {
                natural_order(
                    &a.file.path.to_string_lossy(),
                    &b.file.path.to_string_lossy(),
                )
            })
        });
        if let Some(pair) = members
            .windows(2)
            .find(|pair| pair[0].name.frame == pair[1].name.frame)
        {
            let first = name_of(&pair[0].file.path);
            let reason = format!("{first} has the same surface and frame in its name");
            return Err(vec![(pair[1].file.path.clone(), reason)]);
        }
        if let [first, _, ..] = members.as_slice()
            && first.name.frame.is_none()
        {
            notices.push(Notice::warning(format!(
                "{} has no frame in its name, as others have, and is read as the first frame",
                name_of(&first.file.path)
            )));
        }
        frames_of.push((kind, members.iter().filter_map(|m| m.name.frame).collect()));
        surfaces.push(surface_plan(kind, members));
    }
    same_frames(&frames_of).map_err(|reason| vec![(folder.to_owned(), reason)])?;
    if let Some((_, frames)) = frames_of.first() {
        let times = take_facts(frames, &mut stated, &mut notices);
        if let Some(surface) = surfaces.first_mut() {
            surface.times = surface.times.take().or(times);
        }
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
                plan.times = times;
            }
            None => plan.files.push(member.file.path),
        }
    }
    plan
}

/// All surfaces must have the same frames by name.
pub(super) fn same_frames(frames_of: &[(KindPlan, Vec<FrameName>)]) -> Result<(), String> {
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

#[cfg(test)]
mod tests;
