//! Where do two poses differ?

use std::sync::Arc;

use crate::analysis::alignment::{AlignmentError, SizeScale, rigid_motion};
use crate::analysis::metrics::{Metric, MetricError, PairScratch};
use crate::mesh::Point3;
use crate::progress::{Progress, Stopped};
use crate::study::{Study, Subject};

use super::CheckedPoseDistanceParams;
use super::smooth::smoothed_study;

/// Why two poses cannot be compared face by face.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PairError {
    /// It was asked to stop.
    #[error("{0}")]
    Stopped(#[from] Stopped),
    /// Their vertices do not correspond.
    #[error(
        "the meshes of {a} ({a_vertices} vertices) and {b} ({b_vertices} vertices) do not correspond"
    )]
    NoCorrespondence {
        /// The first subject.
        a: String,
        /// Its vertices.
        a_vertices: usize,
        /// The second subject.
        b: String,
        /// Its vertices.
        b_vertices: usize,
    },
    /// A frame that is not there.
    #[error("{subject} has {frames} frames, so there is no frame {frame}")]
    NoFrame {
        /// Id of the subject concerned.
        subject: String,
        /// The frame named.
        frame: usize,
        /// How many there are.
        frames: usize,
    },
    /// A subject has no size that could be normalised.
    #[error("the size of {subject} at end-diastole is not measurable")]
    NoSize {
        /// Id of the subject concerned.
        subject: String,
    },
    /// The poses cannot be aligned with each other.
    #[error(transparent)]
    Alignment(#[from] AlignmentError),
    /// The metric refuses a pose.
    #[error(transparent)]
    Metric(#[from] MetricError),
}

/// Share of each face in the squared distance of two poses, smoothed, sizes normalised and aligned as in
/// [`super::pose_distances`] without a transport; without unit where the metric is scale-free. Shares sum to the squared
/// distance of that matrix; faces are those of all surfaces, one surface after the other.
///
/// # Errors
/// If stopped, the poses do not correspond, or cannot be computed with.
pub fn pair_contributions(
    a: (&Subject, usize),
    b: (&Subject, usize),
    params: &CheckedPoseDistanceParams,
    progress: &Progress,
) -> Result<Vec<f64>, PairError> {
    let (first, second) = (&a.0.sequence, &b.0.sequence);
    if first.correspondence() != second.correspondence() {
        return Err(PairError::NoCorrespondence {
            a: a.0.id.clone(),
            a_vertices: first.vertex_count(),
            b: b.0.id.clone(),
            b_vertices: second.vertex_count(),
        });
    }
    // Through the same smoothing as the matrix, so that shares sum to its entry.
    let both = Study {
        subjects: vec![Arc::new(a.0.clone()), Arc::new(b.0.clone())],
        ..Study::default()
    };
    let smooth = smoothed_study(&both, params.smoothing, progress)?;
    let [a, b] = [(0, a.1), (1, b.1)].map(|(index, frame)| (&*smooth.subjects[index], frame));
    let (target, source) = (normalised(a)?, normalised(b)?);
    // The second onto the first, as in the matrix.
    let motion = rigid_motion(&source, &target)?;
    let metric = Metric::new(&first.joined_faces(), params.metric);
    let (target, source) = (metric.prepare(&target)?, metric.prepare(&source)?);
    let scratch = &mut PairScratch::default();
    let (rotation, translation) = (&motion.rotation, &motion.translation);
    Ok(metric.face_contributions(&target, &source, rotation, translation, scratch))
}

/// A pose, divided by the subject's scale.
fn normalised((subject, frame): (&Subject, usize)) -> Result<Vec<Point3>, PairError> {
    let pose = |frame: usize| {
        let found = subject.sequence.pose(frame);
        found.ok_or_else(|| PairError::NoFrame {
            subject: subject.id.clone(),
            frame,
            frames: subject.sequence.frame_count(),
        })
    };
    // Size is that of end-diastole at every frame: contraction is not normalised away.
    let rest = pose(subject.start_frame())?;
    let scale = SizeScale::of_end_diastole(&rest).ok_or_else(|| PairError::NoSize {
        subject: subject.id.clone(),
    })?;
    Ok(pose(frame)?.iter().map(|p| scale.normalised(p)).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::pose_distances::{PoseDistanceParams, pose_distances};
    use crate::study::built_in::{BuiltInParams, cohort};

    #[test]
    fn shares_sum_to_the_squared_distance_of_the_map() {
        let params = BuiltInParams {
            vertices: 200,
            ..BuiltInParams::default()
        };
        let mut study = cohort(&params).unwrap().study;
        study.subjects.truncate(12);
        let all = PoseDistanceParams::default().check().unwrap();
        let matrix = pose_distances(&study, &all, &Progress::default()).unwrap();
        let row = |subject, frame| {
            let same = |pose: &crate::analysis::pose_distances::PoseId| {
                (pose.subject, pose.frame) == (subject, frame)
            };
            matrix.poses.iter().position(same).unwrap()
        };
        let progress = Progress::default();
        for ((i, frame), (j, other)) in [((0, 0), (11, 0)), ((3, 3), (10, 4)), ((2, 5), (2, 1))] {
            let (a, b) = (&study.subjects[i], &study.subjects[j]);
            let shares = pair_contributions((a, frame), (b, other), &all, &progress).unwrap();
            assert_eq!(shares.len(), a.sequence.face_count());
            let distance = matrix.distances.get(row(i, frame), row(j, other));
            let sum: f64 = shares.iter().sum();
            assert!(
                (sum.sqrt() - distance).abs() < 1e-9 * distance,
                "{sum} {distance}"
            );
        }
        let (first, second) = (&study.subjects[0], &study.subjects[1]);
        let error = pair_contributions((first, 0), (second, 99), &all, &progress);
        assert!(error.unwrap_err().to_string().contains("no frame 99"));
    }
}
