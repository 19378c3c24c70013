//! Do different vertices lie at the same place?

use std::collections::HashSet;

use super::frame_counts::FrameCounts;
use super::words::{about, counted};
use crate::mesh::TriMesh;
use crate::study::{Notice, Severity, SurfaceSequence};

/// Vertices at exactly the position of another vertex of the same frame.
///
/// Why it matters: where rims coincide the surface was cut along a seam (STL stores every triangle
/// apart), and neighbours do not know each other across the cut. Elsewhere it is folded or collapsed.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct DuplicateVertices {
    /// Frames that have any.
    pub frames: Vec<usize>,
    /// The largest count among them.
    pub most: usize,
    /// Whether all of them lie on rims: a seam.
    pub only_on_rims: bool,
}

impl DuplicateVertices {
    /// Counts at each frame.
    pub fn of(surface: &SurfaceSequence) -> Self {
        let on_rim = surface.faces().boundary_vertices();
        let found: Vec<Vec<usize>> = surface.frames().iter().map(coinciding).collect();
        let FrameCounts { frames, most } = FrameCounts::of(found.iter().map(Vec::len));
        Self {
            frames,
            most,
            only_on_rims: found.iter().flatten().all(|&vertex| on_rim[vertex]),
        }
    }

    /// What the load report says, if there are any.
    pub fn notice(&self, surface: &SurfaceSequence) -> Option<Notice> {
        if self.frames.is_empty() {
            return None;
        }
        let up_to = if self.frames.len() > 1 { "up to " } else { "" };
        let verb = if self.most == 1 { "lies" } else { "lie" };
        let (severity, place) = if self.only_on_rims {
            (
                Severity::Info,
                " along a rim: the surface is cut open along a seam",
            )
        } else {
            (Severity::Warning, "")
        };
        let text = format!(
            "{}: {up_to}{} {verb} exactly on another{place}",
            about(surface.kind().name(), &self.frames, surface.frames().len()),
            counted(self.most, "vertex", "vertices")
        );
        Some(Notice { severity, text })
    }
}

/// Vertices at the place of a vertex of lower number.
fn coinciding(mesh: &TriMesh) -> Vec<usize> {
    let mut seen = HashSet::with_capacity(mesh.vertices().len());
    mesh.vertices()
        .iter()
        .enumerate()
        // Adding zero makes −0 and 0 one place.
        .filter(|(_, p)| !seen.insert([p.x + 0.0, p.y + 0.0, p.z + 0.0].map(f64::to_bits)))
        .map(|(vertex, _)| vertex)
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Faces, Point3, phantom};
    use crate::study::SurfaceKind;

    #[test]
    fn a_triangle_soup_repeats_its_shared_corners() {
        let ball = phantom::sphere(0, 1.0);
        let points: Vec<Point3> = ball
            .triangles()
            .iter()
            .flatten()
            .map(|&vertex| ball.vertices()[vertex as usize])
            .collect();
        let triangles = (0..20_u32).map(|f| [3 * f, 3 * f + 1, 3 * f + 2]).collect();
        let mesh = TriMesh::new(points, Faces::new(60, triangles).unwrap()).unwrap();
        let surface = SurfaceSequence::new(SurfaceKind::Wall, vec![mesh]).unwrap();
        assert_eq!(
            DuplicateVertices::of(&surface).notice(&surface),
            Some(Notice::info(
                "wall: 48 vertices lie exactly on another along a rim: the surface is cut open along a seam"
            ))
        );
    }

    #[test]
    fn a_collapsed_neighbour_is_a_warning() {
        let ball = phantom::sphere(1, 1.0);
        let mut points = ball.vertices().to_vec();
        points[7] = points[3];
        let mesh = TriMesh::new(points, ball.faces().clone()).unwrap();
        let surface = SurfaceSequence::new(SurfaceKind::Cavity, vec![mesh]).unwrap();
        assert_eq!(
            DuplicateVertices::of(&surface).notice(&surface),
            Some(Notice::warning("cavity: 1 vertex lies exactly on another"))
        );
    }

    #[test]
    fn zero_and_minus_zero_are_one_place() {
        let points = vec![
            Point3::new(0.0, 0.0, 0.0),
            Point3::new(-0.0, 0.0, 0.0),
            Point3::new(1.0, 0.0, 0.0),
        ];
        let mesh = TriMesh::new(points, Faces::new(3, vec![[0, 1, 2]]).unwrap()).unwrap();
        assert_eq!(coinciding(&mesh), [1]);
    }
}
