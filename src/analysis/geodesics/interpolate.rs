//! The way between two poses, and through all frames of a beat.

use rayon::prelude::*;

use crate::analysis::metrics::{Form, Metric, MetricKind, PathEnergy};
use crate::mesh::{Faces, Point3, crossing_faces};
use crate::progress::Progress;
use crate::study::MeshSequence;

use super::minimise::{Content, Inner, cheapest, resampled, time_levels};
use super::stiffness::Stiffness;
use super::{CheckedGeodesicParams, GeodesicError, GeodesicPath};

/// Finds many paths on one connectivity: what does not depend on the ends is computed once.
#[derive(Clone, Debug)]
pub struct GeodesicSolver {
    faces: Faces,
    metric: Metric,
    params: CheckedGeodesicParams,
    stiffness: Option<Stiffness>,
}

impl GeodesicSolver {
    /// Prepares for paths near a reference pose, such as one of the ends or the mean of a cohort:
    /// it says which directions are stiff, so that the search is short. It changes no minimum.
    ///
    /// # Errors
    /// If the reference does not fit the faces or cannot be computed with.
    pub fn new(
        faces: &Faces,
        reference: &[Point3],
        params: &CheckedGeodesicParams,
    ) -> Result<Self, GeodesicError> {
        check_ends(faces, reference, reference)?;
        let stiffness = if curvature_is_a_factor(params) {
            None // It depends on both ends: made for each path.
        } else {
            Stiffness::new(faces, reference, &params.metric, None)
        };
        Ok(Self {
            faces: faces.clone(),
            metric: Metric::new(faces, params.metric),
            params: *params,
            stiffness,
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
        progress: &Progress,
    ) -> Result<GeodesicPath, GeodesicError> {
        check_ends(&self.faces, start, end)?;
        let count = usize::from(self.params.in_betweens);
        let ends = [flat(start), flat(end)];
        let ends = [ends[0].as_slice(), ends[1].as_slice()];
        let mut energy = PathEnergy::new(&self.metric, start, end, count)?;
        let straight = resampled(ends[0], &[], ends[1], count);
        let energy_linear = energy.energy(&straight);
        if !energy_linear.is_finite() {
            return Err(GeodesicError::Energy {
                energy: energy_linear,
            });
        }
        let mut inner = if count == 0 || energy_linear == 0.0 {
            Inner {
                coordinates: straight.clone(),
                iterations: 0,
                converged: true,
                stopped: false,
            }
        } else {
            self.search(start, end, ends, progress)?
        };
        let mut found = energy.energy(&inner.coordinates);
        // Stopped early, an unfinished path of few poses may be worse than none.
        if found.is_nan() || found > energy_linear {
            inner.coordinates = straight;
            found = energy.energy(&inner.coordinates);
        }
        let mut stopped = inner.stopped;
        let step_lengths = (energy.step_energies().iter())
            .map(|energy| (0.5 * energy).max(0.0).sqrt())
            .collect();
        let mut poses = vec![start.to_vec()];
        poses.extend(
            (inner.coordinates.chunks_exact((3 * start.len()).max(1))).map(|pose| {
                pose.chunks_exact(3)
                    .map(|p| Point3::new(p[0], p[1], p[2]))
                    .collect()
            }),
        );
        poses.push(end.to_vec());
        let mut self_intersections = 0;
        for pose in &poses[1..poses.len() - 1] {
            match crossing_faces(pose, self.faces.triangles(), || !progress.stop_requested()) {
                Some(count) => self_intersections += count,
                None => stopped = true,
            }
        }
        Ok(GeodesicPath {
            poses,
            energy_linear,
            energy: found,
            step_lengths,
            iterations: inner.iterations,
            self_intersections,
            converged: inner.converged,
            stopped,
        })
    }

    fn search(
        &self,
        start: &[Point3],
        end: &[Point3],
        ends: [&[f64]; 2],
        progress: &Progress,
    ) -> Result<Inner, GeodesicError> {
        let own = self.own_stiffness(start, end)?;
        let content = Content {
            tolerance: self.params.tolerance,
            most_iterations: self.params.most_iterations as usize,
        };
        let levels = time_levels(usize::from(self.params.in_betweens));
        Ok(cheapest(
            |count| PathEnergy::new(&self.metric, start, end, count),
            own.as_ref().or(self.stiffness.as_ref()),
            ends,
            &levels,
            &content,
            || !progress.stop_requested(),
        )?)
    }

    /// For forms with curvature change as a factor: about (ΔK / steps)², which a step has.
    fn own_stiffness(
        &self,
        start: &[Point3],
        end: &[Point3],
    ) -> Result<Option<Stiffness>, GeodesicError> {
        if !curvature_is_a_factor(&self.params) {
            return Ok(None);
        }
        let (a, b) = (self.metric.prepare(start)?, self.metric.prepare(end)?);
        let steps = match self.params.metric.form {
            Form::Frozen => 1.0,
            _ => f64::from(self.params.in_betweens) + 1.0,
        };
        let weights: Vec<f64> = (self.metric.frozen_weights(&a, &b).iter())
            .map(|weight| weight / (steps * steps))
            .collect();
        Ok(Stiffness::new(
            &self.faces,
            start,
            &self.params.metric,
            Some(&weights),
        ))
    }
}

fn curvature_is_a_factor(params: &CheckedGeodesicParams) -> bool {
    params.metric.kind == MetricKind::QuasiConformal && params.metric.form != Form::Additive
}

fn flat(points: &[Point3]) -> Vec<f64> {
    points.iter().flat_map(|p| [p.x, p.y, p.z]).collect()
}

fn check_ends(faces: &Faces, start: &[Point3], end: &[Point3]) -> Result<(), GeodesicError> {
    let expected = faces.vertex_count();
    if start.len() != expected || end.len() != expected {
        return Err(GeodesicError::VertexCounts {
            start: start.len(),
            end: end.len(),
            expected,
        });
    }
    for (name, points) in [("start", start), ("end", end)] {
        let bad = |p: &Point3| !p.coords.norm_squared().powi(2).is_finite();
        if let Some(vertex) = points.iter().position(bad) {
            let Point3 { coords } = points[vertex];
            return Err(GeodesicError::NotFinite {
                end: name,
                vertex,
                x: coords.x,
                y: coords.y,
                z: coords.z,
            });
        }
        let area = crate::mesh::area(points, faces.triangles());
        if area.is_nan() || area <= 0.0 {
            return Err(GeodesicError::Degenerate {
                end: name,
                faces: faces.triangles().len(),
                vertices: expected,
            });
        }
    }
    Ok(())
}

/// The path from `start` to `end` that minimises the path energy.
///
/// Ends are taken as they lie: where one is turned or shifted against the other, that is charged
/// as far as the metric charges it; align them first if it should not be.
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
    let reference = if check_ends(faces, &middle, &middle).is_ok() {
        &middle
    } else {
        start
    };
    GeodesicSolver::new(faces, reference, params)?.between(start, end, progress)
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
