//! The pixels of a file, frame by frame.

use std::hash::{DefaultHasher, Hash, Hasher};
use std::ops::Range;

use super::codecs::{check_share, unpacked_jpeg, unpacked_jpeg_ls, unpacked_jpeg2000};
use super::element::{Encoding, Items};
use super::file::{DicomFile, Packing};
use super::layout::{Layout, Sample, unsupported};
use super::rle::unpacked_rle;
use crate::io::image_file::ReadImageError;

/// The pixels of one file, still packed.
#[derive(Clone, Debug)]
pub(super) struct Pixels {
    pub(super) layout: Layout,
    bytes: Vec<u8>,
    big_endian: bool,
    packing: Packing,
    /// Where the parts of each packed frame stand.
    parts: Vec<Vec<Range<usize>>>,
}

/// The numbers of one frame: value = slope · number + intercept (PS3.3, C.11.1.1.2).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Rescale {
    pub(super) slope: f64,
    pub(super) intercept: f64,
}

impl Pixels {
    /// Takes the pixels out of a file, which are checked to be all there.
    ///
    /// # Errors
    /// If they are cut short, larger than `most` pixels, packed by a codec that is not read, or their parts belong to no frames.
    pub(super) fn new(file: &DicomFile, most: usize) -> Result<Self, ReadImageError> {
        let set = file.data_set();
        let layout = Layout::new(&set)?;
        ReadImageError::unless_voxels_fit(layout.pixels_in_all(), most as u64)?;
        let Some(element) = set.element(layout.pixels) else {
            return Err(unsupported("it holds no pixels"));
        };
        let value = element.value;
        let mut pixels = Self {
            layout,
            bytes: value.to_vec(),
            big_endian: file.encoding.big_endian,
            packing: file.packing,
            parts: Vec::new(),
        };
        // Some files say that they are packed and are not.
        if !element.delimited && (file.packing == Packing::Plain || !element.cut) {
            pixels.packing = Packing::Plain;
        }
        // Bytes that were written as words stand in pairs (PS3.5, annex D, note on Big Endian).
        let words = element.letters == Some(*b"OW");
        if pixels.big_endian && words && pixels.bits_of_one() == 8 {
            pixels.bytes.chunks_exact_mut(2).for_each(<[u8]>::reverse);
        }
        match pixels.packing {
            Packing::Plain => pixels.check_length()?,
            Packing::Refused(codec) => {
                return Err(unsupported(format!(
                    "pixels packed by {codec}, which is not read"
                )));
            }
            _ => {
                check_share(layout.pixels_in_all(), value.len())?;
                pixels.parts = parts_of_frames(value, layout.frames)?;
            }
        }
        Ok(pixels)
    }

    /// Bits of one pixel that is not packed.
    fn bits_of_one(&self) -> usize {
        match self.layout.sample {
            Sample::Whole { allocated, .. } => allocated as usize,
            Sample::Float => 32,
            Sample::Double => 64,
        }
    }

    fn check_length(&self) -> Result<(), ReadImageError> {
        let bits = self
            .layout
            .pixels_in_all()
            .saturating_mul(self.bits_of_one() as u64);
        let expected = bits.div_ceil(8);
        let present = self.bytes.len() as u64;
        if present < expected {
            return Err(ReadImageError::Truncated { expected, present });
        }
        Ok(())
    }

    /// Whether two frames hold the same numbers, as far as can be told without unpacking.
    pub(super) fn same(&self, frame: usize, other: &Self, other_frame: usize) -> bool {
        self.layout.sample == other.layout.sample
            && self.packing == other.packing
            && (self.packed(frame)).is_some_and(|own| other.packed(other_frame) == Some(own))
    }

    /// A number that is equal for equal frames.
    pub(super) fn digest(&self, frame: usize) -> u64 {
        let mut hasher = DefaultHasher::new();
        self.packed(frame).hash(&mut hasher);
        hasher.finish()
    }

    /// The bytes of a frame; `None` if it is not there, or need not begin with a byte.
    fn packed(&self, frame: usize) -> Option<&[u8]> {
        if self.packing != Packing::Plain {
            let parts = self.parts.get(frame)?;
            let whole = parts.first()?.start..parts.last()?.end;
            return self.bytes.get(whole);
        }
        let bytes = self.bits_of_one() / 8;
        let length = self.layout.pixels_of_frame().checked_mul(bytes)?;
        if length == 0 {
            return None;
        }
        let start = frame.checked_mul(length)?;
        self.bytes.get(start..start.checked_add(length)?)
    }

