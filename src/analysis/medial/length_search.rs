//! Over what length rough surfaces are smoothed.

use std::f64::consts::PI;

use rayon::prelude::*;

use super::connectivity::Connectivity;
use super::roughness::Roughness;
use super::smoothing::{Smoothed, smooth, smooth_from};
use crate::mesh::{Point3, vertex_areas, vertex_normals};

/// Each length that is tried over the one before.
const RATIO: f64 = std::f64::consts::SQRT_2;

/// Noise, in sides of the square that a vertex has to itself, from which areas and angles are those of noise: a vertex
/// off by a seventh of its side turns its faces by some ten degrees. Of that order, and not tuned.
const ROUGH: f64 = 0.15;

/// How often at most areas and angles are taken from the surfaces smoothed before: a bound on time. Not tuned.
const PASSES: usize = 8;

/// How the surfaces of all poses are smoothed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Plan {
    /// Standard deviation of the noise of each coordinate, in coordinates.
    pub noise: f64,
    /// ℓ, in coordinates.
    pub length: f64,
    /// How often areas and angles are taken from smoothed surfaces.
    pub passes: usize,
}

impl Plan {
    /// A pose smoothed by it.
    pub fn smooth(&self, connectivity: &Connectivity, points: &[Point3]) -> Smoothed {
        smooth(connectivity, points, self.length, self.passes)
    }
}

/// Looks for the length over which what is left of noise and what is lost of the shape are least together.
///
/// Both are estimated without knowing the shape: with K = 2 S − S² the mean of (n·(x − K x))² + 2 σ² tr K / V is, but for a
/// constant, the expected square of the error. The trace is that of a plane whose vertices have an area a each: waves of up to k² = 4π/a
/// keep (1 + 2u) / (1 + u)², u = ℓ²k², which over all of them is (2 ln(1 + U) − U / (1 + U)) / U with U = 4πℓ²/a.
///
/// Source: unbiased estimate of risk, Stein (1981), Annals of Statistics 9(6), 1135–1151.
pub(super) struct LengthSearch<'a> {
    pub roughness: &'a Roughness,
    pub connectivity: &'a Connectivity,
    /// Poses on which lengths are tried.
    pub poses: &'a [&'a [Point3]],
    /// Standard deviation of the noise of each coordinate, in coordinates.
    pub noise: f64,
}

/// What came of a length.
struct Tried {
    length: f64,
    /// Expected square of the error.
    risk: f64,
    /// Of the square that a vertex has to itself.
    side: f64,
    smoothed: Vec<Smoothed>,
}

/// The best length so far.
#[derive(Default)]
pub(super) struct BestLength {
    tried: Option<Tried>,
    /// Whether a longer one was worse.
    pub is_settled: bool,
}

impl LengthSearch<'_> {
    /// Goes on from the best length so far, or from the least, for as long as it gets better, up to the most.
    pub fn lengthen(&self, best: &mut BestLength, [least, most]: [f64; 2]) {
        let mut length = (best.tried.as_ref()).map_or(least, |tried| tried.length * RATIO);
        while !best.is_settled && length <= most && length > 0.0 {
            let tried = self.try_length(length, best.tried.as_ref());
            match &best.tried {
                // Risk falls and then rises with the length: the first rise ends the search.
                Some(before) if tried.risk >= before.risk => best.is_settled = true,
                _ => best.tried = Some(tried),
            }
            length *= RATIO;
        }
    }

    /// The plan of the best length, if there is one, and the poses smoothed by it.
    pub fn plan(&self, best: &BestLength) -> Option<(Plan, Vec<Smoothed>)> {
        let tried = best.tried.as_ref()?;
        // Noise that is small against edges does not change areas, and passes over smoothed ones would be wasted.
        let is_rough = self.noise > ROUGH * tried.side;
        let plan = Plan {
            noise: self.noise,
            length: tried.length,
            passes: if is_rough { PASSES } else { 0 },
        };
        let by_plan = |points: &&[Point3]| plan.smooth(self.connectivity, points);
        let smoothed = if is_rough {
            tried.smoothed.clone()
        } else {
            self.poses.iter().map(by_plan).collect()
        };
        Some((plan, smoothed))
    }

    fn try_length(&self, length: f64, before: Option<&Tried>) -> Tried {
        // What came out over one length is nearer to what comes out over the next than the poses are.
        let smoothed: Vec<Smoothed> = (self.poses.par_iter().enumerate())
            .map(|(pose, &points)| {
                let shape = before.map_or(points, |tried| &tried.smoothed[pose].once);
                smooth_from(self.connectivity, shape, points, length, PASSES)
            })
            .collect();
        let estimates: Vec<[f64; 2]> = (self.poses.par_iter().zip(&smoothed))
            .map(|(points, smoothed)| self.risk_and_area(points, smoothed, length))
            .collect();
        let mean =
            |what: usize| estimates.iter().map(|t| t[what]).sum::<f64>() / estimates.len() as f64;
        Tried {
            length,
            risk: mean(0),
            side: mean(1).sqrt(),
            smoothed,
        }
    }

    /// Expected square of the error at a length, and the mean area that a vertex has to itself.
    fn risk_and_area(&self, points: &[Point3], smoothed: &Smoothed, length: f64) -> [f64; 2] {
        let triangles = &self.connectivity.triangles;
        let normals = vertex_normals(&smoothed.once, triangles);
        let areas = vertex_areas(&smoothed.once, triangles);
        let (mut sum, mut area) = (0.0, 0.0);
        for vertex in self.roughness.inside.iter().map(|&v| v as usize) {
            // Along the normal alone: sliding in the surface is no error of the shape.
            let lost = (points[vertex] - smoothed.points[vertex]).dot(&normals[vertex]);
            let waves = 4.0 * PI * length * length / areas[vertex].max(f64::MIN_POSITIVE);
            let kept = (2.0 * waves.ln_1p() - waves / (1.0 + waves)) / waves;
            sum += lost * lost + 2.0 * self.noise * self.noise * kept;
            area += areas[vertex];
        }
        let count = self.roughness.inside.len().max(1) as f64;
        [sum / count, area / count]
    }
}
