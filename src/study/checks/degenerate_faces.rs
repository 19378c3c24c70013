//! Are there triangles of zero area?

use super::frame_counts::FrameCounts;
use super::words::{about, counted};
use crate::mesh::{Point3, TriMesh};
use crate::study::{Notice, SurfaceSequence};

/// A triangle counts as having no area where its height is below this share of its longest side:
/// a thousand times the rounding of `f64`, far below any triangle that a mesher means.
const FLAT: f64 = 1e-12;

/// Triangles whose corners lie on one line, per frame.
///
/// Why it matters: such a triangle has no normal and no angles; metrics that weigh by angles or
/// divide by area meet a zero there.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct DegenerateFaces {
    /// Frames that have any.
    pub frames: Vec<usize>,
    /// The largest count among them.
    pub most: usize,
}

impl DegenerateFaces {
    /// Counts at each frame.
    pub fn of(surface: &SurfaceSequence) -> Self {
        let FrameCounts { frames, most } =
            FrameCounts::of(surface.frames().iter().map(flat_triangles));
        Self { frames, most }
    }

    /// What the load report says, if there are any.
    pub fn notice(&self, surface: &SurfaceSequence) -> Option<Notice> {
        if self.frames.is_empty() {
            return None;
        }
        let up_to = if self.frames.len() > 1 { "up to " } else { "" };
        Some(Notice::warning(format!(
            "{}: {up_to}{}",
            about(surface.kind().name(), &self.frames, surface.frames().len()),
            counted(self.most, "degenerate triangle", "degenerate triangles")
        )))
    }
}

fn flat_triangles(mesh: &TriMesh) -> usize {
    mesh.triangles()
        .iter()
        .filter(|triangle| is_flat(triangle.map(|vertex| mesh.vertices()[vertex as usize])))
        .count()
}

/// Height over longest side = |(b − a) × (c − a)| / longest².
fn is_flat([a, b, c]: [Point3; 3]) -> bool {
    let doubled_area = (b - a).cross(&(c - a)).norm();
    let longest_squared = (b - a)
        .norm_squared()
        .max((c - b).norm_squared())
        .max((a - c).norm_squared());
    doubled_area <= FLAT * longest_squared
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::phantom;
    use crate::study::SurfaceKind;

    #[test]
    fn a_vertex_moved_onto_its_neighbour_flattens_two_faces_of_one_frame() {
        let ball = phantom::sphere(1, 1.0);
        let mut points = ball.vertices().to_vec();
        let [a, b, _] = ball.triangles()[0];
        points[a as usize] = points[b as usize];
        let dented = TriMesh::new(points, ball.faces().clone()).unwrap();
        let surface = SurfaceSequence::new(SurfaceKind::Cavity, vec![ball, dented]).unwrap();
        assert_eq!(
            DegenerateFaces::of(&surface).notice(&surface),
            Some(Notice::warning("cavity, frame 1: 2 degenerate triangles"))
        );
    }

    #[test]
    fn thin_triangles_far_from_the_origin_still_have_area() {
        let corner = |x: f64, y: f64| Point3::new(1e4 + x, 1e4 + y, 1e4);
        assert!(!is_flat([
            corner(0.0, 0.0),
            corner(1.0, 0.0),
            corner(0.5, 1e-6)
        ]));
        assert!(is_flat([
            corner(0.0, 0.0),
            corner(1.0, 0.0),
            corner(0.5, 0.0)
        ]));
    }
}
