//! Points of a heart that a person marks in an image.

use crate::mesh::Point3;

/// Points of the left ventricle in the world of the image (LPS, millimetres), as far as they are marked.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MarkedPoints {
    /// The tip of the ventricle.
    pub apex: Option<Point3>,
    /// The middle of the mitral ring.
    pub base: Option<Point3>,
    /// A point of the septum, or of the right ventricle beyond it; only its direction from the long axis counts.
    pub septum: Option<Point3>,
    /// A point of the blood in the left ventricle.
    pub blood: Option<Point3>,
}
