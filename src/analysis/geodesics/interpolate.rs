//! The path of least energy between two poses.

use crate::mesh::{Faces, Point3};
use crate::progress::Progress;

use super::path_ends::check_ends;
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
