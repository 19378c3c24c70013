//! From a plan to subjects: files are read in parallel, joined to sequences, and checked.

use std::collections::HashMap;
use std::path::PathBuf;

use rayon::prelude::*;

use super::length_unit::length_unit;
use super::plan::SeriesTimes;
use super::plan::{KindPlan, StatedUnit, SubjectPlan, SurfacePlan};
use super::read_file::{read_bytes, read_mesh_at};
use super::series_parts::SAME_TIME;
use super::series_times::seconds;
use super::sheet_by_shape::sheet_by_shape;
use crate::io::{Limits, MeshFile, OpenError, ReadMeshError};
use crate::mesh::TriMesh;
use crate::progress::{Progress, Stopped};
use crate::study::checks::{
    FaceListing, check_count, check_subject, frames_phrase, sort_warnings_first,
};
use crate::study::{MeshSequence, Notice, SequenceError, Subject, SurfaceKind, SurfaceSequence};
use crate::units::Seconds;

/// A subject, or one error for each of its files that cannot be read.
pub(super) type SubjectOrErrors = Result<Subject, Vec<OpenError>>;

/// What each file of each surface holds.
type Contents = Vec<Vec<Result<MeshFile, String>>>;

/// Reads all files of all subjects, each a step, and joins them.
pub(super) fn read_subjects(
    plans: Vec<SubjectPlan>,
    limits: &Limits,
    progress: &Progress,
) -> Result<Vec<SubjectOrErrors>, Stopped> {
    // A file of several subjects or frames is read once.
    let mut places: HashMap<&PathBuf, usize> = HashMap::new();
    let mut files: Vec<&PathBuf> = Vec::new();
    let mut uses: Vec<usize> = Vec::new();
    for path in plans
        .iter()
        .filter(|plan| excess(plan, limits).is_none())
        .flat_map(files_of)
    {
        let place = *places.entry(path).or_insert(files.len());
        if place == files.len() {
            files.push(path);
            uses.push(0);
        }
        uses[place] += 1;
    }
    let checks: usize = plans.iter().map(|p| check_count(p.surfaces.len())).sum();
    progress.expect_steps(files.len() + checks);
    let mut contents: Vec<Option<Result<MeshFile, String>>> = files
        .par_iter()
        .map(|path| {
            progress.step()?;
            let content =
                read_bytes(path, limits).and_then(|bytes| read_mesh_at(path, &bytes, limits));
            Ok(Some(content))
        })
        .collect::<Result<_, Stopped>>()?;
    let mut take = |path: &PathBuf| -> Result<MeshFile, String> {
        let not_read = || Err("not read".to_owned());
        let Some(&place) = places.get(path) else {
            return not_read();
        };
        uses[place] -= 1;
        let content = if uses[place] == 0 {
            contents[place].take()
        } else {
            contents[place].clone()
        };
        content.unwrap_or_else(not_read)
    };
    let of_plans: Vec<Contents> = plans
        .iter()
        .map(|plan| match excess(plan, limits) {
            Some(_) => Vec::new(),
            None => {
                let surfaces = plan.surfaces.iter();
                surfaces
                    .map(|surface| surface.files.iter().map(&mut take).collect())
                    .collect()
            }
        })
        .collect();
    let work: Vec<(SubjectPlan, Contents)> = plans.into_iter().zip(of_plans).collect();
    work.into_par_iter()
        .map(|(plan, contents)| join_subject(plan, contents, limits, progress))
        .collect()
}

fn files_of(plan: &SubjectPlan) -> impl Iterator<Item = &PathBuf> {
    plan.surfaces.iter().flat_map(|surface| &surface.files)
}

/// The number of files of a surface that has more than it may have frames; none of them is read.
fn excess(plan: &SubjectPlan, limits: &Limits) -> Option<String> {
    let counts = plan.surfaces.iter().map(|surface| surface.files.len());
    let count = counts.max().filter(|&count| count > limits.frames)?;
    Some(too_many_frames(count, limits))
}

fn too_many_frames(count: usize, limits: &Limits) -> String {
    let reason = ReadMeshError::TooMany {
        what: "frames",
        count: count as u64,
        most: limits.frames as u64,
    };
    reason.to_string()
}

