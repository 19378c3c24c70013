//! Segmentations: masks of one bit or fractions, each frame a slice of one segment (PS3.3, C.8.20).

use std::collections::BTreeMap;
use std::sync::Arc;

use super::element::DataSet;
use super::functional_groups::FunctionalGroups;
use super::group::SAME_PLACE_MM;
use super::layout::unsupported;
use super::pixels::{Pixels, Rescale};
use super::plane::{FileFacts, Plane, SlicePlace};
use super::series::told;
use super::tag::{
    MAXIMUM_FRACTION, PIXEL_MEASURES, REFERENCED_SEGMENT, SEGMENT_IDENTIFICATION,
    SEGMENTATION_TYPE, SPACING_BETWEEN_SLICES,
};
use crate::image::{Image, VolumeFrame};
use crate::io::image_file::{ImageSeries, Modality, Provenance, ReadImageError, neutral_name};
use crate::mesh::Point3;
use crate::study::Notice;

/// A frame with the segment that it belongs to and its slice.
struct SegmentFrame<'a> {
    plane: &'a Plane,
    segment: u32,
    slice: usize,
}

/// Where the slices stand.
struct Slices {
    origin: Point3,
    normal_step: f64,
    count: usize,
    omitted: usize,
}

/// A volume of labels (the numbers of the segments), or one volume for each segment where they overlap or are fractions.
///
/// # Errors
/// If frames do not say where they are, stand at uneven distances, or make more than `most` voxels.
pub(super) fn segmentation_series(
    set: &DataSet<'_>,
    groups: &FunctionalGroups<'_>,
    facts: &Arc<FileFacts>,
    pixels: &Arc<Pixels>,
    most: u64,
) -> Result<Vec<ImageSeries>, ReadImageError> {
    let kind = set.text(SEGMENTATION_TYPE).unwrap_or_default();
    let planes = groups.planes(set, facts, pixels);
    let first = planes
        .first()
        .ok_or_else(|| unsupported("it has no frames"))?;
    let place = first
        .place
        .ok_or_else(|| unsupported("its position and orientation are not said"))?;
    let measures = groups.group(0, PIXEL_MEASURES);
    let stated = measures.and_then(|measures| measures.number(SPACING_BETWEEN_SLICES));
    let (slices, places) = slices_of(&planes, &place, stated.map(f64::abs))?;
    let frames = segment_frames(&planes, &places, groups);
    let size = [pixels.layout.columns, pixels.layout.rows, slices.count];
    let [rows_mm, columns_mm] = first.spacing.unwrap_or([1.0; 2]);
    let steps = [
        place.row * columns_mm,
        place.column * rows_mm,
        place.normal() * slices.normal_step,
    ];
    let frame = VolumeFrame::new(size, slices.origin, steps)?;
    let mut segments: BTreeMap<u32, Vec<&SegmentFrame>> = BTreeMap::new();
    for frame in &frames {
        segments.entry(frame.segment).or_default().push(frame);
    }
    let fractions = kind == "FRACTIONAL";
    let merged = match (kind, fractions) {
        ("LABELMAP", _) => Some(volume_of(
            &frames.iter().collect::<Vec<_>>(),
            &frame,
            Mark::Own,
            most,
        )?),
        (_, true) => None,
        _ => labels(&segments, &frame, most)?,
    };
    let notices = notices_of(&slices, first);
    let series = |what: &str, values: Vec<f32>| {
        Ok(ImageSeries {
            name: neutral_name(what, &frame, 1),
            format: "DICOM",
            modality: Some(Modality::Segmentation),
            image: Image::new(frame, vec![values.into()], None)?,
            gates: None,
            spacing: told(first.spacing.is_some()),
            times: Provenance::Stated,
            position_known: true,
            notices: notices.clone(),
        })
    };
    if let Some(values) = merged {
        return Ok(vec![series("segmentation (labels)", values)?]);
    }
    let all = (frame.voxel_count() as u64).saturating_mul(segments.len() as u64);
    ReadImageError::unless_voxels_fit(all, most)?;
    let full = set.number(MAXIMUM_FRACTION).filter(|&full| full > 0.0);
    let mark = match fractions {
        true => Mark::Share(full.unwrap_or(255.0)),
        false => Mark::Own,
    };
    let each = segments.iter().map(|(number, frames)| {
        let values = volume_of(frames, &frame, mark, most)?;
        series(&format!("segmentation (segment {number})"), values)
    });
    each.collect()
}

/// The segment and the slice of each frame.
fn segment_frames<'a>(
    planes: &'a [Plane],
    slices: &[usize],
    groups: &FunctionalGroups<'_>,
) -> Vec<SegmentFrame<'a>> {
    let frames = planes.iter().zip(slices).enumerate();
    let each = frames.map(|(n, (plane, &slice))| {
        let group = groups.group(n, SEGMENT_IDENTIFICATION);
        let segment = group.and_then(|group| group.count(REFERENCED_SEGMENT));
        SegmentFrame {
            plane,
            segment: segment.unwrap_or(1) as u32,
            slice,
        }
    });
    each.collect()
}

