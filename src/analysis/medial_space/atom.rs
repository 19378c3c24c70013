//! Atoms as points of R³ × R⁺ × S² × S²: tangents, geodesics, the group that moves them, distances.

use nalgebra::Rotation3;

use crate::analysis::medial::Atom;
use crate::mesh::Vector3;

use super::sphere::{PoleLog, angle, exp, log, log_pole};

/// A tangent of the space of atoms.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AtomTangent {
    /// Way of the centre, in the length unit of the atoms.
    pub position: Vector3,
    /// Change of ln r.
    pub log_radius: f64,
    /// Tangents of the two spokes, in ambient coordinates; radians.
    pub spokes: [Vector3; 2],
}

/// A logarithm in the space of atoms.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AtomLog {
    /// Where to, from the base.
    pub tangent: AtomTangent,
    /// Whether each spoke turns by half a turn, so that its direction was chosen.
    pub antipodal: [bool; 2],
}

/// What a pair of atoms differs by.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AtomDifference {
    /// |x₂ − x₁|, in the length unit of the atoms.
    pub distance: f64,
    /// ln(r₂ / r₁).
    pub log_radius: f64,
    /// Angles between the inner and between the outer spokes, in radians.
    pub angles_rad: [f64; 2],
}

/// How the parts of a difference make one number.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum AtomNorm {
    /// Section 4.3.2 as printed: √(|x|² + ρ ln² + angle₀² + angle₁²), which adds lengths, their roots
    /// and angles.
    Printed,
    /// √(|x|² + ρ² (ln² + angle₀² + angle₁²)): a length throughout, and the norm of a Riemannian metric
    /// on the product; the weights of m-reps (Fletcher et al. 2004).
    #[default]
    Fletcher,
}

/// An element (v, s, R₀, R₁) of the group that moves atoms (4.3.2).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AtomAction {
    /// Added to the centre.
    pub translation: Vector3,
    /// Multiplies the radius.
    pub scale: f64,
    /// Turn the two spokes.
    pub rotations: [Rotation3<f64>; 2],
}

impl AtomAction {
    /// g · m = (x + v, r s, R₀ S₀, R₁ S₁).
    pub fn act(&self, atom: &Atom) -> Atom {
        let [s0, s1] = atom.spokes;
        Atom {
            position: atom.position + self.translation,
            radius: atom.radius * self.scale,
            spokes: [self.rotations[0] * s0, self.rotations[1] * s1],
        }
    }
}

/// The atom at the end of the geodesic that leaves `base` with a tangent:
/// (x + v, r eʷ, Exp_{S₀}(v₀), Exp_{S₁}(v₁)).
pub fn atom_exp(base: &Atom, tangent: &AtomTangent) -> Atom {
    let [s0, s1] = &base.spokes;
    let [v0, v1] = &tangent.spokes;
    Atom {
        position: base.position + tangent.position,
        // Multiplied, so that a radius stays positive however long the tangent.
        radius: base.radius * tangent.log_radius.exp(),
        spokes: [exp(s0, v0), exp(s1, v1)],
    }
}

/// The tangent at `base` of the shortest geodesic to `atom`; radii must be positive.
pub fn atom_log(base: &Atom, atom: &Atom) -> AtomLog {
    let spokes = [0, 1].map(|side| log(&base.spokes[side], &atom.spokes[side]));
    AtomLog {
        tangent: AtomTangent {
            position: atom.position - base.position,
            log_radius: (atom.radius / base.radius).ln(),
            spokes: spokes.map(|log| log.tangent),
        },
        antipodal: spokes.map(|log| log.antipodal),
    }
}

/// Log at the base atom {(0,0,0), 1, (0,0,1), (0,0,1)} of 4.3.2: x, ln r and, by equation 4.2, the
/// tangents of the spokes in the plane of x and y.
pub fn atom_log_pole(atom: &Atom) -> (Vector3, f64, [PoleLog; 2]) {
    let spokes = [0, 1].map(|side| log_pole(&atom.spokes[side]));
    (atom.position.coords, atom.radius.ln(), spokes)
}

/// Atom at the share `t` of the geodesic from `a` (0) to `b` (1): its centre moves straight, its radius
/// grows at a steady rate, its spokes turn along great circles.
pub fn atom_between(a: &Atom, b: &Atom, t: f64) -> Atom {
    let AtomTangent {
        position,
        log_radius,
        spokes,
    } = atom_log(a, b).tangent;
    let part = AtomTangent {
        position: position * t,
        log_radius: log_radius * t,
        spokes: spokes.map(|spoke| spoke * t),
    };
    atom_exp(a, &part)
}

impl AtomDifference {
    /// Between two atoms.
    pub fn new(a: &Atom, b: &Atom) -> Self {
        Self {
            distance: (b.position - a.position).norm(),
            log_radius: (b.radius / a.radius).ln(),
            angles_rad: [0, 1].map(|side| angle(&a.spokes[side], &b.spokes[side])),
        }
    }

    /// Norm, with ρ the mean radius of all atoms that are compared.
    pub fn norm(&self, norm: AtomNorm, mean_radius: f64) -> f64 {
        let angles2: f64 = self.angles_rad.iter().map(|angle| angle * angle).sum();
        let (way2, log2) = (
            self.distance * self.distance,
            self.log_radius * self.log_radius,
        );
        match norm {
            // Its terms have different units; kept to compare with the text.
            AtomNorm::Printed => (way2 + mean_radius * log2 + angles2).sqrt(),
            AtomNorm::Fletcher => (way2 + mean_radius * mean_radius * (log2 + angles2)).sqrt(),
        }
    }
}

/// d(m₁, m₂) = ‖Log_{m₁}(m₂)‖ in a norm with ρ the mean radius of all atoms that are compared.
pub fn atom_distance(a: &Atom, b: &Atom, norm: AtomNorm, mean_radius: f64) -> f64 {
    AtomDifference::new(a, b).norm(norm, mean_radius)
}
