//! Positions on checked connectivity.

use std::sync::Arc;

use super::{Faces, MeshError, Point3};

/// A triangle mesh whose coordinates are finite and whose faces refer to vertices that exist.
///
/// Connectivity is shared: all frames of a sequence hold the same [`Faces`].
/// Being closed, manifold or oriented is not promised; `study::checks` tells.
#[derive(Clone, Debug, PartialEq)]
pub struct TriMesh {
    vertices: Arc<[Point3]>,
    faces: Arc<Faces>,
}

impl TriMesh {
    /// Joins positions and connectivity.
    ///
    /// # Errors
    /// If the counts differ, or a coordinate is NaN or infinite.
    pub fn new(
        vertices: impl Into<Arc<[Point3]>>,
        faces: impl Into<Arc<Faces>>,
    ) -> Result<Self, MeshError> {
        let (vertices, faces) = (vertices.into(), faces.into());
        if vertices.len() != faces.vertex_count() {
            return Err(MeshError::VertexCount {
                positions: vertices.len(),
                expected: faces.vertex_count(),
            });
        }
        if let Some(vertex) = vertices
            .iter()
            .position(|point| !point.iter().all(|x| x.is_finite()))
        {
            return Err(MeshError::NotFinite { vertex });
        }
        Ok(Self { vertices, faces })
    }

    /// Positions, one per vertex.
    pub fn vertices(&self) -> &[Point3] {
        &self.vertices
    }

    /// Positions as a handle that can be kept without copying.
    pub fn shared_vertices(&self) -> Arc<[Point3]> {
        Arc::clone(&self.vertices)
    }

    /// The connectivity.
    pub fn faces(&self) -> &Arc<Faces> {
        &self.faces
    }

    /// Three vertex indices per face.
    pub fn triangles(&self) -> &[[u32; 3]] {
        self.faces.triangles()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_coordinate_that_is_not_a_number_is_refused() {
        let faces = Faces::new(3, vec![[0, 1, 2]]).unwrap();
        let mut points = vec![Point3::origin(); 3];
        points[1].y = f64::NAN;
        assert_eq!(
            TriMesh::new(points, faces),
            Err(MeshError::NotFinite { vertex: 1 })
        );
    }

    #[test]
    fn positions_and_connectivity_must_agree_in_number() {
        let faces = Faces::new(3, vec![[0, 1, 2]]).unwrap();
        assert_eq!(
            TriMesh::new(vec![Point3::origin(); 4], faces),
            Err(MeshError::VertexCount {
                positions: 4,
                expected: 3
            })
        );
    }
}
