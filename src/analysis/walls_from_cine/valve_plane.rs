//! Which slices lie above the valve at an instant: the base of a ventricle descends in systole.

use super::beat::SliceBeat;
use super::epicardium::muscle_share;

/// Share of the directions in which a slice of the ventricle is surrounded by muscle; the outflow tract opens a quarter.
const SURROUNDED: f64 = 0.5;
/// Share of the slices, from the base on, that the valve may leave behind: it descends by 10 to 20 mm of 80 to 100.
const MOST_LEFT: f64 = 0.35;

/// How many slices, counted from the apex, belong to the ventricle at each instant.
///
/// From the base on, slices that muscle surrounds in less than half of the directions lie above the valve. An instant that
/// differs from both its neighbours follows them.
pub(super) fn slices_below_valve(beats: &[SliceBeat]) -> Vec<usize> {
    let count = beats.len();
    let least = count - (MOST_LEFT * count as f64).floor() as usize;
    let instants = beats.first().map_or(0, |beat| beat.endo.len());
    let at = |instant: usize| {
        let surrounded = |slice: &SliceBeat| {
            let (polar, endo, epi) = (
                &slice.polars[instant],
                &slice.endo[instant],
                &slice.epi[instant],
            );
            muscle_share(polar, &slice.tones, endo, epi) >= SURROUNDED
        };
        let above = beats
            .iter()
            .rev()
            .take_while(|slice| !surrounded(slice))
            .count();
        (count - above).max(least)
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
