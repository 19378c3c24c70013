//! Reads a NIfTI file: one volume, or volumes over time.

use super::header::{MAX_HEADER, NiftiHeader};
use super::placement::placement;
use crate::image::Image;
use crate::io::binary_cursor::Scalar;
use crate::io::image_file::{ImageSeries, Modality, ReadImageError, neutral_name};
use crate::io::image_source::ImageSource;
use crate::io::image_times::VolumeTimes;
use crate::io::packed::{Packing, unpacked_head};
use crate::io::voxels::{Scaling, VolumeOrder, VoxelLayout, read_values};
use crate::study::Notice;

/// Reads NIfTI-1 or NIfTI-2, packed or not, whose values may stand in a file beside it.
///
/// # Errors
/// If the header says what cannot be, the kind of numbers is none of an image, or values are missing.
pub(in crate::io) fn read_nifti(source: &ImageSource<'_>) -> Result<ImageSeries, ReadImageError> {
    let header = NiftiHeader::read(&unpacked_head(source.bytes, MAX_HEADER))?;
    let scalar = scalar(&header)?;
    let mut notices = Vec::new();
    let axes = axes(&header)?;
    let volumes = VolumeOrder::new(axes.size, axes.volumes, 3, source.limits)?;
    let place = placement(&header, axes.size)?;
    notices.extend(place.notices);
    if header.bitpix != 8 * scalar.size() as i64 {
        notices.push(Notice::warning(format!(
            "bitpix is {}, but the type of numbers has {} bits: the type is used",
            header.bitpix,
            8 * scalar.size()
        )));
    }
    let layout = VoxelLayout {
        scalar,
        order: header.order,
        scaling: scaling(&header)?,
        volumes,
    };
    let beside = if header.pair {
        Some(values_beside(source)?)
    } else {
        None
    };
    let bytes = beside.as_deref().unwrap_or(source.bytes);
    let values = read_values(bytes, Packing::of_file(bytes), header.vox_offset, &layout)?;
    notices.extend(values.notices);
    let times = times(&header, &axes);
    notices.extend(times.notices);
    let name = neutral_name(header.format(), &place.frame, values.volumes.len());
    Ok(ImageSeries {
        name,
        format: header.format(),
        modality: (header.intent == INTENT_LABEL).then_some(Modality::Segmentation),
        image: Image::new(place.frame, values.volumes, times.times_ms)?,
        gates: None,
        spacing: place.spacing,
        times: times.source,
        position_known: place.position_known,
        notices,
    })
}

/// NIFTI_INTENT_LABEL.
const INTENT_LABEL: i64 = 1002;

/// The type of stored numbers, or why they are none of an image.
fn scalar(header: &NiftiHeader) -> Result<Scalar, ReadImageError> {
    let refused = match header.datatype {
        2 => return Ok(Scalar::U8),
        4 => return Ok(Scalar::I16),
        8 => return Ok(Scalar::I32),
        16 => return Ok(Scalar::F32),
        64 => return Ok(Scalar::F64),
        256 => return Ok(Scalar::I8),
        512 => return Ok(Scalar::U16),
        768 => return Ok(Scalar::U32),
        1024 => return Ok(Scalar::I64),
        1280 => return Ok(Scalar::U64),
        1 => "one bit a voxel (datatype 1)",
        32 => "complex numbers of 64 bits (datatype 32)",
        128 => "colours, RGB24 (datatype 128)",
        1536 => "numbers of 128 bits (datatype 1536)",
        1792 => "complex numbers of 128 bits (datatype 1792)",
        2048 => "complex numbers of 256 bits (datatype 2048)",
        2304 => "colours, RGBA32 (datatype 2304)",
        other => {
            return Err(ReadImageError::InField {
                field: "datatype",
                reason: format!("{other} is no type of numbers"),
            });
        }
    };
    Err(ReadImageError::Unsupported(format!(
        "holds {refused}, not one number a voxel: convert it to numbers first"
    )))
}

