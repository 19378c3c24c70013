//! How bright blood and muscle are.

use super::CineError;
use super::polar::{Polar, RAYS, STEP_MM, mean, running_sums};
use super::slices::{Place, Slices};

/// Values of blood and muscle around one place: coils near the chest see more than those far away.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Tones {
    pub blood: f64,
    pub muscle: f64,
}

/// Radius of the disc around the marked point that is taken for blood, in millimetres: three voxels.
const DISC_MM: f64 = 4.0;
/// How far around the marked point other tissues are looked at, in millimetres.
const AROUND_MM: f64 = 40.0;
/// Blood is at least this share of what is bright around it (95 of 100 values lie below). Muscle has 0.2 to 0.35 of the values
/// of blood in balanced steady-state images; blood near the coils is up to 1.6 times as bright as far from them.
const BRIGHT_SHARE: f64 = 0.45;
/// Values below this share of those of blood are muscle, or something else that ends the blood.
const NOT_BLOOD: f64 = 0.65;
/// Length over which a ray stays below that, in millimetres: half a wall.
const WALL_MM: f64 = 4.0;
/// Share of the rays that leave the blood.
const MIN_RAYS: f64 = 0.6;
/// Muscle is not brighter than this share of blood, or the two are no longer distinguished.
const MAX_MUSCLE: f64 = 0.75;
/// Blood is this many times as bright as in the slice before, at most: fat is brighter.
const BLOOD_RANGE: f64 = 1.3;

impl Tones {
    /// From a point that was marked as blood.
    ///
    /// # Errors
    /// If there are no values, it is dark, or nothing ends the blood around it.
    pub(super) fn marked(
        slices: &Slices<'_>,
        slice: usize,
        place: Place,
    ) -> Result<Self, CineError> {
        let around: Vec<Polar> = (0..slices.instants())
            .map(|instant| Polar::of(slices, instant, slice, place, AROUND_MM))
            .collect();
        let within = |reach_mm: f64| {
            let samples = (reach_mm / STEP_MM) as usize;
            let rays = around
                .iter()
                .flat_map(|polar| (0..RAYS).map(move |ray| polar.ray(ray)));
            let values = rays.flat_map(move |ray| ray.iter().take(samples).step_by(2));
            values
                .filter(|value| value.is_finite())
                .map(|&value| f64::from(value))
                .collect::<Vec<_>>()
        };
        // The point may lie in the wall at end-systole: the upper quartile is that of blood.
        let blood =
            quantile(within(DISC_MM), 0.75).ok_or(CineError::Outside("the point of the blood"))?;
        let usual = quantile(within(AROUND_MM), 0.95).unwrap_or(blood);
        // Dark as well where both are 0 or below.
        if !(blood > BRIGHT_SHARE * usual && blood > 0.0) {
            return Err(CineError::Dark {
                value: blood,
                usual,
            });
        }
        let rays = around
            .iter()
            .flat_map(|polar| (0..RAYS).map(move |ray| polar.ray(ray)));
        let ends: Vec<f64> = rays.filter_map(|ray| first_wall(ray, blood)).collect();
        let found = ends.len() as f64 / (around.len() * RAYS) as f64;
        match quantile(ends, 0.5) {
            Some(muscle) if found >= MIN_RAYS => Ok(Self { blood, muscle }),
            _ => Err(CineError::NoEdge {
                found_percent: 100.0 * found,
                min_percent: 100.0 * MIN_RAYS,
            }),
        }
    }

    /// From the endocardium that was found with these: medians of what lies well within, and of what lies just beyond.
    pub(super) fn renewed(self, polars: &[Polar], endo: &[Vec<f64>]) -> Self {
        let (mut within, mut beyond) = (Vec::new(), Vec::new());
        for (polar, radii) in polars.iter().zip(endo) {
            for (ray, radius) in radii.iter().enumerate() {
                let values = polar.ray(ray);
                let at = |mm: f64| ((mm / STEP_MM) as usize).min(values.len());
                let pick = |from: usize, to: usize| {
                    let piece = values[from.min(to)..to].iter().step_by(2);
                    piece.filter(|v| v.is_finite()).map(|&v| f64::from(v))
                };
                within.extend(pick(0, at(0.65 * radius)));
                beyond.extend(pick(at(radius + 1.5), at(radius + 4.5)));
            }
        }
        let blood = quantile(within, 0.5).unwrap_or(self.blood);
        let blood = blood.clamp(self.blood / BLOOD_RANGE, self.blood * BLOOD_RANGE);
        let muscle = quantile(beyond, 0.5).unwrap_or(self.muscle);
        if muscle > 0.0 && muscle < MAX_MUSCLE * blood {
            Self { blood, muscle }
        } else {
            self
        }
    }

    /// 0 as muscle, 1 as blood; darker than muscle is below 0. What is unknown is like muscle.
    pub(super) fn blood_share(&self, value: f32) -> f64 {
        let share = (f64::from(value) - self.muscle) / (self.blood - self.muscle);
        // Beyond blood there is fat, and nothing is more blood than blood.
        if share.is_nan() {
            0.0
        } else {
            share.clamp(-0.3, 1.1)
        }
    }

    /// 0 as muscle, up to 1 as something brighter, down to −1 as something darker.
    pub(super) fn departure(&self, value: f32) -> f64 {
        let away = f64::from(value) - self.muscle;
        let unit = if away > 0.0 {
            self.blood - self.muscle
        } else {
            self.muscle
        };
        let share = away / unit;
        if share.is_nan() {
            0.0
        } else {
            share.clamp(-1.0, 1.0)
        }
    }
}

/// The mean value of the darkest piece near the first one on a ray that is a wall long and darker than blood.
fn first_wall(ray: &[f32], blood: f64) -> Option<f64> {
    let known = ray.iter().take_while(|value| value.is_finite()).count();
    let sums = running_sums(ray[..known].iter().map(|&value| f64::from(value)));
    let length = (WALL_MM / STEP_MM) as usize;
    let pieces =
        (0..known.saturating_sub(length)).map(|n| mean(&sums, n as isize, (n + length) as isize));
    // The first dark piece is half blood: the darkest one within the next wall is muscle.
    let dark = pieces.skip_while(|mean| *mean >= NOT_BLOOD * blood);
    dark.take(length).reduce(f64::min)
}

/// The value below which a share of all lie; `None` of none.
pub(super) fn quantile(mut values: Vec<f64>, share: f64) -> Option<f64> {
    if values.is_empty() {
        return None;
    }
    let place = ((values.len() - 1) as f64 * share).round() as usize;
    let (_, value, _) = values.select_nth_unstable_by(place, f64::total_cmp);
    Some(*value)
}
