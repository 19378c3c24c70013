//! Noise added to vertices: three families of equal variance.

use rand::Rng;
use rand_chacha::ChaCha8Rng;

use crate::mesh::{Point3, Vector3};

/// Rate of the Poisson family (formulas, section 4): skewness 1/√10.
const POISSON_RATE: f64 = 10.0;

/// How a coordinate of the noise is distributed; mean 0 and variance σ² in each.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum NoiseFamily {
    /// Between −√3 σ and √3 σ.
    Uniform,
    /// Normal.
    Gaussian,
    /// σ (k − L)/√L with k of a Poisson distribution of rate L = 10.
    Poisson,
}

/// What a level of p % is a share of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum NoiseReference {
    /// The variance per coordinate of the clean mesh at rest, Σ|p − p̄|² / 3n.
    #[default]
    Shape,
    /// The mean square per coordinate of the clean displacement from rest, over the poses
    /// that are moved: the harder reading.
    Displacement,
}

impl NoiseFamily {
    /// All families, in the order of table 3.1.
    pub const ALL: [Self; 3] = [Self::Uniform, Self::Gaussian, Self::Poisson];

    /// What tables call it.
    pub fn name(self) -> &'static str {
        match self {
            Self::Uniform => "uniform",
            Self::Gaussian => "Gaussian",
            Self::Poisson => "Poisson",
        }
    }

    /// One draw with standard deviation `sigma`, in its unit.
    pub fn draw(self, sigma: f64, random: &mut ChaCha8Rng) -> f64 {
        match self {
            // The variance of a uniform number on ±1 is a third.
            Self::Uniform => sigma * 3.0_f64.sqrt() * random.random_range(-1.0..1.0),
            Self::Gaussian => sigma * standard_normal(random),
            Self::Poisson => {
                // Mean and variance of a Poisson number are both its rate.
                sigma * (f64::from(poisson(random)) - POISSON_RATE) / POISSON_RATE.sqrt()
            }
        }
    }

    /// The points with independent noise in every coordinate.
    pub fn added(self, points: &[Point3], sigma: f64, random: &mut ChaCha8Rng) -> Vec<Point3> {
        (points.iter())
            .map(|point| point + Vector3::from_fn(|_, _| self.draw(sigma, random)))
            .collect()
    }
}

/// Variance per coordinate: Σ|p − p̄|² / 3n; 0 without points.
pub fn coordinate_variance(points: &[Point3]) -> f64 {
    let count = points.len().max(1) as f64;
    let mean = points.iter().map(|p| p.coords).sum::<Vector3>() / count;
    let spread: f64 = (points.iter())
        .map(|p| (p.coords - mean).norm_squared())
        .sum();
    // Per coordinate, since noise is added to each.
    spread / (3.0 * count)
}

/// Standard deviation per coordinate of p % noise on a sequence of clean poses, the first at rest.
pub fn noise_sigma(poses: &[Vec<Point3>], percent: f64, reference: NoiseReference) -> f64 {
    let Some((rest, moved)) = poses.split_first() else {
        return 0.0;
    };
    let variance = match reference {
        NoiseReference::Shape => coordinate_variance(rest),
        NoiseReference::Displacement => {
            // About zero, not about its mean: a translation is displacement, too.
            let square: f64 = (moved.iter().flat_map(|pose| pose.iter().zip(rest)))
                .map(|(p, q)| (p - q).norm_squared())
                .sum();
            square / (3 * rest.len() * moved.len()).max(1) as f64
        }
    };
    (percent / 100.0 * variance).sqrt()
}

/// By the transformation of Box and Muller.
fn standard_normal(random: &mut ChaCha8Rng) -> f64 {
    // 1 − u lies in (0, 1], so that its logarithm is finite.
    let radius = (-2.0 * (1.0 - random.random::<f64>()).ln()).sqrt();
    radius * (std::f64::consts::TAU * random.random::<f64>()).cos()
}

/// By multiplying uniform draws until they fall below exp(−L): exact, and quick at a rate of 10.
fn poisson(random: &mut ChaCha8Rng) -> u32 {
    let limit = (-POISSON_RATE).exp();
    let (mut product, mut count) = (random.random::<f64>(), 0);
    // Knuth: waiting times of a unit rate until they exceed the mean; the rate is small.
    while product > limit {
        product *= random.random::<f64>();
        count += 1;
    }
    count
}
