//! Reads a MetaImage file: a volume, or volumes over time.

use super::header::{DataPlace, MetaHeader};
use crate::image::{Image, VolumeFrame};
use crate::io::binary_cursor::ByteOrder;
use crate::io::data_files::joined_files;
use crate::io::image_file::{ImageSeries, Provenance, ReadImageError, neutral_name};
use crate::io::image_source::ImageSource;
use crate::io::image_times::VolumeTimes;
use crate::io::packed::Packing;
use crate::io::voxels::{Scaling, Values, VolumeOrder, VoxelLayout, read_text_values, read_values};
use crate::mesh::{Point3, Vector3};
use crate::study::Notice;

/// Reads MetaImage, with the values in the same file or beside it.
///
/// # Errors
/// If the header says what cannot be or is not read, or values are missing.
pub(in crate::io) fn read_metaimage(
    source: &ImageSource<'_>,
) -> Result<ImageSeries, ReadImageError> {
    let header = MetaHeader::read(source.bytes)?;
    let (size, volumes) = sizes(&header)?;
    let order = VolumeOrder::new(size, volumes, 3, source.limits)?;
    let mut notices = Vec::new();
    let steps = steps(&header, &mut notices)?;
    let (frame, position_known) = placed(&header, size, &steps, &mut notices)?;
    let binary = header.flag("BinaryData").unwrap_or(true);
    if header.order().is_none() && header.scalar.size() > 1 && binary {
        notices.push(Notice::warning(
            "the header does not say which byte comes first: the least significant is assumed",
        ));
    }
    let layout = VoxelLayout {
        scalar: header.scalar,
        order: header.order().unwrap_or(ByteOrder::Little),
        scaling: scaling(&header, &mut notices)?,
        volumes: order,
    };
    let values = values(source, &header, &layout, binary)?;
    notices.extend(values.notices);
    let times = match steps.spacing.as_ref().and_then(|spacing| spacing.get(3)) {
        _ if volumes == 1 => VolumeTimes::of_one_volume(),
        Some(step) => VolumeTimes::of_steps(steps.offset(3), *step, volumes, None),
        None => VolumeTimes::missing("the file gives no times of its volumes"),
    };
    notices.extend(times.notices);
    let name = neutral_name("MetaImage", &frame, values.volumes.len());
    Ok(ImageSeries {
        name,
        format: "MetaImage",
        modality: header.modality(),
        image: Image::new(frame, values.volumes, times.times_ms)?,
        gates: None,
        spacing: match steps.spacing {
            Some(_) => Provenance::Stated,
            None => Provenance::Missing,
        },
        times: times.source,
        position_known,
        notices,
    })
}

/// Three axes of voxels, and one of volumes if there is a fourth.
fn sizes(header: &MetaHeader<'_>) -> Result<([usize; 3], usize), ReadImageError> {
    match header.sizes[..] {
        [i, j, k] => Ok(([i, j, k], 1)),
        [i, j, k, volumes] => Ok(([i, j, k], volumes)),
        [i, j, k, volumes, ref more @ ..] if more.iter().all(|size| *size == 1) => {
            Ok(([i, j, k], volumes))
        }
        _ => Err(ReadImageError::Unsupported(format!(
            "has {} axes: not a volume",
            header.sizes.len()
        ))),
    }
}

/// Steps, positions and directions as the header gives them, each with as many numbers as there are axes.
struct Steps {
    spacing: Option<Vec<f64>>,
    offset: Option<Vec<f64>>,
    /// Directions of the axes one after the other.
    directions: Option<Vec<f64>>,
    axes: usize,
}

impl Steps {
    fn offset(&self, axis: usize) -> f64 {
        let offset = self.offset.as_ref().and_then(|offset| offset.get(axis));
        offset.copied().unwrap_or(0.0)
    }
}

fn steps(header: &MetaHeader<'_>, notices: &mut Vec<Notice>) -> Result<Steps, ReadImageError> {
    let axes = header.sizes.len();
    let first = |keys: &[&'static str], count: usize| -> Result<Option<Vec<f64>>, ReadImageError> {
        for key in keys {
            if let Some(numbers) = header.list(key, count)? {
                return Ok(Some(numbers));
            }
        }
        Ok(None)
    };
    // Files from before ElementSpacing give the size of a voxel alone.
    let spacing = first(&["ElementSpacing", "ElementSize"], axes)?;
    if spacing.is_none() {
        notices.push(Notice::warning(
            "the distances between voxels are unknown: 1 mm stands for them",
        ));
    }
    Ok(Steps {
        spacing,
        offset: first(&["Offset", "Position", "Origin"], axes)?,
        directions: first(&["TransformMatrix", "Rotation", "Orientation"], axes * axes)?,
        axes,
    })
}

