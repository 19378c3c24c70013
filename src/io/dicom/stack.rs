//! From planes of one grid to a volume at each instant: slices by their positions, then instants within each slice.

use std::collections::HashMap;

use super::group::{Group, SAME_PLACE_MM};
use super::instants::{ChosenKey, Slice, choose_key, drop_incomplete, sort_by_key};
use super::plane::{INSTANT_KEYS, InstantKey, Plane};
use crate::mesh::{Point3, Vector3};
use crate::study::Notice;

/// Slices at even distances, each with the same number of instants in their order.
#[derive(Clone, Debug)]
pub(super) struct Stack {
    pub(super) slices: Vec<Slice>,
    /// By what the instants are ordered; `None` if there is one.
    pub(super) key: Option<ChosenKey>,
    /// Where the first pixel of the first slice stands.
    pub(super) origin: Point3,
    /// The step from a slice to the next, also sideways (a tilted gantry); `None` for a single slice.
    pub(super) step: Option<Vector3>,
    pub(super) notices: Vec<Notice>,
}

/// Positions may be off an even distance by this share of it: positions are written with few digits.
const UNEVEN: f64 = 0.02;
/// And by so much in millimetres at least.
const UNEVEN_MM: f64 = 0.02;
/// So many acquisitions of the same slices are kept apart; more are taken for instants.
const MAX_ACQUISITIONS: usize = 3;

/// The stacks of a group: one, or one for each acquisition that repeats all slices without saying when.
///
/// # Errors
/// The reason why the group is no stack, as text.
pub(super) fn stacks(group: Group) -> Result<Vec<Stack>, String> {
    let Group {
        planes,
        mut notices,
    } = group;
    let mut slices = slices_of(planes)?;
    drop_copies(&mut slices, &mut notices);
    if slices.iter().all(|slice| slice.planes.len() == 1) {
        return Ok(vec![finished(slices, None, notices)?]);
    }
    let key = choose_key(&slices);
    let told = key.is_some_and(|key| {
        use InstantKey::{AfterRWave, Index, Percent, Reference};
        matches!(key.key, AfterRWave | Percent | Index | Reference)
    });
    if !told && let Some(parts) = by_acquisition(&slices) {
        let note = Notice::warning(format!(
            "one series holds {} acquisitions of the same slices without times in a beat; each stands for itself",
            parts.len()
        ));
        let parts = parts.into_iter().map(|slices| {
            let notices = notices.iter().cloned().chain([note.clone()]).collect();
            finished(slices, None, notices)
        });
        return parts.collect();
    }
    let Some(key) = key else {
        return Err(
            "several images stand at one place, and nothing tells their instants apart".to_owned(),
        );
    };
    if !told {
        notices.push(Notice::warning(format!(
            "several images stand at each place without a time in the beat; they are ordered by {}",
            key.name
        )));
    }
    sort_by_key(&mut slices, key);
    let dropped = drop_incomplete(&mut slices, key)?;
    if !dropped.is_empty() {
        let numbers: Vec<String> = dropped.iter().map(usize::to_string).collect();
        notices.push(Notice::warning(format!(
            "instant {} is left out, since not all slices have it",
            numbers.join(", ")
        )));
    }
    Ok(vec![finished(slices, Some(key), notices)?])
}

/// Planes that stand together, in the order along their normal.
fn slices_of(mut planes: Vec<Plane>) -> Result<Vec<Slice>, String> {
    let Some(place) = planes.first().and_then(|plane| plane.place) else {
        return Err("its position and orientation are not said".to_owned());
    };
    let normal = place.normal();
    // The sort keeps the order of equal ones: that of the files.
    planes.sort_by(|a, b| a.along(normal).total_cmp(&b.along(normal)));
    let mut slices: Vec<Slice> = Vec::new();
    for plane in planes {
        let along_mm = plane.along(normal);
        match slices.last_mut() {
            Some(slice) if along_mm - slice.along_mm < SAME_PLACE_MM => slice.planes.push(plane),
            _ => slices.push(Slice {
                along_mm,
                planes: vec![plane],
            }),
        }
    }
    for slice in &slices {
        let place = |plane: &Plane| plane.place.map(|place| place.origin);
        let first = slice.planes.first().and_then(place);
        let aside = |plane: &Plane| match (place(plane), first) {
            (Some(own), Some(first)) => (own - first).norm() > 2.0 * SAME_PLACE_MM,
            _ => true,
        };
        if slice.planes.iter().any(aside) {
            return Err(format!(
                "images {:.2} mm along their normal are shifted against each other within their plane",
                slice.along_mm
            ));
        }
    }
    Ok(slices)
}

/// Drops planes that are there twice: the same numbers at the same place and time. Equal numbers alone are no reason where times differ, nor are equal times where numbers differ.
fn drop_copies(slices: &mut [Slice], notices: &mut Vec<Notice>) {
    let before = uneven_counts(slices);
    let kept: Vec<Vec<bool>> = slices.iter().map(originals).collect();
    let dropped = kept.iter().flatten().filter(|&&kept| !kept).count();
    if dropped == 0 {
        return;
    }
    let mut thinned = slices.to_vec();
    for (slice, kept) in thinned.iter_mut().zip(&kept) {
        let mut kept = kept.iter();
        slice
            .planes
            .retain(|_| kept.next().copied().unwrap_or(true));
    }
    // Empty slices are alike at all instants; that they are there at each says that they are no copies.
    if !before && uneven_counts(&thinned) {
        return;
    }
    slices.clone_from_slice(&thinned);
    notices.push(Notice::info(format!(
        "left out as copies of others at the same place (equal pixels): {dropped}"
    )));
}

