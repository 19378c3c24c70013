//! How small a patch could have been found in this subject.

use std::f64::consts::PI;

use super::akinetic_regions::CORE_AREA;
use super::averaged_thickening::AveragedThickening;
use super::diffusion::RegularMesh;
use super::params::CheckedThickeningParams;

/// Rings into which a disc and what is around it are cut.
const RINGS: usize = 240;
/// How far around a disc averaging still reaches, in √(½ t).
const REACH: f64 = 8.0;
/// Standard deviations of noise that a core must stay below its limit: normal noise exceeds two of them in one of forty draws. That patches
/// from a third above the limit on are detected is tested by `tests/small.rs`.
const SURE: f64 = 2.0;
/// Largest patch that is looked for: remote myocardium is estimated from the fifth of the wall that thickens most, the middle of what
/// three fifths leave.
const LARGEST: f64 = 0.6;
/// Halvings of the area: to a millionth.
const HALVINGS: usize = 20;
/// A patch of fewer atoms is no part of a mesh.
const MIN_ATOMS: f64 = 4.0;

/// Least share of the regular surface that a round patch that is akinetic needs to be found for sure; `None` where noise
/// hides even the largest.
///
/// A disc in a plane that thickens by 0 where all around thickens as remote myocardium does, averaged as thickening
/// is, is detected where its core and its extent hold the areas that a patch needs, the core with noise on top.
pub(super) fn smallest_detectable(
    estimate: &AveragedThickening,
    mesh: &RegularMesh,
    params: &CheckedThickeningParams,
) -> Option<f64> {
    // Where remote myocardium does not thicken, no patch can stand out.
    if estimate.hardly_thickens(params) || estimate.remote <= 0.0 {
        return None;
    }
    // The core must stay below its limit although noise may lift it.
    let core = params
        .core_threshold
        .min(params.akinetic_threshold / estimate.remote)
        - SURE * estimate.noise / estimate.remote;
    let enough = |area: f64| {
        let profile = Profile::new(area, estimate.share);
        profile.area_below(core) >= CORE_AREA * estimate.min_share
            && profile.area_below(params.extent_threshold) >= estimate.min_share
    };
    if !enough(LARGEST) {
        return None;
    }
    let [mut low, mut high] = [0.0, LARGEST];
    // `enough` grows with the area, so that bisection finds the smallest.
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if enough(middle) {
            high = middle;
        } else {
            low = middle;
        }
    }
    let atoms = mesh.areas.iter().filter(|&&area| area > 0.0).count();
    Some(high.max(MIN_ATOMS / atoms.max(1) as f64))
}

/// Averaged thickening over the distance from the middle of a disc, 0 within and 1 around it before.
struct Profile {
    ring: f64,
    values: Vec<f64>,
}

impl Profile {
    /// Of a disc of this area, averaged over this one, both as shares of the whole.
    fn new(area: f64, averaged: f64) -> Self {
        // As `Diffusion` does it: two steps of ½ t, t being the area over 6π.
        let time = 0.5 * averaged / (6.0 * PI);
        let radius = (area / PI).sqrt();
        let ring = (radius + REACH * time.sqrt()) / RINGS as f64;
        // Areas of rings: (i + 1)² − i² = 2 i + 1.
        let volume = |i: usize| PI * ring * ring * (2 * i + 1) as f64;
        // The ring on the disc's edge is still in part.
        let mut values: Vec<f64> = (0..RINGS)
            .map(|i| {
                let inside = area - PI * (ring * i as f64).powi(2);
                1.0 - (inside / volume(i)).clamp(0.0, 1.0)
            })
            .collect();
        for _ in 0..2 {
            values = diffused(&values, volume, time);
        }
        Self { ring, values }
    }

    /// Area within which it is at most this.
    fn area_below(&self, limit: f64) -> f64 {
        let Some(first) = self.values.iter().position(|&value| value > limit) else {
            return PI * (self.ring * self.values.len() as f64).powi(2);
        };
        let Some(before) = first.checked_sub(1) else {
            return 0.0;
        };
        let [low, high] = [self.values[before], self.values[first]];
        // Between the middles of two rings, by the values there.
        let centre = before as f64 + 0.5 + (limit - low) / (high - low);
        PI * (self.ring * centre).powi(2)
    }
}

/// (V + t C)⁻¹ V of rings of these volumes, whose sides conduct 2π i each; nothing leaves the outermost.
fn diffused(values: &[f64], volume: impl Fn(usize) -> f64, time: f64) -> Vec<f64> {
    let count = values.len();
    // Between ring i − 1 and ring i.
    let side = |i: usize| {
        if i == 0 || i == count {
            0.0
        } else {
            time * 2.0 * PI * i as f64
        }
    };
    let mut upper = vec![0.0; count];
    let mut found = vec![0.0; count];
    for i in 0..count {
        let [above, left] = match i {
            0 => [0.0, 0.0],
            _ => [upper[i - 1], found[i - 1]],
        };
        // Thomas’ algorithm: the matrix of rings is tridiagonal.
        let pivot = volume(i) + side(i) + side(i + 1) - side(i) * above;
        upper[i] = side(i + 1) / pivot;
        found[i] = (volume(i) * values[i] + side(i) * left) / pivot;
    }
    for i in (0..count.saturating_sub(1)).rev() {
        found[i] += upper[i] * found[i + 1];
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_disc_is_blurred_by_no_more_than_averaging_reaches() {
        let wide = Profile::new(0.2, 0.01);
        assert!(wide.values[0] < 1e-3 && wide.values[RINGS - 1] > 0.99);
        assert!(wide.values.is_sorted());
        // Half-way up lies about on the edge of a disc that is large against averaging.
        assert!((wide.area_below(0.5) / 0.2 - 1.0).abs() < 0.03);
        // What a disc takes from its surroundings is its area: averaging loses nothing.
        let area = |i: usize| PI * wide.ring * wide.ring * (2 * i + 1) as f64;
        let lost: f64 = (0..RINGS).map(|i| area(i) * (1.0 - wide.values[i])).sum();
        assert!((lost - 0.2).abs() < 1e-9, "{lost}");
        // A disc as small as the area of averaging loses more than a third of its depth.
        assert!((0.3..0.5).contains(&Profile::new(0.005, 0.01).values[0]));
    }
}
