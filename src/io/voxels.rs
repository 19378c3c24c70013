//! The values of an image from the bytes of a file: types, byte orders, scaling, and volumes one after the other or interleaved.

use std::io::Read;
use std::sync::Arc;

use super::binary_cursor::{ByteOrder, Scalar};
use super::packed::{Packing, fill};
use super::{Limits, ReadImageError};
use crate::study::Notice;

/// How the values of an image lie in its bytes.
#[derive(Clone, Copy, Debug)]
pub(super) struct VoxelLayout {
    /// Type of a stored number.
    pub scalar: Scalar,
    /// Its byte order.
    pub order: ByteOrder,
    /// What a stored number means: `slope · stored + intercept`.
    pub scaling: Scaling,
    /// How values go on from one to the next.
    pub volumes: VolumeOrder,
}

impl VoxelLayout {
    /// Bytes of all stored numbers.
    pub(super) fn bytes(&self) -> u64 {
        (self.volumes.all() as u64).saturating_mul(self.scalar.size() as u64)
    }
}

/// `value = slope · stored + intercept`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Scaling {
    pub slope: f64,
    pub intercept: f64,
}

impl Scaling {
    /// Stored numbers are values.
    pub(super) const NONE: Self = Self {
        slope: 1.0,
        intercept: 0.0,
    };
}

/// Where the axis of volumes stands among the axes of voxels, from the fastest to the slowest.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct VolumeOrder {
    /// Voxels along all axes faster than that of volumes: all of a volume if it is the last axis, 1 if it is the first.
    inner: usize,
    /// How many volumes.
    volumes: usize,
    /// Voxels along all slower axes.
    outer: usize,
}

impl VolumeOrder {
    /// Volumes of `size` voxels, with the axis of volumes before axis `place` of the three (3: after all of them).
    ///
    /// # Errors
    /// If a size is 0, or voxels or volumes are more than the limits.
    pub(super) fn new(
        size: [usize; 3],
        volumes: usize,
        place: usize,
        limits: &Limits,
    ) -> Result<Self, ReadImageError> {
        if let Some(axis) = size.iter().chain([&volumes]).position(|&count| count == 0) {
            return Err(ReadImageError::InField {
                field: "size",
                reason: format!("axis {} has no voxels", axis + 1),
            });
        }
        if volumes > limits.frames {
            return Err(ReadImageError::TooMany {
                what: "volumes",
                count: volumes as u64,
                most: limits.frames as u64,
            });
        }
        let all = (size.iter().chain([&volumes])).fold(1_u64, |n, &by| n.saturating_mul(by as u64));
        ReadImageError::unless_voxels_fit(all, limits.voxels)?;
        let (faster, slower) = size.split_at(place.min(3));
        Ok(Self {
            inner: faster.iter().product(),
            volumes,
            outer: slower.iter().product(),
        })
    }

    fn voxels(self) -> usize {
        self.inner * self.outer
    }

    fn all(self) -> usize {
        self.voxels() * self.volumes
    }

    /// Empty volumes, to be filled in the order of the file.
    fn canvas(self) -> Canvas {
        Canvas {
            order: self,
            volumes: vec![vec![0.0; self.voxels()]; self.volumes],
            place: [0; 3],
            rounded: 0,
            overflowed: 0,
        }
    }
}

/// Volumes that are being filled.
struct Canvas {
    order: VolumeOrder,
    volumes: Vec<Vec<f32>>,
    /// Where the next value goes: inner, volume, outer.
    place: [usize; 3],
    /// Whole numbers that have more digits than are kept.
    rounded: u64,
    /// Finite numbers that are too large to be kept.
    overflowed: u64,
}

impl Canvas {
    /// Takes the next value.
    fn push(&mut self, value: f64, whole: bool) {
        let kept = value as f32;
        if whole && f64::from(kept) != value {
            self.rounded += 1;
        }
        if value.is_finite() && !kept.is_finite() {
            self.overflowed += 1;
        }
        let [inner, volume, outer] = &mut self.place;
        let at = *outer * self.order.inner + *inner;
        let place = self.volumes.get_mut(*volume).and_then(|v| v.get_mut(at));
        if let Some(place) = place {
            *place = kept;
        }
        *inner += 1;
        if *inner == self.order.inner {
            *inner = 0;
            *volume += 1;
            if *volume == self.order.volumes {
                *volume = 0;
                *outer += 1;
            }
        }
    }

    fn finish(self) -> Values {
        let mut notices = Vec::new();
        if self.rounded > 0 {
            notices.push(Notice::info(format!(
                "{} whole numbers beyond 16777216 are rounded to 24 bits",
                self.rounded
            )));
        }
        if self.overflowed > 0 {
            notices.push(Notice::warning(format!(
                "{} values are beyond ±3.4e38 and count as infinite",
                self.overflowed
            )));
        }
        Values {
            volumes: self.volumes.into_iter().map(Arc::from).collect(),
            notices,
        }
    }
}

/// The values of all volumes, and what was lost on the way.
#[derive(Debug)]
pub(super) struct Values {
    pub volumes: Vec<Arc<[f32]>>,
    pub notices: Vec<Notice>,
}