fn uneven_counts(slices: &[Slice]) -> bool {
    let mut counts = slices.iter().map(|slice| slice.planes.len());
    let first = counts.next();
    counts.any(|count| Some(count) != first)
}

/// Which planes of a slice are no copies of an earlier one.
fn originals<'a>(slice: &'a Slice) -> Vec<bool> {
    let mut timed: HashMap<Vec<Option<u64>>, usize> = HashMap::new();
    for plane in &slice.planes {
        *timed.entry(times(plane)).or_default() += 1;
    }
    let mut by_numbers: HashMap<(Vec<Option<u64>>, u64), Vec<&Plane>> = HashMap::new();
    let original = |plane: &'a Plane| {
        let time = times(plane);
        if timed.get(&time) == Some(&1) {
            return true;
        }
        let same = by_numbers.entry((time, plane.pixels.digest(plane.frame)));
        let same = same.or_default();
        let copied = same.iter().any(|other| other.same_numbers(plane));
        same.push(plane);
        !copied
    };
    slice.planes.iter().map(original).collect()
}

/// What is said of the instant but for the time of the day and the number of the image, which differ between copies.
fn times(plane: &Plane) -> Vec<Option<u64>> {
    let known = INSTANT_KEYS.iter().zip(plane.when.0);
    known
        .filter(|((key, _), _)| !matches!(key, InstantKey::Clock | InstantKey::Instance))
        .map(|(_, time)| time.map(f64::to_bits))
        .collect()
}

/// The slices of each acquisition, if there are a few and each has every slice once.
fn by_acquisition(slices: &[Slice]) -> Option<Vec<Vec<Slice>>> {
    let number = |plane: &Plane| plane.facts.acquisition.map(f64::to_bits);
    let first = slices.first()?;
    let numbers: Vec<u64> = first.planes.iter().filter_map(number).collect();
    if numbers.len() < 2 || numbers.len() > MAX_ACQUISITIONS || slices.len() < 2 {
        return None;
    }
    let parts = numbers.iter().map(|&acquisition| {
        let own = slices.iter().map(|slice| {
            let mut planes = slice.planes.iter();
            let planes: Vec<_> = (planes.by_ref())
                .filter(|plane| number(plane) == Some(acquisition))
                .cloned()
                .collect();
            (planes.len() == 1 && slice.planes.len() == numbers.len()).then_some(Slice {
                along_mm: slice.along_mm,
                planes,
            })
        });
        own.collect::<Option<Vec<Slice>>>()
    });
    parts.collect()
}

/// A stack of slices, if they stand at even distances on one line.
fn finished(
    slices: Vec<Slice>,
    key: Option<ChosenKey>,
    notices: Vec<Notice>,
) -> Result<Stack, String> {
    let origins: Vec<Point3> = (slices.iter())
        .filter_map(|slice| Some(slice.planes.first()?.place?.origin))
        .collect();
    let (Some(&origin), Some(&last)) = (origins.first(), origins.last()) else {
        return Err("it has no slices".to_owned());
    };
    let mut step = None;
    if slices.len() > 1 {
        let mean: Vector3 = (last - origin) / (slices.len() - 1) as f64;
        check_distances(&slices)?;
        let off = origins.iter().enumerate().find(|&(k, own)| {
            (own - (origin + mean * k as f64)).norm() > UNEVEN_MM + 2.0 * UNEVEN * mean.norm()
        });
        if let Some((k, _)) = off {
            return Err(format!(
                "slice {} does not stand on a line with the others",
                k + 1
            ));
        }
        step = Some(mean);
    }
    Ok(Stack {
        slices,
        key,
        origin,
        step,
        notices,
    })
}

/// Refuses slices at uneven distances, and names the place (InsightSoftwareConsortium/ITK#441).
fn check_distances(slices: &[Slice]) -> Result<(), String> {
    let steps: Vec<f64> = (slices.windows(2))
        .map(|pair| pair[1].along_mm - pair[0].along_mm)
        .collect();
    let mut sorted = steps.clone();
    sorted.sort_by(f64::total_cmp);
    let usual = sorted.get((sorted.len() - 1) / 2).copied().unwrap_or(0.0);
    let uneven = |step: f64| (step - usual).abs() > UNEVEN_MM + UNEVEN * usual;
    let Some(at) = steps.iter().position(|&step| uneven(step)) else {
        return Ok(());
    };
    let mm = |slice: Option<&Slice>| slice.map_or(0.0, |slice| slice.along_mm);
    Err(format!(
        "its slices stand at uneven distances: {:.2} mm between slices {} and {} (at {:.2} and {:.2} mm along their normal), {usual:.2} mm between the others; a slice is missing, or they are of several stacks",
        steps[at],
        at + 1,
        at + 2,
        mm(slices.get(at)),
        mm(slices.get(at + 1)),
    ))
}
