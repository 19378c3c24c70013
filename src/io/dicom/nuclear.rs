//! Tomograms of a gamma camera: one file holds the slices of all gates (PS3.3, C.8.4.8, C.8.4.13 and C.8.4.15).

use std::sync::Arc;

use rayon::prelude::*;

use super::element::DataSet;
use super::layout::unsupported;
use super::nuclear_grid::nuclear_grid;
use super::pixels::{Pixels, Rescale};
use super::plane::{FileFacts, rescale};
use super::series::told;
use super::tag::{
    DATA_INFORMATION, FRAME_INCREMENT_POINTER, FRAME_TIME, GATED_INFORMATION, NOMINAL_INTERVAL,
    NUMBER_OF_RR_INTERVALS, NUMBER_OF_SLICES, NUMBER_OF_TIME_SLOTS, RR_INTERVAL_VECTOR,
    SLICE_VECTOR, TIME_SLOT_INFORMATION, TIME_SLOT_TIME, TIME_SLOT_VECTOR, Tag,
};
use crate::image::Image;
use crate::io::image_file::{Gates, ImageSeries, Modality, ReadImageError, neutral_name};
use crate::study::Notice;

/// The three counters of a frame: interval between R waves, gate, slice; each with its number in all.
const COUNTERS: [(Tag, Tag, &str); 3] = [
    (
        RR_INTERVAL_VECTOR,
        NUMBER_OF_RR_INTERVALS,
        "RRIntervalVector",
    ),
    (TIME_SLOT_VECTOR, NUMBER_OF_TIME_SLOTS, "TimeSlotVector"),
    (SLICE_VECTOR, NUMBER_OF_SLICES, "SliceVector"),
];

/// The volumes of a file.
///
/// # Errors
/// If its frames are projections or planar, are not one for each slice of each gate, or their grid is none.
pub(super) fn nuclear_series(
    set: &DataSet<'_>,
    facts: &FileFacts,
    pixels: &Pixels,
) -> Result<ImageSeries, ReadImageError> {
    check_kind(facts, set)?;
    let layout = &pixels.layout;
    let mut notices = Vec::new();
    let counters = counters(set, layout.frames)?;
    let intervals = distinct(&counters[0]);
    let chosen = intervals.first().copied().unwrap_or(1);
    if intervals.len() > 1 {
        notices.push(Notice::warning(format!(
            "{} intervals between R waves; the volumes are those of the first",
            intervals.len()
        )));
    }
    let (gates, slices) = (distinct(&counters[1]), distinct(&counters[2]));
    check_numbers(&slices)?;
    let order = order(&counters, chosen, &gates, &slices)?;
    let grid = nuclear_grid(set, layout, slices.len(), &mut notices)?;

    let volumes = volumes(&order, pixels, rescale(&[set]))?;
    if layout.low_is_bright {
        notices.push(Notice::info("low values are meant to be shown bright"));
    }

    let timing = Timing::new(set);
    let gated = gates.len() > 1 || facts.is_kind("RECON GATED TOMO");
    let times = timing.of_gates(&gates).filter(|_| gates.len() > 1);
    if gates.len() > 1 && times.is_none() {
        notices.push(Notice::warning(
            "the file says neither the time of its gates nor that between R waves",
        ));
    }
    let times_known = times.is_some() || volumes.len() == 1;
    let count = volumes.len();
    let what = match gated {
        true => "gated tomogram (NM)",
        false => "tomogram (NM)",
    };
    Ok(ImageSeries {
        name: neutral_name(what, &grid.frame, count),
        format: "DICOM",
        modality: Some(Modality::NuclearMedicine),
        image: Image::new(grid.frame, volumes, times)?,
        gates: gated.then_some(Gates {
            numbers: gates,
            cycle_ms: timing.cycle_ms,
        }),
        spacing: grid.spacing,
        times: told(times_known),
        position_known: grid.position_known,
        notices,
    })
}

/// Slices may be counted from any number, but without gaps.
fn check_numbers(slices: &[u32]) -> Result<(), ReadImageError> {
    let ends = slices.first().zip(slices.last());
    let span = ends.map(|(first, last)| (last - first) as usize);
    if span == slices.len().checked_sub(1) {
        return Ok(());
    }
    Err(ReadImageError::InField {
        field: "SliceVector",
        reason: "the numbers of the slices have gaps".to_owned(),
    })
}

