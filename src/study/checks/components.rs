//! How many separate pieces is a surface made of?

use super::words::counted;
use crate::mesh::Faces;
use crate::study::{Notice, SurfaceKind, SurfaceSequence};

/// The pieces of a surface that share no vertex.
///
/// Why it matters: a subject surface is one piece. Two pieces are an inner and an outer side that
/// were stored together, or debris that adds to volumes and pulls on averages.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Components {
    /// Faces of each piece, largest first.
    pub face_counts: Vec<usize>,
}

impl Components {
    /// Counts the pieces.
    pub fn of(surface: &SurfaceSequence) -> Self {
        let faces = surface.faces();
        let piece_of = piece_of_each_vertex(faces);
        let mut face_counts = vec![0; faces.vertex_count()];
        for &[a, _, _] in faces.triangles() {
            face_counts[piece_of[a as usize] as usize] += 1;
        }
        face_counts.retain(|&count| count > 0);
        face_counts.sort_unstable_by(|a, b| b.cmp(a));
        Self { face_counts }
    }

    /// What the load report says, if there is more than one piece.
    pub fn notice(&self, surface: &SurfaceSequence) -> Option<Notice> {
        let name = surface.kind().name();
        match self.face_counts.as_slice() {
            [] | [_] => None,
            [outer, inner] if surface.kind() == SurfaceKind::Wall => Some(Notice::info(format!(
                "{name}: two separate pieces of {} and {} (inner and outer side of a wall are often stored so)",
                counted(*outer, "face", "faces"),
                counted(*inner, "face", "faces"),
            ))),
            [largest, rest @ ..] => Some(Notice::warning(format!(
                "{name}: {} separate pieces; the largest has {}, the others {} together",
                rest.len() + 1,
                counted(*largest, "face", "faces"),
                rest.iter().sum::<usize>(),
            ))),
        }
    }
}

/// For each vertex the lowest vertex of its piece; a vertex of no face is its own piece.
pub(super) fn piece_of_each_vertex(faces: &Faces) -> Vec<u32> {
    let mut parent: Vec<u32> = (0..faces.vertex_count() as u32).collect();
    for &[a, b, c] in faces.triangles() {
        join(&mut parent, a, b);
        join(&mut parent, b, c);
    }
    (0..parent.len() as u32)
        .map(|vertex| root(&mut parent, vertex))
        .collect()
}

fn join(parent: &mut [u32], a: u32, b: u32) {
    let (a, b) = (root(parent, a), root(parent, b));
    parent[a.max(b) as usize] = a.min(b);
}

fn root(parent: &mut [u32], mut vertex: u32) -> u32 {
    while parent[vertex as usize] != vertex {
        let above = parent[parent[vertex as usize] as usize];
        parent[vertex as usize] = above;
        vertex = above;
    }
    vertex
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{TriMesh, phantom};

    fn two_balls() -> TriMesh {
        let (small, large) = (phantom::sphere(1, 1.0), phantom::sphere(2, 2.0));
        let faces = Faces::joined(&[small.faces(), large.faces()]);
        let points = [small.vertices(), large.vertices()].concat();
        TriMesh::new(points, faces).unwrap()
    }

    #[test]
    fn two_shells_are_a_remark_for_a_wall_and_a_warning_for_a_cavity() {
        let wall = SurfaceSequence::new(SurfaceKind::Wall, vec![two_balls()]).unwrap();
        let found = Components::of(&wall);
        assert_eq!(found.face_counts, [320, 80]);
        assert_eq!(
            found.notice(&wall),
            Some(Notice::info(
                "wall: two separate pieces of 320 faces and 80 faces (inner and outer side of a wall are often stored so)"
            ))
        );
        let cavity = SurfaceSequence::new(SurfaceKind::Cavity, vec![two_balls()]).unwrap();
        assert_eq!(
            found.notice(&cavity).unwrap().text,
            "cavity: 2 separate pieces; the largest has 320 faces, the others 80 together"
        );
    }

    #[test]
    fn one_piece_is_nothing_to_tell() {
        let surface =
            SurfaceSequence::new(SurfaceKind::Wall, vec![phantom::torus(3.0, 1.0, 12, 8)]).unwrap();
        assert_eq!(Components::of(&surface).notice(&surface), None);
    }
}
