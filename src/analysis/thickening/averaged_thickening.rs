//! Thickening averaged over neighbourhoods, and the noise that this leaves.

use super::akinetic_regions::{REMOTE_QUANTILE, area_quantile};
use super::curve::{ThickeningCurve, averaged};
use super::diffusion::Diffusion;
use super::error::ThickeningError;
use super::noise::{MIN_POSES, noise_of};
use super::params::CheckedThickeningParams;
use super::surface::Surface;

/// Averaging goes on over twice, four times… the area, up to so many times what it begins with, while noise is above [`MAX_NOISE`].
const MAX_AVERAGING: f64 = 4.0;
/// Noise of averaged thickening that is small enough, as a share of what remote myocardium does: twice as much stays below the distance, a tenth, from the core's default
/// limit to what thickens least in normal subjects, the apex. More averaging blurs small patches away. Not tuned beyond that.
const MAX_NOISE: f64 = 0.05;
/// Least thickening of remote myocardium, in standard deviations of averaged noise, that is thickening at all.
const SURE: f64 = 3.0;
/// How much larger a patch must be where too few poses are there to distinguish it from an error of one of them.
///
/// With two poses an error of either contour that neighbours share looks as stillness does. Of the 20 normal
/// subjects of ACDC (ED and ES) 7 have such a place of 2 % and more, 2 one of 4 %; all 20 infarcted ones have a patch either way.
const FEW_POSES: f64 = 2.0;

fn min_share(poses: usize, params: &CheckedThickeningParams) -> f64 {
    // With few poses noise is estimated from neighbours, and small patches are often noise.
    let factor = if poses < MIN_POSES { FEW_POSES } else { 1.0 };
    factor * params.min_share
}

/// Thickening averaged over neighbourhoods that are as large as noise asks for.
pub(super) struct AveragedThickening {
    /// Per atom, ln PT from end-diastole to end-systole.
    pub thickening: Vec<f64>,
    /// Share of the area averaged over.
    pub share: f64,
    pub diffusion: Diffusion,
    pub curve: ThickeningCurve,
    pub remote: f64,
    /// Standard deviation of the noise of `thickening`.
    pub noise: f64,
    /// And of ln r of one atom at one pose.
    pub atom_noise: f64,
    /// Least area of a patch, as a share of the regular medial surface.
    pub min_share: f64,
}

impl AveragedThickening {
    /// From centred ln r, one column per pose.
    pub fn new(
        columns: &[Vec<f64>],
        surface: &Surface,
        params: &CheckedThickeningParams,
    ) -> Result<Self, ThickeningError> {
        let Surface {
            mesh,
            middle,
            neighbours,
            phases,
            ..
        } = surface;
        let mut share = params.smoothing;
        loop {
            let diffusion = Diffusion::new(mesh, middle, share)?;
            let means = averaged(columns, &diffusion);
            let curve = ThickeningCurve::new(&means, &mesh.areas, *phases);
            let mut thickening = curve.thickening(&means);
            for (value, area) in thickening.iter_mut().zip(&mesh.areas) {
                // Atoms that take part in nothing have a value for the sake of the array only.
                if *area == 0.0 {
                    *value = 0.0;
                }
            }
            let remote = area_quantile(&thickening, &mesh.areas, REMOTE_QUANTILE);
            let noise = curve.rise * noise_of(&means, &curve, &mesh.areas, neighbours);
            // Doubling the area halves the variance of independent noise.
            let wider = 2.0 * share;
            if noise <= MAX_NOISE * remote
                || wider > MAX_AVERAGING * params.smoothing
                || share == 0.0
            {
                return Ok(Self {
                    // From what is not averaged: the tolerance of a single step is about single atoms.
                    atom_noise: noise_of(columns, &curve, &mesh.areas, neighbours),
                    thickening,
                    min_share: min_share(columns.len(), params),
                    share,
                    diffusion,
                    curve,
                    remote,
                    noise,
                });
            }
            share = wider;
        }
    }

    /// Whether even remote myocardium hardly thickens, or by no more than noise.
    pub fn hardly_thickens(&self, params: &CheckedThickeningParams) -> bool {
        self.remote < params.min_thickening.max(SURE * self.noise)
    }
}