fn notices_of(slices: &Slices, first: &Plane) -> Vec<Notice> {
    let omitted = (slices.omitted > 0).then(|| {
        Notice::info(format!(
            "slices that are not in the file, since no label is in them: {}",
            slices.omitted
        ))
    });
    let unknown = first
        .spacing
        .is_none()
        .then(|| Notice::warning("the file does not say the distance of its pixels"));
    omitted.into_iter().chain(unknown).collect()
}

/// What stands in a voxel of a mask.
#[derive(Clone, Copy)]
enum Mark {
    /// The number of the file.
    Own,
    /// Its share of the number that means "fully within".
    Share(f64),
}

/// The slices on which frames stand, and the slice of each frame. Slices without labels may be left out of a file: the
/// distance is the stated one where positions are whole multiples of it, else the smallest between positions.
fn slices_of(
    planes: &[Plane],
    place: &SlicePlace,
    stated: Option<f64>,
) -> Result<(Slices, Vec<usize>), ReadImageError> {
    let normal = place.normal();
    let missing = planes.iter().any(|plane| plane.place.is_none());
    let turned = planes.iter().filter_map(|plane| plane.place).any(|other| {
        (other.row - place.row).norm() > 1e-3 || (other.column - place.column).norm() > 1e-3
    });
    if missing || turned {
        return Err(unsupported("its frames have no common orientation"));
    }
    let mut sorted: Vec<(f64, Point3)> = (planes.iter())
        .filter_map(|plane| Some((plane.along(normal), plane.place?.origin)))
        .collect();
    sorted.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (low, origin) = sorted.first().copied().unwrap_or((0.0, place.origin));
    let high = sorted.last().map_or(low, |last| last.0);
    let steps = sorted.windows(2).map(|pair| pair[1].0 - pair[0].0);
    let smallest = steps
        .filter(|&step| step > SAME_PLACE_MM)
        .fold(f64::INFINITY, f64::min);
    let whole = |step: f64| {
        let off = |along: f64| ((along - low) / step - ((along - low) / step).round()).abs();
        step > 0.0 && sorted.iter().all(|&(along, _)| off(along) < 0.02)
    };
    let stated = stated.filter(|&step| whole(step));
    let alone = (planes.first())
        .and_then(|plane| plane.thickness_mm)
        .unwrap_or(1.0);
    let step = match (stated, smallest.is_finite()) {
        (Some(stated), _) => stated,
        (None, true) => smallest,
        (None, false) => alone,
    };
    if !whole(step) {
        return Err(unsupported(format!(
            "its slices stand at uneven distances: {smallest:.2} mm is the smallest, and others are no multiples of it"
        )));
    }
    let index = |along: f64| ((along - low) / step).round().max(0.0) as usize;
    let places: Vec<usize> = planes
        .iter()
        .map(|plane| index(plane.along(normal)))
        .collect();
    let mut filled = places.clone();
    filled.sort_unstable();
    filled.dedup();
    let count = index(high).saturating_add(1);
    let slices = Slices {
        origin,
        normal_step: step,
        count,
        omitted: count.saturating_sub(filled.len()),
    };
    Ok((slices, places))
}

/// The values of a frame; "nothing here" is no label.
fn values(frame: &SegmentFrame<'_>) -> Result<Vec<f32>, ReadImageError> {
    let plain = Rescale {
        slope: 1.0,
        intercept: 0.0,
    };
    let mut values = frame.plane.pixels.values(frame.plane.frame, plain)?;
    values
        .iter_mut()
        .filter(|value| value.is_nan())
        .for_each(|value| *value = 0.0);
    Ok(values)
}

/// One volume of the numbers of segments; `None` if two of them overlap.
fn labels(
    segments: &BTreeMap<u32, Vec<&SegmentFrame<'_>>>,
    frame: &VolumeFrame,
    most: u64,
) -> Result<Option<Vec<f32>>, ReadImageError> {
    ReadImageError::unless_voxels_fit(frame.voxel_count() as u64, most)?;
    let mut volume = vec![0.0_f32; frame.voxel_count()];
    let slice_size = frame.size()[0] * frame.size()[1];
    for (&number, frames) in segments {
        for one in frames {
            let place = one.slice * slice_size;
            let slice = volume
                .get_mut(place..place + slice_size)
                .unwrap_or_default();
            for (label, value) in slice.iter_mut().zip(values(one)?) {
                if value == 0.0 {
                    continue;
                }
                if *label != 0.0 && *label != number as f32 {
                    return Ok(None);
                }
                *label = number as f32;
            }
        }
    }
    Ok(Some(volume))
}

/// One volume of the numbers of frames.
fn volume_of(
    frames: &[&SegmentFrame<'_>],
    frame: &VolumeFrame,
    mark: Mark,
    most: u64,
) -> Result<Vec<f32>, ReadImageError> {
    ReadImageError::unless_voxels_fit(frame.voxel_count() as u64, most)?;
    let mut volume = vec![0.0_f32; frame.voxel_count()];
    let slice_size = frame.size()[0] * frame.size()[1];
    for one in frames {
        let place = one.slice * slice_size;
        let slice = volume
            .get_mut(place..place + slice_size)
            .unwrap_or_default();
        for (own, value) in slice.iter_mut().zip(values(one)?) {
            *own = match mark {
                Mark::Own => value,
                Mark::Share(full) => (f64::from(value) / full) as f32,
            };
        }
    }
    Ok(volume)
}
