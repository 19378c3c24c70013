//! From a stack of planes, or a file that does not say where its frames stand, to a series of volumes.

use std::sync::Arc;

use rayon::prelude::*;

use super::layout::Layout;
use super::plane::{InstantKey, Plane, SlicePlace};
use super::stack::Stack;
use crate::image::{Image, VolumeFrame};
use crate::io::image_file::{
    Gates, ImageSeries, Modality, Provenance, ReadImageError, neutral_name,
};
use crate::mesh::{Point3, Vector3};
use crate::progress::Progress;
use crate::study::Notice;

/// Times of one instant that differ by more than this from slice to slice are worth a note, in milliseconds.
const SAME_TIME_MS: f64 = 1.0;

/// Whether something is said, as its provenance.
pub(super) fn told(known: bool) -> Provenance {
    match known {
        true => Provenance::Stated,
        false => Provenance::Missing,
    }
}

/// The volumes of a stack. Asked to stop, it fails soon; who asks hears it from `progress`.
///
/// # Errors
/// If pixels cannot be unpacked, there are more than `most` voxels, or positions make no grid.
pub(super) fn series_of_stack(
    stack: &Stack,
    most: u64,
    progress: &Progress,
) -> Result<ImageSeries, ReadImageError> {
    let Some(first) = stack.slices.first().and_then(|slice| slice.planes.first()) else {
        return Err(ReadImageError::Unsupported("it has no images".to_owned()));
    };
    let Some(place) = first.place else {
        return Err(ReadImageError::Unsupported(
            "its position is not said".to_owned(),
        ));
    };
    let mut notices = stack.notices.clone();
    let third = stack.step.unwrap_or_else(|| {
        notices.push(thickness_note(first.thickness_mm));
        place.normal() * first.thickness_mm.unwrap_or(1.0)
    });
    let (frame, spacing) = grid(first, &place, stack.origin, third, stack.slices.len())?;
    if spacing == Provenance::Missing {
        notices.push(Notice::warning(
            "the file does not say the distance of its pixels",
        ));
    }
    tell_tilt(stack, &place, &mut notices);
    let instants = instants_of(stack);
    check_size(&frame, instants, most)?;
    let volumes = (0..instants).map(|instant| match progress.check() {
        Ok(()) => volume(stack, instant, &frame),
        Err(stopped) => Err(ReadImageError::Unsupported(stopped.to_string())),
    });
    let volumes = volumes.collect::<Result<Vec<_>, _>>()?;
    tell_bright(first, &mut notices);
    if let Some(taken) = first
        .facts
        .images_of_a_beat
        .filter(|&taken| instants > 1 && taken > instants)
    {
        notices.push(Notice::warning(format!(
            "{taken} instants of the beat were taken, but only {instants} are here"
        )));
    }
    let times = times(stack, &mut notices);
    let in_beat = (stack.key)
        .is_some_and(|key| matches!(key.key, InstantKey::AfterRWave | InstantKey::Percent));
    let gates = (in_beat && instants > 1).then(|| Gates {
        numbers: (1..=instants as u32).collect(),
        cycle_ms: cycle_ms(stack),
    });
    Ok(ImageSeries {
        name: neutral_name(
            what(first.facts.modality, instants, gates.is_some()),
            &frame,
            instants,
        ),
        format: "DICOM",
        modality: first.facts.modality,
        times: told(times.is_some() || instants == 1),
        image: Image::new(frame, volumes, times)?,
        gates,
        spacing,
        position_known: true,
        notices,
    })
}

/// A word for the kind of series.
fn what(modality: Option<Modality>, instants: usize, gated: bool) -> &'static str {
    use Modality::{ComputedTomography, MagneticResonance, PositronEmission, Ultrasound};
    match (modality, instants > 1 || gated) {
        (Some(MagneticResonance), true) => "cine (MR)",
        (Some(MagneticResonance), false) => "MR",
        (Some(ComputedTomography), true) => "cine (CT)",
        (Some(ComputedTomography), false) => "CT",
        (Some(PositronEmission), true) => "gated PET",
        (Some(PositronEmission), false) => "PET",
        (Some(Ultrasound), _) => "ultrasound",
        (_, true) => "DICOM over time",
        (_, false) => "DICOM",
    }
}

