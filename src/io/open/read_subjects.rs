//! From a plan and what its files hold to a subject: files are joined to sequences, and checked.

use std::path::PathBuf;
use std::sync::Arc;

use super::length_unit::length_unit;
use super::plan::SeriesTimes;
use super::plan::{KindPlan, StatedUnit, SubjectPlan, SurfacePlan};
use super::seams::without_seams;
use super::series_parts::SAME_TIME;
use super::series_times::seconds;
use super::sheet_by_shape::sheet_by_shape;
use crate::io::opened::NOT_IN_CORRESPONDENCE;
use crate::io::{Limits, MeshFile, OpenError, ReadMeshError};
use crate::mesh::TriMesh;
use crate::progress::{Progress, Stopped};
use crate::study::checks::{
    FaceListing, LandmarkDoubt, check_subject, frames_phrase, sort_warnings_first,
};
use crate::study::{MeshSequence, Notice, SequenceError, Subject, SurfaceKind, SurfaceSequence};
use crate::units::Seconds;

/// A subject, or one error for each of its files that cannot be read.
pub(super) type SubjectOrErrors = Result<Arc<Subject>, Vec<OpenError>>;

/// The number of files of a surface that has more than it may have frames; none of them is read.
pub(super) fn excess(plan: &SubjectPlan, limits: &Limits) -> Option<String> {
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

/// Joins what the files hold, all files of one surface after those of the other.
pub(super) fn join_subject(
    plan: &SubjectPlan,
    contents: Vec<Result<MeshFile, String>>,
    limits: &Limits,
    progress: &Progress,
) -> Result<SubjectOrErrors, Stopped> {
    let wrong = |path: &PathBuf, reason: String| OpenError {
        subject: Some(plan.id.clone()),
        path: path.clone(),
        reason,
    };
    if let Some(reason) = excess(plan, limits) {
        return Ok(Err(vec![wrong(&plan.place, reason)]));
    }
    let read = match files_of_surfaces(plan, contents) {
        Ok(read) => read,
        Err(errors) => return Ok(Err(errors)),
    };
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
    let times = times_of(plan, times, &mut notices);
    match MeshSequence::new(surfaces) {
        Ok(sequence) => {
            let frames = sequence.frame_count();
            let subject = with_facts(plan, sequence, frames, times, notices);
            checked(subject, progress).map(|subject| Ok(Arc::new(subject)))
        }
        Err(error) => Ok(Err(vec![wrong(&plan.place, error.to_string())])),
    }
}

/// Times that lists or names of files give, else those of a file.
pub(super) fn times_of(
    plan: &SubjectPlan,
    of_file: Option<Vec<f64>>,
    notices: &mut Vec<Notice>,
) -> Option<Vec<f64>> {
    let given = plan
        .surfaces
        .iter()
        .find_map(|surface| surface.times.as_ref());
    let Some(given) = given else {
        return of_file;
    };
    let (seconds, notice) = seconds(given, plan.stated.rr_s);
    notices.extend(notice.filter(|_| plan.stated.frame_times_s.is_none()));
    seconds.or(of_file)
}

/// What was read of each surface, or one error for each file that cannot be read.
pub(super) fn files_of_surfaces(
    plan: &SubjectPlan,
    contents: Vec<Result<MeshFile, String>>,
) -> Result<Vec<Vec<MeshFile>>, Vec<OpenError>> {
    let mut errors = Vec::new();
    let mut read = Vec::new();
    let mut contents = contents.into_iter();
    for surface in &plan.surfaces {
        let mut files = Vec::new();
        for (path, content) in surface.files.iter().zip(&mut contents) {
            match content {
                Ok(file) => files.push(file),
                Err(reason) => errors.push(OpenError {
                    subject: Some(plan.id.clone()),
                    path: path.clone(),
                    reason,
                }),
            }
        }
        read.push(files);
    }
    if errors.is_empty() {
        Ok(read)
    } else {
        Err(errors)
    }
}

/// Surfaces whose lists give times must give the same: frames of other times are no pair.
pub(super) fn one_time_axis(surfaces: &[SurfacePlan]) -> Result<(), String> {
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

/// Frames of all files of one surface in correspondence; the error names the file if it is one file's.
fn join_surface(
    plan: &SurfacePlan,
    files: Vec<MeshFile>,
    limits: &Limits,
) -> Result<JoinedSurface, (Option<PathBuf>, String)> {
    let listed = listed_frames(plan, files, limits).map_err(|reason| (None, reason))?;
    let (kind, file_of_frame) = (listed.kind, listed.file_of_frame);
    let mut notices = listed.notices;
    notices.extend(FaceListing::of(&listed.frames).notices(kind));
    let sequence = SurfaceSequence::new(kind, listed.frames).map_err(|error| match &error {
        SequenceError::TopologyChanges { frame, .. } => {
            let file = file_of_frame.get(*frame);
            let path = file.and_then(|&file| plan.files.get(file).cloned());
            (path, format!("{error}{NOT_IN_CORRESPONDENCE}"))
        }
        _ => (None, error.to_string()),
    })?;
    Ok(JoinedSurface {
        sequence,
        times_s: listed.times_s,
        notices,
    })
}

/// Frames of one surface, whether or not they correspond.
pub(super) struct ListedFrames {
    pub(super) kind: SurfaceKind,
    pub(super) frames: Vec<TriMesh>,
    /// Which file each is from.
    file_of_frame: Vec<usize>,
    pub(super) times_s: Option<Vec<f64>>,
    pub(super) notices: Vec<Notice>,
}

/// Frames of all files of one surface.
pub(super) fn listed_frames(
    plan: &SurfacePlan,
    files: Vec<MeshFile>,
    limits: &Limits,
) -> Result<ListedFrames, String> {
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
        return Err(too_many_frames(frames.len(), limits));
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
    let (frames, joined) = without_seams(kind, frames);
    notices.extend(joined);
    Ok(ListedFrames {
        kind,
        frames,
        file_of_frame,
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

/// The subject with all that is stated and assumed about it, of so many frames.
pub(super) fn with_facts(
    plan: &SubjectPlan,
    sequence: MeshSequence,
    frame_count: usize,
    times_s: Option<Vec<f64>>,
    from_files: Vec<Notice>,
) -> Subject {
    let stated = plan.stated.clone();
    let mut notices = plan.notices.clone();
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
    let mut subject = Subject::new(plan.id.clone(), sequence, unit);
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
    if let Some(doubt) = LandmarkDoubt::of(&subject) {
        subject.notices.push(doubt.notice());
        subject.anatomy = None;
    }
    subject.notices.extend(findings);
    subject.notices.dedup();
    sort_warnings_first(&mut subject.notices);
    Ok(subject)
}
