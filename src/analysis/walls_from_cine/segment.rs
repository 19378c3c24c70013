//! The road from three marked points to the outlines of both surfaces over the beat.

use super::CineError;
use super::beat::SliceBeat;
use super::coherence::{settle_endocardium, settle_epicardium};
use super::edits::{Edit, corrected, placed};
use super::endocardium::edge;
use super::outline::mean_radius;
use super::params::{CheckedCineParams, CineParams};
use super::slices::{Place, Slices};
use super::tones::Tones;
use super::valve_plane::slices_below_valve;
use crate::image::{Contour, ContourPart, Image, MarkedPoints};
use crate::progress::{Progress, Stopped};
use crate::study::Notice;

/// The outlines of both surfaces and how they came about.
#[derive(Clone, Debug)]
pub struct CineSegmentation {
    /// Endocardium and epicardium by instant and slice from the apex on; a slice without cavity has an epicardium alone, and a
    /// slice above the valve none. Those set by hand are as they were set.
    pub contours: Vec<Contour>,
    /// What was found, assumed and left out.
    pub notices: Vec<Notice>,
}

/// A mean edge of the blood below which there is none: half of what noise leaves of a real one.
const MIN_EDGE: f64 = 0.3;
/// A cavity with a smaller mean radius is none, in millimetres: two voxels across.
const MIN_RADIUS_MM: f64 = 2.5;
/// How far from where the axis leads the middle of the next slice is looked for, in millimetres: breath-holds differ.
const MIDDLE_WITHIN_MM: f64 = 8.0;
/// Share of blood that a millimetre away from the axis must gain.
const AWAY: f64 = 0.03;

/// The outlines of endocardium and epicardium in the short-axis slices between apex and base of a cine image, at every instant.
///
/// 1. Blood has the value around the marked point, muscle that of the first dark piece of the rays from there on.
/// 2. In the slice of the point and then in one slice after the other, the endocardium is the closed path of least cost in polar
///    coordinates (see `endocardium`); its middle and the values of blood and muscle are renewed from it.
/// 3. Paths are sought again with the pull of their neighbours in time (around the beat) and along the axis. Papillary muscles lie
///    within the convex hull of the path.
/// 4. The epicardium is the closed path around it up to which there is muscle (see `epicardium`).
/// 5. Outlines set by hand (`edits`, in the plane of a slice) take the place of those found, and move their neighbours.
/// 6. Slices at the base that lie above the valve at an instant are left out of it (see `valve_plane`).
///
/// `points` needs blood, apex and base, as they are at the first instant. The result lies in the planes of the slices, in the world of the image.
///
/// # Errors
/// If a point is missing or wrong, the blood is dark or without edge, an edit has no place; or if it was asked to stop.
pub fn segment_cine(
    image: &Image,
    points: &MarkedPoints,
    edits: &[Contour],
    params: &CheckedCineParams,
    progress: &Progress,
) -> Result<CineSegmentation, CineError> {
    let params = params.get();
    let slices = Slices::of(image, points)?;
    let edits = placed(&slices, edits)?;
    progress.begin_phase("following the cavity", 0.0, 0.5);
    let mut beats = all_slices(&slices, &params, progress)?;
    progress.begin_phase("finding the endocardium", 0.5, 0.8);
    progress.expect_steps(3 * slices.count() * slices.instants());
    settle_endocardium(&mut beats, &params, progress)?;
    progress.begin_phase("finding the epicardium", 0.8, 1.0);
    let rounds = if edits.is_empty() { 3 } else { 6 };
    progress.expect_steps(rounds * slices.count() * slices.instants());
    settle_epicardium(&mut beats, &params, progress)?;
    // Before anything is moved: a correction of one instant would look like a change of the wall.
    let below = slices_below_valve(&beats);
    if !edits.is_empty() {
        corrected(
            &mut beats,
            &edits,
            ContourPart::Endocardium,
            &slices,
            &params,
        );
        settle_epicardium(&mut beats, &params, progress)?;
    }
    corrected(
        &mut beats,
        &edits,
        ContourPart::Epicardium,
        &slices,
        &params,
    );
    Ok(outlined(&slices, &beats, &edits, &below))
}

/// The endocardium of all slices, each from the one before, beginning at the marked point.
fn all_slices(
    slices: &Slices<'_>,
    params: &CineParams,
    progress: &Progress,
) -> Result<Vec<SliceBeat>, CineError> {
    progress.expect_steps(slices.count());
    let (start, place) = slices.blood();
    let tones = Tones::marked(slices, start, place)?;
    let first = SliceBeat::followed(slices, start, (place, tones), None, params, progress)?;
    progress.step()?;
    let edges = first.polars.iter().zip(&first.endo);
    let sum: f64 = edges
        .map(|(polar, radii)| edge(polar, &first.tones, radii))
        .sum();
    let found = sum / slices.instants() as f64;
    if found < MIN_EDGE {
        return Err(CineError::NoEdge {
            found_percent: 100.0 * found.max(0.0),
            min_percent: 100.0 * MIN_EDGE,
        });
    }
    let mut beats = vec![first];
    for slice in start + 1..slices.count() {
        let next = next_slice(slices, (slice - 1, slice), beats.last(), params, progress)?;
        beats.extend(next);
    }
    beats.reverse();
    for slice in (0..start).rev() {
        let next = next_slice(slices, (slice + 1, slice), beats.last(), params, progress)?;
        beats.extend(next);
    }
    beats.reverse();
    Ok(beats)
}

