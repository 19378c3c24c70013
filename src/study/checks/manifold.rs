//! Does a surface branch, or touch itself at single vertices?

use super::words::counted;
use crate::study::{Notice, SurfaceSequence};

/// Edges of more than two faces, and vertices where two sheets touch.
///
/// Why it matters: areas, curvatures and the inside of a surface are defined only where it is a
/// sheet; methods that walk from face to face stop at such places.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct NonManifold {
    /// Edges on three or more faces.
    pub edges: usize,
    /// Vertices whose faces form more than one fan, on no such edge.
    pub vertices: usize,
}

impl NonManifold {
    /// Counts both.
    pub fn of(surface: &SurfaceSequence) -> Self {
        let borders = surface.faces().borders();
        Self {
            edges: borders.branching.len(),
            vertices: borders.pinched,
        }
    }

    /// What the load report says, if there is any.
    pub fn notice(&self, surface: &SurfaceSequence) -> Option<Notice> {
        let mut parts = Vec::new();
        if self.edges > 0 {
            let verb = if self.edges == 1 { "joins" } else { "join" };
            parts.push(format!(
                "{} {verb} more than two faces",
                counted(self.edges, "edge", "edges")
            ));
        }
        if self.vertices > 0 {
            parts.push(format!(
                "sheets touch at {}",
                counted(self.vertices, "vertex", "vertices")
            ));
        }
        if parts.is_empty() {
            return None;
        }
        Some(Notice::warning(format!(
            "{}: not a manifold: {}",
            surface.kind().name(),
            parts.join(", ")
        )))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Faces, Point3, TriMesh, phantom};
    use crate::study::SurfaceKind;

    fn surface(count: usize, triangles: Vec<[u32; 3]>) -> SurfaceSequence {
        let points: Vec<Point3> = (0..count)
            .map(|i| Point3::new(i as f64, (i * i) as f64, 1.0))
            .collect();
        let mesh = TriMesh::new(points, Faces::new(count, triangles).unwrap()).unwrap();
        SurfaceSequence::new(SurfaceKind::Wall, vec![mesh]).unwrap()
    }

    #[test]
    fn three_pages_on_one_edge_branch() {
        let book = surface(5, vec![[0, 1, 2], [0, 1, 3], [0, 1, 4]]);
        assert_eq!(
            NonManifold::of(&book).notice(&book),
            Some(Notice::warning(
                "wall: not a manifold: 1 edge joins more than two faces"
            ))
        );
    }

    #[test]
    fn two_triangles_that_share_a_tip_touch_at_one_vertex() {
        let bow_tie = surface(5, vec![[0, 1, 2], [0, 3, 4]]);
        assert_eq!(
            NonManifold::of(&bow_tie),
            NonManifold {
                edges: 0,
                vertices: 1
            }
        );
    }

    /// A time that grew with the square of these faces would be minutes.
    #[test]
    fn a_vertex_of_half_a_million_faces_is_one_fan() {
        const FACES: u32 = 500_000;
        let around = (1..=FACES).map(|rim| [0, rim, rim % FACES + 1]);
        let mut triangles: Vec<[u32; 3]> = around.step_by(2).collect();
        triangles.extend(
            (1..=FACES)
                .skip(1)
                .step_by(2)
                .map(|rim| [0, rim, rim % FACES + 1]),
        );
        let wheel = surface(FACES as usize + 1, triangles);
        assert_eq!(NonManifold::of(&wheel), NonManifold::default());
    }

    #[test]
    fn closed_and_open_phantoms_are_manifolds() {
        for mesh in [phantom::sphere(2, 1.0), phantom::bowl(1.0, 5, 9)] {
            let surface = SurfaceSequence::new(SurfaceKind::Wall, vec![mesh]).unwrap();
            assert_eq!(NonManifold::of(&surface), NonManifold::default());
        }
    }
}
