//! How all poses of a wall are smoothed, and how thick the wall is then.

use std::borrow::Cow;

use rayon::prelude::*;

use super::connectivity::Connectivity;
use super::error::MedialError;
use super::length_search::{BestLength, LengthSearch, Plan};
use super::params::CheckedMedialParams;
use super::smoothing::Smoothed;
use super::wall_atlas::WallAtlas;
use crate::mesh::Point3;
use crate::progress::Progress;

/// Noise over the typical thickness up to which the least smoothing is enough: of smooth surfaces the estimate is less.
/// Half a per cent of the thickness is far below what thickening is about: a search for a longer length would cost time
/// for nothing.
const HARDLY_ROUGH: f64 = 0.005;

/// Longest ℓ in typical thicknesses that noise can ask for.
const MAX_LENGTH: f64 = 1.5;

/// Noise makes walls look thin. Where they are so many times as thick without it, longer lengths are tried as well: below a
/// quarter more, lengths that are tried, √2 apart, would hardly be others. Not tuned.
const THICKER: f64 = 1.25;

/// How many times longer lengths are tried in all: a bound on time, each round smooths two poses again. Not tuned.
const ROUNDS: usize = 3;

/// What is known of a wall's poses before spheres are fitted into it.
#[derive(Clone, Debug)]
pub(super) struct Prepared {
    /// About how thick the wall is, in coordinates.
    pub thickness: f64,
    pub plan: Plan,
    /// Poses that are smoothed by the plan already, with their numbers.
    smoothed: Vec<(usize, Smoothed)>,
}

impl Prepared {
    fn new(thickness: f64, plan: Plan) -> Self {
        Self {
            thickness,
            plan,
            smoothed: Vec::new(),
        }
    }

    /// A pose smoothed by the plan.
    pub fn smoothed(
        &self,
        connectivity: &Connectivity,
        pose: usize,
        points: &[Point3],
    ) -> Cow<'_, Smoothed> {
        match self.smoothed.iter().find(|(number, _)| *number == pose) {
            Some((_, smoothed)) => Cow::Borrowed(smoothed),
            None => Cow::Owned(self.plan.smooth(connectivity, points)),
        }
    }
}

impl WallAtlas {
    /// How poses of a wall about as thick as this are smoothed, and how thick they are when noise that makes walls look thin
    /// is off them.
    ///
    /// # Errors
    /// If it was stopped.
    pub fn plan(
        &self,
        poses: &[&[Point3]],
        thickness: f64,
        params: &CheckedMedialParams,
        progress: &Progress,
    ) -> Result<Prepared, MedialError> {
        let least = Plan {
            noise: 0.0,
            length: params.smoothing * thickness,
            passes: 0,
        };
        // Asked for surfaces as they are.
        if params.smoothing <= 0.0 || poses.is_empty() {
            return Ok(Prepared::new(thickness, least));
        }
        // Every pose is looked at, since noise may differ, but one length is used for all: ratios of radii must
        // compare equally smooth walls.
        let mut noises: Vec<f64> = (poses.par_iter())
            .map(|points| {
                progress.check()?;
                Ok(self.roughness.of(&self.connectivity, points))
            })
            .collect::<Result<_, MedialError>>()?;
        let middle = noises.len() / 2;
        // The median: one bad frame must not blur the whole beat.
        let noise = *noises.select_nth_unstable_by(middle, f64::total_cmp).1;
        let least = Plan { noise, ..least };
        if noise <= HARDLY_ROUGH * thickness {
            return Ok(Prepared::new(thickness, least));
        }
        // The first pose and one well on: usually end-diastole and near end-systole.
        let sample = [0, (poses.len() / 3).max(1)];
        let sample = &sample[..poses.len().min(2)];
        let tried: Vec<&[Point3]> = sample.iter().map(|&pose| poses[pose]).collect();
        let search = LengthSearch {
            roughness: &self.roughness,
            connectivity: &self.connectivity,
            poses: &tried,
            noise,
        };
        let mut best = BestLength::default();
        let mut prepared = Prepared::new(thickness, least);
        // The longest length to be tried depends on the thickness, and the thickness on the smoothing.
        for _ in 0..ROUNDS {
            let looked = prepared.thickness;
            let most = params.smoothing.max(MAX_LENGTH) * looked;
            search.lengthen(&mut best, [least.length, most]);
            progress.check()?;
            let Some((plan, smoothed)) = search.plan(&best) else {
                break;
            };
            // Shorter lengths leave the thickness as it was measured.
            if plan.length > least.length {
                prepared.thickness = (smoothed.iter())
                    .map(|smoothed| self.thickness(&smoothed.points))
                    // Noise only makes walls look thin, so that the largest of the estimates is nearest.
                    .fold(looked, f64::max);
            }
            prepared.plan = plan;
            prepared.smoothed = sample.iter().copied().zip(smoothed).collect();
            if best.is_settled || prepared.thickness <= THICKER * looked {
                break;
            }
        }
        // The setting is a share of the thickness, which has just been found to be larger; smoothed poses are then
        // stale.
        let length = params.smoothing * prepared.thickness;
        if THICKER * prepared.plan.length < length {
            prepared.plan.length = length;
            prepared.smoothed.clear();
        }
        Ok(prepared)
    }
}