/// The values of the frames of each gate.
fn volumes(
    order: &[Vec<usize>],
    pixels: &Pixels,
    by: Rescale,
) -> Result<Vec<Arc<[f32]>>, ReadImageError> {
    let pixels_of_frame = pixels.layout.pixels_of_frame();
    let volumes = order.par_iter().map(|frames| {
        let mut values = Vec::with_capacity(pixels_of_frame * frames.len());
        for &frame in frames {
            values.extend(pixels.values(frame, by)?);
        }
        Ok(Arc::from(values))
    });
    volumes.collect()
}

/// Refuses frames that are no slices.
fn check_kind(facts: &FileFacts, set: &DataSet<'_>) -> Result<(), ReadImageError> {
    let projections = [
        "TOMO",
        "GATED TOMO",
        "STATIC",
        "WHOLE BODY",
        "DYNAMIC",
        "GATED",
    ];
    if let Some(kind) = projections.iter().find(|kind| facts.is_kind(kind)) {
        let what = match kind.ends_with("TOMO") {
            true => "projections, not a reconstructed volume",
            false => "planar pictures, not a volume",
        };
        return Err(unsupported(format!("{what} (its kind is {kind})")));
    }
    let volume = facts.is_kind("RECON TOMO") || facts.is_kind("RECON GATED TOMO");
    if !volume && !set.has(SLICE_VECTOR) {
        return Err(unsupported(
            "it does not say that its frames are slices of a reconstructed volume",
        ));
    }
    Ok(())
}

/// The counters of each frame, from 1.
///
/// They stand in vectors. Without them the order that the file names is taken if the numbers in all fit: its last
/// counter is the fastest (PS3.3, C.7.6.6.1.1).
fn counters(set: &DataSet<'_>, frames: usize) -> Result<[Vec<u32>; 3], ReadImageError> {
    let vectors = COUNTERS.map(|(vector, _, _)| set.numbers(vector));
    for (vector, (_, _, field)) in vectors.iter().zip(COUNTERS) {
        if let Some(found) = vector
            && found.len() != frames
        {
            let reason = format!("{} numbers for {frames} frames", found.len());
            return Err(ReadImageError::InField { field, reason });
        }
    }
    let totals = COUNTERS.map(|(_, total, _)| set.count(total).unwrap_or(1).max(1));
    let varying = |n: usize| totals[n] > 1;
    let missing = (0..3).any(|n| varying(n) && vectors[n].is_none());
    let told = |n: usize| vectors[n].is_none() && (varying(n) || n == 2);
    if !missing && (vectors[2].is_some() || frames == 1) {
        return Ok(vectors.map(|vector| match vector {
            Some(numbers) => numbers.into_iter().map(|n| n as u32).collect(),
            None => vec![1; frames],
        }));
    }
    let mut named: Vec<usize> = (set.named_tags(FRAME_INCREMENT_POINTER).iter())
        .filter_map(|tag| COUNTERS.iter().position(|(vector, _, _)| vector == tag))
        .collect();
    named.dedup();
    // A single slice counter needs no total; several counters need all of theirs.
    let mut totals = totals;
    if named == [2] || (named.is_empty() && !varying(0) && !varying(1)) {
        (named, totals) = (vec![2], [1, 1, frames]);
    }
    let product = named.iter().map(|&n| totals[n]).product::<usize>();
    if product != frames || (0..3).any(|n| told(n) && !named.contains(&n)) {
        let reason = format!("it is missing, and the numbers in all do not make {frames} frames");
        let field = COUNTERS
            .iter()
            .zip(&vectors)
            .find(|(_, vector)| vector.is_none());
        return Err(ReadImageError::InField {
            field: field.map_or("SliceVector", |((_, _, field), _)| field),
            reason,
        });
    }
    let mut counters = [(); 3].map(|()| vec![1_u32; frames]);
    let mut stride = 1;
    for &n in named.iter().rev() {
        for (frame, counter) in counters[n].iter_mut().enumerate() {
            *counter = (frame / stride % totals[n] + 1) as u32;
        }
        stride *= totals[n];
    }
    Ok(counters)
}

