//! Triangle connectivity, checked once, and the edges and boundary loops that follow from it.

use std::sync::OnceLock;

use super::borders::{Borders, Edge};

/// Why positions and faces do not make a mesh.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum MeshError {
    /// A face names a vertex that is not there.
    #[error("face {face} refers to vertex {vertex}, but there are only {count}")]
    VertexOutOfRange {
        /// Index of the face.
        face: usize,
        /// The index it names.
        vertex: u32,
        /// How many vertices there are.
        count: usize,
    },
    /// A face names one vertex twice.
    #[error("face {face} uses vertex {vertex} twice")]
    RepeatedCorner {
        /// Index of the face.
        face: usize,
        /// The vertex that stands twice.
        vertex: u32,
    },
    /// As many positions as vertices are needed.
    #[error("{positions} positions for connectivity of {expected} vertices")]
    VertexCount {
        /// Positions given.
        positions: usize,
        /// Vertices the connectivity has.
        expected: usize,
    },
    /// A coordinate is NaN or infinite.
    #[error("vertex {vertex} has a coordinate that is not a finite number")]
    NotFinite {
        /// The first such vertex.
        vertex: usize,
    },
}

/// Triangles over `vertex_count` vertices: indices in range, no repeated corner.
#[derive(Clone, Debug)]
pub struct Faces {
    vertex_count: usize,
    triangles: Vec<[u32; 3]>,
    /// Found when first asked for.
    borders: OnceLock<Borders>,
}

impl PartialEq for Faces {
    fn eq(&self, other: &Self) -> bool {
        self.vertex_count == other.vertex_count && self.triangles == other.triangles
    }
}

impl Eq for Faces {}

impl Faces {
    /// Checks every triangle.
    ///
    /// # Errors
    /// At the first face that refers to a missing vertex or repeats a corner.
    pub fn new(vertex_count: usize, triangles: Vec<[u32; 3]>) -> Result<Self, MeshError> {
        for (face, triangle) in triangles.iter().enumerate() {
            if let Some(&vertex) = triangle.iter().find(|&&v| v as usize >= vertex_count) {
                return Err(MeshError::VertexOutOfRange {
                    face,
                    vertex,
                    count: vertex_count,
                });
            }
            if let Some(vertex) = repeated_corner(triangle) {
                return Err(MeshError::RepeatedCorner { face, vertex });
            }
        }
        Ok(Self {
            vertex_count,
            triangles,
            borders: OnceLock::new(),
        })
    }

    /// Number of vertices, used by a face or not.
    pub fn vertex_count(&self) -> usize {
        self.vertex_count
    }

    /// Three vertex indices per face, each below `vertex_count`.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// Every undirected edge once, in ascending order.
    pub fn edges(&self) -> Vec<Edge> {
        let mut edges: Vec<Edge> = self.directed_edges().map(undirected).collect();
        edges.sort_unstable();
        edges.dedup();
        edges
    }

    /// Every side of every face, in face order and winding.
    pub fn directed_edges(&self) -> impl Iterator<Item = [u32; 2]> {
        self.triangles
            .iter()
            .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]])
    }

    /// Faces on each undirected edge, in ascending order of edges: 1 on a boundary, 2 inside a
    /// manifold, more where sheets branch.
    pub fn edge_valences(&self) -> Vec<(Edge, usize)> {
        let mut sides: Vec<Edge> = self.directed_edges().map(undirected).collect();
        sides.sort_unstable();
        sides
            .chunk_by(|a, b| a == b)
            .map(|run| (run[0], run.len()))
            .collect()
    }

    /// Where the surface ends, branches, turns over or only touches.
    pub fn borders(&self) -> &Borders {
        (self.borders).get_or_init(|| Borders::of(self.vertex_count, &self.triangles))
    }

    /// Whether each vertex lies on an edge of exactly one face.
    pub fn boundary_vertices(&self) -> Vec<bool> {
        let mut on_boundary = vec![false; self.vertex_count];
        for &vertex in self.borders().rims.iter().flatten() {
            on_boundary[vertex as usize] = true;
        }
        on_boundary
    }

    /// Closed chains of boundary vertices, each in the direction of its faces' sides.
    ///
    /// Starts at the lowest vertex of each loop; loops come in ascending order of that vertex.
    /// Where a boundary vertex has several outgoing sides (a pinched boundary) the lowest unused
    /// one is followed. A chain that does not close, because winding is inconsistent, is left out.
    pub fn boundary_loops(&self) -> Vec<Vec<u32>> {
        let sides = &self.borders().rims;
        // Where the sides from each vertex begin that are not used yet.
        let mut unused = vec![usize::MAX; self.vertex_count];
        for (place, &[from, _]) in sides.iter().enumerate().rev() {
            unused[from as usize] = place;
        }
        let mut loops = Vec::new();
        for &[start, _] in sides {
            let mut chain = vec![start];
            let mut here = start;
            while let Some(&[_, next]) =
                (sides.get(unused[here as usize])).filter(|&&[from, _]| from == here)
            {
                unused[here as usize] += 1;
                if next == start {
                    loops.push(chain);
                    break;
                }
                chain.push(next);
                here = next;
            }
        }
        loops
    }

    /// These faces after another mesh's: indices are shifted past its vertices.
    pub fn joined(parts: &[&Self]) -> Self {
        let mut triangles = Vec::with_capacity(parts.iter().map(|part| part.triangles.len()).sum());
        let mut offset = 0_u32;
        for part in parts {
            triangles.extend(part.triangles.iter().map(|t| t.map(|v| v + offset)));
            offset += part.vertex_count as u32;
        }
        Self {
            vertex_count: offset as usize,
            triangles,
            borders: OnceLock::new(),
        }
    }
}

fn undirected([a, b]: [u32; 2]) -> Edge {
    if a < b { [a, b] } else { [b, a] }
}

fn repeated_corner(&[a, b, c]: &[u32; 3]) -> Option<u32> {
    if a == b || a == c {
        Some(a)
    } else if b == c {
        Some(b)
    } else {
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::phantom;

    #[test]
    fn a_face_beyond_the_last_vertex_is_refused() {
        assert_eq!(
            Faces::new(3, vec![[0, 1, 3]]),
            Err(MeshError::VertexOutOfRange {
                face: 0,
                vertex: 3,
                count: 3
            })
        );
    }

    #[test]
    fn a_face_with_a_repeated_corner_is_refused() {
        assert_eq!(
            Faces::new(3, vec![[0, 1, 2], [1, 2, 2]]),
            Err(MeshError::RepeatedCorner { face: 1, vertex: 2 })
        );
    }

    #[test]
    fn a_sphere_has_no_boundary_and_a_bowl_has_one_loop() {
        let sphere = phantom::sphere(2, 1.0);
        assert!(sphere.faces().boundary_loops().is_empty());
        assert_eq!(sphere.faces().edges().len(), 480);
        let bowl = phantom::bowl(1.0, 8, 12);
        let loops = bowl.faces().boundary_loops();
        assert_eq!(loops.len(), 1);
        assert_eq!(loops[0].len(), 12);
        assert_eq!(
            bowl.faces()
                .boundary_vertices()
                .iter()
                .filter(|&&b| b)
                .count(),
            12
        );
    }

    #[test]
    fn joined_faces_keep_to_their_own_vertices() {
        let one = Faces::new(3, vec![[0, 1, 2]]).unwrap();
        let both = Faces::joined(&[&one, &one]);
        assert_eq!(both.vertex_count(), 6);
        assert_eq!(both.triangles(), [[0, 1, 2], [3, 4, 5]]);
    }
}
