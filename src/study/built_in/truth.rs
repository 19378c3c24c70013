//! What is true of a built-in subject by construction; no analysis may see it.

use crate::study::SurfaceKind;

/// What is wrong with a built-in subject.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Abnormality {
    /// Nothing.
    None,
    /// One patch of the wall, up to a twelfth of it, neither moves nor thickens.
    SmallPatch,
    /// One patch, about a tenth to a sixth of the wall.
    MediumPatch,
    /// One patch, about a quarter of the wall.
    LargePatch,
    /// One patch, more than a third of the wall.
    VeryLargePatch,
    /// Two patches.
    TwoPatches,
    /// A wide cavity that empties little.
    Dilated,
    /// A thick wall around a small cavity.
    Hypertrophic,
}

/// Illness of the vertices of one surface.
#[derive(Clone, Debug, PartialEq)]
pub struct SurfaceTruth {
    /// Which surface of the subject.
    pub kind: SurfaceKind,
    /// Patch of each vertex, counted from 1; 0 where the wall is well.
    pub patch: Vec<u8>,
    /// How ill each vertex is: 0 moves as it should, 1 does not move.
    pub severity: Vec<f64>,
}

/// What is true of one built-in subject.
#[derive(Clone, Debug, PartialEq)]
pub struct GroundTruth {
    /// What is wrong with it.
    pub abnormality: Abnormality,
    /// How many patches it has.
    pub patches: usize,
    /// AHA segments (1–17) of which at least a third lies in a patch, ascending.
    pub segments: Vec<u8>,
    /// Illness per vertex, one entry for each surface in the order of the sequence.
    pub surfaces: Vec<SurfaceTruth>,
    /// Volume of the cavity at end-diastole by the model's equations.
    pub end_diastolic_volume_ml: f64,
    /// Ejection fraction by the model's equations.
    pub ejection_fraction: f64,
}
