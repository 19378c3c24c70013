//! Which slices lie above the valve at an instant: the base of a ventricle descends in systole.

use super::beat::SliceBeat;
use super::epicardium::muscle_share;
use super::outline::{area_and_centroid, mean_radius};
use super::tones::quantile;

/// Share of the directions in which a slice of the ventricle is surrounded by muscle; the outflow tract opens a quarter.
const SURROUNDED: f64 = 0.5;
/// Share of the slices, from the base on, that the valve may leave behind: it descends by 10 to 20 mm of 80 to 100.
const MAX_LEFT: f64 = 0.35;

/// The wall of a ventricle is no thinner than this share of what it is at the first instant; that of the atrium is.
const THINNED: f64 = 0.85;
/// The area of a cavity at the base, relative to the first instant, is no greater than the median of all slices by this much:
/// the atrium fills while the ventricle empties.
const FILLED: f64 = 0.25;

/// How many slices, counted from the apex, belong to the ventricle at each instant.
///
/// From the base on, slices lie above the valve that muscle surrounds in less than half of the directions, whose wall is thinner
/// than at the first instant, or whose cavity empties less than the others. An instant that differs from both its neighbours
/// follows them. Chosen on patients of ACDC: in systole the masks of experts end where one of these holds.
pub(super) fn slices_below_valve(beats: &[SliceBeat]) -> Vec<usize> {
    let count = beats.len();
    let least = count - (MAX_LEFT * count as f64).floor() as usize;
    let instants = beats.first().map_or(0, |beat| beat.endo.len());
    let at = |instant: usize| {
        let emptied = beats.iter().map(|slice| area_ratio(slice, instant));
        let usual = quantile(emptied.collect(), 0.5).unwrap_or(1.0);
        let in_ventricle = |slice: &SliceBeat| {
            let (polar, endo, epi) = (
                &slice.polars[instant],
                &slice.endo[instant],
                &slice.epi[instant],
            );
            muscle_share(polar, &slice.tones, endo, epi) >= SURROUNDED
                && wall_mm(slice, instant) >= THINNED * wall_mm(slice, 0)
                && area_ratio(slice, instant) <= usual + FILLED
        };
        let above = beats.iter().rev().take_while(|slice| !in_ventricle(slice));
        (count - above.count()).max(least)
    };
    let counts: Vec<usize> = (0..instants).map(at).collect();
    let followed = |instant: usize| {
        let [before, after] = [instants - 1, 1].map(|by| counts[(instant + by) % instants]);
        if instants > 4 && before == after {
            before
        } else {
            counts[instant]
        }
    };
    (0..instants).map(followed).collect()
}

/// Mean thickness of the wall.
fn wall_mm(slice: &SliceBeat, instant: usize) -> f64 {
    mean_radius(&slice.epi[instant]) - mean_radius(&slice.endo[instant])
}

/// Area of the cavity relative to the first instant.
fn area_ratio(slice: &SliceBeat, instant: usize) -> f64 {
    let area = |instant: usize| area_and_centroid(&slice.corners(&slice.endo[instant])).0;
    area(instant) / area(0).max(f64::MIN_POSITIVE)
}
