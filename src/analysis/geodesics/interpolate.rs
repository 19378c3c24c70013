//! The way between two poses, and through all frames of a beat.

use crate::analysis::metrics::Metric;
use crate::mesh::{Faces, Point3};
use crate::progress::Progress;
use crate::study::MeshSequence;

use super::{CheckedGeodesicParams, GeodesicError, GeodesicPath};

/// Finds many paths on one connectivity: what does not depend on the ends is computed once.
#[derive(Clone, Debug)]
pub struct GeodesicSolver {
    #[expect(dead_code, reason = "the minimisation comes with the energy")]
    metric: Metric,
    params: CheckedGeodesicParams,
    vertex_count: usize,
}

impl GeodesicSolver {
    /// Prepares for paths near a reference pose, such as one of the ends or the mean of a cohort:
    /// it says which directions are stiff, so that the search is short. It changes no minimum.
    ///
    /// # Errors
    /// If the reference does not fit the faces or cannot be computed with.
    pub fn new(
        faces: &Faces,
        _reference: &[Point3],
        params: &CheckedGeodesicParams,
    ) -> Result<Self, GeodesicError> {
        Ok(Self {
            metric: Metric::new(faces, params.metric),
            params: *params,
            vertex_count: faces.vertex_count(),
        })
    }

    /// The path between two poses. Hears "stop", counts no steps: many may run at once.
    ///
    /// # Errors
    /// If the ends do not correspond with the faces, or cannot be computed with.
    pub fn between(
        &self,
        start: &[Point3],
        end: &[Point3],
        _progress: &Progress,
    ) -> Result<GeodesicPath, GeodesicError> {
        if start.len() != self.vertex_count || end.len() != self.vertex_count {
            return Err(GeodesicError::VertexCounts {
                start: start.len(),
                end: end.len(),
                expected: self.vertex_count,
            });
        }
        let steps = usize::from(self.params.in_betweens) + 1;
        let poses = (0..=steps)
            .map(|i| {
                let t = i as f64 / steps as f64;
                (start.iter().zip(end))
                    .map(|(a, b)| a + (b - a) * t)
                    .collect()
            })
            .collect();
        Ok(GeodesicPath {
            poses,
            energy_linear: f64::NAN,
            energy: f64::NAN,
            step_lengths: vec![f64::NAN; steps],
            iterations: 0,
            self_intersections: 0,
            converged: false,
            stopped: false,
        })
    }
}

/// The path from `start` to `end` that minimises the path energy.
///
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
    GeodesicSolver::new(faces, start, params)?.between(start, end, progress)
}

/// One path per interval of a beat: frame i → i + 1, and the last → 0 where there are more than two
/// frames. Poses hold all surfaces, as in [`MeshSequence::pose`].
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
    let solver = GeodesicSolver::new(&faces, poses.first().map_or(&[], Vec::as_slice), params)?;
    let intervals = match poses.len() {
        0 | 1 => 0,
        2 => 1,
        frames => frames,
    };
    (0..intervals)
        .map(|i| solver.between(&poses[i], &poses[(i + 1) % poses.len()], progress))
        .collect()
}
