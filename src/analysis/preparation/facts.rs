//! What is known of an image before anything is made of it, and which road fits.

use super::{Preparation, Road};
use crate::image::{Image, Modality};

/// What is known of an image.
#[derive(Clone, Debug, PartialEq)]
pub struct ImageFacts {
    /// The kind of machine, where the file says it.
    pub modality: Option<Modality>,
    /// Voxels along i, j and k.
    pub size: [usize; 3],
    /// Distances between them; 1 where the file says none.
    pub spacing_mm: [f64; 3],
    /// Whether the file says the distances.
    pub spacing_known: bool,
    /// Number of volumes.
    pub instants: usize,
    /// Whether the file says their times; one volume needs none.
    pub times_known: bool,
    /// The values that occur beside 0, ascending, if they are so few and whole that they are labels.
    pub labels: Option<Vec<i32>>,
    /// Outlines that were read beside the image, or drawn.
    pub contours: usize,
}

/// A road for an image, with its settings by default.
#[derive(Clone, Debug, PartialEq)]
pub struct Proposal {
    /// The settings.
    pub preparation: Preparation,
    /// Why this road, or why none fits.
    pub reason: String,
    /// Whether a heart can be expected in the image at all; if not, the road is the least wrong one.
    pub suitable: bool,
}

/// What somebody must say before an image gives walls, or may say.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Asked {
    /// Distances between voxels.
    Spacing,
    /// Times of the volumes; walls can be made without.
    Times,
    /// Which label is which tissue.
    Labels,
    /// The tip of the ventricle.
    Apex,
    /// The middle of the mitral ring.
    Base,
    /// A point of the blood.
    Blood,
    /// Outlines of both surfaces.
    Outlines,
}