fn join_subject(
    plan: SubjectPlan,
    contents: Contents,
    limits: &Limits,
    progress: &Progress,
) -> Result<SubjectOrErrors, Stopped> {
    let wrong = |path: &PathBuf, reason: String| OpenError {
        subject: Some(plan.id.clone()),
        path: path.clone(),
        reason,
    };
    if let Some(reason) = excess(&plan, limits) {
        return Ok(Err(vec![wrong(&plan.place, reason)]));
    }
    let mut errors = Vec::new();
    let mut read = Vec::new();
    for (surface, contents) in plan.surfaces.iter().zip(contents) {
        let mut files = Vec::new();
        for (path, content) in surface.files.iter().zip(contents) {
            match content {
                Ok(file) => files.push(file),
                Err(reason) => errors.push(wrong(path, reason)),
            }
        }
        read.push(files);
    }
    if !errors.is_empty() {
        return Ok(Err(errors));
    }
    let mut joined = Vec::new();
    for (surface, files) in plan.surfaces.iter().zip(read) {
        match join_surface(surface, files, limits) {
            Ok(surface) => joined.push(surface),
            Err((path, reason)) => {
                let path = path.unwrap_or_else(|| plan.place.clone());
                return Ok(Err(vec![wrong(&path, reason)]));
            }
        }
    }
    if let Err(reason) = one_time_axis(&plan.surfaces) {
        return Ok(Err(vec![wrong(&plan.place, reason)]));
    }
    let mut notices = Vec::new();
    let mut times = None;
    let mut surfaces = Vec::new();
    for mut surface in joined {
        notices.append(&mut surface.notices);
        times = times.or(surface.times_s);
        surfaces.push(surface.sequence);
    }
    if let Some(given) = plan
        .surfaces
        .iter()
        .find_map(|surface| surface.times.as_ref())
    {
        let (seconds, notice) = seconds(given, plan.stated.rr_s);
        times = seconds.or(times);
        notices.extend(notice.filter(|_| plan.stated.frame_times_s.is_none()));
    }
    match MeshSequence::new(surfaces) {
        Ok(sequence) => {
            let subject = with_facts(plan, sequence, times, notices);
            checked(subject, progress).map(Ok)
        }
        Err(error) => Ok(Err(vec![wrong(&plan.place, error.to_string())])),
    }
}

/// Surfaces whose lists give times must give the same: frames of other times are no pair.
fn one_time_axis(surfaces: &[SurfacePlan]) -> Result<(), String> {
    let mut given = surfaces.iter().filter_map(|surface| surface.times.as_ref());
    let Some(first) = given.next() else {
        return Ok(());
    };
    let same = |times: &SeriesTimes| {
        times.values.len() == first.values.len()
            && times
                .values
                .iter()
                .zip(&first.values)
                .all(|(a, b)| (a - b).abs() <= SAME_TIME * a.abs().max(b.abs()))
    };
    if given.all(same) {
        Ok(())
    } else {
        Err("the lists of its surfaces give different times".to_owned())
    }
}

struct JoinedSurface {
    sequence: SurfaceSequence,
    times_s: Option<Vec<f64>>,
    notices: Vec<Notice>,
}

/// Frames of all files of one surface; the error names the file if it is one file's.
fn join_surface(
    plan: &SurfacePlan,
    files: Vec<MeshFile>,
    limits: &Limits,
) -> Result<JoinedSurface, (Option<PathBuf>, String)> {
    let mut frames: Vec<TriMesh> = Vec::new();
    let mut file_of_frame = Vec::new();
    let mut counted: Vec<(Notice, Vec<usize>)> = Vec::new();
    let mut times_s = None;
    let file_count = files.len();
    for (index, file) in files.into_iter().enumerate() {
        file_of_frame.extend(std::iter::repeat_n(index, file.frames.len()));
        frames.extend(file.frames);
        if file_count == 1 {
            times_s = file.times_s;
        }
        for notice in file.notices {
            match counted.iter_mut().find(|(known, _)| *known == notice) {
                Some((_, in_files)) => in_files.push(index),
                None => counted.push((notice, vec![index])),
            }
        }
    }
    if frames.len() > limits.frames {
        return Err((None, too_many_frames(frames.len(), limits)));
    }
    let (kind, assumed) = kind_of(plan.kind, &frames);
    let mut notices: Vec<Notice> = assumed.into_iter().collect();
    for (notice, in_files) in counted {
        let text = format!(
            "{}: {}",
            with_frames(kind.name(), &in_files, file_count),
            notice.text
        );
        notices.push(Notice { text, ..notice });
    }
    notices.extend(FaceListing::of(&frames).notices(kind));
    let sequence = SurfaceSequence::new(kind, frames).map_err(|error| {
        let path = match &error {
            SequenceError::TopologyChanges { frame, .. } => file_of_frame
                .get(*frame)
                .and_then(|&file| plan.files.get(file).cloned()),
            _ => None,
        };
        (path, error.to_string())
    })?;
    Ok(JoinedSurface {
        sequence,
        times_s,
        notices,
    })
}

