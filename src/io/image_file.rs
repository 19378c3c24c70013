//! What one series of images is, whatever the format: a volume over time, with what its files do not say told as such.

pub use crate::image::Modality;
use crate::image::{Image, ImageError, VolumeFrame};
use crate::study::Notice;

/// The volumes of one series: of one file, or of all DICOM files of a series.
#[derive(Clone, Debug, PartialEq)]
pub struct ImageSeries {
    /// A neutral name made from numbers and technical words; free text of a file never gets here.
    pub name: String,
    /// The format as people call it: `NIfTI-1`, `NRRD`, `MetaImage`, `DICOM`.
    pub format: &'static str,
    /// The kind of machine, where the file says it.
    pub modality: Option<Modality>,
    /// Where the voxels stand, and their values at each instant. Its times are `None` where the files say none.
    pub image: Image,
    /// The gate of each volume, if the series is gated.
    pub gates: Option<Gates>,
    /// Where the distances between voxels come from.
    pub spacing: Provenance,
    /// Where the times come from: `Missing` exactly where `image` has several volumes and no times.
    pub times: Provenance,
    /// Whether position and orientation in the patient are those of the file; otherwise voxel 0 stands in the origin and
    /// the axes are those of the grid.
    pub position_known: bool,
    /// What was left out or assumed.
    pub notices: Vec<Notice>,
}

/// Parts of the beat that the volumes of a gated series belong to.
#[derive(Clone, Debug, PartialEq)]
pub struct Gates {
    /// The number of the gate of each volume, counted from 1, in the order of the volumes.
    pub numbers: Vec<u32>,
    /// The time between two R waves in milliseconds, where the file says it.
    pub cycle_ms: Option<f64>,
}

/// Where numbers with a unit come from: the distances between voxels, or the times of volumes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Provenance {
    /// The file says them, in a unit that the file or its format says.
    Stated,
    /// The file says numbers without a unit; one was assumed, and a note says which.
    UnitAssumed,
    /// The file does not say all of them, and somebody must be asked. 1 mm stands where a distance is not said; times are
    /// none.
    Missing,
}

impl Provenance {
    /// The word for it in tables and JSON.
    pub fn word(self) -> &'static str {
        match self {
            Self::Stated => "from the file",
            Self::UnitAssumed => "unit assumed",
            Self::Missing => "missing",
        }
    }
}

impl ImageSeries {
    /// Whether somebody must be asked for the distances between voxels before lengths mean anything.
    pub fn spacing_known(&self) -> bool {
        self.spacing != Provenance::Missing
    }

    /// Whether each volume has a time; a single volume needs none.
    pub fn times_known(&self) -> bool {
        self.times != Provenance::Missing
    }
}

/// A name of a series that says nothing of a patient: `NIfTI-1, 40 × 44 × 14, 6 volumes`.
pub fn neutral_name(what: &str, frame: &VolumeFrame, volumes: usize) -> String {
    let [i, j, k] = frame.size();
    match volumes {
        1 => format!("{what}, {i} × {j} × {k}"),
        _ => format!("{what}, {i} × {j} × {k}, {volumes} volumes"),
    }
}

/// Why an image file cannot be read; shown after the file's name. Quotes no free text of a file.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ReadImageError {
    /// The first bytes are of no format that can be read.
    #[error("not an image format that can be read ({known})")]
    UnknownFormat {
        /// Names of those that can.
        known: String,
    },
    /// The file is larger than the limit.
    #[error("{size} bytes; the limit is {most}")]
    TooLarge {
        /// Its size.
        size: u64,
        /// The limit.
        most: u64,
    },
    /// It declares or holds more items than the limit.
    #[error("{count} {what}; the limit is {most}")]
    TooMany {
        /// `voxels`, `volumes`, …
        what: &'static str,
        /// How many.
        count: u64,
        /// The limit.
        most: u64,
    },
    /// A header of numbers is wrong at a byte, counted from 0, in the file as it is unpacked.
    #[error("byte {byte}: {reason}")]
    AtByte {
        /// The offset.
        byte: u64,
        /// What is wrong there.
        reason: String,
    },
    /// A header of text is wrong at a line, counted from 1.
    #[error("line {line}: {reason}")]
    AtLine {
        /// The line.
        line: usize,
        /// What is wrong there.
        reason: String,
    },
    /// A header lacks something, or says something that cannot be.
    #[error("{field}: {reason}")]
    InField {
        /// The name of the field in the format.
        field: &'static str,
        /// What is wrong.
        reason: String,
    },
    /// A sound file of a kind that is not read: colours, complex numbers, a codec.
    #[error("{0}")]
    Unsupported(String),
    /// The values end too early.
    #[error(
        "the values of the voxels take {expected} bytes, but only {present} are there: the file is cut short"
    )]
    Truncated {
        /// Bytes that the header calls for.
        expected: u64,
        /// Bytes that are there.
        present: u64,
    },
    /// Packed values cannot be unpacked.
    #[error("the values cannot be unpacked after {unpacked} bytes: {reason}")]
    Unpack {
        /// Bytes that were unpacked until there.
        unpacked: u64,
        /// What the unpacker says.
        reason: String,
    },
    /// Values stand in another file, which cannot be had.
    #[error("{field} names a file with the values: {reason}")]
    DataFile {
        /// The field of the header that names it, or how its name is made.
        field: &'static str,
        /// Why it cannot be had.
        reason: String,
    },
    /// Grid and values do not belong together, or the grid is none.
    #[error(transparent)]
    Image(#[from] ImageError),
}

impl ReadImageError {
    /// Refuses more voxels than `most`.
    pub(super) fn unless_voxels_fit(count: u64, most: u64) -> Result<(), Self> {
        match count > most {
            true => Err(Self::TooMany {
                what: "voxels",
                count,
                most,
            }),
            false => Ok(()),
        }
    }
}

impl From<crate::image::FrameError> for ReadImageError {
    fn from(error: crate::image::FrameError) -> Self {
        Self::Image(error.into())
    }
}
