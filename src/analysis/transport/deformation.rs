//! A whole deformation transported to another subject, step after step.

use crate::analysis::geodesics::GeodesicSolver;
use crate::analysis::metrics::Metric;
use crate::mesh::{Faces, Point3, Vector3};
use crate::progress::{Progress, Stopped};

use super::pose_path::transport_nearest;
use super::{
    CheckedTransportParams, FoundPath, Geodesics, TransportAccount, TransportError,
    TransportedPoses,
};

/// Transports many deformations on one connectivity: what does not depend on the subjects is computed once.
#[derive(Clone, Debug)]
pub struct DeformationTransport {
    metric: Metric,
    /// `None` where the way is straight.
    solver: Option<GeodesicSolver>,
    params: CheckedTransportParams,
    vertex_count: usize,
}

impl DeformationTransport {
    /// Prepares for subjects near a reference pose, such as the one that is to move: it makes the
    /// search for geodesics short.
    ///
    /// # Errors
    /// If the reference does not fit the faces or cannot be computed with.
    pub fn new(
        faces: &Faces,
        reference: &[Point3],
        params: &CheckedTransportParams,
    ) -> Result<Self, TransportError> {
        let solver = (params.geodesic.as_ref())
            .map(|geodesic| GeodesicSolver::new(faces, reference, geodesic))
            .transpose()?;
        Ok(Self {
            metric: Metric::new(faces, params.metric),
            solver,
            params: *params,
            vertex_count: faces.vertex_count(),
        })
    }

    /// The deformation `source` of the subject `source[0]`, transported to the subject `onto`: as many
    /// poses, the first of which is `onto`.
    ///
    /// N₀ = `onto`, N_{i+1} = N_i + X̄_i, where X̄_i is M_{i+1} − M_i transported along the path from M_i
    /// to N_i. Both are taken as they lie: align them first, and make sizes comparable. Counts one
    /// step of progress per displacement.
    ///
    /// # Errors
    /// If stopped, there is no pose, counts differ, or squares of lengths overflow.
    pub fn transport(
        &self,
        source: &[Vec<Point3>],
        onto: &[Point3],
        progress: &Progress,
    ) -> Result<TransportedPoses, TransportError> {
        let first = source.first().ok_or(TransportError::NoPoses)?;
        // Checked once, so that no step can read past a pose.
        for pose in source.iter().map(Vec::as_slice).chain([onto]) {
            if pose.len() != self.vertex_count {
                return Err(TransportError::FieldLength {
                    displacements: pose.len(),
                    vertices: self.vertex_count,
                });
            }
        }
        let mut account = TransportAccount::default();
        let found = &mut account.paths;
        let bend = match self.params.geodesics {
            // Computed once: paths of later steps bend alike, and on real meshes their differences are noise.
            Geodesics::First if source.len() > 1 => self.bend(first, onto, found, progress)?,
            _ => Vec::new(),
        };
        let mut transported = vec![onto.to_vec()];
        let mut here = onto.to_vec();
        for (pose, pair) in source.windows(2).enumerate() {
            progress.step()?;
            let path = match self.params.geodesics {
                Geodesics::First => bent_line(&pair[0], &here, &bend),
                // Between the poses reached so far, as the text has it; the cost is a geodesic for every frame.
                Geodesics::EveryStep => self.path(&pair[0], &here, &mut account.paths, progress)?,
            };
            let field = difference(&pair[0], &pair[1]);
            let (nearness, keep_norm) = (self.params.nearness, self.params.keep_norm);
            let moved = transport_nearest(&self.metric, &path, &field, nearness, keep_norm);
            let (moved, kept) = moved.map_err(|error| match error {
                TransportError::NotFinite { norm2, .. } => {
                    TransportError::NotFinite { pose, norm2 }
                }
                other => other,
            })?;
            account.steps.push(kept);
            for (point, x) in here.iter_mut().zip(&moved) {
                *point += x;
            }
            transported.push(here.clone());
        }
        Ok(TransportedPoses {
            poses: transported,
            account,
        })
    }

    /// How far each interpolated pose of the geodesic lies from the straight line.
    fn bend(
        &self,
        start: &[Point3],
        end: &[Point3],
        found: &mut Vec<FoundPath>,
        progress: &Progress,
    ) -> Result<Vec<Vec<Vector3>>, TransportError> {
        let path = self.path(start, end, found, progress)?;
        // Only how the path bends is kept; where it begins and ends is another matter in every step.
        let straight = bent_line(start, end, &vec![Vec::new(); path.len().saturating_sub(2)]);
        let inner = 1..path.len().saturating_sub(1);
        Ok(inner.map(|k| difference(&straight[k], &path[k])).collect())
    }

    fn path(
        &self,
        start: &[Point3],
        end: &[Point3],
        found: &mut Vec<FoundPath>,
        progress: &Progress,
    ) -> Result<Vec<Vec<Point3>>, TransportError> {
        let Some(solver) = &self.solver else {
            return Ok(vec![start.to_vec(), end.to_vec()]);
        };
        let path = solver.between(start, end, progress)?;
        if path.stopped {
            return Err(Stopped.into());
        }
        if path.fell_back {
            // The straight line given out as a geodesic would hide that none was found.
            return Err(TransportError::NoGeodesic {
                energy_linear: path.energy_linear,
            });
        }
        found.push(FoundPath::of(&path));
        Ok(path.poses)
    }
}

/// The straight line from start to end with one interpolated pose per bend, moved by it.
fn bent_line(start: &[Point3], end: &[Point3], bends: &[Vec<Vector3>]) -> Vec<Vec<Point3>> {
    let steps = bends.len() + 1;
    let mut path = vec![start.to_vec()];
    for (k, bend) in bends.iter().enumerate() {
        let t = (k + 1) as f64 / steps as f64;
        let mut pose: Vec<Point3> = (start.iter().zip(end))
            .map(|(a, b)| a + (b - a) * t)
            .collect();
        for (point, x) in pose.iter_mut().zip(bend) {
            *point += x;
        }
        path.push(pose);
    }
    path.push(end.to_vec());
    path
}

fn difference(from: &[Point3], to: &[Point3]) -> Vec<Vector3> {
    from.iter().zip(to).map(|(a, b)| b - a).collect()
}

/// One deformation transported to one subject, see [`DeformationTransport::transport`].
///
/// # Errors
/// If stopped, there is no pose, counts differ, or squares of lengths overflow.
pub fn transport_deformation(
    faces: &Faces,
    source: &[Vec<Point3>],
    onto: &[Point3],
    params: &CheckedTransportParams,
    progress: &Progress,
) -> Result<TransportedPoses, TransportError> {
    progress.expect_steps(source.len().saturating_sub(1));
    DeformationTransport::new(faces, onto, params)?.transport(source, onto, progress)
}
