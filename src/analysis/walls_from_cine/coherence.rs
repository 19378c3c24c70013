//! Outlines of all slices and instants together: neighbours in time and along the axis pull at each other.

use rayon::prelude::*;

use super::beat::{SliceBeat, tidied};
use super::endocardium::{Pull, endocardium};
use super::epicardium::epicardium;
use super::outline::{mean_radius, smooth};
use super::params::CineParams;
use super::polar::RAYS;
use super::tones::quantile;
use crate::progress::{Progress, Stopped};

/// Pull of neighbouring instants, per mm²: at 5 mm a quarter of an edge.
const IN_TIME: f64 = 0.01;
/// Pull of neighbouring slices, per mm².
const ALONG_AXIS: f64 = 0.004;
/// Pull of the usual thickness of the wall in a slice, per mm².
const THICKNESS: f64 = 0.004;
/// Instants of a beat from which on neighbours pull with their whole weight; of fewer each is farther from the next.
const DENSE: f64 = 20.0;
/// Sweeps in which neighbours pull at each other.
const SWEEPS: usize = 3;
/// Harmonics of an epicardium.
const EPI_HARMONICS: usize = 6;

/// Outlines by slice, instant and ray.
type Outlines = Vec<Vec<Vec<f64>>>;

/// The endocardium of every slice and instant once more, with the pull of neighbours.
pub(super) fn settle_endocardium(
    beats: &mut [SliceBeat],
    params: &CineParams,
    progress: &Progress,
) -> Result<(), Stopped> {
    for _ in 0..SWEEPS {
        let before: Outlines = beats.iter().map(|beat| beat.endo.clone()).collect();
        for (slice, beat) in beats.iter_mut().enumerate() {
            let (polars, tones) = (&beat.polars, &beat.tones);
            let path = |(instant, polar)| {
                progress.step()?;
                let pulls = neighbours(&before, slice, instant, params.coherence);
                Ok(tidied(&endocardium(
                    polar,
                    tones,
                    (params.endocardium, params.max_radius_mm),
                    &pulls,
                )))
            };
            let endo = polars
                .par_iter()
                .enumerate()
                .map(path)
                .collect::<Result<Vec<_>, Stopped>>()?;
            beat.tones = beat.tones.renewed(&beat.polars, &endo);
            beat.endo = endo;
        }
    }
    beats
        .iter_mut()
        .for_each(|beat| beat.endo = smooth_in_time(&beat.endo, params.coherence));
    Ok(())
}

/// The epicardium of every slice and instant around its endocardium.
pub(super) fn settle_epicardium(
    beats: &mut [SliceBeat],
    params: &CineParams,
    progress: &Progress,
) -> Result<(), Stopped> {
    let wall_mm = [params.min_wall_mm, params.max_wall_mm];
    for sweep in 0..SWEEPS {
        let before: Outlines = beats.iter().map(|beat| beat.epi.clone()).collect();
        for (slice, beat) in beats.iter_mut().enumerate() {
            let (polars, tones, endo) = (&beat.polars, &beat.tones, &beat.endo);
            let path = |(instant, polar)| {
                progress.step()?;
                let mut pulls = Vec::new();
                if sweep > 0 {
                    pulls = neighbours(&before, slice, instant, params.coherence);
                    pulls.push(usual_thickness(&endo[instant], &before[slice][instant]));
                }
                let found = epicardium(polar, tones, &endo[instant], wall_mm, &pulls);
                Ok(smooth(&found, EPI_HARMONICS))
            };
            beat.epi = polars
                .par_iter()
                .enumerate()
                .map(path)
                .collect::<Result<Vec<_>, Stopped>>()?;
        }
    }
    for beat in beats {
        beat.epi = smooth_in_time(&beat.epi, params.coherence);
        // Smoothing may bring both outlines together.
        for (epi, endo) in beat.epi.iter_mut().zip(&beat.endo) {
            (epi.iter_mut().zip(endo))
                .for_each(|(epi, endo)| *epi = epi.max(endo + params.min_wall_mm));
        }
    }
    Ok(())
}

/// What the neighbours in time and along the axis say about an outline.
fn neighbours(outlines: &Outlines, slice: usize, instant: usize, coherence: f64) -> Vec<Pull> {
    let own = &outlines[slice];
    let count = own.len();
    let mut pulls = Vec::new();
    if count > 2 {
        let [before, after] = [count - 1, 1].map(|by| &own[(instant + by) % count]);
        pulls.push(Pull {
            radii: mean_of(before, after),
            weight: coherence * IN_TIME * in_time(count),
        });
    }
    if slice > 0 && slice + 1 < outlines.len() {
        let [below, above] = [slice - 1, slice + 1].map(|slice| &outlines[slice][instant]);
        // Along the axis the shape is alike, less so the size.
        let shape = mean_of(below, above);
        let by = 0.5 * (mean_radius(&own[instant]) - mean_radius(&shape));
        pulls.push(Pull {
            radii: shape.iter().map(|radius| radius + by).collect(),
            weight: coherence * ALONG_AXIS,
        });
    }
    pulls
}

fn mean_of(a: &[f64], b: &[f64]) -> Vec<f64> {
    a.iter().zip(b).map(|(a, b)| 0.5 * (a + b)).collect()
}

/// How near instants are to each other, 0 to 1.
fn in_time(instants: usize) -> f64 {
    (instants as f64 / DENSE).powi(2).min(1.0)
}

/// The endocardium and the median thickness around it.
fn usual_thickness(endo: &[f64], epi: &[f64]) -> Pull {
    let walls = epi.iter().zip(endo).map(|(epi, endo)| epi - endo);
    let usual = quantile(walls.collect(), 0.5).unwrap_or(0.0);
    Pull {
        radii: endo.iter().map(|radius| radius + usual).collect(),
        weight: THICKNESS,
    }
}

/// Each outline with a quarter of the one before and of the one after, around the beat; less where instants are far apart.
fn smooth_in_time(beat: &[Vec<f64>], coherence: f64) -> Vec<Vec<f64>> {
    let count = beat.len();
    let share = 0.25 * in_time(count) * coherence.min(1.0);
    let at = |instant: usize| {
        let [before, after] = [count - 1, 1].map(|by| &beat[(instant + by) % count]);
        let ray = |ray: usize| {
            let own = beat[instant][ray];
            own + share * (before[ray] + after[ray] - 2.0 * own)
        };
        (0..RAYS).map(ray).collect()
    };
    (0..count).map(at).collect()
}
