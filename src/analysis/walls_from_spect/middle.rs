//! The middle of the wall: where counts are greatest along the rays, on a surface that is smooth in space and time.

use crate::progress::{Progress, Stopped};

use super::rays::{Profiles, Rays, STEP_MM, Sheet};

/// Weight of a difference from the mean of the neighbours, in counts of the wall per cm².
const SMOOTHNESS: f64 = 0.25;
/// Weight of the same ray at a neighbouring instant in that mean, where one beside it has 1. More would hold the wall back
/// at end-systole and end-diastole.
const IN_TIME: f64 = 0.02;
/// Distance on either side of where the wall is expected that is looked at.
const WINDOW_MM: f64 = 16.0;
/// Rounds over all rays; fewer once nothing moves by more than a tenth of a sample.
const ROUNDS: usize = 30;
/// Counts above those of the usual wall count no more: a liver is no better wall.
const MOST: f64 = 1.15;

/// Sheets at all instants, each near to what is expected and to its neighbours in space and in the cycle of the beat.
///
/// On each ray, f(r) − s (r − m)² − h (r − r₀)² is greatest, where f are counts relative to those of the wall, m the mean of the
/// neighbours, r₀ what is expected and h how firmly (`held`, per cm²); found by rounds over all rays.
///
/// # Errors
/// If it was asked to stop.
pub(super) fn middles(
    rays: &Rays,
    profiles: &[Profiles],
    expected: &[f64],
    wall_counts: &[f64],
    held: f64,
    progress: &Progress,
) -> Result<Vec<Sheet>, Stopped> {
    let instants = profiles.len();
    let mut sheets = vec![expected.to_vec(); instants];
    for _ in 0..ROUNDS {
        let mut moved = 0.0_f64;
        for instant in 0..instants {
            progress.check()?;
            let wall = wall_counts.get(instant).copied().unwrap_or(1.0);
            for (ray, &r0) in expected.iter().enumerate() {
                let around = mean_around(rays, &sheets, instant, ray);
                let counts = PathState {
                    profiles: &profiles[instant],
                    ray,
                    wall,
                    held,
                };
                let found = counts.best(around, r0);
                moved = moved.max((found - sheets[instant][ray]).abs());
                sheets[instant][ray] = found;
            }
        }
        if moved < 0.1 * STEP_MM {
            break;
        }
    }
    Ok(sheets)
}

/// Mean of the neighbours in space, and of those in time where there are any.
fn mean_around(rays: &Rays, sheets: &[Sheet], instant: usize, ray: usize) -> f64 {
    let (mut sum, mut count) = (0.0, 0.0);
    for neighbour in rays.neighbours(ray) {
        sum += sheets[instant][neighbour];
        count += 1.0;
    }
    let instants = sheets.len();
    if instants > 2 {
        for other in [
            (instant + 1) % instants,
            (instant + instants - 1) % instants,
        ] {
            sum += IN_TIME * sheets[other][ray];
            count += IN_TIME;
        }
    }
    sum / count
}

/// Counts along one ray.
struct PathState<'a> {
    profiles: &'a Profiles,
    ray: usize,
    wall: f64,
    held: f64,
}

impl PathState<'_> {
    /// The distance with the most of counts and smoothness.
    fn best(&self, around: f64, expected: f64) -> f64 {
        let value = |sample: usize| {
            let r = sample as f64 * STEP_MM;
            let counts = self.profiles.of(self.ray).get(sample);
            let counts = counts.map_or(f64::NAN, |&c| f64::from(c)) / self.wall;
            // Beyond the image nothing is known.
            let counts = if counts.is_finite() {
                counts.clamp(0.0, MOST)
            } else {
                0.0
            };
            let cm = [r - around, r - expected].map(|mm| mm / 10.0);
            counts - SMOOTHNESS * cm[0] * cm[0] - self.held * cm[1] * cm[1]
        };
        let first = ((expected - WINDOW_MM) / STEP_MM).ceil().max(1.0) as usize;
        let last = ((expected + WINDOW_MM) / STEP_MM).floor().max(1.0) as usize;
        let mut best = (first, f64::MIN);
        for sample in first..=last.max(first) {
            let value = value(sample);
            if value > best.1 {
                best = (sample, value);
            }
        }
        // A parabola through it and its neighbours.
        let [below, at, above] = [value(best.0 - 1), best.1, value(best.0 + 1)];
        let bend = below - 2.0 * at + above;
        let aside = match bend < 0.0 {
            true => (0.5 * (below - above) / bend).clamp(-0.5, 0.5),
            false => 0.0,
        };
        (best.0 as f64 + aside) * STEP_MM
    }
}
