//! A closed surface of a ventricle, opened at its base.

use std::collections::HashMap;

use nalgebra::{Matrix3, SymmetricEigen};

use crate::mesh::{Point3, Vector3, mean_point};

use super::TargetError;
use super::target_surface::TargetSurface;

/// Share of the length from an end at which its width is looked at.
const END: f64 = 0.15;
/// How much wider the base must be than the apex to be told from it.
const MIN_WIDER: f64 = 1.15;
/// Share of the length that is cut off where nobody said where the base is: lids are flat, and flat but for this.
const LID: f64 = 0.03;
/// Least and greatest share that is cut off where somebody said where the base is.
const CUTS: [f64; 2] = [0.02, 0.5];

/// Which way the ventricle points, and where its base is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Opening {
    /// Unit direction from the base to the apex.
    pub down: Vector3,
    /// Share of the length along it that is cut off.
    pub share: f64,
}

impl Opening {
    /// At a base that was marked.
    pub fn marked(
        surface: &TargetSurface,
        base: Point3,
        apex: Point3,
    ) -> Result<Self, TargetError> {
        let down = (apex - base).try_normalize(0.0);
        let down = down.ok_or(TargetError::NoAxis)?;
        let [from, to] = extent(surface.vertices(), down);
        let share = (down.dot(&base.coords) - from) / (to - from);
        if !share.is_finite() || share > CUTS[1] {
            return Err(TargetError::NoAxis);
        }
        let share = share.max(CUTS[0]);
        Ok(Self { down, share })
    }

    /// Along the longest principal axis of the vertices' box, at the wider end.
    pub fn found(surface: &TargetSurface) -> Result<Self, TargetError> {
        let points = surface.vertices();
        let centre = mean_point(points.iter().copied());
        let scatter: Matrix3<f64> = (points.iter().map(|p| p - centre))
            .map(|away| away * away.transpose())
            .sum();
        let eigen = SymmetricEigen::new(scatter);
        let longest: Vector3 = eigen.eigenvectors.column(eigen.eigenvalues.imax()).into();
        let longest = longest.try_normalize(0.0).ok_or(TargetError::NoAxis)?;
        let [from, to] = extent(points, longest);
        let width = |end: f64| {
            let at = from + end * (to - from);
            let near = points
                .iter()
                .filter(|p| (longest.dot(&p.coords) - at).abs() <= 0.05 * (to - from));
            let ring: Vec<Point3> = near.copied().collect();
            let middle = mean_point(ring.iter().copied());
            let away = |p: &Point3| {
                let away = p - middle;
                (away - longest * longest.dot(&away)).norm()
            };
            ring.iter().map(away).sum::<f64>() / ring.len().max(1) as f64
        };
        let (low, high) = (width(END), width(1.0 - END));
        let down = match (low > MIN_WIDER * high, high > MIN_WIDER * low) {
            (true, _) => longest,
            (_, true) => -longest,
            _ => return Err(TargetError::NoAxis),
        };
        Ok(Self { down, share: LID })
    }

    /// The surface without its lid, and a note of it.
    pub fn cut(&self, surface: &TargetSurface) -> Result<TargetSurface, TargetError> {
        let [from, to] = extent(surface.vertices(), self.down);
        let height = from + self.share * (to - from);
        let (vertices, triangles) =
            beyond(surface.vertices(), surface.triangles(), self.down, height);
        let mut notes = surface.notes.clone();
        notes.push(format!(
            "closed at the base: opened {:.0} % of its length below its top",
            100.0 * self.share
        ));
        TargetSurface::of_piece(&vertices, &triangles, surface.is_oriented(), notes)
    }
}

/// Least and greatest height of points along a direction.
fn extent(points: &[Point3], along: Vector3) -> [f64; 2] {
    let heights = points.iter().map(|p| along.dot(&p.coords));
    heights.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], h| {
        [low.min(h), high.max(h)]
    })
}

/// The part of a surface beyond a height; faces across it are cut.
fn beyond(
    vertices: &[Point3],
    triangles: &[[u32; 3]],
    along: Vector3,
    height: f64,
) -> (Vec<Point3>, Vec<[u32; 3]>) {
    let heights: Vec<f64> = (vertices.iter())
        .map(|p| along.dot(&p.coords) - height)
        .collect();
    let mut points = vertices.to_vec();
    let mut kept = Vec::with_capacity(triangles.len());
    let mut on_edge: HashMap<[u32; 2], u32> = HashMap::new();
    for triangle in triangles {
        let mut polygon: Vec<u32> = Vec::with_capacity(4);
        for side in 0..3 {
            let [a, b] = [triangle[side], triangle[(side + 1) % 3]];
            let [low, high] = [a.min(b), a.max(b)];
            let [at, to] = [a, b].map(|v| heights[v as usize]);
            if at >= 0.0 {
                polygon.push(a);
            }
            if (at >= 0.0) != (to >= 0.0) {
                polygon.push(*on_edge.entry([low, high]).or_insert_with(|| {
                    let [p, q] = [low, high].map(|v| vertices[v as usize]);
                    let [s, t] = [low, high].map(|v| heights[v as usize]);
                    points.push(p + (q - p) * (s / (s - t)));
                    (points.len() - 1) as u32
                }));
            }
        }
        match polygon[..] {
            [a, b, c] => kept.push([a, b, c]),
            [a, b, c, d] => kept.extend([[a, b, c], [a, c, d]]),
            _ => {}
        }
    }
    (points, kept)
}