fn thickness_note(thickness_mm: Option<f64>) -> Notice {
    Notice::info(match thickness_mm {
        Some(mm) => {
            format!("one slice: across it the voxel is as long as the slice is thick, {mm} mm")
        }
        None => "one slice, whose thickness is not said: across it the voxel is taken as 1 mm"
            .to_owned(),
    })
}

/// The grid of planes whose next one stands at `third`.
fn grid(
    plane: &Plane,
    place: &SlicePlace,
    origin: Point3,
    third: Vector3,
    slices: usize,
) -> Result<(VolumeFrame, Provenance), ReadImageError> {
    let Layout { rows, columns, .. } = plane.pixels.layout;
    // The first number is the distance of rows, which is along the column (FNNDSC/ami#166).
    let [rows_mm, columns_mm] = plane.spacing.unwrap_or([1.0; 2]);
    let steps = [place.row * columns_mm, place.column * rows_mm, third];
    let frame = VolumeFrame::new([columns, rows, slices], origin, steps)?;
    Ok((frame, told(plane.spacing.is_some())))
}

/// How many instants all slices have.
pub(super) fn instants_of(stack: &Stack) -> usize {
    let counts = stack.slices.iter().map(|slice| slice.planes.len());
    counts.min().unwrap_or(0)
}

fn check_size(frame: &VolumeFrame, instants: usize, most: u64) -> Result<(), ReadImageError> {
    let count = (frame.voxel_count() as u64).saturating_mul(instants as u64);
    ReadImageError::unless_voxels_fit(count, most)
}

/// The values of all slices at one instant.
fn volume(
    stack: &Stack,
    instant: usize,
    frame: &VolumeFrame,
) -> Result<Arc<[f32]>, ReadImageError> {
    let slices = stack
        .slices
        .par_iter()
        .map(|slice| match slice.planes.get(instant) {
            Some(plane) => plane.pixels.values(plane.frame, plane.rescale),
            None => Ok(Vec::new()),
        });
    let slices: Vec<Vec<f32>> = slices.collect::<Result<_, ReadImageError>>()?;
    let mut values = Vec::with_capacity(frame.voxel_count());
    slices
        .iter()
        .for_each(|slice| values.extend_from_slice(slice));
    Ok(values.into())
}

/// Says that slices are shifted sideways. The grid keeps it: its axes need not be normal to each other.
fn tell_tilt(stack: &Stack, place: &SlicePlace, notices: &mut Vec<Notice>) {
    let Some(step) = stack.step else {
        return;
    };
    let tilt = step.angle(&place.normal()).to_degrees();
    // Less is rounding of the positions: a hundredth of a millimetre in one.
    if tilt > 0.6 {
        notices.push(Notice::info(format!(
            "each slice is shifted sideways against the one before (a gantry tilted by {tilt:.1}°); the grid is oblique, as it was measured"
        )));
    }
}

fn tell_bright(plane: &Plane, notices: &mut Vec<Notice>) {
    if plane.pixels.layout.low_is_bright {
        notices.push(Notice::info("low values are meant to be shown bright"));
    }
}

/// The mean time between R waves that slices say.
fn cycle_ms(stack: &Stack) -> Option<f64> {
    let planes = stack.slices.iter().filter_map(|slice| slice.planes.first());
    let cycles: Option<Vec<f64>> = planes.map(|plane| plane.cycle_ms).collect();
    let cycles = cycles.filter(|cycles| !cycles.is_empty())?;
    Some(cycles.iter().sum::<f64>() / cycles.len() as f64)
}

