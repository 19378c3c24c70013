//! Faces, which of them are looked for, and what is found.

use crate::mesh::{Point3, Vector3};

/// Faces of a pose, in the order of the tree around them.
#[derive(Clone, Copy, Debug)]
pub(in crate::analysis::medial) struct FacesOfPose<'a> {
    pub points: &'a [Point3],
    pub triangles: &'a [[u32; 3]],
    /// Unit normals; zero for faces of zero area, which are never found.
    pub normals: &'a [Vector3],
}

impl FacesOfPose<'_> {
    pub fn corners(&self, face: u32) -> [Point3; 3] {
        self.triangles[face as usize].map(|vertex| self.points[vertex as usize])
    }
}

/// Which faces a search may find: those, of all or with numbers in a range, whose normals are at least an angle away from a direction.
#[derive(Clone, Copy, Debug)]
pub(in crate::analysis::medial) struct Facing {
    pub direction: Vector3,
    /// Cosine of that angle; above 1 all faces are found.
    pub cos_min_angle: f64,
    pub faces: Option<[u32; 2]>,
}

impl Facing {
    /// All faces, or all with numbers in a range.
    pub fn any(faces: Option<[u32; 2]>) -> Self {
        Self {
            direction: Vector3::zeros(),
            cos_min_angle: 2.0,
            faces,
        }
    }
}

/// Nearest point of the faces.
#[derive(Clone, Copy, Debug)]
pub(in crate::analysis::medial) struct Nearest {
    pub point: Point3,
    pub face: u32,
    pub squared: f64,
    /// Weights of the corners.
    pub weights: [f64; 3],
}
