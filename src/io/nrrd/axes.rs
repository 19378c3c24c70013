//! What the axes of an NRRD file are for, and where its voxels stand.

use super::header::{Field, NrrdHeader};
use super::space::Space;
use super::values::{Entry, entries, length_mm, quoted_words};
use crate::image::VolumeFrame;
use crate::io::ReadImageError;
use crate::io::image_file::Provenance;
use crate::io::image_source::quoted;
use crate::mesh::{Point3, Vector3};
use crate::study::Notice;

/// The grid, the axis of volumes, and what the file does not say.
#[derive(Debug)]
pub(super) struct NrrdAxes {
    pub frame: VolumeFrame,
    pub spacing: Provenance,
    pub position_known: bool,
    pub notices: Vec<Notice>,
    pub volumes: usize,
    /// Number of the axis of volumes, if there is one.
    pub volume_axis: Option<usize>,
    /// How many axes of voxels are faster than it.
    pub faster: usize,
    /// The step of time along it in `space directions`.
    pub time_step: Option<f64>,
}

/// Sorts the axes and places the grid.
///
/// # Errors
/// If there are not three axes of space and at most one of volumes, or they span no volume.
pub(super) fn axes(header: &NrrdHeader<'_>) -> Result<NrrdAxes, ReadImageError> {
    let space = Space::of(header)?;
    let directions = directions(header, &space)?;
    let kinds = kinds(header);
    let mut notices = Vec::new();
    let spatial = spatial_axes(header, directions.as_deref(), &kinds, &mut notices)?;
    let volume_axis = volume_axis(header, &kinds, spatial)?;
    let size = spatial.map(|axis| header.sizes[axis]);
    if size.contains(&0) {
        return Err(ReadImageError::InField {
            field: "sizes",
            reason: "an axis has no voxels".to_owned(),
        });
    }
    let place = match &directions {
        Some(directions) => placed(header, &space, directions, spatial)?,
        None => unplaced(header, spatial)?,
    };
    notices.extend(place.notices);
    let field = if directions.is_some() {
        "space directions"
    } else {
        "spacings"
    };
    let frame = VolumeFrame::new(size, place.origin, place.steps).map_err(|error| {
        ReadImageError::InField {
            field,
            reason: error.to_string(),
        }
    })?;
    if !place.position_known {
        notices.push(Notice::info(
            "position and orientation in the patient are not in the file",
        ));
    }
    let along = |axis| {
        directions
            .as_ref()?
            .get::<usize>(axis)?
            .as_ref()?
            .get(3)
            .copied()
    };
    Ok(NrrdAxes {
        frame,
        spacing: place.spacing,
        position_known: place.position_known,
        notices,
        volumes: volume_axis.map_or(1, |axis| header.sizes[axis]),
        volume_axis,
        faster: volume_axis.map_or(3, |axis| spatial.iter().filter(|own| **own < axis).count()),
        time_step: volume_axis.and_then(along),
    })
}

/// A vector for each axis of space, in coordinates of the file; `None` for other axes.
type Directions = Vec<Option<Vec<f64>>>;

fn directions(
    header: &NrrdHeader<'_>,
    space: &Space,
) -> Result<Option<Directions>, ReadImageError> {
    let Some(field) = header.field("spacedirections") else {
        return Ok(None);
    };
    let found = entries(field, "space directions")?;
    if found.len() != header.sizes.len() {
        return Err(ReadImageError::AtLine {
            line: field.line,
            reason: format!(
                "{} space directions for {} axes",
                found.len(),
                header.sizes.len()
            ),
        });
    }
    let vector = |entry| match entry {
        Entry::None => Ok(None),
        Entry::Vector(numbers) if numbers.len() == space.coordinates => {
            // Some programs write a vector of NaN for an axis without direction.
            Ok(Some(numbers).filter(|numbers| !numbers.iter().all(|x| x.is_nan())))
        }
        Entry::Vector(numbers) => Err(ReadImageError::AtLine {
            line: field.line,
            reason: format!(
                "a space direction of {} numbers in a space of {}",
                numbers.len(),
                space.coordinates
            ),
        }),
    };
    found
        .into_iter()
        .map(vector)
        .collect::<Result<_, _>>()
        .map(Some)
}

/// Kinds of the axes in small letters; empty where none is said.
fn kinds(header: &NrrdHeader<'_>) -> Vec<String> {
    let words = header
        .field("kinds")
        .map(|field| field.value.to_ascii_lowercase());
    let words = words.unwrap_or_default();
    let mut kinds: Vec<String> = words.split_whitespace().map(str::to_owned).collect();
    kinds.resize(header.sizes.len(), String::new());
    kinds
}

/// The three axes of space: those with a direction; else those whose kind says so; else all that are not of another kind.
fn spatial_axes(
    header: &NrrdHeader<'_>,
    directions: Option<&[Option<Vec<f64>>]>,
    kinds: &[String],
    notices: &mut Vec<Notice>,
) -> Result<[usize; 3], ReadImageError> {
    let count = header.sizes.len();
    let by_direction = |axis: usize| {
        let vector = directions
            .and_then(|all| all.get(axis))
            .and_then(Option::as_ref);
        vector.is_some_and(|vector| vector.iter().take(3).any(|x| *x != 0.0))
    };
    let of_space = |axis: usize| ["domain", "space"].contains(&kinds[axis].as_str());
    let unsaid = |axis: usize| ["", "???", "none"].contains(&kinds[axis].as_str());
    let mut found: Vec<usize> = if directions.is_some() {
        (0..count).filter(|axis| by_direction(*axis)).collect()
    } else {
        (0..count)
            .filter(|axis| of_space(*axis) || unsaid(*axis))
            .collect()
    };
    if directions.is_none() && found.len() == 4 {
        notices.push(Notice::warning(
            "the header does not say which of four axes is that of volumes: the last one is taken",
        ));
        found.pop();
    }
    <[usize; 3]>::try_from(found).map_err(|found| {
        ReadImageError::Unsupported(format!(
            "{} of {count} axes are of space: not a volume",
            found.len()
        ))
    })
}

