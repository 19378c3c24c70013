//! Which planes of a slice belong to which instant.

use super::plane::{INSTANT_KEYS, InstantKey, Plane};

/// The planes of one slice.
#[derive(Clone, Debug)]
pub(super) struct Slice {
    /// How far it stands along the normal of the stack, in millimetres.
    pub(super) along_mm: f64,
    pub(super) planes: Vec<Plane>,
}

/// By what the instants of a stack are ordered.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct ChosenKey {
    pub(super) index: usize,
    pub(super) key: InstantKey,
    pub(super) name: &'static str,
}

/// Milliseconds that a beat may take where a file does not say: 24 beats a minute. Longer "times after the R wave" are
/// something else (rordenlab/dcm2niix#395).
const LONGEST_BEAT_MS: f64 = 2_500.0;
/// As much longer than the nominal beat a time after the R wave may be.
const BEYOND_NOMINAL: f64 = 1.2;

impl ChosenKey {
    /// What a plane says by this key.
    pub(super) fn of(self, plane: &Plane) -> Option<f64> {
        plane.when.0.get(self.index).copied().flatten()
    }
}

/// The first key that all planes have and that tells the planes of each slice apart.
pub(super) fn choose_key(slices: &[Slice]) -> Option<ChosenKey> {
    let keys = INSTANT_KEYS.iter().enumerate();
    let mut keys = keys.map(|(index, &(key, name))| ChosenKey { index, key, name });
    keys.find(|&key| tells_apart(slices, key))
}

fn tells_apart(slices: &[Slice], key: ChosenKey) -> bool {
    slices.iter().all(|slice| {
        let mut values = Vec::with_capacity(slice.planes.len());
        for plane in &slice.planes {
            let Some(value) = key.of(plane) else {
                return false;
            };
            if key.key == InstantKey::AfterRWave {
                let longest = plane.cycle_ms.map(|cycle| cycle * BEYOND_NOMINAL);
                if value > longest.unwrap_or(LONGEST_BEAT_MS) {
                    return false;
                }
            }
            values.push(value);
        }
        values.sort_by(f64::total_cmp);
        values.windows(2).all(|pair| pair[0] < pair[1])
    })
}

/// Sorts the planes of each slice by a key.
pub(super) fn sort_by_key(slices: &mut [Slice], key: ChosenKey) {
    for slice in slices {
        let value = |plane: &Plane| key.of(plane).unwrap_or(f64::INFINITY);
        slice.planes.sort_by(|a, b| value(a).total_cmp(&value(b)));
    }
}

/// Leaves as many instants as every slice has. Returns the numbers (from 1) of those that were dropped.
///
/// Where all slices count by the same values, those that are not everywhere are dropped. Where each has its own times
/// only those at the end can be: a slice whose steps are even lacks the last ones (rordenlab/dcm2niix#830).
///
/// # Errors
/// If it cannot be told which instants a slice lacks.
pub(super) fn drop_incomplete(slices: &mut [Slice], key: ChosenKey) -> Result<Vec<usize>, String> {
    let counts = || slices.iter().map(|slice| slice.planes.len());
    let (most, fewest) = (counts().max().unwrap_or(0), counts().min().unwrap_or(0));
    if most == fewest {
        return Ok(Vec::new());
    }
    let which = counts().position(|count| count == fewest).unwrap_or(0) + 1;
    if 2 * fewest <= most {
        return Err(format!("slice {which} has {fewest} of {most} instants"));
    }
    let values = |slice: &Slice| -> Vec<f64> {
        slice
            .planes
            .iter()
            .filter_map(|plane| key.of(plane))
            .collect()
    };
    let all: Vec<Vec<f64>> = slices.iter().map(values).collect();
    let Some(full) = all.iter().find(|values| values.len() == most).cloned() else {
        return Ok(Vec::new());
    };
    let among = |values: &[f64], value: f64| values.iter().any(|v| (v - value).abs() < 1e-6);
    if all
        .iter()
        .all(|values| values.iter().all(|&v| among(&full, v)))
    {
        let kept = |value: f64| all.iter().all(|values| among(values, value));
        let dropped = full.iter().enumerate().filter(|&(_, &value)| !kept(value));
        let dropped: Vec<usize> = dropped.map(|(n, _)| n + 1).collect();
        for slice in slices.iter_mut() {
            slice.planes.retain(|plane| key.of(plane).is_some_and(kept));
        }
        return Ok(dropped);
    }
    let short = all
        .iter()
        .zip(1..)
        .filter(|(values, _)| values.len() < most);
    for (values, number) in short {
        let late = match (values.first(), full.first(), full.get(1)) {
            (Some(own), Some(first), Some(second)) => own - first > 0.5 * (second - first),
            _ => true,
        };
        if late || !even(values) {
            return Err(format!(
                "slice {number} has {} of {most} instants, and it does not show which it lacks",
                values.len()
            ));
        }
    }
    for slice in slices.iter_mut() {
        slice.planes.truncate(fewest);
    }
    Ok((fewest + 1..=most).collect())
}

/// Whether the steps of times are alike: a step over a lacking one is twice as long.
fn even(values: &[f64]) -> bool {
    let mut steps: Vec<f64> = values.windows(2).map(|pair| pair[1] - pair[0]).collect();
    steps.sort_by(f64::total_cmp);
    let Some(&median) = steps.get(steps.len() / 2) else {
        return false;
    };
    steps
        .iter()
        .all(|step| (step - median).abs() <= 0.4 * median)
}
