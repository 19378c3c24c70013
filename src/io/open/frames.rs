//! Frames as they are, one mesh each, whether or not their vertices correspond.

use std::path::PathBuf;
use std::sync::Arc;

use super::plan::{StatedUnit, SubjectPlan};
use super::read_subjects::{
    excess, files_of_surfaces, listed_frames, one_time_axis, times_of, with_facts,
};
use crate::io::{Limits, MeshFile, OpenError};
use crate::mesh::{Point3, TriMesh};
use crate::study::{MeshSequence, Subject, SurfaceKind, SurfaceSequence};

/// A subject whose frames are separate meshes.
#[derive(Clone, Debug)]
pub struct SubjectFrames {
    /// All that is known beside the meshes; its sequence has the first frame alone.
    pub subject: Subject,
    /// Each surface with its frames in order, in the unit of the subject.
    pub surfaces: Vec<(SurfaceKind, Vec<TriMesh>)>,
    /// The file or folder that is named where it is wrong.
    pub place: PathBuf,
}

/// A subject, or what is wrong with its files.
pub(super) type FramesOrErrors = Result<SubjectFrames, Vec<OpenError>>;

/// Lists what the files hold, as [`join_subject`](super::read_subjects::join_subject) joins it.
pub(super) fn frames_of(
    plan: &SubjectPlan,
    contents: Vec<Result<MeshFile, String>>,
    limits: &Limits,
) -> FramesOrErrors {
    let wrong = |reason: String| {
        vec![OpenError {
            subject: Some(plan.id.clone()),
            path: plan.place.clone(),
            reason,
        }]
    };
    if let Some(reason) = excess(plan, limits) {
        return Err(wrong(reason));
    }
    let mut notices = Vec::new();
    let mut times = None;
    let mut surfaces: Vec<(SurfaceKind, Vec<TriMesh>)> = Vec::new();
    for (surface, files) in plan.surfaces.iter().zip(files_of_surfaces(plan, contents)?) {
        let listed = listed_frames(surface, files, limits).map_err(wrong)?;
        notices.extend(listed.notices);
        times = times.or(listed.times_s);
        surfaces.push((listed.kind, listed.frames));
    }
    one_time_axis(&plan.surfaces).map_err(wrong)?;
    let times = times_of(plan, times, &mut notices);
    let first = surfaces.iter().map(|(kind, frames)| {
        let first = frames.first().cloned();
        SurfaceSequence::new(*kind, first.into_iter().collect())
    });
    let first: Result<Vec<_>, _> = first.collect();
    let sequence = first.and_then(MeshSequence::new);
    let sequence = sequence.map_err(|error| wrong(error.to_string()))?;
    let count = surfaces.first().map_or(0, |(_, frames)| frames.len());
    if let Some(StatedUnit::Millimetres(factor)) = plan.stated.unit {
        for mesh in surfaces.iter_mut().flat_map(|(_, frames)| frames) {
            *mesh = scaled(mesh, factor).map_err(wrong)?;
        }
    }
    let mut subject = with_facts(plan, sequence, count, times, notices);
    subject.end_diastole = subject.end_diastole.filter(|&frame| frame < count);
    subject.end_systole = subject.end_systole.filter(|&frame| frame < count);
    Ok(SubjectFrames {
        subject,
        surfaces,
        place: plan.place.clone(),
    })
}

fn scaled(mesh: &TriMesh, factor: f64) -> Result<TriMesh, String> {
    if factor == 1.0 {
        return Ok(mesh.clone());
    }
    let points: Vec<Point3> = mesh.vertices().iter().map(|p| p * factor).collect();
    TriMesh::new(points, Arc::clone(mesh.faces())).map_err(|error| error.to_string())
}
