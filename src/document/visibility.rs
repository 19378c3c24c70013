//! Which parts of a subject are drawn, and how.

use crate::render::Shading;

/// Which parts of a subject are drawn, and how.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Visibility {
    /// The inner surface.
    pub endocardium: bool,
    /// The outer surface or the whole wall.
    pub epicardium: bool,
    /// Edges of faces.
    pub wireframe: bool,
    /// Vertices as discs.
    pub vertices: bool,
    /// Atoms of the medial surface, coloured by PT.
    pub atoms: bool,
    /// Their spokes to the wall.
    pub spokes: bool,
    /// Borders of patches.
    pub patches: bool,
    /// ANV and MP.
    pub direction: bool,
    /// Smooth or flat.
    pub shading: Shading,
}

impl Default for Visibility {
    fn default() -> Self {
        Self {
            endocardium: true,
            epicardium: true,
            wireframe: false,
            vertices: false,
            atoms: false,
            spokes: false,
            patches: true,
            direction: false,
            shading: Shading::Smooth,
        }
    }
}
