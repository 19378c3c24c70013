//! The values around a middle, in polar coordinates.

use std::f64::consts::TAU;

use super::slices::{Place, Slices};

/// Directions around the middle: 5.6°, 3 mm at the endocardium of an adult.
pub(super) const RAYS: usize = 64;
/// Distance of samples along a ray, in millimetres: a third of a voxel.
pub(super) const STEP_MM: f64 = 0.5;

/// The direction of a ray.
pub(super) fn direction(ray: usize) -> Place {
    let angle = TAU * ray as f64 / RAYS as f64;
    Place::new(angle.cos(), angle.sin())
}

/// Values along rays from a middle, sample n at a distance of n + ½ steps.
#[derive(Clone, Debug)]
pub(super) struct Polar {
    samples: usize,
    /// Ray by ray; where there is no image or no number, NaN.
    values: Vec<f32>,
}

impl Polar {
    pub(super) fn of(
        slices: &Slices<'_>,
        instant: usize,
        slice: usize,
        middle: Place,
        reach_mm: f64,
    ) -> Self {
        let samples = (reach_mm / STEP_MM).ceil() as usize;
        let rays = (0..RAYS).flat_map(|ray| {
            let along = direction(ray);
            (0..samples).map(move |n| middle + along * ((n as f64 + 0.5) * STEP_MM))
        });
        let values = rays.map(|place| slices.value(instant, slice, place).unwrap_or(f32::NAN));
        Self {
            samples,
            values: values.collect(),
        }
    }

    pub(super) fn samples(&self) -> usize {
        self.samples
    }

    pub(super) fn ray(&self, ray: usize) -> &[f32] {
        &self.values[ray * self.samples..(ray + 1) * self.samples]
    }
}

/// The sum of values before each sample and after the last: means over pieces of a ray in constant time.
pub(super) fn running_sums(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut sum = 0.0;
    let sums = values.map(|value| {
        sum += value;
        sum
    });
    std::iter::once(0.0).chain(sums).collect()
}

/// The mean over samples `from..to`, cut off at the ends; 0 of none.
pub(super) fn mean(sums: &[f64], from: isize, to: isize) -> f64 {
    let last = sums.len() as isize - 1;
    let [from, to] = [from, to].map(|n| n.clamp(0, last) as usize);
    if to <= from {
        return 0.0;
    }
    (sums[to] - sums[from]) / (to - from) as f64
}