/// The time of each instant after the R wave: the mean of those of its slices, which were taken in different beats. The
/// instants are matched by their rank, not by equal times.
fn times(stack: &Stack, notices: &mut Vec<Notice>) -> Option<Vec<f64>> {
    let key = stack.key?;
    let factor = match key.key {
        InstantKey::AfterRWave => 1.0,
        InstantKey::Percent => cycle_ms(stack)? / 100.0,
        _ => return None,
    };
    let mut spread: f64 = 0.0;
    let times: Option<Vec<f64>> = (0..instants_of(stack))
        .map(|instant| {
            let planes = stack.slices.iter().map(|slice| slice.planes.get(instant));
            let own: Option<Vec<f64>> = planes.map(|plane| key.of(plane?)).collect();
            let own = own?;
            let (low, high) = (own.iter())
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), &t| {
                    (l.min(t), h.max(t))
                });
            spread = spread.max((high - low) * factor);
            match high > low {
                true => Some(own.iter().sum::<f64>() / own.len() as f64 * factor),
                false => Some(low * factor),
            }
        })
        .collect();
    if spread > SAME_TIME_MS {
        notices.push(Notice::info(format!(
            "the times of one instant differ by up to {spread:.0} ms from slice to slice (each was taken in beats of its own); instants are matched by their rank, and their times are means"
        )));
    }
    times
}

/// The frames of one file that is a film of one place, or does not say where they stand.
///
/// # Errors
/// As [`series_of_stack`].
pub(super) fn series_of_film(
    planes: &[Plane],
    frame_times_ms: Option<Vec<f64>>,
    most: u64,
) -> Result<ImageSeries, ReadImageError> {
    let Some(first) = planes.first() else {
        return Err(ReadImageError::Unsupported("it has no images".to_owned()));
    };
    let over_time = frame_times_ms.is_some() && planes.len() > 1;
    let slices = if over_time { 1 } else { planes.len() };
    // The position of a file is that of all frames of a film, and of none but the first of slices.
    let known = first.place.filter(|_| slices == 1);
    let place = known.unwrap_or(SlicePlace {
        origin: Point3::origin(),
        row: Vector3::x(),
        column: Vector3::y(),
    });
    let mut notices = Vec::new();
    if known.is_none() {
        notices.push(Notice::warning(
            "the file says neither position nor orientation of its slices: only distances are known, not where they stand in the patient",
        ));
    }
    let third = match slices {
        1 => {
            notices.push(thickness_note(first.thickness_mm));
            place.normal() * first.thickness_mm.unwrap_or(1.0)
        }
        _ => {
            notices.push(Notice::warning(
                "the file does not say whether its frames are slices or instants, nor how far they are from each other; they are taken as slices",
            ));
            place.normal()
        }
    };
    let (frame, spacing) = grid(first, &place, place.origin, third, slices)?;
    let spacing = if slices > 1 {
        Provenance::Missing
    } else {
        spacing
    };
    if first.spacing.is_none() {
        notices.push(Notice::warning(
            "the file does not say the distance of its pixels",
        ));
    }
    let instants = planes.len() / slices;
    check_size(&frame, instants, most)?;
    let values = planes
        .par_iter()
        .map(|plane| plane.pixels.values(plane.frame, plane.rescale));
    let values: Vec<Vec<f32>> = values.collect::<Result<_, ReadImageError>>()?;
    let volumes: Vec<Arc<[f32]>> = match over_time {
        true => values.into_iter().map(Arc::from).collect(),
        false => vec![values.concat().into()],
    };
    tell_bright(first, &mut notices);
    let times = frame_times_ms.filter(|_| over_time);
    let name = what(first.facts.modality, instants, false);
    Ok(ImageSeries {
        name: neutral_name(name, &frame, instants),
        format: "DICOM",
        modality: first.facts.modality,
        image: Image::new(frame, volumes, times)?,
        gates: None,
        spacing,
        times: Provenance::Stated,
        position_known: known.is_some(),
        notices,
    })
}
