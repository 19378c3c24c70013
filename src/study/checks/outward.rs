//! Do normals point away from what a surface encloses?

use super::enclosed_volume::enclosed_volume;
use super::words::about;
use crate::study::{Notice, SurfaceSequence};

/// Frames whose faces wind so that normals point into the enclosed space.
///
/// Why it matters: the sign of a volume, wall thickness along normals, and which side is lit all
/// follow the winding. All frames inwards is a habit of some programs; a change from frame to
/// frame means that the surface was turned inside out.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct InsideOut {
    /// Frames of negative enclosed volume.
    pub frames: Vec<usize>,
}

impl InsideOut {
    /// Looks at the sign of each frame's enclosed volume.
    pub fn of(surface: &SurfaceSequence) -> Self {
        let loops = surface.faces().boundary_loops();
        let frames = surface
            .frames()
            .iter()
            .enumerate()
            .filter(|(_, mesh)| enclosed_volume(mesh.vertices(), mesh.triangles(), &loops) < 0.0)
            .map(|(frame, _)| frame)
            .collect();
        Self { frames }
    }

    /// What the load report says, if any frame is inside out.
    pub fn notice(&self, surface: &SurfaceSequence) -> Option<Notice> {
        let (name, count) = (surface.kind().name(), surface.frames().len());
        if self.frames.is_empty() {
            return None;
        }
        if self.frames.len() == count {
            return Some(Notice::info(format!(
                "{name}: normals point inwards{}; sizes do not depend on it",
                if count > 1 { " in all frames" } else { "" }
            )));
        }
        let outside = count - self.frames.len();
        Some(Notice::warning(format!(
            "{}: turned inside out, unlike {outside} of {count} frames",
            about(name, &self.frames, count)
        )))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Point3, TriMesh, phantom};
    use crate::study::SurfaceKind;

    fn mirrored(mesh: &TriMesh) -> TriMesh {
        let points: Vec<Point3> = mesh
            .vertices()
            .iter()
            .map(|p| Point3::new(-p.x, p.y, p.z))
            .collect();
        TriMesh::new(points, mesh.faces().clone()).unwrap()
    }

    #[test]
    fn one_mirrored_frame_among_three_is_a_warning() {
        let bowl = phantom::bowl(3.0, 5, 12);
        let frames = vec![bowl.clone(), mirrored(&bowl), bowl];
        let surface = SurfaceSequence::new(SurfaceKind::Endocardium, frames).unwrap();
        assert_eq!(
            InsideOut::of(&surface).notice(&surface),
            Some(Notice::warning(
                "endocardium, frame 1: turned inside out, unlike 2 of 3 frames"
            ))
        );
    }

    #[test]
    fn normals_that_point_inwards_throughout_are_a_remark() {
        let ball = mirrored(&phantom::sphere(2, 3.0));
        let surface = SurfaceSequence::new(SurfaceKind::Cavity, vec![ball.clone(), ball]).unwrap();
        assert_eq!(
            InsideOut::of(&surface).notice(&surface).unwrap(),
            Notice::info("cavity: normals point inwards in all frames; sizes do not depend on it")
        );
    }
}