/// The grid. Numbers of `TransformMatrix` are the directions of one axis after the other, in LPS.
fn placed(
    header: &MetaHeader<'_>,
    size: [usize; 3],
    steps: &Steps,
    notices: &mut Vec<Notice>,
) -> Result<(VolumeFrame, bool), ReadImageError> {
    let unit_mm = header.unit_mm();
    let axis = |axis: usize| {
        let length = steps
            .spacing
            .as_ref()
            .and_then(|s| s.get(axis))
            .map_or(1.0, |s| s * unit_mm);
        let direction = match &steps.directions {
            Some(numbers) => {
                let number = |k: usize| numbers.get(axis * steps.axes + k).copied();
                Vector3::new(
                    number(0).unwrap_or(0.0),
                    number(1).unwrap_or(0.0),
                    number(2).unwrap_or(0.0),
                )
            }
            None => Vector3::ith(axis, 1.0),
        };
        direction * length
    };
    let origin = Point3::new(steps.offset(0), steps.offset(1), steps.offset(2)) * unit_mm;
    let frame = VolumeFrame::new(size, origin, [axis(0), axis(1), axis(2)]).map_err(|error| {
        ReadImageError::InField {
            field: "TransformMatrix and ElementSpacing",
            reason: error.to_string(),
        }
    })?;
    let known = steps.directions.is_some() && steps.offset.is_some();
    if !known {
        notices.push(Notice::info(
            "position and orientation in the patient are not in the file",
        ));
    }
    Ok((frame, known))
}

/// `ElementToIntensityFunction`, which few files have.
fn scaling(header: &MetaHeader<'_>, notices: &mut Vec<Notice>) -> Result<Scaling, ReadImageError> {
    let slope = header
        .one::<f64>("ElementToIntensityFunctionSlope")?
        .unwrap_or(1.0);
    let intercept = header
        .one::<f64>("ElementToIntensityFunctionOffset")?
        .unwrap_or(0.0);
    if !slope.is_finite() || !intercept.is_finite() || slope == 0.0 {
        return Err(ReadImageError::InField {
            field: "ElementToIntensityFunctionSlope",
            reason: format!("values cannot be {slope} × number + {intercept}"),
        });
    }
    let scaling = Scaling { slope, intercept };
    if scaling != Scaling::NONE {
        notices.push(Notice::info(format!(
            "values are {slope} × stored number + {intercept}, as the header says"
        )));
    }
    Ok(scaling)
}

/// The values after the header, or of the files that it names.
fn values(
    source: &ImageSource<'_>,
    header: &MetaHeader<'_>,
    layout: &VoxelLayout,
    binary: bool,
) -> Result<Values, ReadImageError> {
    const FIELD: &str = "ElementDataFile";
    let packed = header.flag("CompressedData").unwrap_or(false);
    // MetaIO writes zlib and reads gzip too.
    let packing = |file: &[u8]| match (packed, Packing::of_file(file)) {
        (false, _) => Packing::Plain,
        (true, Packing::Gzip) => Packing::Gzip,
        (true, _) => Packing::Zlib,
    };
    let skip = header.one::<i64>("HeaderSize")?.unwrap_or(0);
    if skip < -1 || (skip == -1 && packed) {
        return Err(ReadImageError::InField {
            field: "HeaderSize",
            reason: "the values cannot begin there".to_owned(),
        });
    }
    // A size of -1 means that the values are the last bytes.
    let begin = |file: &[u8], expected: u64| {
        let at = match skip {
            -1 => (file.len() as u64).saturating_sub(expected),
            _ => skip.unsigned_abs(),
        };
        (usize::try_from(at).unwrap_or(usize::MAX), 0)
    };
    let own;
    let file = match &header.place {
        DataPlace::Local => header.rest,
        DataPlace::Files(names) => match &names[..] {
            [name] => {
                own = (source.sibling)(name).map_err(|reason| ReadImageError::DataFile {
                    field: FIELD,
                    reason,
                })?;
                let (at, _) = begin(&own, layout.bytes());
                own.get(at..).unwrap_or_default()
            }
            _ if packed || !binary => {
                let reason = "packed values or text in several files are not read".to_owned();
                return Err(ReadImageError::Unsupported(reason));
            }
            names => {
                let plain = Packing::Plain;
                let all = joined_files(source, names, FIELD, plain, layout.bytes(), &begin)?;
                return read_values(&all, plain, 0, layout);
            }
        },
    };
    if binary {
        read_values(file, packing(file), 0, layout)
    } else {
        read_text_values(file, layout)
    }
}
