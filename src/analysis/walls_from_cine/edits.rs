//! Outlines that somebody set by hand: where they lie, and what they say about the others.

use super::CineError;
use super::beat::SliceBeat;
use super::outline::radii_of;
use super::params::CineParams;
use super::slices::Slices;
use crate::image::{Contour, ContourPart};
use crate::mesh::Point3;

/// An outline in its slice of the volume.
pub(super) struct Edit<'a> {
    pub contour: &'a Contour,
    /// The slice between apex and base, if it lies in one.
    pub slice: Option<usize>,
}

/// Distance from the middle of a slice up to which an outline lies in it, in slices: as far as to the next.
const OFF_SLICE: f64 = 0.5;
/// How far an outline may leave its plane, in slices.
const OBLIQUE: f64 = 0.5;
/// Weight of not being corrected at all: one outline at the same place and instant is followed by 95 %.
const NOTHING: f64 = 0.05;

/// Puts outlines into their slices.
///
/// # Errors
/// If one has fewer than three corners, coordinates that are not numbers, or lies at an instant or in a slice that is not
/// there.
pub(super) fn placed<'a>(
    slices: &Slices<'_>,
    edits: &'a [Contour],
) -> Result<Vec<Edit<'a>>, CineError> {
    let place = |(number, contour): (usize, &'a Contour)| {
        let error = |reason| CineError::Edit {
            number,
            instant: contour.instant,
            reason,
        };
        if contour.instant >= slices.instants() {
            return Err(error("the image has no such instant"));
        }
        if contour.points.len() < 3 {
            return Err(error("it has fewer than three corners"));
        }
        if !contour
            .points
            .iter()
            .all(|p| p.iter().all(|x| x.is_finite()))
        {
            return Err(error("its coordinates are not numbers"));
        }
        let heights = contour.points.iter().map(|&point| slices.height(point));
        let [low, high] = heights.fold([f64::MAX, f64::MIN], |[low, high], h| {
            [low.min(h), high.max(h)]
        });
        let number = (0.5 * (low + high)).round();
        if !(0.0..slices.in_volume() as f64).contains(&number) {
            return Err(error("it lies outside of the image"));
        }
        if high - low > OBLIQUE || (0.5 * (low + high) - number).abs() > OFF_SLICE {
            return Err(error("it is oblique to the slices"));
        }
        Ok(Edit {
            contour,
            slice: slices.with_number(number as usize),
        })
    };
    edits.iter().enumerate().map(place).collect()
}

/// What an outline set by hand changes: radii less those that were found.
struct Correction {
    slice: usize,
    instant: usize,
    by: Vec<f64>,
}

/// Moves outlines that were found towards what outlines set by hand say.
///
/// The correction at a slice and instant is Σ wᵢ Δᵢ / (0.05 + Σ wᵢ), where Δᵢ are the differences of radii between outlines set
/// by hand and those found at the same place, and wᵢ = 2^(−t/τ) 2^(−z/ζ) for distances t around the beat and z along the axis. At
/// the place of an outline set by hand it is followed entirely.
pub(super) fn corrected(
    beats: &mut [SliceBeat],
    edits: &[Edit<'_>],
    part: ContourPart,
    slices: &Slices<'_>,
    params: &CineParams,
) {
    let corrections: Vec<Correction> = (edits.iter())
        .filter(|edit| edit.contour.part == part)
        .filter_map(|edit| correction(beats, edit, slices))
        .collect();
    if corrections.is_empty() {
        return;
    }
    for (slice, beat) in beats.iter_mut().enumerate() {
        let instants = beat.endo.len();
        for instant in 0..instants {
            let exact = corrections
                .iter()
                .rev()
                .find(|c| c.slice == slice && c.instant == instant);
            let by = match exact {
                Some(correction) => correction.by.clone(),
                None => interpolated(&corrections, |c| {
                    let apart = c.instant.abs_diff(instant);
                    let beats = apart.min(instants - apart) as f64 / instants as f64;
                    let mm = c.slice.abs_diff(slice) as f64 * slices.step_mm();
                    (-beats / params.edit_reach_beats - mm / params.edit_reach_mm).exp2()
                }),
            };
            let radii = outlines(beat, part).get_mut(instant);
            (radii.into_iter().flatten().zip(by))
                .for_each(|(radius, by)| *radius = (*radius + by).max(0.0));
        }
    }
}

fn outlines(beat: &mut SliceBeat, part: ContourPart) -> &mut Vec<Vec<f64>> {
    match part {
        ContourPart::Epicardium => &mut beat.epi,
        _ => &mut beat.endo,
    }
}

/// `None` if it lies in no slice between apex and base, or around something else than the middle of the cavity.
fn correction(beats: &mut [SliceBeat], edit: &Edit<'_>, slices: &Slices<'_>) -> Option<Correction> {
    let slice = edit.slice?;
    let beat = beats.get_mut(slice)?;
    let place = |&point: &Point3| slices.place_in(slice, point);
    let polygon: Vec<_> = edit.contour.points.iter().map(place).collect();
    let set = radii_of(&polygon, beat.middle)?;
    let found = outlines(beat, edit.contour.part).get(edit.contour.instant)?;
    Some(Correction {
        slice,
        instant: edit.contour.instant,
        by: set
            .iter()
            .zip(found)
            .map(|(set, found)| set - found)
            .collect(),
    })
}

fn interpolated(corrections: &[Correction], weight: impl Fn(&Correction) -> f64) -> Vec<f64> {
    let mut sum = vec![0.0; corrections.first().map_or(0, |c| c.by.len())];
    let mut weights = NOTHING;
    for correction in corrections {
        let weight = weight(correction);
        weights += weight;
        (sum.iter_mut().zip(&correction.by)).for_each(|(sum, by)| *sum += weight * by);
    }
    sum.into_iter().map(|sum| sum / weights).collect()
}
