//! An outline around a point as the square of its radius over the angle: what is smoothed has the outline's area.

use std::f64::consts::{PI, TAU};

use super::planes::{Place, Planes};
use super::region::Region;

/// Waves around the axis that are kept. Rays of the finest usual mesh (36 around) show no more than 18.
pub(super) const WAVES: usize = 16;
/// Sectors in which area is counted; several for each wave.
const SECTORS: usize = 128;
/// Parts of a pixel along each side, by which its area is spread over sectors.
const PARTS: usize = 4;

/// Coefficients of q(θ) = c₀ + 2 Σ (aₘ cos mθ + bₘ sin mθ), in square millimetres; `[a, b]` for each m, with b₀ = 0.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct SquaredRadius(pub [[f64; 2]; WAVES + 1]);

impl SquaredRadius {
    /// Of the area of a region in each direction from `centre`: q(θ) dθ / 2 is the area within dθ, so that a region
    /// need not be star-shaped and none of its area is lost. The steps of pixels are smoothed by a Gaussian along the outline
    /// whose σ is half a pixel's side.
    pub fn of_region(planes: &Planes, slice: usize, region: &Region, centre: Place) -> Self {
        let mut sectors = [0.0; SECTORS];
        let part = planes.pixel_mm2() / (PARTS * PARTS) as f64;
        let within = |k: usize| (k as f64 + 0.5) / PARTS as f64 - 0.5;
        let [along, beside] = planes.pixel_steps();
        for [i, j] in region.pixels() {
            let middle = planes.place(slice, [i as f64, j as f64]) - centre;
            for k in 0..PARTS * PARTS {
                let at = middle + along * within(k % PARTS) + beside * within(k / PARTS);
                // Shared between the two sectors whose middles it lies between, so that no rounding decides which one has it.
                let place = (at.y.atan2(at.x) / TAU).rem_euclid(1.0) * SECTORS as f64 - 0.5;
                let share = place - place.floor();
                let below = (place.floor() + SECTORS as f64) as usize % SECTORS;
                sectors[below] += part * (1.0 - share);
                sectors[(below + 1) % SECTORS] += part * share;
            }
        }
        let area: f64 = sectors.iter().sum();
        let sigma_rad =
            0.5 * planes.pixel_mm() / f64::max((area / PI).sqrt(), 0.5 * planes.pixel_mm());
        let middle = |sector: usize| TAU * (sector as f64 + 0.5) / SECTORS as f64;
        let squares = sectors.iter().enumerate();
        // q in a sector is twice its area over its angle.
        Self::of_samples(
            squares.map(|(s, area)| (middle(s), 2.0 * area * SECTORS as f64 / TAU)),
            sigma_rad,
        )
    }

    /// Of samples (θ, q) at equal steps around, smoothed by a Gaussian of `sigma_rad`.
    pub fn of_samples(samples: impl ExactSizeIterator<Item = (f64, f64)>, sigma_rad: f64) -> Self {
        let count = samples.len().max(1) as f64;
        let mut sums = [[0.0; 2]; WAVES + 1];
        for (angle, square) in samples {
            for (m, [a, b]) in sums.iter_mut().enumerate() {
                let (sin, cos) = (m as f64 * angle).sin_cos();
                *a += square * cos;
                *b += square * sin;
            }
        }
        for (m, sum) in sums.iter_mut().enumerate() {
            // The transform of the Gaussian.
            let kept = (-0.5 * (m as f64 * sigma_rad).powi(2)).exp();
            *sum = sum.map(|x| kept * x / count);
        }
        Self(sums)
    }

    /// Area that it encloses: π c₀.
    pub fn area(&self) -> f64 {
        PI * self.0[0][0]
    }
}

/// q(θ) of coefficients, which may have been interpolated.
pub(super) fn squared_radius(coefficients: &[[f64; 2]], angle: f64) -> f64 {
    let terms = coefficients.iter().enumerate().map(|(m, [a, b])| {
        let (sin, cos) = (m as f64 * angle).sin_cos();
        let twice = if m == 0 { 1.0 } else { 2.0 };
        twice * (a * cos + b * sin)
    });
    terms.sum()
}
