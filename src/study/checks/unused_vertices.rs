//! Are there vertices that no face uses?

use super::words::counted;
use crate::study::{Notice, SurfaceSequence};

/// Vertices of no face.
///
/// Why it matters: they are not seen, but a mean position, a size or an alignment over all
/// vertices counts them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct UnusedVertices {
    /// How many.
    pub count: usize,
}

impl UnusedVertices {
    /// Counts them.
    pub fn of(surface: &SurfaceSequence) -> Self {
        let faces = surface.faces();
        let mut used = vec![false; faces.vertex_count()];
        for &vertex in faces.triangles().iter().flatten() {
            used[vertex as usize] = true;
        }
        Self {
            count: used.iter().filter(|&&used| !used).count(),
        }
    }

    /// What the load report says, if there are any.
    pub fn notice(&self, surface: &SurfaceSequence) -> Option<Notice> {
        (self.count > 0).then(|| {
            Notice::warning(format!(
                "{}: {} on no face",
                surface.kind().name(),
                counted(self.count, "vertex is", "vertices are")
            ))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Faces, Point3, TriMesh};
    use crate::study::SurfaceKind;

    #[test]
    fn vertices_of_no_face_are_counted() {
        let points: Vec<Point3> = (0..5)
            .map(|i| Point3::new(f64::from(i * i), f64::from(i), 0.0))
            .collect();
        let mesh = TriMesh::new(points, Faces::new(5, vec![[0, 1, 3]]).unwrap()).unwrap();
        let surface = SurfaceSequence::new(SurfaceKind::Wall, vec![mesh]).unwrap();
        assert_eq!(
            UnusedVertices::of(&surface).notice(&surface),
            Some(Notice::warning("wall: 2 vertices are on no face"))
        );
    }
}
