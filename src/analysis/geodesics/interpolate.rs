//! The way between two poses, and through all frames of a beat.

use rayon::prelude::*;

use crate::mesh::{Faces, Point3};
use crate::progress::Progress;
use crate::study::MeshSequence;

use super::ends::check_ends;
use super::{CheckedGeodesicParams, GeodesicError, GeodesicPath, GeodesicSolver};

/// Evaluations of the energy that subjects take; the bar waits at its end for more difficult ends.
const USUAL_EVALUATIONS: usize = 60;

/// The path from `start` to `end` that minimises the path energy.
///
/// Ends are taken as they lie: where one is turned or shifted against the other, that counts
/// as far as the metric penalises it; align them first if it should not be.
/// Stopped, it gives the best path so far, marked as such.
///
/// # Errors
/// If the ends do not correspond with the faces, or cannot be computed with.
pub fn geodesic(
    faces: &Faces,
    start: &[Point3],
    end: &[Point3],
    params: &CheckedGeodesicParams,
    progress: &Progress,
) -> Result<GeodesicPath, GeodesicError> {
    check_ends(faces, start, end)?;
    let middle: Vec<Point3> = (start.iter().zip(end))
        .map(|(a, b)| a + (b - a) * 0.5)
        .collect();
    // Half-way, stiffness is right on average; a degenerate middle, as of a shape turned inside out, has none.
    let reference = if check_ends(faces, &middle, &middle).is_ok() {
        &middle
    } else {
        start
    };
    let solver = GeodesicSolver::new(faces, reference, params)?;
    progress.expect_steps(USUAL_EVALUATIONS);
    solver.path(start, end, &|| progress.step().is_ok())
}

/// One path per interval of a beat: frame i → i + 1, and the last → 0 where there are more than two
/// frames. Poses hold all surfaces, as in [`MeshSequence::pose`].
///
/// Intervals are computed side by side, one progress step each. Stopped, those not yet found are
/// straight lines, marked as stopped.
///
/// # Errors
/// If a frame cannot be computed with.
pub fn interpolated_sequence(
    sequence: &MeshSequence,
    params: &CheckedGeodesicParams,
    progress: &Progress,
) -> Result<Vec<GeodesicPath>, GeodesicError> {
    let faces = sequence.joined_faces();
    let poses: Vec<Vec<Point3>> = (0..sequence.frame_count())
        .filter_map(|frame| sequence.pose(frame))
        .collect();
    let intervals = match poses.len() {
        0 | 1 => return Ok(Vec::new()),
        // With two frames the way back would be the same path again.
        2 => 1,
        frames => frames,
    };
    let solver = GeodesicSolver::new(&faces, &poses[0], params)?;
    progress.expect_steps(intervals);
    (0..intervals)
        .into_par_iter()
        .map(|i| {
            let path = solver.between(&poses[i], &poses[(i + 1) % poses.len()], progress);
            let _ = progress.step(); // Heard inside, so that the others end as best so far.
            path
        })
        .collect()
}
