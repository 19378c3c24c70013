//! Outlines of one slice over the beat.

use rayon::prelude::*;

use super::endocardium::{Pull, endocardium};
use super::outline::{area_and_centroid, corners, hull, smooth};
use super::params::CineParams;
use super::polar::Polar;
use super::slices::{Place, Slices};
use super::tones::Tones;
use crate::progress::{Progress, Stopped};

/// One slice: its values around a middle that stays over the beat, and outlines at each instant as radii in millimetres.
#[derive(Clone, Debug)]
pub(super) struct SliceBeat {
    pub middle: Place,
    pub tones: Tones,
    pub polars: Vec<Polar>,
    pub endo: Vec<Vec<f64>>,
    pub epi: Vec<Vec<f64>>,
}

/// Searches for the middle of a slice.
const RECENTRINGS: usize = 3;
/// A middle that moves by less stays, in millimetres.
const STAYS_MM: f64 = 0.7;
/// A middle moves by no more than this from where the neighbouring slice leads, in millimetres: breath-holds differ.
const DRIFT_MM: f64 = 8.0;
/// Pull of the neighbouring slice while slices are followed, per mm².
const FOLLOWED: f64 = 0.002;
/// Harmonics of an endocardium without its muscles.
const HARMONICS: usize = 7;

impl SliceBeat {
    /// The endocardium of a slice over the beat, from a place within the cavity; `neighbour` holds the radii of the slice
    /// that was followed before.
    pub(super) fn followed(
        slices: &Slices<'_>,
        slice: usize,
        (mut middle, mut tones): (Place, Tones),
        neighbour: Option<&Self>,
        params: &CineParams,
        progress: &Progress,
    ) -> Result<Self, Stopped> {
        let mut found = None;
        let (led_to, first_tones) = (middle, tones);
        let max_mm = if neighbour.is_some() {
            DRIFT_MM
        } else {
            params.max_radius_mm
        };
        for _ in 0..=RECENTRINGS {
            let polars = Self::sampled(slices, slice, middle, params, progress)?;
            let pull = |instant: usize| {
                let radii = neighbour?.endo.get(instant)?.clone();
                Some(Pull {
                    radii,
                    weight: FOLLOWED,
                })
            };
            let path = |(instant, polar): (usize, &Polar)| {
                progress.check()?;
                let pulls: Vec<Pull> = pull(instant).into_iter().collect();
                Ok(tidied(&endocardium(
                    polar,
                    &tones,
                    (params.endocardium, params.max_radius_mm),
                    &pulls,
                )))
            };
            let endo = polars
                .par_iter()
                .enumerate()
                .map(path)
                .collect::<Result<Vec<_>, Stopped>>()?;
            tones = first_tones.renewed(&polars, &endo);
            let away = mean_centroid(&endo);
            found = Some((polars, endo, middle));
            if away.norm() < STAYS_MM {
                break;
            }
            let moved = middle + away - led_to;
            middle = led_to + moved * (max_mm / moved.norm().max(max_mm));
        }
        let (polars, endo, middle) = found.unwrap_or_default();
        Ok(Self {
            middle,
            tones,
            polars,
            endo,
            epi: Vec::new(),
        })
    }

    fn sampled(
        slices: &Slices<'_>,
        slice: usize,
        middle: Place,
        params: &CineParams,
        progress: &Progress,
    ) -> Result<Vec<Polar>, Stopped> {
        let reach_mm = params.max_radius_mm + params.max_wall_mm;
        let polar = |instant| {
            progress.check()?;
            Ok(Polar::of(slices, instant, slice, middle, reach_mm))
        };
        (0..slices.instants()).into_par_iter().map(polar).collect()
    }

    /// Corners of an outline in the world of the slice.
    pub(super) fn corners(&self, radii: &[f64]) -> Vec<Place> {
        corners(radii, self.middle)
    }
}

/// Without muscles that stand into the cavity, and smooth.
pub(super) fn tidied(radii: &[f64]) -> Vec<f64> {
    let smooth = smooth(&hull(radii), HARMONICS);
    smooth.into_iter().map(|radius| radius.max(0.0)).collect()
}

/// Where the middles of outlines lie on the mean over the beat.
fn mean_centroid(beat: &[Vec<f64>]) -> Place {
    let centroids = beat
        .iter()
        .map(|radii| area_and_centroid(&corners(radii, Place::zeros())).1);
    centroids.sum::<Place>() / beat.len().max(1) as f64
}
