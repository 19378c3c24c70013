//! Atoms of the wall as plain values.

use std::sync::Arc;

use crate::mesh::{Faces, Point3, Vector3};
use crate::study::SurfaceKind;

/// A sphere in the wall that touches its inner and its outer side: (x, r, S₀, S₁) ∈ R³ × R⁺ × S² × S².
///
/// Source: V. Taimouri, *Shape Analysis in Shape Space*, 4.2, where S is read as a unit vector, so that the sphere touches
/// at yᵢ = x + r Sᵢ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Atom {
    /// Centre x, in coordinates.
    pub position: Point3,
    /// Radius r, in coordinates: half the thickness where the sides are parallel.
    pub radius: f64,
    /// Unit vectors S₀ to the inner and S₁ to the outer side.
    pub spokes: [Vector3; 2],
}

impl Atom {
    /// Where the sphere touches the inner and the outer side: x + r Sᵢ.
    pub fn boundary_points(&self) -> [Point3; 2] {
        self.spokes.map(|spoke| self.position + self.radius * spoke)
    }

    /// PT = r / r₀: thickness relative to that of the same atom at a reference pose (4.4).
    ///
    /// The plain quotient: where a sphere is missing, which no atom that takes part has, it is 0, infinite or not a number,
    /// and so cannot be taken for a wall that keeps its thickness.
    pub fn thickness_ratio(&self, reference: &Self) -> f64 {
        self.radius / reference.radius
    }
}

/// Third spoke of an atom at which the medial surface ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EndSpoke {
    /// Unit vector b halfway between the spokes; it points out of the sheet, to the rim.
    pub direction: Vector3,
    /// Length of the spoke in radii, η ∈ [1, 1/cos θ], where 2θ is the angle between the spokes.
    pub eta: f64,
}

/// Middle of the wall at one instant, one atom per vertex of the template.
#[derive(Clone, Debug, PartialEq)]
pub struct MedialSurface {
    /// The atoms, in the order of the template's vertices.
    pub atoms: Vec<Atom>,
    /// Unit normals of the medial surface, from the inner to the outer side.
    pub normals: Vec<Vector3>,
    /// The third spoke where the sheet ends, and so where r is no thickness.
    pub end: Vec<Option<EndSpoke>>,
}

impl MedialSurface {
    /// Positions of the atoms.
    pub fn positions(&self) -> Vec<Point3> {
        self.atoms.iter().map(|atom| atom.position).collect()
    }
}

/// Middle of the wall over the beat.
#[derive(Clone, Debug, PartialEq)]
pub struct MedialBeat {
    /// The surface whose vertices the template's are.
    pub surface: SurfaceKind,
    /// Number of each atom's vertex in that surface.
    pub vertices: Vec<u32>,
    /// The medial mesh, over atoms: the template's connectivity.
    pub faces: Arc<Faces>,
    /// One per frame.
    pub frames: Vec<MedialSurface>,
    /// Whether an atom is an end atom in no frame: these take part in the analysis.
    pub regular: Vec<bool>,
}
