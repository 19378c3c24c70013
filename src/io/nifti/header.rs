//! The fixed header of NIfTI-1 (348 bytes) and NIfTI-2 (540 bytes), in either byte order.
//!
//! Source: nifti1.h and nifti2.h of the NIfTI Data Format Working Group. Free text of the header (`descrip`, `aux_file`,
//! `intent_name`, extensions) is never read, as names of patients stand there.

use crate::io::ReadImageError;
use crate::io::binary_cursor::{ByteOrder, Scalar};

/// Bytes that hold either header.
pub(in crate::io) const MAX_HEADER: usize = 540;

/// Which of the layouts a header has.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Version {
    One,
    Two,
    /// ANALYZE 7.5, on which NIfTI-1 was built: no orientation.
    Analyze,
}

impl Version {
    fn header_bytes(self) -> u64 {
        match self {
            Self::Two => 540,
            Self::One | Self::Analyze => 348,
        }
    }
}

/// Layout and byte order by the first bytes.
pub(in crate::io) fn recognises(head: &[u8]) -> bool {
    kind(head).is_some()
}

/// Layout, byte order, and whether the values stand in another file.
fn kind(head: &[u8]) -> Option<(Version, ByteOrder, bool)> {
    let first: [u8; 4] = head.get(..4)?.try_into().ok()?;
    let size = [
        (ByteOrder::Little, i32::from_le_bytes(first)),
        (ByteOrder::Big, i32::from_be_bytes(first)),
    ];
    let (order, size) = size
        .into_iter()
        .find(|(_, size)| [348, 540].contains(size))?;
    if size == 540 {
        return match head.get(4..12)? {
            b"n+2\0\r\n\x1a\n" => Some((Version::Two, order, false)),
            b"ni2\0\r\n\x1a\n" => Some((Version::Two, order, true)),
            _ => None,
        };
    }
    match head.get(344..348)? {
        b"n+1\0" => Some((Version::One, order, false)),
        b"ni1\0" => Some((Version::One, order, true)),
        _ => {
            let dimensions = Scalar::I16.number(head.get(40..42)?, order);
            let possible = (1.0..=7.0).contains(&dimensions);
            possible.then_some((Version::Analyze, order, true))
        }
    }
}

/// What the header says, in the terms of the standard.
#[derive(Clone, Debug)]
pub(super) struct NiftiHeader {
    pub version: Version,
    pub order: ByteOrder,
    /// Whether the values stand in another file.
    pub pair: bool,
    /// Sizes of the axes, as many as there are.
    pub sizes: Vec<usize>,
    pub intent: i64,
    pub datatype: i64,
    pub bitpix: i64,
    pub pixdim: [f64; 8],
    /// Where the values begin.
    pub vox_offset: u64,
    pub slope: f64,
    pub intercept: f64,
    pub units: u8,
    pub time_offset: f64,
    pub qform_code: i64,
    pub sform_code: i64,
    /// b, c, d.
    pub quaternion: [f64; 3],
    pub qoffset: [f64; 3],
    /// Rows of the sform.
    pub srow: [[f64; 4]; 3],
}

/// Places of fields, which differ between the layouts.
struct Places {
    /// Type and place of `dim[0]`.
    dim: (Scalar, usize),
    intent: (Scalar, usize),
    datatype: usize,
    bitpix: usize,
    /// Type of all numbers with fractions.
    real: Scalar,
    pixdim: usize,
    vox_offset: (Scalar, usize),
    slope: usize,
    units: (Scalar, usize),
    time_offset: usize,
    qform_code: (Scalar, usize),
    quaternion: usize,
    srow: usize,
}

const ONE: Places = Places {
    dim: (Scalar::I16, 40),
    intent: (Scalar::I16, 68),
    datatype: 70,
    bitpix: 72,
    real: Scalar::F32,
    pixdim: 76,
    vox_offset: (Scalar::F32, 108),
    slope: 112,
    units: (Scalar::U8, 123),
    time_offset: 136,
    qform_code: (Scalar::I16, 252),
    quaternion: 256,
    srow: 280,
};

const TWO: Places = Places {
    dim: (Scalar::I64, 16),
    intent: (Scalar::I32, 504),
    datatype: 12,
    bitpix: 14,
    real: Scalar::F64,
    pixdim: 104,
    vox_offset: (Scalar::I64, 168),
    slope: 176,
    units: (Scalar::I32, 500),
    time_offset: 216,
    qform_code: (Scalar::I32, 344),
    quaternion: 352,
    srow: 400,
};

