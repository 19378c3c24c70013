//! Reads an NRRD file: a volume, or a sequence of volumes as Slicer writes them.

use super::axes::{NrrdAxes, axes};
use super::header::{Encoding, NrrdHeader};
use super::values::{numbers, quoted_words, time_ms};
use crate::image::Image;
use crate::io::data_files::joined_files;
use crate::io::image_file::{ImageSeries, ReadImageError, neutral_name};
use crate::io::image_source::{HeaderLines, ImageSource};
use crate::io::image_times::VolumeTimes;
use crate::io::packed::Packing;
use crate::io::voxels::{Scaling, Values, VolumeOrder, VoxelLayout, read_text_values, read_values};

/// Reads NRRD, attached or detached.
///
/// # Errors
/// If the header says what cannot be or is not read, or values are missing.
pub(in crate::io) fn read_nrrd(source: &ImageSource<'_>) -> Result<ImageSeries, ReadImageError> {
    let header = NrrdHeader::read(source.bytes)?;
    let axes = axes(&header)?;
    let volumes = VolumeOrder::new(axes.frame.size(), axes.volumes, axes.faster, source.limits)?;
    let layout = VoxelLayout {
        scalar: header.scalar,
        order: header.order()?,
        scaling: Scaling::NONE,
        volumes,
    };
    let times = times(&header, &axes)?;
    let values = values(source, &header, &layout)?;
    let name = neutral_name("NRRD", &axes.frame, values.volumes.len());
    let mut notices = axes.notices;
    notices.extend(values.notices);
    notices.extend(times.notices);
    Ok(ImageSeries {
        name,
        format: "NRRD",
        modality: None,
        image: Image::new(axes.frame, values.volumes, times.times_ms)?,
        gates: None,
        spacing: axes.spacing,
        times: times.source,
        position_known: axes.position_known,
        notices,
    })
}

/// The values after the header, or of the files that it names.
fn values(
    source: &ImageSource<'_>,
    header: &NrrdHeader<'_>,
    layout: &VoxelLayout,
) -> Result<Values, ReadImageError> {
    const FIELD: &str = "data file";
    let packing = match header.encoding {
        Encoding::Gzip => Packing::Gzip,
        Encoding::Raw | Encoding::Text => Packing::Plain,
    };
    let (lines, bytes) = (header.whole("lineskip")?, header.whole("byteskip")?);
    let raw = header.encoding == Encoding::Raw;
    if lines < 0 || bytes < -1 || (bytes == -1 && !raw) {
        return Err(ReadImageError::InField {
            field: "byte skip",
            reason: "the values cannot begin there".to_owned(),
        });
    }
    // Where the values of a file begin; a skip of -1 means that they are its last bytes.
    let begin = move |file: &[u8], expected: u64| {
        if bytes == -1 {
            let before = (file.len() as u64).saturating_sub(expected);
            return (usize::try_from(before).unwrap_or(usize::MAX), 0);
        }
        let mut rest = HeaderLines::new(file);
        for _ in 0..lines {
            if rest.next().is_none() {
                break;
            }
        }
        (file.len() - rest.rest().len(), bytes.unsigned_abs())
    };
    let expected = layout.bytes();
    let own;
    let file = match header.data_files.as_deref() {
        None => header.rest,
        Some([name]) => {
            own = (source.sibling)(name).map_err(|reason| ReadImageError::DataFile {
                field: FIELD,
                reason,
            })?;
            &own[..]
        }
        Some(_) if header.encoding == Encoding::Text => {
            let reason = "values as text in several files are not read".to_owned();
            return Err(ReadImageError::Unsupported(reason));
        }
        Some(names) => {
            let all = joined_files(source, names, FIELD, packing, expected, &begin)?;
            return read_values(&all, Packing::Plain, 0, layout);
        }
    };
    let (at, skip) = begin(file, expected);
    let rest = file.get(at..).unwrap_or_default();
    if header.encoding == Encoding::Text {
        let skip = usize::try_from(skip).unwrap_or(usize::MAX);
        return read_text_values(rest.get(skip..).unwrap_or_default(), layout);
    }
    read_values(rest, packing, skip, layout)
}

/// Times of the volumes: listed by Slicer's sequences or its MultiVolume module, or steps along the axis.
fn times(header: &NrrdHeader<'_>, axes: &NrrdAxes) -> Result<VolumeTimes, ReadImageError> {
    let Some(axis) = axes.volume_axis else {
        return Ok(VolumeTimes::of_one_volume());
    };
    let units = header
        .field("units")
        .map(|field| quoted_words(&field.value))
        .unwrap_or_default();
    let unit_ms = units.get(axis).and_then(|unit| time_ms(unit));
    if let Some(values) = header.key(&format!("axis {axis} index values")) {
        let numeric = header.key(&format!("axis {axis} index type"));
        if numeric.is_some_and(|kind| !kind.eq_ignore_ascii_case("numeric")) {
            return Ok(VolumeTimes::missing(
                "the volumes have words for an index: their times are unknown",
            ));
        }
        return Ok(listed(values.split_whitespace(), axes.volumes, unit_ms));
    }
    if let Some(labels) = header.key("multivolume.framelabels") {
        let tag = header
            .key("multivolume.frameidentifyingdicomtagname")
            .unwrap_or_default();
        if !["triggertime", "contenttime", "acquisitiontime", "time"]
            .contains(&tag.to_ascii_lowercase().as_str())
        {
            return Ok(VolumeTimes::missing(
                "the volumes are not sorted by time: their times are unknown",
            ));
        }
        let unit = header.key("multivolume.frameidentifyingdicomtagunits");
        return Ok(listed(
            labels.split(','),
            axes.volumes,
            unit.and_then(time_ms),
        ));
    }
    let space_units = header
        .field("spaceunits")
        .map(|field| quoted_words(&field.value));
    let space_unit = space_units.as_ref().and_then(|units| units.get(3));
    if let Some(step) = axes.time_step {
        let unit_ms = space_unit.and_then(|unit| time_ms(unit));
        return Ok(VolumeTimes::of_steps(0.0, step, axes.volumes, unit_ms));
    }
    let spacings = numbers(header, "spacings")?.unwrap_or_default();
    Ok(
        match spacings
            .get(axis)
            .filter(|step| step.is_finite() && **step > 0.0)
        {
            Some(step) => VolumeTimes::of_steps(0.0, *step, axes.volumes, unit_ms),
            None => VolumeTimes::missing("the file gives no times of its volumes"),
        },
    )
}

/// Times that are listed, one for each volume.
fn listed<'w>(
    words: impl Iterator<Item = &'w str>,
    volumes: usize,
    unit_ms: Option<f64>,
) -> VolumeTimes {
    let values: Option<Vec<f64>> = words.map(|word| word.trim().parse().ok()).collect();
    match values.filter(|values| values.len() == volumes) {
        Some(values) => VolumeTimes::of_values(values, unit_ms),
        None => VolumeTimes::missing(
            "the list of times has not one number for each volume: times are unknown",
        ),
    }
}
