//! Where the blood ends: costs of the endocardium along rays.

use super::closed_path::Costs;
use super::polar::{Polar, STEP_MM, mean, running_sums};
use super::tones::Tones;

/// Pieces of a ray to either side of an edge that are compared, in millimetres.
const SIDE_MM: f64 = 3.0;
/// Price of a millimetre of muscle within the cavity: crossing a papillary muscle costs a fifth of an edge, a wall more.
const DARK_WITHIN: f64 = 0.12;
/// Price of being off the level of the endocardium.
const OFF_LEVEL: f64 = 0.4;
/// Price of (Δr)² from ray to ray, per mm².
const BENDING: f64 = 0.05;

/// Radii that pull at a path, and how strongly, per mm².
#[derive(Clone, Debug)]
pub(super) struct Pull {
    pub radii: Vec<f64>,
    pub weight: f64,
}

impl Pull {
    /// What a radius costs on a ray.
    pub(super) fn cost(&self, ray: usize, radius: f64) -> f64 {
        // A far pull is as good as none: where a neighbour is wrong, the image wins.
        let away = (radius - self.radii[ray]).abs().min(FAR_MM);
        self.weight * away * away
    }
}

/// Distance beyond which a pull grows no more.
const FAR_MM: f64 = 12.0;

/// The endocardium around a middle: the closed path along which what lies within is blood and what lies beyond is not.
///
/// With b the values between muscle (0) and blood (1), a radius r of a ray costs
/// −(b̄ within − b̄ beyond) + 0.12 ∫₀ʳ max(0, L − b) dr' + 0.4 |b(r) − L| + pull: b̄ are means over 3 mm, L is the level;
/// radii reach up to the greatest one.
pub(super) fn endocardium(
    polar: &Polar,
    tones: &Tones,
    (level, max_radius_mm): (f64, f64),
    pulls: &[Pull],
) -> Vec<f64> {
    let side = (SIDE_MM / STEP_MM) as isize;
    let samples = polar.samples().min((max_radius_mm / STEP_MM) as usize);
    let costs = Costs::of(samples, |ray| {
        let blood: Vec<f64> = polar
            .ray(ray)
            .iter()
            .map(|&value| tones.blood_share(value))
            .collect();
        let sums = running_sums(blood.iter().copied());
        let mut dark = 0.0;
        let cost = |(n, &own): (usize, &f64)| {
            dark += (level - own).max(0.0) * STEP_MM;
            let at = n as isize;
            let edge = mean(&sums, at - side, at) - mean(&sums, at + 1, at + 1 + side);
            let radius = (n as f64 + 0.5) * STEP_MM;
            let pull: f64 = pulls.iter().map(|pull| pull.cost(ray, radius)).sum();
            pull - edge + DARK_WITHIN * dark + OFF_LEVEL * (own - level).abs().min(1.0)
        };
        blood.iter().take(samples).enumerate().map(cost).collect()
    });
    costs.min_closed(BENDING)
}

/// The mean difference of blood within and beyond an outline, 1 for a perfect edge.
pub(super) fn edge(polar: &Polar, tones: &Tones, radii: &[f64]) -> f64 {
    let side = (SIDE_MM / STEP_MM) as isize;
    let edges = radii.iter().enumerate().map(|(ray, radius)| {
        let sums = running_sums(polar.ray(ray).iter().map(|&value| tones.blood_share(value)));
        let at = (radius / STEP_MM) as isize;
        mean(&sums, at - side, at) - mean(&sums, at, at + side)
    });
    edges.sum::<f64>() / radii.len().max(1) as f64
}
