//! One surface at all frames, whose faces need not correspond.

use super::target_surface::TargetSurface;
use crate::mesh::TriMesh;
use crate::study::SurfaceKind;

/// One surface of a subject at all frames; no two of them need have the same faces.
#[derive(Clone, Debug, PartialEq)]
pub struct SurfaceFrames {
    /// Which surface it is.
    pub kind: SurfaceKind,
    /// Its frames, in order.
    pub frames: Vec<TriMesh>,
}

/// One surface of what a template is laid onto, at all frames.
#[derive(Clone, Debug)]
pub(super) struct TargetFrames {
    /// The surface of the template.
    pub kind: SurfaceKind,
    pub frames: Vec<TargetSurface>,
}
