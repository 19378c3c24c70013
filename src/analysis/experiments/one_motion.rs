//! A study in which all subjects move alike: what still separates them is shape.

use std::sync::Arc;

use crate::analysis::alignment::{Comparable, comparable_subjects, rigid_motion};
use crate::mesh::{Point3, TriMesh, Vector3};
use crate::study::{MeshSequence, Study, Subject, SurfaceSequence};

use super::ExperimentError;
use super::error::step;

/// The corresponding subjects of a study, each with the motion of the first of them: to the
/// end-diastolic pose of every subject are added the first one's displacements from end-diastole, turned by
/// the rigid motion that lays the first end-diastolic pose onto the subject's own, sizes normalised. Frames
/// and times are those of the first.
///
/// A perfect transport onto one subject would make all these motions equal.
///
/// # Errors
/// If poses cannot be aligned, or a coordinate leaves the range of numbers.
pub(super) fn one_motion_study(study: &Study) -> Result<Study, ExperimentError> {
    let (members, _) = comparable_subjects(study);
    let Some(first) = members.first() else {
        return Ok(study.clone());
    };
    // In sizes of each subject: a large one moves by more.
    let normalised = |member: &Comparable<'_>, frame: usize| {
        let pose = member.subject.sequence.pose(frame).unwrap_or_default();
        let points: Vec<Point3> = pose.iter().map(|p| member.scale.normalised(p)).collect();
        points
    };
    let rest = normalised(first, first.end_diastole);
    let displacements: Vec<Vec<Vector3>> = (0..first.subject.sequence.frame_count())
        .map(|frame| {
            let pose = normalised(first, frame);
            pose.iter().zip(&rest).map(|(p, q)| p - q).collect()
        })
        .collect();
    let subjects = (members.iter())
        .map(|member| {
            let own = normalised(member, member.end_diastole);
            // Displacements are turned with the subject, or the motion would point elsewhere in each.
            let turn = rigid_motion(&rest, &own).map_err(|e| step("aligning subjects", &e))?;
            let poses: Vec<Vec<Point3>> = (displacements.iter())
                .map(|field| {
                    (own.iter().zip(field))
                        .map(|(p, u)| member.scale.restored(&(p + turn.rotation * u)))
                        .collect()
                })
                .collect();
            Ok(Arc::new(Subject {
                sequence: moved(&member.subject.sequence, &poses)?,
                // Alike in time, too.
                timing: first.subject.timing.clone(),
                end_diastole: Some(first.end_diastole),
                end_systole: first.subject.end_systole,
                ..member.subject.clone()
            }))
        })
        .collect::<Result<_, ExperimentError>>()?;
    Ok(Study {
        subjects,
        ..study.clone()
    })
}

/// Poses, all surfaces one after the other, as a sequence with the surfaces of another.
fn moved(like: &MeshSequence, poses: &[Vec<Point3>]) -> Result<MeshSequence, ExperimentError> {
    let mut surfaces = Vec::new();
    let mut begin = 0;
    for surface in like.surfaces() {
        let part = begin..begin + surface.faces().vertex_count();
        begin = part.end;
        let frames = (poses.iter())
            .map(|pose| TriMesh::new(pose[part.clone()].to_vec(), Arc::clone(surface.faces())))
            .collect::<Result<Vec<_>, _>>()?;
        surfaces.push(SurfaceSequence::new(surface.kind(), frames)?);
    }
    Ok(MeshSequence::new(surfaces)?)
}
