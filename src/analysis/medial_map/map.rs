//! All paths on one map: distances 4.5.1 in axes that the subjects share, embedded by multidimensional scaling.

use crate::analysis::embedding::{EmbeddingError, MapMethod, embed};
use crate::analysis::medial_space::pose_distance;
use crate::analysis::pose_distances::DistanceMatrix;
use crate::progress::Progress;

use super::placement::Frame;
use super::result::{AkineticPart, MedialMap, MedialMapError, MedialPose, Spread, SubjectPaths};

/// Two points always lie on a line, whatever they are.
const MIN_POSES: usize = 3;

/// The map is a plane.
const DIMENSIONS: usize = 2;

/// The map of the poses of all subjects, one result per subject of the study: its paths, or in words why
/// it has none.
///
/// 1. All subjects are compared in the frame that the least known of them has; see [`Frame`].
/// 2. d² = |x̄₂ − x̄₁|² + (ρ₂ ln r̂₂ − ρ₁ ln r̂₁)² + angle(N̄₁, N̄₂)², positions in sizes of the subject (4.5.1).
/// 3. Scaling onto a plane.
///
/// # Errors
/// If there are fewer than three poses, a distance is not finite, the method of mapping fails, or on
/// "stop".
pub fn medial_map(
    hearts: &[Result<SubjectPaths, String>],
    method: MapMethod,
    progress: &Progress,
) -> Result<MedialMap, MedialMapError> {
    let mapped = || {
        let hearts = hearts.iter().enumerate();
        hearts.filter_map(|(subject, heart)| Some((subject, heart.as_ref().ok()?)))
    };
    let known: Vec<&SubjectPaths> = mapped().map(|(_, heart)| heart).collect();
    // One frame for all: distances between positions in different axes would mean nothing.
    let frame = shared_frame(&known);
    let poses: Vec<MedialPose> = mapped()
        .flat_map(|(subject, heart)| placed(subject, heart, frame))
        .collect();
    // Two points always lie on a line, at their distance: a plane would say no more.
    if poses.len() < MIN_POSES {
        return Err(MedialMapError::TooFewPoses {
            poses: poses.len(),
            hearts: mapped().count(),
        });
    }
    let distances = distances(&poses, progress)?;
    let embedding =
        embed(&distances, method, DIMENSIONS, progress).map_err(|error| match error {
            EmbeddingError::Stopped(stopped) => MedialMapError::Stopped(stopped),
            other => MedialMapError::Embedding(other),
        })?;
    Ok(MedialMap {
        spreads: spreads(&poses, &distances),
        distances,
        embedding,
        poses,
        frame,
        left_out: (hearts.iter().enumerate())
            .filter_map(|(subject, heart)| Some((subject, heart.as_ref().err()?.clone())))
            .collect(),
    })
}

/// The frame that all subjects have.
fn shared_frame(hearts: &[&SubjectPaths]) -> Frame {
    let known =
        |frame: &Frame| (hearts.iter()).all(|heart| heart.placements[*frame as usize].is_some());
    // From the most to the least comparable.
    (Frame::ALL.into_iter()).find(known).unwrap_or(Frame::Files)
}

fn placed(
    subject: usize,
    heart: &SubjectPaths,
    frame: Frame,
) -> impl Iterator<Item = MedialPose> + '_ {
    let placement = heart.placements[frame as usize];
    let paths = heart.paths.iter();
    paths.flat_map(move |path| {
        path.steps.iter().filter_map(move |step| {
            Some(MedialPose {
                subject,
                part: path.part,
                step_from: step.from,
                step_to: step.to,
                descriptor: placement?.placed(&step.descriptor),
            })
        })
    })
}

fn distances(poses: &[MedialPose], progress: &Progress) -> Result<DistanceMatrix, MedialMapError> {
    progress.expect_steps(poses.len());
    let mut upper = Vec::with_capacity(poses.len() * (poses.len() - 1) / 2);
    for (row, pose) in poses.iter().enumerate() {
        progress.step()?;
        let (others, before) = (poses[row + 1..].iter(), upper.len());
        upper.extend(others.map(|other| pose_distance(&pose.descriptor, &other.descriptor)));
        // Row by row, so that the subject can be named.
        if upper[before..].iter().any(|distance| !distance.is_finite()) {
            let subject = pose.subject;
            return Err(MedialMapError::NotFinite { subject });
        }
    }
    let whole = DistanceMatrix::from_upper(poses.len(), upper);
    let subject = poses.first().map_or(0, |pose| pose.subject);
    whole.ok_or(MedialMapError::NotFinite { subject })
}

/// Mean distance within each run of poses of one part of one subject.
fn spreads(poses: &[MedialPose], distances: &DistanceMatrix) -> Vec<Spread> {
    let part = |pose: &MedialPose| -> (usize, AkineticPart) { (pose.subject, pose.part) };
    let mut first = 0;
    let runs = poses.chunk_by(|a, b| part(a) == part(b));
    runs.map(|run| {
        let rows = first..first + run.len();
        first = rows.end;
        let pairs = (rows.clone()).flat_map(|i| (i + 1..rows.end).map(move |j| (i, j)));
        let sum: f64 = pairs.clone().map(|(i, j)| distances.get(i, j)).sum();
        let count = pairs.count();
        Spread {
            subject: run[0].subject,
            part: run[0].part,
            mean_distance: (count > 0).then(|| sum / count as f64),
        }
    })
    .collect()
}
