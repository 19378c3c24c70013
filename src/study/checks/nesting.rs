//! Does one surface lie inside another, at every frame?

use std::collections::HashSet;

use super::inside::Inside;
use crate::mesh::Point3;
use crate::study::SurfaceSequence;

/// Surfaces count as apart where more than this share of the inner one is outside the outer one: real walls reach
/// 0.05, where a rim stands out of the other's lid or noise of segmentation lets them touch; surfaces of 25 and
/// 35 mm shifted by half the inner one's radius reach 0.13, in other coordinates 1.
const APART: f64 = 0.2;

/// Vertices that are looked at: their share is known to 0.05 at worst.
const SAMPLES: usize = 100;

/// Frames in which an inner surface does not lie in the outer one.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Nesting {
    /// Frames with too much outside, ascending.
    pub frames: Vec<usize>,
    /// The largest share outside.
    pub outside: f64,
}

impl Nesting {
    /// Looks at vertices of `inner` away from its rims at every frame.
    pub fn of(inner: &SurfaceSequence, outer: &SurfaceSequence) -> Self {
        let samples = samples(inner);
        let loops = outer.faces().boundary_loops();
        let mut found = Self::default();
        for (frame, (mesh, around)) in inner.frames().iter().zip(outer.frames()).enumerate() {
            let inside = Inside::new(around.vertices(), around.triangles(), &loops);
            let points = samples.iter().map(|&v| mesh.vertices()[v as usize]);
            let outside = 1.0 - share_inside(&inside, points);
            found.outside = found.outside.max(outside);
            if outside > APART {
                found.frames.push(frame);
            }
        }
        found
    }
}

/// Share of points that are inside; 1 of none.
pub(super) fn share_inside(inside: &Inside, points: impl ExactSizeIterator<Item = Point3>) -> f64 {
    let count = points.len();
    if count == 0 {
        return 1.0;
    }
    points.filter(|&point| inside.holds(point)).count() as f64 / count as f64
}

/// Vertices of faces, without those of rims, which may lie in the other surface's lid: evenly spread over their
/// numbers.
pub(super) fn samples(surface: &SurfaceSequence) -> Vec<u32> {
    let faces = surface.faces();
    let rims: HashSet<u32> = faces.boundary_loops().into_iter().flatten().collect();
    let mut used: Vec<u32> = faces.triangles().iter().flatten().copied().collect();
    used.sort_unstable();
    used.dedup();
    used.retain(|vertex| !rims.contains(vertex));
    let stride = used.len().div_ceil(SAMPLES).max(1);
    used.into_iter().step_by(stride).collect()
}
