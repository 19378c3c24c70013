//! Gaussian blur of volumes, axis by axis.

use std::sync::Arc;

use rayon::prelude::*;

use super::{Image, ImageError};
use crate::progress::{Progress, Stopped};

/// Standard deviations at which the kernel ends: beyond lies 6·10⁻⁵ of its weight.
const TRUNCATE: f64 = 4.0;

/// Greatest standard deviation in voxels: wider than any organ on any grid, and bounds the time of a blur.
const MAX_SIGMA_VOXELS: f64 = 256.0;

/// Numbers that are summed side by side.
const LANES: usize = 8;

/// What lies beyond the border of a volume.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Border {
    /// Its mirror image, the value at the border twice: d c b a | a b c d.
    #[default]
    Reflect,
    /// The value at the border: a a a a | a b c d.
    Nearest,
}

/// Why nothing is blurred.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum BlurError {
    /// Values and a grid do not belong together.
    #[error("{values} values for {voxels} voxels")]
    Count {
        /// How many values there are.
        values: usize,
        /// How many there should be.
        voxels: usize,
    },
    /// A width that is negative, no number, or beyond any use.
    #[error(
        "the standard deviation of the blur must lie in 0 to {MAX_SIGMA_VOXELS} voxels, but is {0}"
    )]
    Sigma(f64),
    /// The result is no image.
    #[error(transparent)]
    Image(#[from] ImageError),
    /// Stopped.
    #[error(transparent)]
    Stopped(#[from] Stopped),
}

/// An image whose volumes are blurred with a Gaussian of standard deviation `sigma_mm`, see [`gaussian_blur`].
///
/// It is blurred along the axes of the grid: exact where these are at right angles.
///
/// # Errors
/// If the standard deviation is negative, not finite or more than 256 voxels along an axis, or it is stopped.
pub fn blurred_image(
    image: &Image,
    sigma_mm: f64,
    border: Border,
    progress: &Progress,
) -> Result<Image, BlurError> {
    let sigma = image.frame().spacing().map(|spacing| sigma_mm / spacing);
    let count = image.volumes().len() as f32;
    let blur = |(at, values): (usize, &Arc<[f32]>)| {
        let [from, to] = [at, at + 1].map(|done| done as f32 / count);
        let part = progress.part("blurring", from, to);
        gaussian_blur(image.frame().size(), values, sigma, border, &part).map(Arc::from)
    };
    let volumes = image.volumes().iter().enumerate().map(blur);
    let volumes = volumes.collect::<Result<Vec<Arc<[f32]>>, BlurError>>()?;
    let times = image.times_ms().map(<[f64]>::to_vec);
    Ok(Image::new(*image.frame(), volumes, times)?)
}

/// Values convolved with a Gaussian of standard deviation σ, in voxels along each axis, i fastest.
///
/// The kernel is exp(−t²/2σ²) at whole t up to ⌊4σ + ½⌋, divided by its sum; the convolution is done along i, then j, then k.
/// Where a value is missing (NaN or infinite) it stays so, and its neighbours are the weighted means of those that are there:
/// Σ w v / Σ w. Sums are those of doubles, results are rounded to single precision after each axis.
///
/// # Errors
/// If counts differ, a σ is negative, not finite or more than 256, or it is stopped; that is heard once a slice.
pub fn gaussian_blur(
    size: [usize; 3],
    values: &[f32],
    sigma: [f64; 3],
    border: Border,
    progress: &Progress,
) -> Result<Vec<f32>, BlurError> {
    let voxels = (size.iter()).try_fold(1_usize, |count, &n| count.checked_mul(n));
    if voxels != Some(values.len()) {
        return Err(BlurError::Count {
            values: values.len(),
            voxels: voxels.unwrap_or(usize::MAX),
        });
    }
    if let Some(&wrong) = (sigma.iter()).find(|sigma| !(0.0..=MAX_SIGMA_VOXELS).contains(*sigma)) {
        return Err(BlurError::Sigma(wrong));
    }
    if values.is_empty() {
        return Ok(Vec::new());
    }
    let blur = Blur {
        size,
        kernels: sigma.map(half_kernel),
        border,
    };
    let whole = values
        .par_chunks(size[0])
        .all(|row| row.iter().all(|v| v.is_finite()));
    progress.expect_steps(if whole { 2 } else { 4 } * size[2]);
    if whole {
        return Ok(blur.blurred(values, progress)?);
    }
    let present = |v: &f32| v.is_finite();
    let known: Vec<f32> = values
        .iter()
        .map(|v| if present(v) { *v } else { 0.0 })
        .collect();
    let weights: Vec<f32> = values.iter().map(|v| f32::from(present(v))).collect();
    let sums = blur.blurred(&known, progress)?;
    let weights = blur.blurred(&weights, progress)?;
    let means = sums.iter().zip(&weights).zip(values);
    let mean = |((&sum, &weight), value): ((&f32, &f32), &f32)| {
        if present(value) { sum / weight } else { *value }
    };
    Ok(means.map(mean).collect())
}

/// The weight at 0 and those at 1, 2, … to either side.
fn half_kernel(sigma: f64) -> Vec<f64> {
    let radius = (TRUNCATE * sigma + 0.5) as usize;
    // Without a radius σ may be 0, and 0/0 no weight.
    let mut weights = vec![1.0];
    weights.extend((1..=radius).map(|t| (-0.5 * (t as f64 / sigma).powi(2)).exp()));
    let sum = 1.0 + 2.0 * weights[1..].iter().sum::<f64>();
    weights.iter().map(|weight| weight / sum).collect()
}

struct Blur {
    size: [usize; 3],
    kernels: [Vec<f64>; 3],
    border: Border,
}

impl Blur {
    fn blurred(&self, values: &[f32], progress: &Progress) -> Result<Vec<f32>, Stopped> {
        let [nx, ny, nz] = self.size;
        let slice = nx * ny;
        let mut within = vec![0.0_f32; values.len()];
        (within.par_chunks_mut(slice).zip(values.par_chunks(slice))).try_for_each(
            |(to, from)| {
                progress.step()?;
                self.along_i_and_j(from, to);
                Ok(())
            },
        )?;
        if self.kernels[2].len() == 1 {
            return Ok(within);
        }
        let mut across = vec![0.0_f32; values.len()];
        (across.par_chunks_mut(slice).enumerate()).try_for_each(|(k, to)| {
            progress.step()?;
            let sources = self.sources(k, nz, 2);
            let mut rows = Vec::with_capacity(sources.len());
            for (j, to) in to.chunks_mut(nx).enumerate() {
                rows.clear();
                rows.extend(
                    sources
                        .iter()
                        .map(|source| &within[source * slice + j * nx..][..nx]),
                );
                combine(to, &rows, &self.kernels[2]);
            }
            Ok(())
        })?;
        Ok(across)
    }

    /// Blurs one slice along its own axes.
    fn along_i_and_j(&self, from: &[f32], to: &mut [f32]) {
        let [nx, ny, _] = self.size;
        let radius = self.kernels[0].len() - 1;
        // Rows with what lies beyond their ends.
        let inner = (0..nx + 2 * radius).map(|at| self.source(at as i64 - radius as i64, nx));
        let inner: Vec<usize> = inner.collect();
        let mut padded = vec![0.0_f32; inner.len()];
        let mut along_i = vec![0.0_f32; from.len()];
        for (to, from) in along_i.chunks_mut(nx).zip(from.chunks(nx)) {
            for (padded, &source) in padded.iter_mut().zip(&inner) {
                *padded = from[source];
            }
            let shifted = |at: usize| &padded[at..at + nx];
            let pairs = (1..=radius).flat_map(|t| [shifted(radius - t), shifted(radius + t)]);
            let rows: Vec<&[f32]> = std::iter::once(shifted(radius)).chain(pairs).collect();
            combine(to, &rows, &self.kernels[0]);
        }
        for (j, to) in to.chunks_mut(nx).enumerate() {
            let sources = self.sources(j, ny, 1);
            let rows: Vec<&[f32]> = sources.iter().map(|at| &along_i[at * nx..][..nx]).collect();
            combine(to, &rows, &self.kernels[1]);
        }
    }

    /// What is summed at a place of an axis of n: itself, then pairs at growing distance.
    fn sources(&self, place: usize, n: usize, axis: usize) -> Vec<usize> {
        let place = place as i64;
        let pairs = (1..self.kernels[axis].len() as i64)
            .flat_map(|t| [self.source(place - t, n), self.source(place + t, n)]);
        std::iter::once(place as usize).chain(pairs).collect()
    }

    /// The place on an axis of n whose value stands at a place that may lie beyond its ends.
    fn source(&self, place: i64, n: usize) -> usize {
        let n = n as i64;
        let within = match self.border {
            Border::Nearest => place.clamp(0, n - 1),
            Border::Reflect => {
                let folded = place.rem_euclid(2 * n);
                folded.min(2 * n - 1 - folded)
            }
        };
        within as usize
    }
}

/// Sums rows: the first with the first weight, each following pair with the next.
fn combine(to: &mut [f32], rows: &[&[f32]], weights: &[f64]) {
    let Some((middle, pairs)) = rows.split_first() else {
        return;
    };
    let (pairs, _) = pairs.as_chunks::<2>();
    let whole = to.len() - to.len() % LANES;
    for at in (0..whole).step_by(LANES) {
        let mut sums = [0.0_f64; LANES];
        for (sum, &value) in sums.iter_mut().zip(&middle[at..at + LANES]) {
            *sum = weights[0] * f64::from(value);
        }
        for ([a, b], weight) in pairs.iter().zip(&weights[1..]) {
            let (a, b) = (&a[at..at + LANES], &b[at..at + LANES]);
            for lane in 0..LANES {
                sums[lane] += weight * (f64::from(a[lane]) + f64::from(b[lane]));
            }
        }
        for (to, sum) in to[at..at + LANES].iter_mut().zip(sums) {
            *to = sum as f32;
        }
    }
    for at in whole..to.len() {
        let mut sum = weights[0] * f64::from(middle[at]);
        for ([a, b], weight) in pairs.iter().zip(&weights[1..]) {
            sum += weight * (f64::from(a[at]) + f64::from(b[at]));
        }
        to[at] = sum as f32;
    }
}

#[cfg(test)]
mod tests;
