//! One image of a slice at one instant, with all that says where and when it was taken.

use std::sync::Arc;

use super::element::DataSet;
use super::pixels::{Pixels, Rescale};
use super::tag::{
    ACQUISITION_NUMBER, ACQUISITION_TIME, CARDIAC_DELAY, CARDIAC_PERCENT, CONTENT_TIME, ECHO_TIME,
    FRAME_OF_REFERENCE, FRAME_REFERENCE_TIME, IMAGE_TYPE, IMAGES_OF_A_BEAT, INSTANCE_NUMBER,
    INTERCEPT, MODALITY, NOMINAL_INTERVAL, ORIENTATION, PIXEL_SPACING, POSITION,
    RR_INTERVAL_NOMINAL, SCANNING_SEQUENCE, SEQUENCE_VARIANT, SERIES, SERIES_NUMBER,
    SLICE_THICKNESS, SLOPE, SOP_CLASS, SOP_INSTANCE, STUDY, TEMPORAL_POSITION,
    TEMPORAL_POSITION_INDEX, TRIGGER_TIME, Tag,
};
use crate::io::image_file::Modality;
use crate::mesh::{Point3, Vector3};

/// What all images of one file share. Nothing of it is shown but the modality and numbers.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct FileFacts {
    /// Its place in the order of the files.
    pub(super) number: usize,
    pub(super) study: String,
    pub(super) series: String,
    pub(super) series_number: Option<f64>,
    pub(super) frame_of_reference: String,
    pub(super) class: String,
    pub(super) instance: String,
    pub(super) modality: Option<Modality>,
    /// The words that say what kind of image it is.
    pub(super) image_type: Vec<String>,
    /// The words for the way in which it was taken.
    pub(super) sequence: [String; 2],
    pub(super) acquisition: Option<f64>,
    /// How many instants of a beat were taken of each slice.
    pub(super) images_of_a_beat: Option<usize>,
}

/// One slice at one instant.
#[derive(Clone, Debug)]
pub(super) struct Plane {
    pub(super) facts: Arc<FileFacts>,
    pub(super) pixels: Arc<Pixels>,
    pub(super) frame: usize,
    pub(super) rescale: Rescale,
    pub(super) place: Option<SlicePlace>,
    /// Distance of rows, then of columns, in millimetres.
    pub(super) spacing: Option<[f64; 2]>,
    pub(super) thickness_mm: Option<f64>,
    pub(super) echo_ms: Option<f64>,
    pub(super) cycle_ms: Option<f64>,
    pub(super) when: When,
}

/// Where the first pixel of a slice stands, and the directions along a row and down a column (PS3.3, C.7.6.2.1.1).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct SlicePlace {
    pub(super) origin: Point3,
    pub(super) row: Vector3,
    pub(super) column: Vector3,
}

/// What a file says of an instant, in the order in which it is believed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct When(pub(super) [Option<f64>; INSTANT_KEYS.len()]);

/// A number that orders the instants of one slice.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum InstantKey {
    /// Milliseconds after the R wave: TriggerTime, or its nominal value.
    AfterRWave,
    /// Share of the beat in percent.
    Percent,
    /// Which volume of the series it is.
    Index,
    /// Milliseconds after the series began.
    Reference,
    /// Time of the day in seconds.
    Clock,
    /// The number of the image.
    Instance,
}

pub(super) const INSTANT_KEYS: [(InstantKey, &str); 10] = [
    (InstantKey::AfterRWave, "TriggerTime"),
    (InstantKey::AfterRWave, "NominalCardiacTriggerDelayTime"),
    (InstantKey::Percent, "NominalPercentageOfCardiacPhase"),
    (InstantKey::Index, "TemporalPositionIndex"),
    (InstantKey::Index, "TemporalPositionIdentifier"),
    (InstantKey::Index, "DimensionIndexValues"),
    (InstantKey::Reference, "FrameReferenceTime"),
    (InstantKey::Clock, "AcquisitionTime"),
    (InstantKey::Clock, "ContentTime"),
    (InstantKey::Instance, "InstanceNumber"),
];
/// The place of the index by dimensions among the keys.
const BY_DIMENSION: usize = 5;

impl FileFacts {
    pub(super) fn new(set: &DataSet<'_>, number: usize) -> Self {
        let text = |tag| set.text(tag).unwrap_or_default().to_owned();
        Self {
            number,
            study: text(STUDY),
            series: text(SERIES),
            series_number: set.number(SERIES_NUMBER),
            frame_of_reference: text(FRAME_OF_REFERENCE),
            class: text(SOP_CLASS),
            instance: text(SOP_INSTANCE),
            modality: set.text(MODALITY).map(modality),
            image_type: set
                .words(IMAGE_TYPE)
                .into_iter()
                .map(str::to_owned)
                .collect(),
            sequence: [text(SCANNING_SEQUENCE), text(SEQUENCE_VARIANT)],
            acquisition: set.number(ACQUISITION_NUMBER),
            images_of_a_beat: set.count(IMAGES_OF_A_BEAT),
        }
    }

    /// Whether a word is among those that say what kind of image it is.
    pub(super) fn is_kind(&self, word: &str) -> bool {
        self.image_type.iter().any(|own| own == word)
    }
}

fn modality(letters: &str) -> Modality {
    match letters {
        "NM" => Modality::NuclearMedicine,
        "PT" => Modality::PositronEmission,
        "MR" => Modality::MagneticResonance,
        "CT" => Modality::ComputedTomography,
        "US" => Modality::Ultrasound,
        "SEG" => Modality::Segmentation,
        _ => Modality::Other,
    }
}

