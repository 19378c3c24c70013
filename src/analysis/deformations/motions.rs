//! How far apart are motions that all begin at one shape?

use rayon::prelude::*;

use crate::analysis::alignment::rigid_motion;
use crate::analysis::metrics::{CheckedMetricParams, Metric};
use crate::analysis::pose_distances::{DistanceMatrix, PoseDistanceError, PoseId};
use crate::analysis::transport::{TransportError, TransportedCohort};
use crate::mesh::{Point3, Vector3};
use crate::progress::{Progress, Stopped};
use crate::study::Study;

use super::beats::{Beat, beats};

/// Root mean square over the beat of the norm of differences of displacements at equal phases,
/// D(i, j)² = mean over φ of ⟨⟨X_i(φ) − X_j(φ), X_i(φ) − X_j(φ)⟩⟩ at the reference.
///
/// X_i(φ) is the pose of i at the share φ of the beat since end-diastole, laid onto the reference by a rigid motion, minus
/// the reference: where the heart as a whole moves is no deformation. φ runs through as many even steps as the subject
/// with most frames has frames; between two frames displacements are interpolated linearly. At one place of the space of
/// poses the metric is Euclidean, and so are these distances ([`Metric::coordinates`]). A metric whose form is no inner
/// product stands for its additive one.
///
/// # Errors
/// If stopped, or the reference cannot be computed with.
pub(super) fn motion_distances(
    study: &Study,
    cohort: TransportedCohort,
    metric: &CheckedMetricParams,
    progress: &Progress,
) -> Result<DistanceMatrix, PoseDistanceError> {
    let TransportedCohort {
        reference, members, ..
    } = cohort;
    let faces = (members.first())
        .and_then(|member| study.subjects.get(member.subject))
        .map(|subject| subject.sequence.joined_faces());
    let Some(faces) = faces else {
        return Ok(DistanceMatrix::empty());
    };
    let metric = Metric::new(&faces, *metric);
    let at = metric.prepare(&reference).map_err(TransportError::Metric)?;
    let poses: Vec<PoseId> = (members.iter())
        .flat_map(|member| {
            let subject = member.subject;
            (0..member.poses.len()).map(move |frame| PoseId { subject, frame })
        })
        .collect();
    let beats = beats(study, &poses);
    let count = members.len();
    let frames: Vec<Vec<Point3>> = members
        .into_iter()
        .flat_map(|member| member.poses)
        .collect();
    // A pose goes when its displacement is there: those of a large cohort would not both fit into memory.
    let fields: Vec<Vec<Vector3>> = (frames.into_par_iter())
        .map(|pose| {
            progress.check()?;
            Ok(displacement(&pose, &reference))
        })
        .collect::<Result<_, Stopped>>()?;
    let phases = beats.iter().map(|beat| beat.rows.len()).max().unwrap_or(0);
    progress.expect_steps(phases);
    let mut squares: Vec<Vec<f64>> = (0..count).map(|i| vec![0.0; count - i - 1]).collect();
    // One phase after the other, so that no more than the coordinates of one are held.
    for phase in 0..phases {
        progress.step()?;
        let time = phase as f64 / phases as f64;
        let coordinates: Vec<Vec<f64>> = (beats.par_iter())
            .map(|beat| metric.coordinates(&at, &field_at(beat, &fields, time)))
            .collect();
        squares.par_iter_mut().enumerate().for_each(|(i, row)| {
            for (sum, other) in row.iter_mut().zip(&coordinates[i + 1..]) {
                let steps = coordinates[i].iter().zip(other);
                *sum += steps.map(|(a, b)| (a - b) * (a - b)).sum::<f64>();
            }
        });
    }
    let upper = squares
        .iter()
        .flatten()
        .map(|sum| (sum / phases as f64).sqrt());
    Ok(DistanceMatrix::from_upper(count, upper.collect()).unwrap_or_else(DistanceMatrix::empty))
}

/// What is left of a pose when it is laid onto the reference and the reference is subtracted.
fn displacement(pose: &[Point3], reference: &[Point3]) -> Vec<Vector3> {
    let Ok(motion) = rigid_motion(pose, reference) else {
        // Only poses of another number of vertices have none, and transport made none of those.
        return vec![Vector3::zeros(); reference.len()];
    };
    (pose.iter().zip(reference))
        .map(|(point, rest)| motion.apply(point) - rest)
        .collect()
}

fn field_at(beat: &Beat, fields: &[Vec<Vector3>], time: f64) -> Vec<Vector3> {
    let between = beat.at(time);
    let (from, to) = (&fields[between.from], &fields[between.to]);
    (from.iter().zip(to))
        .map(|(a, b)| a + (b - a) * between.share)
        .collect()
}