    /// The values of one frame, row by row.
    ///
    /// # Errors
    /// If there is no such frame or it cannot be unpacked.
    pub(super) fn values(&self, frame: usize, by: Rescale) -> Result<Vec<f32>, ReadImageError> {
        let value = |number: f64| (number * by.slope + by.intercept) as f32;
        let layout = &self.layout;
        let plain = |size: usize| {
            (self
                .packed(frame)
                .filter(|_| self.packing == Packing::Plain))
            .map(|bytes| bytes.chunks_exact(size))
            .ok_or_else(|| unsupported(format!("frame {} is not there", frame + 1)))
        };
        // The last bytes of a number first, so that one way of reading serves both.
        let word = |bytes: &[u8]| {
            let join = |word: u64, &byte: &u8| word << 8 | u64::from(byte);
            match self.big_endian {
                true => bytes.iter().fold(0, join),
                false => bytes.iter().rev().fold(0, join),
            }
        };
        let whole = |word: u32| value(layout.number(word));
        Ok(match layout.sample {
            Sample::Float => plain(4)?
                .map(|bytes| f64::from(f32::from_bits(word(bytes) as u32)))
                .map(|number| value(layout.pointed(number)))
                .collect(),
            Sample::Double => plain(8)?
                .map(|bytes| value(layout.pointed(f64::from_bits(word(bytes)))))
                .collect(),
            Sample::Whole { allocated, .. } if self.packing == Packing::Plain => match allocated {
                1 => self.bits(frame).map(whole).collect(),
                _ => plain(allocated as usize / 8)?
                    .map(|bytes| whole(word(bytes) as u32))
                    .collect(),
            },
            Sample::Whole { allocated, .. } => {
                let words = self.unpacked(frame, allocated)?;
                words.into_iter().map(whole).collect()
            }
        })
    }

    /// The bits of a frame. Frames follow each other without a gap, so that they need not begin with a byte
    /// (PS3.5, 8.1.1); the lowest bit of a byte is the first.
    fn bits(&self, frame: usize) -> impl Iterator<Item = u32> {
        let count = self.layout.pixels_of_frame();
        let first = frame.saturating_mul(count);
        (first..first.saturating_add(count)).map(|bit| {
            let byte = self.bytes.get(bit / 8).copied().unwrap_or(0);
            u32::from(byte >> (bit % 8) & 1)
        })
    }

    fn unpacked(&self, frame: usize, allocated: u32) -> Result<Vec<u32>, ReadImageError> {
        let absent = || unsupported(format!("frame {} is not there", frame + 1));
        let parts = self.parts.get(frame).ok_or_else(absent)?;
        let parts: Vec<&[u8]> = (parts.iter())
            .filter_map(|part| self.bytes.get(part.clone()))
            .collect();
        let joined;
        let bytes = match parts[..] {
            [one] => one,
            _ => {
                joined = parts.concat();
                &joined
            }
        };
        let size = [self.layout.columns, self.layout.rows];
        let words = match self.packing {
            Packing::Rle => unpacked_rle(bytes, self.layout.pixels_of_frame(), allocated),
            Packing::Jpeg => unpacked_jpeg(bytes, size),
            Packing::JpegLs => unpacked_jpeg_ls(bytes, size),
            Packing::Jpeg2000 => unpacked_jpeg2000(bytes, size),
            Packing::Plain | Packing::Refused(_) => Err(absent()),
        }?;
        if words.len() != self.layout.pixels_of_frame() {
            return Err(ReadImageError::Truncated {
                expected: self.layout.pixels_of_frame() as u64,
                present: words.len() as u64,
            });
        }
        Ok(words)
    }
}

/// Which parts of packed pixels belong to which frame (PS3.5, A.4).
///
/// One part a frame where that is possible; else by the table of offsets; else a frame begins where a codec's own image begins.
fn parts_of_frames(value: &[u8], frames: usize) -> Result<Vec<Vec<Range<usize>>>, ReadImageError> {
    let encoding = Encoding {
        explicit: true,
        big_endian: false,
    };
    let mut items = Items::new(value, encoding);
    let table = items.next().map_or(0..0, |item| item.value);
    let parts: Vec<_> = items.collect();
    if frames == 1 {
        return Ok(vec![parts.into_iter().map(|part| part.value).collect()]);
    }
    if parts.len() == frames {
        return Ok(parts.into_iter().map(|part| vec![part.value]).collect());
    }
    let table = value.get(table).unwrap_or_default();
    let offsets: Vec<usize> = (table.as_chunks::<4>().0.iter())
        .map(|bytes| u32::from_le_bytes(*bytes) as usize)
        .collect();
    let base = parts.first().map_or(0, |part| part.begin);
    let begins = |part: &super::element::Item| {
        if offsets.len() == frames {
            offsets.binary_search(&(part.begin - base)).is_ok()
        } else {
            let head = value.get(part.value.clone()).unwrap_or_default();
            [
                &[0xff, 0xd8, 0xff][..],
                &[0xff, 0x4f, 0xff, 0x51],
                b"\0\0\0\x0cjP",
            ]
            .iter()
            .any(|magic| head.starts_with(magic))
        }
    };
    let mut joined: Vec<Vec<Range<usize>>> = Vec::new();
    for part in parts {
        match joined.last_mut() {
            Some(frame) if !begins(&part) => frame.push(part.value),
            _ => joined.push(vec![part.value]),
        }
    }
    if joined.len() != frames {
        let found = joined.len();
        return Err(ReadImageError::InField {
            field: "PixelData",
            reason: format!("packed pixels of {found} frames, but there should be {frames}"),
        });
    }
    Ok(joined)
}
