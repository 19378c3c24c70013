//! Every subject's motion on one subject, so that motions can be compared.

use rayon::prelude::*;

use crate::analysis::alignment::{
    Comparable, LeftOut, SizeScale, align_poses, comparable_subjects,
};
use crate::analysis::metrics::CheckedMetricParams;
use crate::mesh::Point3;
use crate::progress::{Progress, Stopped};
use crate::study::Study;

use super::beat::{Rest, in_order_of_frames};
use super::{
    CohortTransportParams, DeformationTransport, Reference, TransportAccount, TransportError,
};

/// All deformations at one place of the space of poses.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TransportedCohort {
    /// The subject that all motions were transported onto, its size normalised.
    pub reference: Vec<Point3>,
    /// The motions, in the order of the study.
    pub members: Vec<MotionOnReference>,
    /// Subjects that take no part, in the order of the study.
    pub left_out: Vec<LeftOut>,
}

/// One subject's motion on the reference.
#[derive(Clone, Debug, PartialEq)]
pub struct MotionOnReference {
    /// Index into the study's subjects.
    pub subject: usize,
    /// Frame at which the pose is the reference.
    pub end_diastole: usize,
    /// What the subject's own coordinates were divided by.
    pub scale: SizeScale,
    /// One pose per frame, sizes normalised, all surfaces one after the other.
    pub poses: Vec<Vec<Point3>>,
    /// How they were made.
    pub account: TransportAccount,
}

/// Transports every usable subject's deformation onto the reference.
///
/// Usable is what [`comparable_subjects`] says. Coordinates of each subject are divided by its
/// [`SizeScale`], its end-diastolic pose is aligned with the reference by a rigid motion, its beat moves
/// with it, and its displacements are transported from end-diastole on. The mean reference is the
/// mean of the end-diastolic poses, aligned with each other by generalised Procrustes alignment. A
/// subject whose motion cannot be transported is left out with the reason. Subjects run in parallel;
/// the result does not depend on the number of threads. Counts one step per displacement.
///
/// # Errors
/// If stopped, settings cannot be used, or the reference is no usable subject.
pub fn transport_cohort(
    study: &Study,
    metric: &CheckedMetricParams,
    params: &CohortTransportParams,
    progress: &Progress,
) -> Result<TransportedCohort, TransportError> {
    let checked = params.with_metric(**metric).check()?;
    let (comparable, mut left_out) = comparable_subjects(study);
    let rests: Vec<Rest> = (comparable.iter())
        .map(|member| {
            let pose = member.subject.sequence.pose(member.end_diastole);
            Rest::new(&pose.unwrap_or_default(), member.end_diastole, member.scale)
        })
        .collect();
    let reference = match params.reference {
        Reference::Mean => mean_shape(&rests, progress)?,
        Reference::Subject(index) => of_subject(study, index, &comparable, &rests, &left_out)?,
    };
    let Some(first) = comparable.first() else {
        return Ok(TransportedCohort {
            left_out,
            ..TransportedCohort::default()
        });
    };
    let faces = first.subject.sequence.joined_faces();
    let transport = DeformationTransport::new(&faces, &reference, &checked)?;
    let frames = comparable.iter().map(|m| m.subject.sequence.frame_count());
    progress.expect_steps(frames.map(|count| count - 1).sum());
    let transported: Vec<Result<MotionOnReference, TransportError>> = comparable
        .par_iter()
        .zip(&rests)
        .map(|(member, rest)| {
            let beat = rest.beat_laid_onto(member.subject, &reference);
            let moved = transport.transport(&beat, &reference, progress)?;
            Ok(MotionOnReference {
                subject: member.index,
                end_diastole: rest.frame,
                scale: rest.scale,
                poses: in_order_of_frames(moved.poses, rest.frame),
                account: moved.account,
            })
        })
        .collect();
    let mut members = Vec::with_capacity(transported.len());
    for (member, result) in comparable.iter().zip(transported) {
        match result {
            Ok(subject) => members.push(subject),
            // Being stopped ends the whole; any other failure concerns one subject, who is left out.
            Err(TransportError::Stopped(stopped)) => return Err(stopped.into()),
            Err(error) => left_out.push(LeftOut {
                subject: member.index,
                reason: format!("its motion cannot be transported onto the reference: {error}"),
            }),
        }
    }
    // Two sources of reasons, one order: that of the study.
    left_out.sort_by_key(|left| left.subject);
    Ok(TransportedCohort {
        reference,
        members,
        left_out,
    })
}

/// Mean of the poses after aligning them with each other; the first pose says how it lies.
fn mean_shape(rests: &[Rest], progress: &Progress) -> Result<Vec<Point3>, Stopped> {
    let poses: Vec<&[Point3]> = rests.iter().map(|rest| rest.pose.as_slice()).collect();
    // Without alignment the mean would shrink by whatever poses differ in position and rotation.
    let motions = align_poses(&poses, &progress.within())?;
    let mut mean = vec![Point3::origin(); poses.first().map_or(0, |pose| pose.len())];
    for (pose, motion) in poses.iter().zip(&motions) {
        for (mean, point) in mean.iter_mut().zip(*pose) {
            *mean += motion.apply(point).coords / poses.len() as f64;
        }
    }
    Ok(mean)
}

fn of_subject(
    study: &Study,
    index: usize,
    comparable: &[Comparable<'_>],
    rests: &[Rest],
    left_out: &[LeftOut],
) -> Result<Vec<Point3>, TransportError> {
    let place = comparable.iter().position(|member| member.index == index);
    if let Some(rest) = place.and_then(|place| rests.get(place)) {
        return Ok(rest.pose.clone());
    }
    let why = left_out.iter().find(|left| left.subject == index);
    Err(TransportError::Reference {
        index,
        subjects: study.subjects.len(),
        reason: why.map_or_else(|| "there is none".to_owned(), |left| left.reason.clone()),
    })
}
