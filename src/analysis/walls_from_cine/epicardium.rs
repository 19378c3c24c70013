//! Where the muscle ends: costs of the epicardium along rays.

use super::closed_path::Costs;
use super::endocardium::Pull;
use super::polar::{Polar, STEP_MM, mean, running_sums};
use super::tones::Tones;

/// Pieces of a ray to either side of an edge that are compared, in millimetres.
const SIDE_MM: f64 = 2.5;
/// Price of a millimetre of something else within the wall, less what muscle is allowed to vary.
const OTHER_WITHIN: f64 = 0.25;
/// What muscle varies: noise, and its partial volume.
const ALLOWED: f64 = 0.2;
/// Price of (Δr)² from ray to ray, per mm².
const BENDING: f64 = 0.1;
/// Price where the wall would be too thin or too thick.
const IMPOSSIBLE: f64 = 100.0;

/// The epicardium around an endocardium: the closed path up to which there is muscle, and beyond which there is something
/// brighter (blood of the right ventricle, fat) or darker (lung).
///
/// With d the departure of values from muscle, 1 at blood and −1 at nothing, a radius r beyond the endocardium rₑ costs
/// −|d̄ beyond − d̄ within| + 0.25 ∫ (|d| − 0.2) dr' from rₑ to r + pull: d̄ are means over 2.5 mm.
pub(super) fn epicardium(
    polar: &Polar,
    tones: &Tones,
    endo: &[f64],
    wall_mm: [f64; 2],
    pulls: &[Pull],
) -> Vec<f64> {
    let side = (SIDE_MM / STEP_MM) as isize;
    let costs = Costs::of(polar.samples(), |ray| {
        let departures: Vec<f64> = polar
            .ray(ray)
            .iter()
            .map(|&value| tones.departure(value))
            .collect();
        let sums = running_sums(departures.iter().copied());
        let mut other = 0.0;
        let cost = |(n, &own): (usize, &f64)| {
            let radius = (n as f64 + 0.5) * STEP_MM;
            let wall = radius - endo[ray];
            // The endocardium itself is half blood.
            if wall > 1.5 {
                other += (own.abs() - ALLOWED) * STEP_MM;
            }
            if !(wall_mm[0]..=wall_mm[1]).contains(&wall) {
                return IMPOSSIBLE;
            }
            let at = n as isize;
            let edge = (mean(&sums, at + 1, at + 1 + side) - mean(&sums, at - side, at))
                .abs()
                .min(1.0);
            let pull: f64 = pulls.iter().map(|pull| pull.cost(ray, radius)).sum();
            pull - edge + OTHER_WITHIN * other
        };
        departures.iter().enumerate().map(cost).collect()
    });
    let found = costs.min_closed(BENDING);
    // Where the path could not follow a jump of the endocardium.
    let within = found
        .iter()
        .zip(endo)
        .map(|(epi, endo)| epi.clamp(endo + wall_mm[0], endo + wall_mm[1]));
    within.collect()
}

/// The share of rays on which what lies between the outlines is muscle: its mean departure is less than half of that of
/// blood.
pub(super) fn muscle_share(polar: &Polar, tones: &Tones, endo: &[f64], epi: &[f64]) -> f64 {
    let is_muscle = |ray: usize| {
        let values = polar.ray(ray);
        let at = |mm: f64| ((mm / STEP_MM).max(0.0) as usize).min(values.len());
        let (from, to) = (at(endo[ray] + 1.0), at(epi[ray] - 0.5));
        let wall = &values[from.min(to)..to];
        let sum: f64 = wall.iter().map(|&value| tones.departure(value).abs()).sum();
        !wall.is_empty() && sum < 0.5 * wall.len() as f64
    };
    (0..endo.len()).filter(|&ray| is_muscle(ray)).count() as f64 / endo.len().max(1) as f64
}