/// Reads the values after the first `skip` unpacked bytes.
///
/// Memory is taken only if the bytes that are there can hold what the layout calls for.
///
/// # Errors
/// If there are too few bytes, or they cannot be unpacked.
pub(super) fn read_values(
    bytes: &[u8],
    packing: Packing,
    skip: u64,
    layout: &VoxelLayout,
) -> Result<Values, ReadImageError> {
    let expected = layout.bytes();
    let possible = packing.max_unpacked(bytes.len()).saturating_sub(skip);
    if expected > possible {
        return Err(match packing {
            Packing::Plain => ReadImageError::Truncated {
                expected,
                present: possible,
            },
            _ => ReadImageError::Unpack {
                unpacked: 0,
                reason: format!("{} packed bytes cannot hold {expected} bytes", bytes.len()),
            },
        });
    }
    let mut reader = packing.reader(bytes);
    let broken = |unpacked: u64, error: &std::io::Error| ReadImageError::Unpack {
        unpacked,
        reason: unpacker_says(error),
    };
    let skipped = std::io::copy(&mut (&mut reader).take(skip), &mut std::io::sink())
        .map_err(|error| broken(0, &error))?;
    if skipped < skip {
        return Err(ReadImageError::Truncated {
            expected,
            present: 0,
        });
    }
    let mut canvas = layout.volumes.canvas();
    let mut buffer = vec![0; 1 << 16];
    let mut present = 0_u64;
    while present < expected {
        let wanted = (expected - present).min(buffer.len() as u64) as usize;
        let count =
            fill(&mut reader, &mut buffer[..wanted]).map_err(|error| broken(present, &error))?;
        decode(&buffer[..count], layout, &mut canvas);
        present += count as u64;
        if count < wanted {
            return Err(ReadImageError::Truncated { expected, present });
        }
    }
    // The checksum comes after the last byte.
    let beyond = reader
        .read(&mut buffer)
        .map_err(|error| broken(present, &error))?;
    let mut values = canvas.finish();
    if beyond > 0 {
        values.notices.push(Notice::info(
            "there are more bytes than the values take: the rest was left out",
        ));
    }
    Ok(values)
}

/// An error of the unpacker, without what it may quote.
fn unpacker_says(error: &std::io::Error) -> String {
    match error.kind() {
        std::io::ErrorKind::UnexpectedEof => "the packed bytes end too early".to_owned(),
        _ => "the packed bytes are damaged".to_owned(),
    }
}

/// Appends all whole numbers of `bytes`, whose count is a multiple of the type's size but for a file that is cut short.
fn decode(bytes: &[u8], layout: &VoxelLayout, canvas: &mut Canvas) {
    let Scaling { slope, intercept } = layout.scaling;
    let scaled = layout.scaling != Scaling::NONE;
    macro_rules! each {
        ($number:ty, $whole:expr) => {{
            const SIZE: usize = size_of::<$number>();
            let (words, _) = bytes.as_chunks::<SIZE>();
            for &word in words {
                let stored = match layout.order {
                    ByteOrder::Little => <$number>::from_le_bytes(word),
                    ByteOrder::Big => <$number>::from_be_bytes(word),
                } as f64;
                if scaled {
                    canvas.push(slope * stored + intercept, false);
                } else {
                    canvas.push(stored, $whole);
                }
            }
        }};
    }
    match layout.scalar {
        Scalar::I8 => each!(i8, false),
        Scalar::U8 => each!(u8, false),
        Scalar::I16 => each!(i16, false),
        Scalar::U16 => each!(u16, false),
        Scalar::I32 => each!(i32, true),
        Scalar::U32 => each!(u32, true),
        Scalar::I64 => each!(i64, true),
        Scalar::U64 => each!(u64, true),
        Scalar::F32 => each!(f32, false),
        Scalar::F64 => each!(f64, false),
    }
}

/// Reads values that are written as text, with white space or commas between them.
///
/// # Errors
/// If one is no number of the layout's type, or there are too few.
pub(super) fn read_text_values(
    bytes: &[u8],
    layout: &VoxelLayout,
) -> Result<Values, ReadImageError> {
    let expected = layout.volumes.all() as u64;
    let too_few = |present: u64| ReadImageError::InField {
        field: "values",
        reason: format!("{expected} numbers expected, but only {present} are there"),
    };
    // A number takes at least a digit and what parts it from the next.
    let possible = (bytes.len() as u64).div_ceil(2);
    if expected > possible {
        return Err(too_few(possible));
    }
    let mut canvas = layout.volumes.canvas();
    let separates = |byte: &u8| byte.is_ascii_whitespace() || *byte == b',';
    let words = bytes.split(separates).filter(|word| !word.is_empty());
    let whole = !matches!(layout.scalar, Scalar::F32 | Scalar::F64);
    let mut present = 0_u64;
    for word in words.take(layout.volumes.all()) {
        let number = std::str::from_utf8(word)
            .ok()
            .and_then(|w| w.parse::<f64>().ok());
        let number = number.filter(|n| !whole || n.fract() == 0.0);
        let Some(number) = number else {
            return Err(ReadImageError::InField {
                field: "values",
                reason: format!("value {} is no number of its type", present + 1),
            });
        };
        let Scaling { slope, intercept } = layout.scaling;
        let scaled = layout.scaling != Scaling::NONE;
        let value = if scaled {
            slope * number + intercept
        } else {
            number
        };
        canvas.push(value, whole && !scaled);
        present += 1;
    }
    if present < expected {
        return Err(too_few(present));
    }
    Ok(canvas.finish())
}

#[cfg(test)]
mod tests;