/// What the axes are for.
struct Axes {
    size: [usize; 3],
    volumes: usize,
    /// Whether the volumes are along the fourth axis, that of time.
    in_time: bool,
}

/// Three axes of voxels, and at most one of volumes. Volumes along the fifth axis are accepted if the header does not say that
/// they are components of vectors.
fn axes(header: &NiftiHeader) -> Result<Axes, ReadImageError> {
    let size = [0, 1, 2].map(|axis| header.sizes.get(axis).copied().unwrap_or(1));
    let mut further = header
        .sizes
        .iter()
        .enumerate()
        .skip(3)
        .filter(|(_, size)| **size > 1);
    let (axis, volumes) = further.next().map_or((3, 1), |(axis, size)| (axis, *size));
    if let Some((second, count)) = further.next() {
        return Err(ReadImageError::Unsupported(format!(
            "{volumes} volumes along axis {} and {count} along axis {}: only one axis of volumes is read",
            axis + 1,
            second + 1
        )));
    }
    // Matrices, displacements, vectors, points, triangles, quaternions; colours.
    let vectors = matches!(header.intent, 1004..=1010 | 2003 | 2004);
    if axis > 3 && vectors {
        return Err(ReadImageError::Unsupported(format!(
            "holds {volumes} numbers a voxel (intent {}), not one",
            header.intent
        )));
    }
    Ok(Axes {
        size,
        volumes,
        in_time: axis == 3,
    })
}

/// Slope 0 or NaN means that stored numbers are values, whatever the intercept.
fn scaling(header: &NiftiHeader) -> Result<Scaling, ReadImageError> {
    let (slope, intercept) = (header.slope, header.intercept);
    if slope == 0.0 || slope.is_nan() {
        return Ok(Scaling::NONE);
    }
    if !slope.is_finite() || !intercept.is_finite() {
        return Err(ReadImageError::InField {
            field: "scl_slope",
            reason: format!("values cannot be {slope} × number + {intercept}"),
        });
    }
    Ok(Scaling { slope, intercept })
}

/// The values of a pair, in the file beside the header.
fn values_beside(source: &ImageSource<'_>) -> Result<Vec<u8>, ReadImageError> {
    let name = source.name;
    let stem = ["hdr.gz", "hdr"].into_iter().find_map(|ending| {
        let at = name.len().checked_sub(ending.len())?;
        let own = name.get(at..)?;
        own.eq_ignore_ascii_case(ending).then(|| &name[..at])
    });
    let mut reason = "the name of the header does not end in .hdr".to_owned();
    for ending in ["img", "img.gz", "IMG", "IMG.gz", "IMG.GZ"] {
        let Some(stem) = stem else { break };
        match (source.sibling)(&format!("{stem}{ending}")) {
            Ok(bytes) => return Ok(bytes),
            Err(why) if ending == "img" => reason = why,
            Err(_) => {}
        }
    }
    Err(ReadImageError::DataFile {
        field: "the pair (.hdr and .img)",
        reason,
    })
}

/// Times of the volumes, in milliseconds.
fn times(header: &NiftiHeader, axes: &Axes) -> VolumeTimes {
    if axes.volumes == 1 {
        return VolumeTimes::of_one_volume();
    }
    if !axes.in_time {
        return VolumeTimes::missing(
            "the volumes are not along the axis of time: their times are unknown",
        );
    }
    let unit_ms = match header.units & 0x38 {
        8 => Some(1e3),
        16 => Some(1.0),
        24 => Some(1e-3),
        32 | 40 | 48 => {
            return VolumeTimes::missing("the fourth axis is not one of time: times are unknown");
        }
        _ => None,
    };
    let offset = if header.time_offset.is_finite() {
        header.time_offset
    } else {
        0.0
    };
    VolumeTimes::of_steps(offset, header.pixdim[4], axes.volumes, unit_ms)
}