/// The axis that is not of space, if one has more than one entry.
fn volume_axis(
    header: &NrrdHeader<'_>,
    kinds: &[String],
    spatial: [usize; 3],
) -> Result<Option<usize>, ReadImageError> {
    let others = (0..header.sizes.len()).filter(|axis| !spatial.contains(axis));
    let mut volume_axes = others.filter(|axis| header.sizes[*axis] != 1);
    let volume_axis = volume_axes.next();
    if volume_axes.next().is_some() {
        let reason = "more than one axis is not of space: only one axis of volumes is read";
        return Err(ReadImageError::Unsupported(reason.to_owned()));
    }
    if let Some(axis) = volume_axis {
        refuse_components(header, kinds, axis)?;
    }
    Ok(volume_axis)
}

/// An axis that is neither of space nor of volumes holds several numbers a voxel.
fn refuse_components(
    header: &NrrdHeader<'_>,
    kinds: &[String],
    axis: usize,
) -> Result<(), ReadImageError> {
    let kind = kinds[axis].as_str();
    let volumes = ["", "???", "none", "list", "time", "domain", "space"].contains(&kind);
    // The MultiVolume module of Slicer writes frames as components.
    let multi_volume = kind == "vector" && header.key("multivolume.numberofframes").is_some();
    if volumes || multi_volume {
        return Ok(());
    }
    Err(ReadImageError::Unsupported(format!(
        "axis {} holds {} numbers a voxel (kind {}), not one",
        axis + 1,
        header.sizes[axis],
        quoted(kind)
    )))
}

/// Where voxels stand.
struct GridPlace {
    origin: Point3,
    steps: [Vector3; 3],
    spacing: Provenance,
    position_known: bool,
    notices: Vec<Notice>,
}

/// By `space directions` and `space origin`.
fn placed(
    header: &NrrdHeader<'_>,
    space: &Space,
    directions: &[Option<Vec<f64>>],
    spatial: [usize; 3],
) -> Result<GridPlace, ReadImageError> {
    let mut notices = Vec::new();
    let words = header
        .field("spaceunits")
        .map(|field| quoted_words(&field.value));
    let units = [0, 1, 2].map(|k| {
        let word = words.as_ref().and_then(|words| words.get(k));
        word.and_then(|word| length_mm(word))
    });
    let unit_mm = units.map(|unit| unit.unwrap_or(1.0));
    let unit_known = units.iter().all(Option::is_some);
    if !unit_known {
        notices.push(Notice::info("no unit of length: millimetres assumed"));
    }
    let steps = spatial.map(|axis| {
        let vector = directions.get(axis).and_then(Option::as_deref);
        space.to_lps(vector.unwrap_or_default(), unit_mm)
    });
    let origin = header
        .field("spaceorigin")
        .map(|field| origin(field, space))
        .transpose()?;
    let position_known = space.to_lps.is_some() && origin.is_some();
    let origin = space.to_lps(&origin.unwrap_or_default(), unit_mm);
    Ok(GridPlace {
        origin: Point3::from(origin),
        steps,
        spacing: if unit_known {
            Provenance::Stated
        } else {
            Provenance::UnitAssumed
        },
        position_known,
        notices,
    })
}

fn origin(field: &Field, space: &Space) -> Result<Vec<f64>, ReadImageError> {
    match &entries(field, "space origin")?[..] {
        [Entry::Vector(numbers)] if numbers.len() == space.coordinates => Ok(numbers.clone()),
        _ => Err(ReadImageError::AtLine {
            line: field.line,
            reason: format!(
                "space origin: not one vector of {} numbers",
                space.coordinates
            ),
        }),
    }
}

/// By `spacings` alone, along the axes of the world.
fn unplaced(header: &NrrdHeader<'_>, spatial: [usize; 3]) -> Result<GridPlace, ReadImageError> {
    let mut notices = Vec::new();
    let spacings = super::values::numbers(header, "spacings")?.unwrap_or_default();
    let words = header
        .field("units")
        .map(|field| quoted_words(&field.value))
        .unwrap_or_default();
    let (mut all_said, mut all_units) = (true, true);
    let mut steps = [Vector3::x(), Vector3::y(), Vector3::z()];
    for (step, axis) in steps.iter_mut().zip(spatial) {
        let length = spacings.get(axis).map(|length| length.abs());
        let length = length.filter(|length| length.is_finite() && *length > 0.0);
        let unit = words.get(axis).and_then(|word| length_mm(word));
        all_said &= length.is_some();
        all_units &= unit.is_some();
        *step *= length.map_or(1.0, |length| length * unit.unwrap_or(1.0));
    }
    if !all_said {
        notices.push(Notice::warning(
            "some distances between voxels are unknown: 1 mm stands for them",
        ));
    } else if !all_units {
        notices.push(Notice::info("no unit of length: millimetres assumed"));
    }
    Ok(GridPlace {
        origin: Point3::origin(),
        steps,
        spacing: match (all_said, all_units) {
            (false, _) => Provenance::Missing,
            (true, false) => Provenance::UnitAssumed,
            (true, true) => Provenance::Stated,
        },
        position_known: false,
        notices,
    })
}
