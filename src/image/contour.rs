//! Outlines that are drawn in the slices of an image.

use crate::mesh::Point3;

/// What an outline goes around.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum ContourPart {
    /// The cavity of the left ventricle, with papillary muscles.
    Endocardium,
    /// The left ventricle with its wall.
    Epicardium,
    /// The cavity of the right ventricle.
    RightCavity,
}

/// A closed outline in one plane, at one instant.
#[derive(Clone, Debug, PartialEq)]
pub struct Contour {
    /// The number of the volume in the image, from 0.
    pub instant: usize,
    /// What it goes around.
    pub part: ContourPart,
    /// At least three corners in the world (LPS, millimetres), in order; the last is joined to the first.
    pub points: Vec<Point3>,
}
