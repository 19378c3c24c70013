//! Endocardium and epicardium: how far counts stay high on either side of the middle of the wall.

use super::rays::{ANGLES, Profiles, Rays, STEP_MM, Sheet};

/// Nearest and farthest borders from the middle of the wall.
const BORDER_MM: [f64; 2] = [3.0, 22.0];
/// Share of a ray's own border in the result; the rest is what is usual at that instant. Counts blur the wall to much the
/// same width everywhere, and noise and neighbouring organs change single rays.
const OWN: f64 = 0.3;
/// Share of what is usual at an instant in what is used there; the rest is what is usual over the beat.
const OWN_INSTANT: f64 = 0.6;

/// Distances of endocardium (inwards) and epicardium (outwards) from the middle of the wall, for each instant and ray.
///
/// The endocardium lies where counts have the height h between the least towards the axis (0) and those of the middle of
/// the wall (1), the epicardium likewise towards the outside.
pub(super) fn borders(
    rays: &Rays,
    profiles: &[Profiles],
    middles: &[Sheet],
    heights: [f64; 2],
    below: &[f64],
) -> [Vec<Sheet>; 2] {
    let [inner, outer] = [0, 1].map(|side| {
        let instants = profiles.iter().zip(middles);
        let found = instants.map(|(profiles, middles)| {
            let on_ray = |(ray, &middle): (usize, &f64)| match side {
                0 => inwards(profiles, ray, middle, heights[0]),
                _ => outwards(profiles, ray, middle, heights[1]),
            };
            middles.iter().enumerate().map(on_ray).collect::<Vec<_>>()
        });
        evened(rays, found.collect(), below)
    });
    [inner, outer]
}

/// Distance inwards to where counts have fallen to a height.
fn inwards(profiles: &Profiles, ray: usize, middle: f64, height: f64) -> Option<f64> {
    let counts = profiles.of(ray);
    let last = ((middle / STEP_MM).floor() as usize).min(counts.len().saturating_sub(1));
    let cavity = counts[..=last].iter().copied().filter(|c| c.is_finite());
    let cavity = f64::from(cavity.fold(f32::INFINITY, f32::min));
    let level = cavity + height * (profiles.at(ray, middle) - cavity);
    crossing(profiles, ray, middle, -STEP_MM, level)
}

/// Distance outwards to where counts have fallen to a height of those before they rise again.
fn outwards(profiles: &Profiles, ray: usize, middle: f64, height: f64) -> Option<f64> {
    let wall = profiles.at(ray, middle);
    let (mut least, mut away) = (wall, 0.0);
    while away < BORDER_MM[1] {
        away += STEP_MM;
        let counts = profiles.at(ray, middle + away);
        // Another organ begins where counts rise by more than a little, and nothing where the image ends.
        if !counts.is_finite() || counts > least + 0.05 * wall {
            break;
        }
        least = least.min(counts);
    }
    crossing(
        profiles,
        ray,
        middle,
        STEP_MM,
        least + height * (wall - least),
    )
}

/// How far from the middle counts first reach a level.
fn crossing(profiles: &Profiles, ray: usize, middle: f64, step: f64, level: f64) -> Option<f64> {
    let mut before = profiles.at(ray, middle);
    let mut away = 0.0;
    while away < BORDER_MM[1] && middle + away * step.signum() >= 0.0 {
        away += step.abs();
        let counts = profiles.at(ray, middle + away * step.signum());
        if !counts.is_finite() {
            return None;
        }
        if counts <= level {
            let part = (before - level) / (before - counts).max(f64::MIN_POSITIVE);
            let found = away - step.abs() * (1.0 - part.clamp(0.0, 1.0));
            return Some(found.clamp(BORDER_MM[0], BORDER_MM[1]));
        }
        before = counts;
    }
    None
}

/// Smooth distances: those of rays, drawn towards what is usual at their instant and over the beat.
fn evened(rays: &Rays, found: Vec<Vec<Option<f64>>>, below: &[f64]) -> Vec<Sheet> {
    let usual = |sheet: &[Option<f64>], base: f64| {
        let rows = (0..rays.rows).filter(|&row| rays.height(row) <= base);
        let of_rows = rows.flat_map(|row| sheet[row * ANGLES..(row + 1) * ANGLES].iter().flatten());
        median(of_rows.copied().collect())
    };
    let at_instants: Vec<Option<f64>> = (found.iter().zip(below))
        .map(|(sheet, &base)| usual(sheet, base))
        .collect();
    let over_beat = median(at_instants.iter().flatten().copied().collect());
    let over_beat = over_beat.unwrap_or(BORDER_MM[0]);
    let instants = found.into_iter().zip(at_instants);
    instants
        .map(|(sheet, at_instant)| {
            let at_instant = at_instant.unwrap_or(over_beat);
            let usual = OWN_INSTANT * at_instant + (1.0 - OWN_INSTANT) * over_beat;
            let low = 0.6 * at_instant;
            let high = 1.5 * at_instant;
            let own = |ray: usize| sheet[ray].map_or(at_instant, |own| own.clamp(low, high));
            let smooth = |ray: usize| {
                let around: Vec<f64> = rays.neighbours(ray).map(own).collect();
                let mean = (own(ray) + around.iter().sum::<f64>()) / (around.len() + 1) as f64;
                usual + OWN * (mean - at_instant)
            };
            (0..rays.count()).map(smooth).collect()
        })
        .collect()
}

/// The median; the lower of two middle ones.
pub(super) fn median(mut values: Vec<f64>) -> Option<f64> {
    values.retain(|value| value.is_finite());
    values.sort_by(f64::total_cmp);
    values.get(values.len().saturating_sub(1) / 2).copied()
}
