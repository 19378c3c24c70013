//! Many poses aligned with their common mean, for views that show them together.

use crate::mesh::Point3;
use crate::progress::{Progress, Stopped};

use super::{RigidMotion, rigid_motion};

/// Sweeps after which the mean is taken as it is; poses of a beat settle within five.
const MAX_SWEEPS: usize = 50;
/// Squared movement of the mean over its squared size at which it has settled: round-off.
const SETTLED: f64 = 1e-24;

/// Rigid motions that lay corresponding poses onto their mean shape (generalised Procrustes
/// analysis without scaling); the first pose stays where it is.
///
/// Alternates between moving each pose onto the mean and averaging the moved poses; the sum of
/// squared distances to the mean never rises. Poses with another number of points than the first
/// stay in place.
///
/// Source: Gower (1975), Psychometrika 40(1), section 2, with fixed scales.
///
/// # Errors
/// If stopped; the flag is heard once per pose.
pub fn align_poses(poses: &[&[Point3]], progress: &Progress) -> Result<Vec<RigidMotion>, Stopped> {
    let mut motions = vec![RigidMotion::identity(); poses.len()];
    let Some(&first) = poses.first() else {
        return Ok(motions);
    };
    let mut mean = first.to_vec();
    progress.expect_steps(MAX_SWEEPS * poses.len());
    for _ in 0..MAX_SWEEPS {
        let mut sum = vec![nalgebra::Vector3::zeros(); first.len()];
        let mut members = 0.0;
        for (pose, motion) in poses.iter().zip(&mut motions) {
            progress.step()?;
            // Another number of points: it has no place in the mean.
            let Ok(found) = rigid_motion(pose, &mean) else {
                continue;
            };
            *motion = found;
            members += 1.0;
            for (sum, point) in sum.iter_mut().zip(*pose) {
                *sum += found.apply(point).coords;
            }
        }
        if members == 0.0 {
            break;
        }
        let next: Vec<Point3> = sum.iter().map(|s| Point3::from(s / members)).collect();
        let moved: f64 = (mean.iter().zip(&next))
            .map(|(old, new)| (new - old).norm_squared())
            .sum();
        // Relative to the size, so that it settles alike in millimetres and in metres.
        let size: f64 = next.iter().map(|p| (p - next[0]).norm_squared()).sum();
        mean = next;
        if moved <= SETTLED * size {
            break;
        }
    }
    // The mean drifts while it settles; seen from the first pose it does not.
    let back = motions[0].inverse();
    Ok(motions.iter().map(|motion| motion.then(&back)).collect())
}

/// One rigid motion per sequence that aligns sequences with each other and leaves each motion as it is;
/// the first sequence stays where it is.
///
/// Sequences are represented by the mean of their poses, and these are aligned with their mean by
/// [`align_poses`]. `sequences[s][f]` are the points of sequence `s` at frame `f`.
///
/// # Errors
/// If stopped.
pub fn align_sequences(
    sequences: &[Vec<&[Point3]>],
    progress: &Progress,
) -> Result<Vec<RigidMotion>, Stopped> {
    // One motion for a whole sequence: aligned frame by frame, it would lose movement of its own.
    let means: Vec<Vec<Point3>> = sequences.iter().map(|frames| mean_pose(frames)).collect();
    let poses: Vec<&[Point3]> = means.iter().map(Vec::as_slice).collect();
    align_poses(&poses, progress)
}

fn mean_pose(frames: &[&[Point3]]) -> Vec<Point3> {
    let mut mean = vec![Point3::origin(); frames.first().map_or(0, |first| first.len())];
    for frame in frames {
        for (mean, point) in mean.iter_mut().zip(*frame) {
            *mean += point.coords / frames.len() as f64;
        }
    }
    mean
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Vector3, phantom};
    use nalgebra::Rotation3;

    fn beat() -> Vec<Vec<Point3>> {
        let rest = phantom::bowl(1.0, 5, 9);
        (0..6)
            .map(|frame| {
                let squeeze = 1.0 - 0.06 * f64::from(frame);
                let wander = Rotation3::from_euler_angles(0.2 * f64::from(frame), 0.1, 0.0);
                rest.vertices()
                    .iter()
                    .map(|p| Point3::new(p.x * squeeze, 1.2 * p.y, 1.6 * p.z))
                    .map(|p| wander * p + Vector3::new(f64::from(frame), 0.0, 2.0))
                    .collect()
            })
            .collect()
    }

    fn spread(poses: &[Vec<Point3>], motions: &[RigidMotion]) -> f64 {
        let moved: Vec<Vec<Point3>> = (poses.iter().zip(motions))
            .map(|(pose, motion)| pose.iter().map(|p| motion.apply(p)).collect())
            .collect();
        let mean = mean_pose(&moved.iter().map(Vec::as_slice).collect::<Vec<_>>());
        moved
            .iter()
            .flat_map(|pose| pose.iter().zip(&mean))
            .map(|(p, m)| (p - m).norm_squared())
            .sum()
    }

    #[test]
    fn the_wandering_of_a_beat_is_taken_out_and_its_deformation_stays() {
        let poses = beat();
        let slices: Vec<&[Point3]> = poses.iter().map(Vec::as_slice).collect();
        let motions = align_poses(&slices, &Progress::default()).unwrap();
        assert_eq!(motions.len(), 6);
        assert!((motions[0].rotation - nalgebra::Matrix3::identity()).norm() < 1e-12);
        let aligned = spread(&poses, &motions);
        let still: Vec<RigidMotion> = vec![RigidMotion::identity(); 6];
        assert!(aligned < 0.01 * spread(&poses, &still));
        assert!(aligned > 1e-3);
    }

    #[test]
    fn whole_sequences_move_as_one() {
        let one = beat();
        let turn = Rotation3::from_euler_angles(0.3, -0.5, 1.0);
        let other: Vec<Vec<Point3>> = one
            .iter()
            .map(|pose| pose.iter().map(|p| turn * p).collect())
            .collect();
        let sequences = [&one, &other].map(|s| s.iter().map(Vec::as_slice).collect::<Vec<_>>());
        let motions = align_sequences(&sequences, &Progress::default()).unwrap();
        for (p, q) in one[3].iter().zip(&other[3]) {
            assert!((motions[1].apply(q) - p).norm() < 1e-10);
        }
    }

    #[test]
    fn a_stopped_alignment_says_so() {
        let progress = Progress::default();
        progress.stop();
        let poses = beat();
        let slices: Vec<&[Point3]> = poses.iter().map(Vec::as_slice).collect();
        assert_eq!(align_poses(&slices, &progress), Err(Stopped));
        assert!(align_poses(&[], &progress).unwrap().is_empty());
    }
}