impl SlicePlace {
    /// From a position and an orientation of a file; `None` if they are missing or no directions.
    pub(super) fn new(position: Option<Vec<f64>>, orientation: Option<Vec<f64>>) -> Option<Self> {
        let origin = position?;
        let [x, y, z] = *origin.first_chunk()?;
        let [row, column] = directions(orientation)?;
        Some(Self {
            origin: Point3::new(x, y, z),
            row,
            column,
        })
    }

    /// The direction that is normal to the slice, on the side of row × column.
    pub(super) fn normal(&self) -> Vector3 {
        self.row.cross(&self.column).normalize()
    }
}

/// The directions along a row and down a column, of length 1; `None` if they are missing or not normal to each other.
pub(super) fn directions(orientation: Option<Vec<f64>>) -> Option<[Vector3; 2]> {
    let [a, b, c, d, e, f] = *orientation?.first_chunk()?;
    let (row, column) = (Vector3::new(a, b, c), Vector3::new(d, e, f));
    let lengths = row.norm() * column.norm();
    // Written with few digits in real files; a tenth of a degree is far more than that.
    let normal = lengths > 0.0 && (row.dot(&column) / lengths).abs() < 2e-3;
    normal.then(|| [row.normalize(), column.normalize()])
}

impl When {
    /// From the data sets that may say it, the first that does counts.
    pub(super) fn new(sets: &[&DataSet<'_>]) -> Self {
        let number = |tag| first_number(sets, tag);
        let clock = |tag| sets.iter().find_map(|set| set.text(tag).and_then(seconds));
        Self([
            number(TRIGGER_TIME),
            number(CARDIAC_DELAY),
            number(CARDIAC_PERCENT),
            number(TEMPORAL_POSITION_INDEX),
            number(TEMPORAL_POSITION),
            None,
            number(FRAME_REFERENCE_TIME),
            clock(ACQUISITION_TIME),
            clock(CONTENT_TIME),
            number(INSTANCE_NUMBER),
        ])
    }

    pub(super) fn with_dimension(mut self, index: Option<f64>) -> Self {
        self.0[BY_DIMENSION] = index;
        self
    }

    /// The number of an image of several frames is followed by that of the frame.
    pub(super) fn of_frame(mut self, frame: usize, frames: usize) -> Self {
        if frames > 1
            && let Some(last) = self.0.last_mut()
        {
            *last = Some(last.unwrap_or(0.0) * MAX_FRAMES + frame as f64);
        }
        self
    }
}

/// More frames than a file has.
const MAX_FRAMES: f64 = 1_000_000.0;

/// The number of an attribute in the first set that has it.
pub(super) fn first_number(sets: &[&DataSet<'_>], tag: Tag) -> Option<f64> {
    sets.iter().find_map(|set| set.number(tag))
}

/// Seconds of `HHMMSS.FFFFFF`.
fn seconds(text: &str) -> Option<f64> {
    let part = |range: std::ops::Range<usize>| text.get(range)?.parse::<f64>().ok();
    let rest = text.get(4..)?.parse::<f64>().ok()?;
    Some(part(0..2)? * 3600.0 + part(2..4)? * 60.0 + rest)
}

/// The factor and the number that is added; a factor of 0 means that there is none.
pub(super) fn rescale(sets: &[&DataSet<'_>]) -> Rescale {
    let slope = first_number(sets, SLOPE).filter(|&slope| slope != 0.0);
    Rescale {
        slope: slope.unwrap_or(1.0),
        intercept: first_number(sets, INTERCEPT).unwrap_or(0.0),
    }
}

/// Distances of rows and columns, if both are positive.
pub(super) fn spacing(numbers: Option<Vec<f64>>) -> Option<[f64; 2]> {
    let [rows, columns] = *numbers?.first_chunk()?;
    (rows > 0.0 && columns > 0.0).then_some([rows, columns])
}

impl Plane {
    /// A frame of a file, from the data sets that may describe it.
    pub(super) fn new(
        facts: &Arc<FileFacts>,
        pixels: &Arc<Pixels>,
        frame: usize,
        sets: &[&DataSet<'_>],
    ) -> Self {
        let numbers = |tag| sets.iter().find_map(|set| set.numbers(tag));
        let positive = |tag| first_number(sets, tag).filter(|&number| number > 0.0);
        Self {
            facts: Arc::clone(facts),
            pixels: Arc::clone(pixels),
            frame,
            rescale: rescale(sets),
            place: SlicePlace::new(numbers(POSITION), numbers(ORIENTATION)),
            spacing: spacing(numbers(PIXEL_SPACING)),
            thickness_mm: positive(SLICE_THICKNESS),
            echo_ms: positive(ECHO_TIME),
            cycle_ms: positive(NOMINAL_INTERVAL).or_else(|| positive(RR_INTERVAL_NOMINAL)),
            when: When::new(sets).of_frame(frame, pixels.layout.frames),
        }
    }

    /// Whether another plane has the same numbers.
    pub(super) fn same_numbers(&self, other: &Self) -> bool {
        self.rescale == other.rescale && self.pixels.same(self.frame, &other.pixels, other.frame)
    }

    /// How far the slice stands along a direction.
    pub(super) fn along(&self, direction: Vector3) -> f64 {
        (self.place).map_or(0.0, |place| place.origin.coords.dot(&direction))
    }
}
