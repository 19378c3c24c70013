//! What the ends of a path must be.

use crate::mesh::{Faces, Point3, area};

use super::GeodesicError;

/// x, y, z of every point.
pub(super) fn flat(points: &[Point3]) -> Vec<f64> {
    points.iter().flat_map(|p| [p.x, p.y, p.z]).collect()
}

/// Poses nearer than this, relative to their largest coordinate, differ by round-off of an alignment: a direction from one
/// to the other, or a path between them, would be of noise.
const SAME: f64 = 1e-12;

/// Whether two poses are one, but for round-off.
pub fn same_pose(a: &[Point3], b: &[Point3]) -> bool {
    let reach = a.iter().fold(0.0_f64, |m, p| m.max(p.coords.amax()));
    a.len() == b.len() && (a.iter().zip(b)).all(|(a, b)| (b - a).amax() <= SAME * reach)
}

/// Counts, coordinates that can be squared twice, and some area.
pub(super) fn check_ends(
    faces: &Faces,
    start: &[Point3],
    end: &[Point3],
) -> Result<(), GeodesicError> {
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
        let total = area(points, faces.triangles());
        if total.is_nan() || total <= 0.0 {
            return Err(GeodesicError::Degenerate {
                end: name,
                faces: faces.triangles().len(),
                vertices: expected,
            });
        }
    }
    Ok(())
}
