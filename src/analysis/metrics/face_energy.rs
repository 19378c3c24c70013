//! Energy of a face per unit of weight, with its derivatives; for one pose or for several side by side.

use crate::numeric::{Arithmetic, three};

use super::corner::{corner_terms, energy, energy_gradient, raw_units, times};

/// An energy with its derivatives along the stretches and squared lengths of the sides ab, bc, ca, and along
/// the factors of the corners a, b, c.
#[derive(Clone, Copy, Debug)]
pub(super) struct FaceEnergy<T> {
    pub energy: T,
    pub stretch: [T; 3],
    /// None where corners are scale-free.
    pub length2: Option<[T; 3]>,
    /// None where corners have no factors.
    pub factor: Option<[T; 3]>,
}

/// (Σ_c |k_c t_c|)² or Σ_c (k_c t_c)² from stretches `s`, squared lengths `l` where corners are raw, and
/// factors `k` of the corners.
#[inline(always)]
pub(super) fn of_corners<T: Arithmetic>(
    s: [T; 3],
    l: Option<[T; 3]>,
    k: Option<[T; 3]>,
    printed: bool,
) -> FaceEnergy<T> {
    let bare = corner_terms(s);
    let long = l.map_or(bare, |l| times(bare, raw_units(l)));
    let t = k.map_or(long, |k| times(long, k));
    // Backwards through the factors: curvature, then lengths, then the bare terms.
    let gradients = energy_gradient(t, printed);
    let along_long = k.map_or(gradients, |k| times(gradients, k));
    let along_bare = l.map_or(along_long, |l| times(along_long, raw_units(l)));
    // Each stretch stands in two corner terms, once with either sign.
    let [a, b, c] = along_bare;
    FaceEnergy {
        energy: energy(t, printed),
        stretch: [a - b, b - c, c - a],
        length2: l.map(|l| {
            // The units are l₀l₂, l₁l₀ and l₂l₁.
            let [a, b, c] = times(along_long, bare);
            [
                a * l[2] + b * l[1],
                b * l[0] + c * l[2],
                c * l[1] + a * l[0],
            ]
        }),
        factor: k.map(|_| times(gradients, long)),
    }
}

/// Σ_e w_e s_e², or Σ_e w_e (s_e l_e)² where lengths count, with the part w_e each side has of the weight.
#[inline(always)]
pub(super) fn of_sides<T: Arithmetic>(
    s: [T; 3],
    l: Option<[T; 3]>,
    parts: [T; 3],
) -> FaceEnergy<T> {
    let rate = l.map_or(s, |l| times(s, l));
    let weighted = times(parts, rate);
    let [a, b, c] = times(weighted, rate);
    let gradients = three(|e| weighted[e] + weighted[e]);
    FaceEnergy {
        energy: a + b + c,
        stretch: l.map_or(gradients, |l| times(gradients, l)),
        length2: l.map(|_| times(gradients, s)),
        factor: None,
    }
}