fn next_slice(
    slices: &Slices<'_>,
    (from, to): (usize, usize),
    before: Option<&SliceBeat>,
    params: &CineParams,
    progress: &Progress,
) -> Result<Option<SliceBeat>, Stopped> {
    progress.step()?;
    let Some(before) = before else {
        return Ok(None);
    };
    let led_to = before.middle + slices.on_axis(to) - slices.on_axis(from);
    let middle = brightest(slices, to, led_to, &before.tones);
    SliceBeat::followed(
        slices,
        to,
        (middle, before.tones),
        Some(before),
        params,
        progress,
    )
    .map(Some)
}

/// The place near one where there is most blood over the beat, within a disc of 4 mm.
fn brightest(slices: &Slices<'_>, slice: usize, near: Place, tones: &Tones) -> Place {
    let grid = |reach: f64, step: f64| {
        let count = (reach / step) as i32;
        let line = move || (-count..=count).map(move |n| f64::from(n) * step);
        let places = line().flat_map(move |y| line().map(move |x| Place::new(x, y)));
        places.filter(move |place| place.norm() <= reach)
    };
    let every = (slices.instants() / 6).max(1);
    let blood_at = |place: Place| {
        let values = (0..slices.instants())
            .step_by(every)
            .filter_map(|instant| slices.value(instant, slice, place));
        values.map(|value| tones.blood_share(value)).sum::<f64>()
    };
    let instants = slices.instants().div_ceil(every) as f64;
    let score = |away: &Place| {
        let disc: Vec<f64> = grid(4.0, 2.0)
            .map(|by| blood_at(near + away + by))
            .collect();
        disc.iter().sum::<f64>() / (instants * disc.len() as f64) - AWAY * away.norm()
    };
    let scored = grid(MIDDLE_WITHIN_MM, 2.0).map(|away| (score(&away), away));
    let best = scored.max_by(|a, b| a.0.total_cmp(&b.0));
    near + best.map_or_else(Place::zeros, |(_, away)| away)
}

/// Contours of all that was found and set.
fn outlined(
    slices: &Slices<'_>,
    beats: &[SliceBeat],
    edits: &[Edit<'_>],
    below: &[usize],
) -> CineSegmentation {
    let mut contours = Vec::new();
    let mut without_cavity = 0;
    for (instant, &count) in below.iter().enumerate() {
        for (slice, beat) in beats.iter().enumerate().take(count) {
            let outlines = [
                (ContourPart::Endocardium, &beat.endo[instant]),
                (ContourPart::Epicardium, &beat.epi[instant]),
            ];
            for (part, radii) in outlines {
                let is_set = |edit: &Edit<'_>| {
                    (edit.slice, edit.contour.instant, edit.contour.part)
                        == (Some(slice), instant, part)
                };
                if edits.iter().any(is_set) {
                    continue;
                }
                if mean_radius(radii) < MIN_RADIUS_MM {
                    without_cavity += 1;
                    continue;
                }
                let corners = beat.corners(radii);
                contours.push(Contour {
                    instant,
                    part,
                    points: corners
                        .into_iter()
                        .map(|place| slices.position(slice, place))
                        .collect(),
                });
            }
        }
    }
    let found = contours.len();
    contours.extend(edits.iter().map(|edit| edit.contour.clone()));
    CineSegmentation {
        notices: notices(slices, below, [found, edits.len(), without_cavity]),
        contours,
    }
}

fn notices(
    slices: &Slices<'_>,
    below: &[usize],
    [found, set, without_cavity]: [usize; 3],
) -> Vec<Notice> {
    let mut notices = vec![Notice::info(format!(
        "{found} outlines found in {} slices and {} instants, {set} set by hand",
        slices.count(),
        slices.instants()
    ))];
    let left = below
        .iter()
        .filter(|&&count| count < slices.count())
        .count();
    if left > 0 {
        let least = below.iter().min().copied().unwrap_or(0);
        notices.push(Notice::info(format!(
            "slices at the base that lie above the valve are left out: up to {} at {left} instants",
            slices.count() - least
        )));
    }
    if without_cavity > 0 {
        notices.push(Notice::info(format!(
            "{without_cavity} outlines have no cavity: there the wall is closed"
        )));
    }
    notices
}
