//! Many paths on one connectivity, each of least energy between its ends.

use crate::analysis::metrics::{CurvatureRole, Metric, MetricError, PathEnergy};
use crate::mesh::{Decimation, Faces, Point3, crossing_faces};
use crate::progress::Progress;

use super::coarse::prolonged;
use super::minimise::{Content, Inner, cheapest, improve, resampled, time_levels};
use super::path_ends::{check_ends, flat, same_pose};
use super::stiffness::Stiffness;
use super::{CheckedGeodesicParams, GeodesicError, GeodesicPath};

/// The same question on fewer of the vertices.
#[derive(Clone, Debug)]
struct Coarse {
    decimation: Decimation,
    solver: GeodesicSolver,
}

/// Finds many paths on one connectivity: what does not depend on the ends is computed once.
#[derive(Clone, Debug)]
pub struct GeodesicSolver {
    faces: Faces,
    metric: Metric,
    params: CheckedGeodesicParams,
    stiffness: Option<Stiffness>,
    coarse: Option<Box<Coarse>>,
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
        // Curvature change as a factor is that between the two ends, unknown here.
        let stiffness = if params.metric.curvature_role().is_factor() {
            None // It depends on both ends: made for each path.
        } else {
            Stiffness::new(faces, reference, &params.metric, None)
        };
        let fewer = params.max_vertices.map(|most| most as usize);
        // A mesh that is small enough is searched as it is.
        let fewer = fewer.filter(|&most| most < faces.vertex_count());
        let coarse = match fewer {
            Some(most) => Self::coarse(faces, reference, params, most)?,
            None => None,
        };
        Ok(Self {
            faces: faces.clone(),
            metric: Metric::new(faces, params.metric),
            params: *params,
            stiffness,
            coarse,
        })
    }

    fn coarse(
        faces: &Faces,
        reference: &[Point3],
        params: &CheckedGeodesicParams,
        max_vertices: usize,
    ) -> Result<Option<Box<Coarse>>, GeodesicError> {
        let Some(decimation) = Decimation::new(reference, faces, max_vertices, || true) else {
            return Ok(None);
        };
        let solver = Self::new(
            decimation.faces(),
            &decimation.restricted(reference),
            // Or the coarse solver would make a coarser one of its own.
            &params.on_all_vertices(),
        )?;
        Ok(Some(Box::new(Coarse { decimation, solver })))
    }

    /// What is minimised. Its regulariser takes its size from the ends, so that poses which swell
    /// gain nothing.
    fn path_energy(
        &self,
        start: &[Point3],
        end: &[Point3],
        interpolated_poses: usize,
    ) -> Result<PathEnergy, MetricError> {
        let energy = PathEnergy::new(&self.metric, start, end, interpolated_poses)?;
        Ok(energy.with_size_of_ends())
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
        self.path(start, end, &|| !progress.stop_requested())
    }

    /// The same, with `go_on` asked after each evaluation of the energy.
    pub(super) fn path(
        &self,
        start: &[Point3],
        end: &[Point3],
        go_on: &dyn Fn() -> bool,
    ) -> Result<GeodesicPath, GeodesicError> {
        check_ends(&self.faces, start, end)?;
        let count = usize::from(self.params.interpolated_poses);
        let ends = [flat(start), flat(end)];
        let ends = [ends[0].as_slice(), ends[1].as_slice()];
        let mut energy = self.path_energy(start, end, count)?;
        let straight = resampled(ends[0], &[], ends[1], count);
        // The straight line is the start of the search and the bound that no result may exceed.
        let energy_linear = energy.energy(&straight);
        if !energy_linear.is_finite() {
            return Err(GeodesicError::Energy {
                energy: energy_linear,
            });
        }
        // Nothing to move, or a path that costs nothing already.
        let mut inner = if count == 0 || energy_linear == 0.0 || same_pose(start, end) {
            Inner {
                coordinates: straight.clone(),
                iterations: 0,
                converged: true,
                stopped: false,
            }
        } else {
            self.search(start, end, ends, go_on)?
        };
        let mut found = energy.energy(&inner.coordinates);
        // Stopped early, an unfinished path of few poses may be worse than none.
        let fell_back = found.is_nan() || found > energy_linear;
        if fell_back {
            inner.coordinates = straight;
            inner.converged = false;
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
        // The ends are as given.
        for pose in &poses[1..poses.len() - 1] {
            match crossing_faces(pose, self.faces.triangles(), go_on) {
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
            fell_back,
            stopped,
        })
    }

    fn search(
        &self,
        start: &[Point3],
        end: &[Point3],
        ends: [&[f64]; 2],
        go_on: &dyn Fn() -> bool,
    ) -> Result<Inner, GeodesicError> {
        if let Some(coarse) = &self.coarse {
            let Coarse { decimation, solver } = &**coarse;
            let poses = [start, end];
            let [start, end] = [start, end].map(|pose| decimation.restricted(pose));
            let few = [flat(&start), flat(&end)];
            let few = [few[0].as_slice(), few[1].as_slice()];
            let mut inner = solver.search(&start, &end, few, go_on)?;
            let count = usize::from(self.params.interpolated_poses);
            inner.coordinates = prolonged(decimation, &inner.coordinates, few, ends, count);
            self.relax(poses, ends, &mut inner, go_on)?;
            return Ok(inner);
        }
        let own = self.own_stiffness(start, end)?;
        let content = self.content();
        let count = usize::from(self.params.interpolated_poses);
        let from = |levels: &[usize], stiffness: Option<&Stiffness>| {
            cheapest(
                |count| self.path_energy(start, end, count),
                stiffness,
                ends,
                levels,
                &content,
                go_on,
            )
        };
        let stiffness = own.as_ref().or(self.stiffness.as_ref());
        // All poses at once: the preconditioner couples them in time, so that few poses first would gain nothing.
        let mut best = from(&[count], stiffness)?;
        // One search is enough where every start leads to the same path.
        if !has_many_minima(&self.params) {
            return Ok(best);
        }
        let mut energy = self.path_energy(start, end, count)?;
        let mut least = energy.energy(&best.coordinates);
        let levels = time_levels(count);
        // Other starts lead to other minima: from few poses on, with and without the preconditioner; the cheapest is
        // kept.
        for (levels, stiffness) in [(&levels[..], stiffness), (&levels, None), (&[count], None)] {
            if best.stopped {
                break;
            }
            let next = from(levels, stiffness)?;
            let found = energy.energy(&next.coordinates);
            let iterations = best.iterations + next.iterations;
            let stopped = next.stopped;
            if found < least {
                (least, best) = (found, next);
            }
            (best.iterations, best.stopped) = (iterations, stopped);
        }
        Ok(best)
    }

    fn content(&self) -> Content {
        Content {
            tolerance: self.params.tolerance,
            max_iterations: self.params.max_iterations as usize,
        }
    }

    /// Goes on from a prolonged path on all vertices: coarse offsets bend what the coarse mesh does not have, and alone
    /// may cost more than the straight line.
    fn relax(
        &self,
        [start, end]: [&[Point3]; 2],
        ends: [&[f64]; 2],
        inner: &mut Inner,
        go_on: &dyn Fn() -> bool,
    ) -> Result<(), GeodesicError> {
        if inner.stopped {
            return Ok(());
        }
        let count = usize::from(self.params.interpolated_poses);
        let mut energy = self.path_energy(start, end, count)?;
        let straight = resampled(ends[0], &[], ends[1], count);
        // The search is best begun low; the straight line is among the starts, so that the end is never above it.
        let mut least = energy.energy(&straight);
        let whole = std::mem::replace(&mut inner.coordinates, straight.clone());
        // Halves of the offsets: three evaluations of the energy against a start that is up to twice too bent. Not tuned.
        for share in [0.25, 0.5, 1.0] {
            let between = straight.iter().zip(&whole);
            let bent: Vec<f64> = between.map(|(s, w)| s + share * (w - s)).collect();
            let found = energy.energy(&bent);
            if found < least {
                (least, inner.coordinates) = (found, bent);
            }
        }
        let own = self.own_stiffness(start, end)?;
        let stiffness = own.as_ref().or(self.stiffness.as_ref());
        improve(&mut energy, stiffness, inner, &self.content(), go_on);
        Ok(())
    }

    /// For forms with curvature change as a factor: about (ΔK / steps)², which a step has.
    fn own_stiffness(
        &self,
        start: &[Point3],
        end: &[Point3],
    ) -> Result<Option<Stiffness>, GeodesicError> {
        let steps = match self.params.metric.curvature_role() {
            CurvatureRole::Unused | CurvatureRole::Term => return Ok(None),
            // The factor is the whole change in every step.
            CurvatureRole::FrozenFactor => 1.0,
            // Each of the steps makes an equal part of the change of the ends.
            CurvatureRole::StepFactor => f64::from(self.params.interpolated_poses) + 1.0,
        };
        let (a, b) = (self.metric.prepare(start)?, self.metric.prepare(end)?);
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

/// Where curvature change multiplies angle change, a step costs nothing if either is nothing: paths
/// alternate between both in many ways, and where a search ends depends on where it began.
fn has_many_minima(params: &CheckedGeodesicParams) -> bool {
    params.metric.curvature_role() == CurvatureRole::StepFactor
}
