//! How well surfaces lie on their masks.

use crate::mesh::{ClosestPoint, Point3, TriMesh, crossing_faces};
use crate::progress::{Progress, Stopped};
use crate::study::SurfaceKind;

/// One surface at one frame against its mask.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceFit {
    /// From 0.
    pub frame: usize,
    /// Endocardium or epicardium.
    pub kind: SurfaceKind,
    /// Mean distance of the mask's outlines from the surface, after slices were put back that stood beside their neighbours.
    pub mean_mm: f64,
    /// Distance that 95 % of the outlines keep.
    pub p95_mm: f64,
    /// Faces that look towards the axis, plus pairs of faces that cross each other.
    pub foldovers: usize,
    /// Volume of the surface up to the plane of the valve.
    pub volume_ml: f64,
    /// Volume of all voxels of the mask, those left out included.
    pub mask_volume_ml: f64,
}

/// Mean and 95th percentile of the distances of points from a surface; zeros without points.
pub(super) fn distances(
    outline: &[Point3],
    surface: &TriMesh,
    progress: &Progress,
) -> Result<[f64; 2], Stopped> {
    let Some(tree) = ClosestPoint::new(surface.vertices(), surface.triangles()) else {
        return Ok([0.0; 2]);
    };
    let mut away = Vec::with_capacity(outline.len());
    for chunk in outline.chunks(512) {
        progress.check()?;
        away.extend(chunk.iter().map(|&p| (tree.closest(p) - p).norm()));
    }
    away.sort_by(f64::total_cmp);
    let mean = away.iter().sum::<f64>() / away.len().max(1) as f64;
    let p95 = away.get(away.len() * 95 / 100).copied().unwrap_or(0.0);
    Ok([mean, p95])
}

/// Faces whose normal points towards the axis, of which `centre` gives the point at the height of another one, plus pairs of
/// faces that cross.
pub(super) fn foldovers(
    surface: &TriMesh,
    centre: impl Fn(Point3) -> Point3,
    progress: &Progress,
) -> Result<usize, Stopped> {
    let vertices = surface.vertices();
    let inwards = |triangle: &&[u32; 3]| {
        let [a, b, c] = triangle.map(|v| vertices[v as usize]);
        let middle = Point3::from((a.coords + b.coords + c.coords) / 3.0);
        (b - a).cross(&(c - a)).dot(&(middle - centre(middle))) <= 0.0
    };
    let turned = surface.triangles().iter().filter(inwards).count();
    let go_on = || progress.check().is_ok();
    let crossing = crossing_faces(vertices, surface.triangles(), go_on).ok_or(Stopped)?;
    Ok(turned + crossing)
}