/// Places of slices in gates that are looked through for the one that is missing, whatever the number of frames.
const MAX_PLACES: usize = 1 << 16;

/// The different numbers of a counter, ascending.
fn distinct(counter: &[u32]) -> Vec<u32> {
    let mut numbers = counter.to_vec();
    numbers.sort_unstable();
    numbers.dedup();
    numbers
}

/// For each gate the frame of each slice, whatever runs fastest in the file.
fn order(
    counters: &[Vec<u32>; 3],
    interval: u32,
    gates: &[u32],
    slices: &[u32],
) -> Result<Vec<Vec<usize>>, ReadImageError> {
    let places = gates.len().saturating_mul(slices.len());
    // Which one is missing is only told where that takes little memory.
    if places > counters[0].len().max(MAX_PLACES) {
        let (gates, slices) = (gates.len(), slices.len());
        return Err(wrong_frames(format!(
            "there are not {slices} slices of {gates} gates"
        )));
    }
    let mut order = vec![vec![None; slices.len()]; gates.len()];
    let [intervals, times, places] = counters;
    for (frame, ((&own, gate), slice)) in intervals.iter().zip(times).zip(places).enumerate() {
        if own != interval {
            continue;
        }
        let at = gates
            .binary_search(gate)
            .ok()
            .zip(slices.binary_search(slice).ok());
        let Some(place) = at.and_then(|(g, s)| order.get_mut(g)?.get_mut(s)) else {
            continue;
        };
        if place.replace(frame).is_some() {
            return Err(wrong_frames(format!(
                "slice {slice} of gate {gate} comes twice"
            )));
        }
    }
    let complete = order.into_iter().zip(gates).map(|(frames, gate)| {
        let frames = frames.into_iter().enumerate();
        frames
            .map(|(slice, frame)| {
                frame.ok_or_else(|| {
                    wrong_frames(format!("slice {} of gate {gate} is missing", slices[slice]))
                })
            })
            .collect()
    });
    complete.collect()
}

fn wrong_frames(reason: String) -> ReadImageError {
    ReadImageError::InField {
        field: "NumberOfFrames",
        reason,
    }
}

/// What a file says of the time of its gates.
struct Timing {
    frame_ms: Option<f64>,
    cycle_ms: Option<f64>,
    slot_ms: Vec<f64>,
}

impl Timing {
    fn new(set: &DataSet<'_>) -> Self {
        let gated = set.item(GATED_INFORMATION);
        let data = gated
            .as_ref()
            .and_then(|gated| gated.item(DATA_INFORMATION));
        let positive = |set: Option<&DataSet<'_>>, tag| {
            set.and_then(|set| set.number(tag)).filter(|&ms| ms > 0.0)
        };
        let number = |tag| positive(data.as_ref(), tag).or_else(|| positive(Some(set), tag));
        let slots = data.as_ref().map(|data| data.items(TIME_SLOT_INFORMATION));
        let slots = slots.unwrap_or_default();
        Self {
            frame_ms: number(FRAME_TIME),
            cycle_ms: number(NOMINAL_INTERVAL),
            slot_ms: (slots.iter())
                .filter_map(|slot| slot.number(TIME_SLOT_TIME))
                .collect(),
        }
    }

    /// When each gate begins: (gate − 1) · the time of a frame, else the sum of the times of the gates before it, else
    /// an even share of the time between R waves.
    fn of_gates(&self, gates: &[u32]) -> Option<Vec<f64>> {
        let last = *gates.last()?;
        let slots = (self.slot_ms.len() >= last as usize
            && self.slot_ms.iter().all(|&ms| ms > 0.0))
        .then_some(&self.slot_ms);
        let even = self.frame_ms.or_else(|| {
            let cycle = self.cycle_ms.filter(|_| slots.is_none())?;
            Some(cycle / f64::from(last))
        });
        let begin = |gate: u32| {
            let before = gate.checked_sub(1)?;
            match (even, slots) {
                (Some(even), _) => Some(f64::from(before) * even),
                (None, Some(slots)) => Some(slots.iter().take(before as usize).sum()),
                (None, None) => None,
            }
        };
        gates.iter().map(|&gate| begin(gate)).collect()
    }
}
