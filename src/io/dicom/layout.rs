//! How the values of a file's pixels are written, and which number each of them means (PS3.3, C.7.6.3; PS3.5, chapter 8).

use super::element::DataSet;
use super::tag::{
    BITS_ALLOCATED, BITS_STORED, COLUMNS, DOUBLE_PIXELS, FLOAT_PIXELS, HIGH_BIT, NUMBER_OF_FRAMES,
    PADDING, PADDING_LIMIT, PHOTOMETRIC, PIXEL_DATA, PIXEL_REPRESENTATION, ROWS, SAMPLES_PER_PIXEL,
    Tag,
};
use crate::io::image_file::ReadImageError;

/// What one pixel is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sample {
    /// A whole number within words of `allocated` bits.
    Whole {
        /// 1, 8, 16 or 32.
        allocated: u32,
        /// How many of them count.
        stored: u32,
        /// How far they stand from the lowest.
        shift: u32,
        /// Whether they are in two's complement.
        signed: bool,
    },
    /// A number of 32 bits with a point.
    Float,
    /// A number of 64 bits with a point.
    Double,
}

/// The pixels of one file, before they are unpacked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Layout {
    pub(super) rows: usize,
    pub(super) columns: usize,
    pub(super) frames: usize,
    pub(super) sample: Sample,
    /// Lowest and highest of the numbers that mean "nothing here".
    padding: Option<(i64, i64)>,
    /// Whether low numbers are to be shown bright. The numbers themselves are as in any other file.
    pub(super) low_is_bright: bool,
    /// The element that holds them.
    pub(super) pixels: Tag,
}

impl Layout {
    /// That of a data set.
    ///
    /// # Errors
    /// If it has no pixels, they are colours, or their description is incomplete or impossible.
    pub(super) fn new(set: &DataSet<'_>) -> Result<Self, ReadImageError> {
        let found = [PIXEL_DATA, FLOAT_PIXELS, DOUBLE_PIXELS];
        let Some(pixels) = found.into_iter().find(|&tag| set.element(tag).is_some()) else {
            return Err(unsupported("it holds no pixels"));
        };
        let photometric = set.text(PHOTOMETRIC).unwrap_or("MONOCHROME2");
        let samples = set.count(SAMPLES_PER_PIXEL).unwrap_or(1);
        if samples != 1 || !photometric.starts_with("MONOCHROME") {
            return Err(unsupported("a picture in colours, not a measured image"));
        }
        let rows = needed(set, ROWS, "Rows")?;
        let columns = needed(set, COLUMNS, "Columns")?;
        let frames = set.count(NUMBER_OF_FRAMES).unwrap_or(1).max(1);
        let sample = match pixels {
            FLOAT_PIXELS => Sample::Float,
            DOUBLE_PIXELS => Sample::Double,
            _ => Self::whole(set)?,
        };
        Ok(Self {
            rows,
            columns,
            frames,
            sample,
            padding: padding(set, sample),
            low_is_bright: photometric == "MONOCHROME1",
            pixels,
        })
    }

    fn whole(set: &DataSet<'_>) -> Result<Sample, ReadImageError> {
        let allocated = needed(set, BITS_ALLOCATED, "BitsAllocated")?;
        if ![1, 8, 16, 32].contains(&allocated) {
            let reason = format!("{allocated} bits; 1, 8, 16 and 32 can be read");
            return Err(ReadImageError::InField {
                field: "BitsAllocated",
                reason,
            });
        }
        let stored = set.count(BITS_STORED).unwrap_or(allocated);
        if stored == 0 || stored > allocated {
            let reason = format!("{stored} of {allocated} bits");
            return Err(ReadImageError::InField {
                field: "BitsStored",
                reason,
            });
        }
        let high = set.count(HIGH_BIT).unwrap_or(stored - 1);
        if high >= allocated || high + 1 < stored {
            let reason = format!("bit {high} for {stored} bits in {allocated}");
            return Err(ReadImageError::InField {
                field: "HighBit",
                reason,
            });
        }
        Ok(Sample::Whole {
            allocated: allocated as u32,
            stored: stored as u32,
            shift: (high + 1 - stored) as u32,
            signed: set.count(PIXEL_REPRESENTATION) == Some(1),
        })
    }

    /// Pixels of one frame.
    pub(super) fn pixels_of_frame(&self) -> usize {
        self.rows.saturating_mul(self.columns)
    }

    /// Pixels of all frames.
    pub(super) fn pixels_in_all(&self) -> u64 {
        (self.pixels_of_frame() as u64).saturating_mul(self.frames as u64)
    }

    /// The number that a word means, before it is rescaled; NaN for padding.
    ///
    /// Padding is looked for among all bits too, since it may stand outside of those that count.
    pub(super) fn number(&self, word: u32) -> f64 {
        let Sample::Whole {
            allocated,
            stored,
            shift,
            signed,
        } = self.sample
        else {
            return f64::NAN;
        };
        let number = extended(word.checked_shr(shift).unwrap_or(0), stored, signed);
        let padded = self.padding.is_some_and(|(low, high)| {
            let within = |number: i64| low <= number && number <= high;
            within(number) || within(extended(word, allocated, signed))
        });
        if padded { f64::NAN } else { number as f64 }
    }

    /// The number of a sample with a point; NaN for padding.
    pub(super) fn pointed(&self, number: f64) -> f64 {
        let padded = (self.padding).is_some_and(|(low, high)| {
            number.fract() == 0.0 && low as f64 <= number && number <= high as f64
        });
        if padded { f64::NAN } else { number }
    }
}

/// The lowest `bits` of a word, as a number with or without a sign.
fn extended(word: u32, bits: u32, signed: bool) -> i64 {
    let word = i64::from(word) & ((1_i64 << bits) - 1);
    if signed && bits > 1 && word >> (bits - 1) == 1 {
        word - (1_i64 << bits)
    } else {
        word
    }
}

/// The range of padding. Whether its numbers have a sign is said by the pixels, not by the letters of the element
/// (PS3.3, C.7.5.1.1.2), which an implicit file does not have anyhow.
fn padding(set: &DataSet<'_>, sample: Sample) -> Option<(i64, i64)> {
    let number = |tag| {
        let number = set.number(tag)?;
        match sample {
            Sample::Whole {
                allocated, signed, ..
            } => {
                let bits = allocated.max(16);
                Some(extended((number as i64) as u32, bits, signed))
            }
            _ => Some(number as i64),
        }
    };
    let first = number(PADDING)?;
    let second = number(PADDING_LIMIT).unwrap_or(first);
    Some((first.min(second), first.max(second)))
}

fn needed(set: &DataSet<'_>, tag: Tag, field: &'static str) -> Result<usize, ReadImageError> {
    match set.count(tag) {
        Some(count) if count > 0 && count <= 65_535 => Ok(count),
        _ => Err(ReadImageError::InField {
            field,
            reason: format!("{tag} is missing, or is no size"),
        }),
    }
}

pub(super) fn unsupported(reason: impl Into<String>) -> ReadImageError {
    ReadImageError::Unsupported(reason.into())
}
