//! Where a surface is open: boundary loops that enclose an area.

use crate::mesh::{Point3, Vector3};
use crate::study::SurfaceSequence;

/// A boundary loop at frame 0.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Opening {
    /// Its vertices in order.
    pub rim: Vec<u32>,
    /// Mean of its vertices.
    pub centre: Point3,
    /// Length of the vector area ½ Σ pᵢ × pᵢ₊₁, in square coordinates.
    pub area: f64,
}

/// A loop that encloses less than this share of its squared perimeter is a slit where a surface is
/// cut along a seam and not sewn together, not an opening. A circle encloses 1 / 4π = 0.08.
const SLIT: f64 = 1e-3;

/// The openings of a surface, in the order of its boundary loops; slits are left out.
pub(crate) fn openings(surface: &SurfaceSequence) -> Vec<Opening> {
    let mesh = &surface.frames()[0];
    let loops = mesh.faces().boundary_loops().into_iter();
    loops
        .filter_map(|rim| {
            let points: Vec<Point3> = rim.iter().map(|&v| mesh.vertices()[v as usize]).collect();
            let sum: Vector3 = points.iter().map(|point| point.coords).sum();
            let centre = Point3::from(sum / points.len().max(1) as f64);
            let (mut doubled, mut perimeter) = (Vector3::zeros(), 0.0);
            for (i, a) in points.iter().enumerate() {
                let b = points[(i + 1) % points.len()];
                doubled += (a - centre).cross(&(b - centre));
                perimeter += (b - a).norm();
            }
            let area = 0.5 * doubled.norm();
            (area > SLIT * perimeter * perimeter).then_some(Opening { rim, centre, area })
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Faces, TriMesh, phantom};
    use crate::study::SurfaceKind;

    #[test]
    fn a_bowl_is_open_and_a_seam_that_is_not_sewn_is_not() {
        let bowl = phantom::bowl(30.0, 4, 24);
        let surface = |mesh| SurfaceSequence::new(SurfaceKind::Endocardium, vec![mesh]).unwrap();
        let found = openings(&surface(bowl));
        assert_eq!(found.len(), 1);
        assert_eq!(found[0].rim.len(), 24);
        // Two faces on each side of a slit whose vertices lie on each other.
        let points = vec![
            Point3::new(0.0, 0.0, 0.0),
            Point3::new(1.0, 0.0, 0.0),
            Point3::new(0.0, 0.0, 0.0),
            Point3::new(1.0, 0.0, 0.0),
        ];
        let faces = Faces::new(4, vec![[0, 1, 3], [0, 3, 2]]).unwrap();
        assert!(openings(&surface(TriMesh::new(points, faces).unwrap())).is_empty());
    }
}