impl NiftiHeader {
    /// Reads the header from the first bytes of the unpacked file.
    ///
    /// # Errors
    /// If it is none, ends too early, or says sizes or places that cannot be.
    pub(super) fn read(head: &[u8]) -> Result<Self, ReadImageError> {
        let (version, order, pair) = kind(head).ok_or(ReadImageError::AtByte {
            byte: 0,
            reason: "no NIfTI header".to_owned(),
        })?;
        if version == Version::Analyze {
            let reason = "an ANALYZE 7.5 image, which says neither orientation nor position: convert it to NIfTI";
            return Err(ReadImageError::Unsupported(reason.to_owned()));
        }
        if (head.len() as u64) < version.header_bytes() {
            return Err(ReadImageError::AtByte {
                byte: head.len() as u64,
                reason: format!("the header of {} bytes ends here", version.header_bytes()),
            });
        }
        let places = if version == Version::Two { TWO } else { ONE };
        let number = |(scalar, at): (Scalar, usize)| {
            scalar.number(head.get(at..).unwrap_or_default(), order)
        };
        let reals =
            |at: usize, index: usize| number((places.real, at + index * places.real.size()));
        let code = places.qform_code;
        let next = |(scalar, at): (Scalar, usize)| (scalar, at + scalar.size());
        Ok(Self {
            version,
            order,
            pair,
            sizes: sizes(places.dim, &number)?,
            intent: number(places.intent) as i64,
            datatype: number((Scalar::I16, places.datatype)) as i64,
            bitpix: number((Scalar::I16, places.bitpix)) as i64,
            pixdim: std::array::from_fn(|index| {
                as_written(reals(places.pixdim, index), places.real)
            }),
            vox_offset: vox_offset(
                number(places.vox_offset),
                places.vox_offset.1,
                version,
                pair,
            )?,
            slope: reals(places.slope, 0),
            intercept: reals(places.slope, 1),
            units: number(places.units) as u8,
            time_offset: as_written(reals(places.time_offset, 0), places.real),
            qform_code: number(code) as i64,
            sform_code: number(next(code)) as i64,
            quaternion: std::array::from_fn(|index| reals(places.quaternion, index)),
            qoffset: std::array::from_fn(|index| reals(places.quaternion, 3 + index)),
            srow: std::array::from_fn(|row| {
                std::array::from_fn(|column| reals(places.srow, 4 * row + column))
            }),
        })
    }

    /// The name of the layout.
    pub(super) fn format(&self) -> &'static str {
        match self.version {
            Version::Two => "NIfTI-2",
            Version::One | Version::Analyze => "NIfTI-1",
        }
    }
}

/// The shortest decimal number that is stored so: 0.14, not 0.14000000059604645, where 32 bits are kept.
fn as_written(number: f64, real: Scalar) -> f64 {
    if real != Scalar::F32 {
        return number;
    }
    (number as f32).to_string().parse().unwrap_or(number)
}

/// `dim[1..=dim[0]]`.
fn sizes(
    (scalar, at): (Scalar, usize),
    number: &dyn Fn((Scalar, usize)) -> f64,
) -> Result<Vec<usize>, ReadImageError> {
    let wrong = |index: usize, reason: String| ReadImageError::AtByte {
        byte: (at + index * scalar.size()) as u64,
        reason,
    };
    let count = number((scalar, at));
    if !(1.0..=7.0).contains(&count) {
        return Err(wrong(0, format!("{count} axes; from 1 to 7 are possible")));
    }
    let size = |axis: usize| {
        let size = number((scalar, at + axis * scalar.size()));
        if size < 1.0 {
            return Err(wrong(axis, format!("axis {axis} has {size} voxels")));
        }
        Ok(size as usize)
    };
    (1..=count as usize).map(size).collect()
}

/// Where the values begin. A single file that says 0 means the first place that is possible.
fn vox_offset(stored: f64, at: usize, version: Version, pair: bool) -> Result<u64, ReadImageError> {
    let wrong = |reason: String| ReadImageError::AtByte {
        byte: at as u64,
        reason,
    };
    if !stored.is_finite() || stored < 0.0 || stored.fract() != 0.0 {
        return Err(wrong(format!("the values cannot begin at byte {stored}")));
    }
    let stored = stored as u64;
    // Four bytes after the header say whether extensions follow.
    let first = version.header_bytes() + 4;
    match (pair, stored) {
        (false, 0) => Ok(first),
        (false, 1..) if stored < version.header_bytes() => Err(wrong(format!(
            "the values cannot begin at byte {stored}, within the header"
        ))),
        _ => Ok(stored),
    }
}
