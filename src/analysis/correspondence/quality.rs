//! How well the template lies on a surface.

use rayon::prelude::*;

use crate::analysis::registration::SurfaceFit;
use crate::mesh::{ClosestPoint, Point3, crossing_faces};
use crate::progress::{Progress, Stopped};
use crate::study::SurfaceKind;

use super::TargetError;
use super::carrying::{Carrier, size};
use super::params::CorrespondenceParams;
use super::target_surface::TargetSurface;
use super::turned_faces::{middle, turned_faces};

/// One surface at one frame against the surface that it stands for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrameFit {
    /// From 0.
    pub frame: usize,
    /// Which surface.
    pub kind: SurfaceKind,
    /// Mean distance between both surfaces, of vertices and middles of faces, in the unit of the coordinates: from the
    /// template or from the surface, the greater.
    pub mean: f64,
    /// The 95th percentile of these distances, the greater of both.
    pub p95: f64,
    /// Faces of the template that look against the surface, plus pairs of its faces that cross.
    pub foldovers: usize,
    /// Volume within the template and a lid on its rim, in cubic units.
    pub volume: f64,
    /// The same of the surface; `None` of one that branches, has one side, or holes.
    pub surface_volume: Option<f64>,
}

impl FrameFit {
    /// Of the template's points on a target.
    pub(super) fn of(
        (kind, frame): (SurfaceKind, usize),
        carrier: &Carrier,
        points: &[Point3],
        target: &TargetSurface,
        progress: &Progress,
    ) -> Result<Self, TargetError> {
        let triangles = carrier.triangles();
        let tree = ClosestPoint::new(points, triangles).ok_or(TargetError::NoExtent)?;
        let there = places(points, triangles);
        let back = places(target.vertices(), target.triangles());
        let there = there.par_iter().map(|&p| target.nearest(p).distance);
        let there: Vec<f64> = there.collect();
        progress.check()?;
        let back: Vec<f64> = back.par_iter().map(|&p| tree.distance(p)).collect();
        let fits = [there, back].map(|distances| SurfaceFit::of_distances(&distances));
        let [Some(there), Some(back)] = fits else {
            return Err(TargetError::NoExtent);
        };
        let turned = turned_faces(points, triangles, target, carrier.outward()).len();
        let go_on = || progress.check().is_ok();
        let crossing = crossing_faces(points, triangles, go_on).ok_or(Stopped)?;
        Ok(Self {
            frame,
            kind,
            mean: there.mean.max(back.mean),
            p95: there.p95.max(back.p95),
            foldovers: turned + crossing,
            volume: carrier.volume(points),
            surface_volume: target.volume(),
        })
    }

    /// Whether it may be used.
    pub(super) fn check(
        &self,
        params: &CorrespondenceParams,
        target: &TargetSurface,
        faces: usize,
    ) -> Result<(), TargetError> {
        let size = size(target.vertices());
        let max_foldovers = (params.max_foldovers * faces as f64) as usize;
        let [max_mean, max_p95] = [params.max_mean, params.max_p95].map(|share| share * size);
        let fits = self.mean <= max_mean && self.p95 <= max_p95 && self.foldovers <= max_foldovers;
        if fits {
            return Ok(());
        }
        Err(TargetError::Misfit {
            mean: self.mean,
            p95: self.p95,
            foldovers: self.foldovers,
            max_mean,
            max_p95,
            max_foldovers,
        })
    }
}

/// Vertices and middles of faces.
fn places(points: &[Point3], triangles: &[[u32; 3]]) -> Vec<Point3> {
    let middles = triangles.iter().map(|t| middle(points, t));
    points.iter().copied().chain(middles).collect()
}