fn with_frames(name: &str, frames: &[usize], count: usize) -> String {
    let phrase = frames_phrase(frames, count);
    if phrase.is_empty() {
        name.to_owned()
    } else {
        format!("{name}, {phrase}")
    }
}

fn kind_of(plan: KindPlan, frames: &[TriMesh]) -> (SurfaceKind, Option<Notice>) {
    match (plan, frames.first()) {
        (KindPlan::Known(kind), _) => (kind, None),
        (KindPlan::Ventricle, Some(mesh)) => {
            let (kind, notice) = sheet_by_shape(mesh);
            (kind, Some(notice))
        }
        (KindPlan::Ventricle | KindPlan::Unnamed, _) => {
            let text = "surface not identified: no blood or muscle volume (file names with endo, epi, wall or cavity identify it, or a study.toml)";
            (SurfaceKind::Other, Some(Notice::info(text)))
        }
    }
}

/// The subject with all that is stated and assumed about it.
fn with_facts(
    plan: SubjectPlan,
    sequence: MeshSequence,
    times_s: Option<Vec<f64>>,
    from_files: Vec<Notice>,
) -> Subject {
    let stated = plan.stated;
    let mut notices = plan.notices;
    notices.extend(from_files);
    let mut anatomy = stated.anatomy;
    let mut scaled_by = 1.0;
    let sequence = match stated.unit {
        Some(StatedUnit::Millimetres(factor)) if factor != 1.0 => {
            anatomy = anatomy.map(|anatomy| anatomy.scaled(factor));
            scaled_by = factor;
            notices.push(Notice::info(format!(
                "coordinates multiplied by {factor} to convert them to mm (unit in study.toml)"
            )));
            sequence.scaled(factor)
        }
        _ => sequence,
    };
    let (unit, notice) = length_unit(stated.unit, &sequence);
    notices.extend(notice);
    let frame_count = sequence.frame_count();
    let mut subject = Subject::new(plan.id, sequence, unit);
    subject.scaled_by = scaled_by;
    subject.label = stated.label;
    subject.end_diastole = stated.end_diastole;
    subject.end_systole = stated.end_systole;
    subject.height_cm = stated.height_cm;
    subject.weight_kg = stated.weight_kg;
    subject.anatomy = anatomy;
    subject.timing.rr = stated.rr_s.map(Seconds);
    subject.timing.frame_times_s = usable_times(stated.frame_times_s, frame_count, &mut notices)
        .or_else(|| usable_times(times_s, frame_count, &mut notices));
    subject.notices = notices;
    subject
}

/// Times, if there is one for each frame and they ascend.
fn usable_times(
    times: Option<Vec<f64>>,
    frame_count: usize,
    notices: &mut Vec<Notice>,
) -> Option<Vec<f64>> {
    let times = times?;
    if times.len() != frame_count {
        notices.push(Notice::warning(format!(
            "{} times for {frame_count} frames: times are ignored",
            times.len()
        )));
        return None;
    }
    if times.windows(2).any(|pair| pair[0] >= pair[1]) {
        notices.push(Notice::warning(
            "times of the frames do not increase: they are ignored",
        ));
        return None;
    }
    Some(times)
}

/// The subject with what the checks find; phases that cannot be are left to the volumes.
fn checked(mut subject: Subject, progress: &Progress) -> Result<Subject, Stopped> {
    let findings = check_subject(&subject, || progress.step())?;
    let frames = subject.sequence.frame_count();
    subject.end_diastole = subject.end_diastole.filter(|&frame| frame < frames);
    subject.end_systole = subject.end_systole.filter(|&frame| frame < frames);
    subject.notices.extend(findings);
    subject.notices.dedup();
    sort_warnings_first(&mut subject.notices);
    Ok(subject)
}
