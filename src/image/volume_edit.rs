//! What a person takes away from an image, or keeps of it, before a surface is made.

use crate::mesh::{Point3, Vector3};

/// One edit of a volume; the same at every instant. Positions are in the world (LPS, millimetres).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum VolumeEdit {
    /// Nothing is kept on the side of a plane that its normal points to.
    CutPlane {
        /// A point of the plane.
        point: Point3,
        /// Its normal; any length but 0.
        normal: Vector3,
    },
    /// Nothing is kept within a sphere.
    SphereEraser {
        /// The middle of the sphere.
        centre: Point3,
        /// Its radius in millimetres.
        radius_mm: f64,
    },
    /// Of what lies above the threshold, only the connected component of the most voxels is kept.
    LargestComponent,
    /// Of what lies above the threshold, only the connected component at this position is kept.
    ComponentAt(Point3),
    /// What lies below the threshold and is enclosed on all sides counts as inside.
    FillHoles,
}
