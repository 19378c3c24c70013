//! Do neighbouring faces wind the same way?

use super::words::counted;
use crate::study::{Notice, SurfaceSequence};

/// Neighbouring faces that wind against each other.
///
/// Why it matters: a volume adds up what faces sweep; where winding changes, parts are subtracted
/// instead, and shading shows dark patches.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct InconsistentWinding {
    /// Edges between two faces that run along them in the same direction.
    pub edges: usize,
}

impl InconsistentWinding {
    /// Counts such edges; edges of three and more faces are left to the manifold check.
    pub fn of(surface: &SurfaceSequence) -> Self {
        Self {
            edges: surface.faces().borders().turned,
        }
    }

    /// What the load report says, if there is any.
    pub fn notice(&self, surface: &SurfaceSequence) -> Option<Notice> {
        (self.edges > 0).then(|| {
            Notice::warning(format!(
                "{}: neighbouring faces wind against each other along {}; its volume is unreliable",
                surface.kind().name(),
                counted(self.edges, "edge", "edges")
            ))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Faces, TriMesh, phantom};
    use crate::study::SurfaceKind;

    #[test]
    fn one_turned_face_disagrees_along_its_three_edges() {
        let ball = phantom::sphere(1, 1.0);
        let mut triangles = ball.triangles().to_vec();
        triangles[5].swap(1, 2);
        let faces = Faces::new(ball.vertices().len(), triangles).unwrap();
        let mesh = TriMesh::new(ball.shared_vertices(), faces).unwrap();
        let surface = SurfaceSequence::new(SurfaceKind::Cavity, vec![mesh]).unwrap();
        let found = InconsistentWinding::of(&surface);
        assert_eq!(found.edges, 3);
        assert_eq!(
            found.notice(&surface).unwrap().text,
            "cavity: neighbouring faces wind against each other along 3 edges; its volume is unreliable"
        );
    }

    #[test]
    fn phantoms_wind_one_way() {
        let surface =
            SurfaceSequence::new(SurfaceKind::Wall, vec![phantom::torus(3.0, 1.0, 9, 7)]).unwrap();
        assert_eq!(InconsistentWinding::of(&surface).edges, 0);
    }
}
