//! Was every frame moved onto the origin by itself?

use crate::mesh::{Point3, Vector3};
use crate::study::{MeshSequence, Notice};

/// Mean positions count as the origin within this share of the subject's extent: files with three
/// digits after the point round a mean of 1,000 vertices to about a millionth of it, and a subject
/// on a scanner's table lies nowhere near.
const AT_ORIGIN: f64 = 1e-3;

/// All frames of a moving subject have their mean vertex at the origin.
///
/// Why it matters: frames that were aligned one by one have lost the motion of the subject as a
/// whole, so a base that seems to are akinetic says nothing.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct CentredFrames {
    /// Whether it is so; never for a single frame.
    pub centred: bool,
}

impl CentredFrames {
    /// Looks at the mean vertex of each frame.
    pub fn of(sequence: &MeshSequence) -> Self {
        let frames = sequence.frame_count();
        let centred = frames > 1
            && (0..frames).all(|frame| {
                sequence
                    .pose(frame)
                    .is_some_and(|pose| mean_is_at_origin(&pose))
            });
        Self { centred }
    }

    /// What the load report says, if it is so.
    pub fn notice(&self) -> Option<Notice> {
        self.centred.then(|| {
            Notice::info(
                "each frame is centred on the origin separately: these files do not contain motion of the heart as a whole",
            )
        })
    }
}

fn mean_is_at_origin(points: &[Point3]) -> bool {
    let sum: Vector3 = points.iter().map(|p| p.coords).sum();
    let spread: f64 = points.iter().map(|p| p.coords.norm_squared()).sum();
    let count = points.len().max(1) as f64;
    (sum / count).norm() <= AT_ORIGIN * (spread / count).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{TriMesh, phantom};
    use crate::study::{SurfaceKind, SurfaceSequence};

    fn beat(shift: f64) -> MeshSequence {
        let rest = phantom::sphere(2, 30.0);
        let points: Vec<Point3> = phantom::sphere(2, 22.0)
            .vertices()
            .iter()
            .map(|p| Point3::new(p.x + shift, p.y, p.z))
            .collect();
        let second = TriMesh::new(points, rest.faces().clone()).unwrap();
        let surface = SurfaceSequence::new(SurfaceKind::Cavity, vec![rest, second]).unwrap();
        MeshSequence::new(vec![surface]).unwrap()
    }

    #[test]
    fn frames_centred_one_by_one_are_told() {
        assert!(CentredFrames::of(&beat(0.0)).notice().is_some());
        assert_eq!(CentredFrames::of(&beat(1.0)).notice(), None);
    }
}
