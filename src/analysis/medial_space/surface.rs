//! Medial surfaces as points of a product of spaces of atoms: distance, ways between, means.

use crate::analysis::medial::{Atom, EndSpoke, MedialSurface};
use crate::mesh::{Point3, Vector3};

use super::atom::{AtomDifference, AtomNorm, atom_between};
use super::mean::frechet_mean;
use super::sphere::between;

/// How distances of atoms make one of surfaces.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum MedialDistance {
    /// Equation 4.3 as printed: the sum over atoms of their printed distances; grows with the number
    /// of atoms.
    PrintedSum,
    /// √Σᵢ d²(mᵢ, m′ᵢ) of Fletcher's distances: the length of the geodesic of the product.
    #[default]
    Product,
}

/// Why surfaces cannot be compared or averaged.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum MedialSpaceError {
    /// They do not correspond.
    #[error("{first} atoms cannot be compared with {other}")]
    Count {
        /// Atoms of the first.
        first: usize,
        /// Atoms of the other.
        other: usize,
    },
    /// There is nothing to average.
    #[error("no medial surface to average")]
    NoSurface,
    /// Radii are not positive, or something is not a finite number.
    #[error("atom {atom} has no positive radius or is not finite")]
    BadAtom {
        /// The first such.
        atom: usize,
    },
    /// Spokes of one atom cancel over the surfaces.
    #[error("spokes of atom {atom} point in directions that cancel")]
    NoMean {
        /// The first such.
        atom: usize,
    },
}

/// Mean radius over all atoms of both surfaces, ρ of 4.3.2; 0 without atoms.
pub fn mean_radius(a: &[Atom], b: &[Atom]) -> f64 {
    let sum: f64 = a.iter().chain(b).map(|atom| atom.radius).sum();
    sum / (a.len() + b.len()).max(1) as f64
}

/// Distance of two medial surfaces whose atoms correspond.
///
/// # Errors
/// If counts differ, or an atom has no positive radius.
pub fn medial_distance(
    a: &[Atom],
    b: &[Atom],
    kind: MedialDistance,
) -> Result<f64, MedialSpaceError> {
    check(a)?;
    check(b)?;
    same_count(a, b)?;
    // Of both surfaces, or the distance would not be symmetric.
    let rho = mean_radius(a, b);
    // Printed or Fletcher: the sum and the root belong to different norms of atoms.
    let norms =
        |norm| (a.iter().zip(b)).map(move |(a, b)| AtomDifference::new(a, b).norm(norm, rho));
    Ok(match kind {
        MedialDistance::PrintedSum => norms(AtomNorm::Printed).sum(),
        MedialDistance::Product => norms(AtomNorm::Fletcher).map(|d| d * d).sum::<f64>().sqrt(),
    })
}

/// The medial surface at the share `t` of the geodesic from `a` (0) to `b` (1).
///
/// Atoms go as [`atom_between`] says; normals and the third spokes of end atoms turn along great
/// circles, η changing evenly. What is an end atom in one of the two only has its third spoke of there.
///
/// # Errors
/// If counts differ, or an atom has no positive radius.
pub fn interpolate(
    a: &MedialSurface,
    b: &MedialSurface,
    t: f64,
) -> Result<MedialSurface, MedialSpaceError> {
    check(&a.atoms)?;
    check(&b.atoms)?;
    same_count(&a.atoms, &b.atoms)?;
    let pairs = a.atoms.iter().zip(&b.atoms);
    let normals = a.normals.iter().zip(&b.normals);
    Ok(MedialSurface {
        atoms: pairs.map(|(a, b)| atom_between(a, b, t)).collect(),
        normals: normals.map(|(a, b)| between(a, b, t)).collect(),
        end: (a.end.iter().zip(&b.end))
            .map(|(a, b)| end_between(a.as_ref(), b.as_ref(), t))
            .collect(),
    })
}

fn end_between(a: Option<&EndSpoke>, b: Option<&EndSpoke>, t: f64) -> Option<EndSpoke> {
    // Without a partner the spoke stays as it is instead of growing from nothing.
    let (a, b) = (a.or(b)?, b.or(a)?);
    Some(EndSpoke {
        direction: between(&a.direction, &b.direction, t),
        eta: a.eta + t * (b.eta - a.eta),
    })
}

/// Fréchet mean of atoms of several surfaces, atom by atom: mean centre, geometric mean radius, means
/// of the spokes on the sphere. The means of the parts are the mean in the product, whatever the
/// weights between them.
///
/// # Errors
/// If there is no surface, counts differ, or spokes of an atom cancel.
pub fn mean_atoms(surfaces: &[&[Atom]]) -> Result<Vec<Atom>, MedialSpaceError> {
    let first = surfaces.first().ok_or(MedialSpaceError::NoSurface)?;
    for surface in surfaces {
        same_count(first, surface)?;
        check(surface)?;
    }
    (0..first.len())
        .map(|atom| {
            let same: Vec<Atom> = surfaces.iter().map(|surface| surface[atom]).collect();
            mean_atom(&same).ok_or(MedialSpaceError::NoMean { atom })
        })
        .collect()
}

/// Fréchet mean of atoms; `None` without any, or where their spokes cancel.
pub fn mean_atom(atoms: &[Atom]) -> Option<Atom> {
    let count = atoms.len().max(1) as f64;
    let weights = vec![1.0; atoms.len()];
    let spokes = |side: usize| {
        let directions: Vec<Vector3> = atoms.iter().map(|atom| atom.spokes[side]).collect();
        frechet_mean(&directions, &weights)
    };
    let centre: Vector3 = atoms.iter().map(|atom| atom.position.coords).sum();
    let log_radius: f64 = atoms.iter().map(|atom| atom.radius.ln()).sum();
    Some(Atom {
        position: Point3::from(centre / count),
        // The Fréchet mean of ln r: the geometric mean.
        radius: (log_radius / count).exp(),
        spokes: [spokes(0)?, spokes(1)?],
    })
}

fn same_count(a: &[Atom], b: &[Atom]) -> Result<(), MedialSpaceError> {
    let (first, other) = (a.len(), b.len());
    if first == other {
        Ok(())
    } else {
        Err(MedialSpaceError::Count { first, other })
    }
}

fn check(atoms: &[Atom]) -> Result<(), MedialSpaceError> {
    let good = |atom: &Atom| {
        atom.radius > 0.0
            && atom.radius.is_finite()
            && atom.position.iter().all(|x| x.is_finite())
            && atom
                .spokes
                .iter()
                .flat_map(|s| s.iter())
                .all(|x| x.is_finite())
    };
    match atoms.iter().position(|atom| !good(atom)) {
        Some(atom) => Err(MedialSpaceError::BadAtom { atom }),
        None => Ok(()),
    }
}
