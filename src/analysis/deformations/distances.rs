//! How far is every whole deformation from every other?

use std::collections::HashMap;

use crate::analysis::pose_distances::{
    CheckedPoseDistanceParams, DistanceMatrix, PoseDistanceError, PoseDistances, PoseId,
    pose_distances_where,
};
use crate::progress::{Progress, Stopped};
use crate::study::Study;

use super::beats::{Beat, Between, beats};

/// Distances of deformations, a row per subject.
#[derive(Clone, Debug, PartialEq)]
pub struct DeformationDistances {
    /// What each row stands for: indices into the study's subjects, ascending.
    pub subjects: Vec<usize>,
    /// The distances, in the unit of the pose distances.
    pub distances: DistanceMatrix,
}

/// Root mean square over the beat of the distances of poses at equal phases,
/// D(i, j)² = mean over φ of d(i at φ, j at φ)², φ the share of the beat since end-diastole.
///
/// φ runs through the frames of i and, with the same weight, through those of j; where both have
/// their frames at the same phases, that is the mean over frames. Between two frames A, A′ of a
/// subject, at the share u of the way, the pose is taken to lie on the straight line between them. For
/// such points B of another way, B = (1 − v) B₀ + v B₁, Stewart's theorem gives
///
/// d² = Σ pₖ qₗ d(Aₖ, Bₗ)² − u(1 − u) d(A₀, A₁)² − v(1 − v) d(B₀, B₁)²,
/// p = (1 − u, u), q = (1 − v, v),
///
/// exact where distances are Euclidean, and 0 where it would be negative. So one motion sampled at
/// other frames is at distance 0 from itself as far as it runs straight between frames.
///
/// # Errors
/// If stopped; the flag is heard once per subject.
pub fn deformation_distances(
    study: &Study,
    poses: &PoseDistances,
    progress: &Progress,
) -> Result<DeformationDistances, Stopped> {
    let beats = beats(study, &poses.poses);
    progress.expect_steps(beats.len());
    let mut upper = Vec::with_capacity(beats.len() * beats.len().saturating_sub(1) / 2);
    for (i, beat) in beats.iter().enumerate() {
        progress.step()?;
        for other in &beats[i + 1..] {
            // Each subject has its own phases; both ways make the distance symmetric.
            let forth = mean_square(&poses.distances, beat, other);
            let back = mean_square(&poses.distances, other, beat);
            upper.push((0.5 * (forth + back)).sqrt());
        }
    }
    Ok(DeformationDistances {
        subjects: beats.iter().map(|beat| beat.subject).collect(),
        distances: DistanceMatrix::from_upper(beats.len(), upper)
            .unwrap_or_else(DistanceMatrix::empty),
    })
}

/// [`deformation_distances`] where distances of poses are asked for nothing else: if all subjects have their frames at equal
/// phases, only poses at equal phases are compared.
///
/// # Errors
/// As [`pose_distances`](crate::analysis::pose_distances::pose_distances).
pub fn distances_at_equal_phases(
    study: &Study,
    params: &CheckedPoseDistanceParams,
    progress: &Progress,
) -> Result<DeformationDistances, PoseDistanceError> {
    let all: Vec<PoseId> = (study.subjects.iter().enumerate())
        .flat_map(|(subject, found)| {
            (0..found.sequence.frame_count()).map(move |frame| PoseId { subject, frame })
        })
        .collect();
    let beats = beats(study, &all);
    let even = beats.windows(2).all(|pair| pair[0].times == pair[1].times);
    let mut step_of: HashMap<PoseId, usize> = HashMap::new();
    for beat in &beats {
        step_of.extend(
            beat.rows
                .iter()
                .enumerate()
                .map(|(step, row)| (all[*row], step)),
        );
    }
    let needed = |a: PoseId, b: PoseId| !even || step_of.get(&a) == step_of.get(&b);
    let poses = pose_distances_where(study, params, &needed, progress)?;
    Ok(deformation_distances(study, &poses, progress)?)
}

/// Mean of d² over the frames of the first.
fn mean_square(distances: &DistanceMatrix, beat: &Beat, other: &Beat) -> f64 {
    let at = |(row, time): (&usize, &f64)| {
        let here = Between {
            from: *row,
            to: *row,
            share: 0.0,
        };
        squared(distances, &here, &other.at(*time))
    };
    let sum: f64 = beat.rows.iter().zip(&beat.times).map(at).sum();
    sum / beat.rows.len() as f64
}

fn squared(distances: &DistanceMatrix, a: &Between, b: &Between) -> f64 {
    let square = |i: usize, j: usize| distances.get(i, j).powi(2);
    let (u, v) = (a.share, b.share);
    let across = (1.0 - u) * ((1.0 - v) * square(a.from, b.from) + v * square(a.from, b.to))
        + u * ((1.0 - v) * square(a.to, b.from) + v * square(a.to, b.to));
    let along = u * (1.0 - u) * square(a.from, a.to) + v * (1.0 - v) * square(b.from, b.to);
    // Distances of a metric need not be Euclidean, and then the theorem may fall below zero.
    (across - along).max(0.0)
}
