//! Small image files made by hand, for tests.

use std::collections::BTreeMap;
use std::io::Write;

use flate2::Compression;
use flate2::write::{GzEncoder, ZlibEncoder};

use super::binary_cursor::{ByteOrder, Scalar};
use super::image_formats::read_image;
use super::{ImageSeries, Limits, ReadImageError};

/// What a file holds that stands alone.
pub(super) fn read(name: &str, bytes: &[u8]) -> Result<ImageSeries, ReadImageError> {
    read_beside(name, bytes, &BTreeMap::new())
}

/// What a file holds that may name others.
pub(super) fn read_beside(
    name: &str,
    bytes: &[u8],
    others: &BTreeMap<&str, Vec<u8>>,
) -> Result<ImageSeries, ReadImageError> {
    let sibling = |name: &str| {
        others
            .get(name)
            .cloned()
            .ok_or_else(|| "there is no such file".to_owned())
    };
    read_image(name, bytes, &Limits::default(), &sibling)
}

/// Values of each volume.
pub(super) fn values(series: &ImageSeries) -> Vec<Vec<f32>> {
    series
        .image
        .volumes()
        .iter()
        .map(|volume| volume.to_vec())
        .collect()
}

/// Whether a note holds these words.
pub(super) fn says(series: &ImageSeries, words: &str) -> bool {
    series.notices.iter().any(|note| note.text.contains(words))
}

/// So many numbers from 0 as 16 bits each, the values of the small files.
pub(super) fn sixteen_bits(count: usize) -> Vec<u8> {
    counted_up(count, Scalar::I16, ByteOrder::Little)
}

/// The same as they are read.
pub(super) fn numbers(from: usize, to: usize) -> Vec<f32> {
    (from..to).map(|number| number as f32).collect()
}

/// Lines of a header, each a name and a value, some of them replaced by their names and others added; a change without a
/// value takes its line out.
pub(super) fn changed_lines(
    lines: &[&'static str],
    separator: char,
    changes: &[&'static str],
) -> Vec<&'static str> {
    let name = |line: &str| line.split(separator).next().unwrap().trim().to_owned();
    let kept = lines
        .iter()
        .filter(|line| !changes.iter().any(|change| name(change) == name(line)));
    let added = changes.iter().filter(|change| !change.ends_with(separator));
    kept.chain(added).copied().collect()
}

pub(super) fn gzipped(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::fast());
    encoder.write_all(bytes).unwrap();
    encoder.finish().unwrap()
}

pub(super) fn zlibbed(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::fast());
    encoder.write_all(bytes).unwrap();
    encoder.finish().unwrap()
}

/// A number as it is stored.
pub(super) fn stored(number: f64, scalar: Scalar, order: ByteOrder) -> Vec<u8> {
    let mut bytes = match scalar {
        Scalar::I8 => (number as i8).to_le_bytes().to_vec(),
        Scalar::U8 => (number as u8).to_le_bytes().to_vec(),
        Scalar::I16 => (number as i16).to_le_bytes().to_vec(),
        Scalar::U16 => (number as u16).to_le_bytes().to_vec(),
        Scalar::I32 => (number as i32).to_le_bytes().to_vec(),
        Scalar::U32 => (number as u32).to_le_bytes().to_vec(),
        Scalar::I64 => (number as i64).to_le_bytes().to_vec(),
        Scalar::U64 => (number as u64).to_le_bytes().to_vec(),
        Scalar::F32 => (number as f32).to_le_bytes().to_vec(),
        Scalar::F64 => number.to_le_bytes().to_vec(),
    };
    if order == ByteOrder::Big {
        bytes.reverse();
    }
    bytes
}

/// Numbers 0, 1, 2… so many, as they are stored.
pub(super) fn counted_up(count: usize, scalar: Scalar, order: ByteOrder) -> Vec<u8> {
    (0..count)
        .flat_map(|number| stored(number as f64, scalar, order))
        .collect()
}

/// A NIfTI file: 2 × 3 × 2 voxels at two times, of the numbers 0 to 23.
#[derive(Clone, Debug)]
pub(super) struct Nifti {
    pub two: bool,
    pub order: ByteOrder,
    pub pair: bool,
    pub dim: Vec<i64>,
    pub datatype: i64,
    pub bitpix: i64,
    pub pixdim: [f64; 8],
    pub offset: f64,
    pub scaling: [f64; 2],
    pub units: i64,
    /// qform, sform.
    pub codes: [i64; 2],
    /// b, c, d, then the offset.
    pub quaternion: [f64; 6],
    pub srow: [f64; 12],
    pub intent: i64,
    pub values: Vec<u8>,
}

impl Default for Nifti {
    fn default() -> Self {
        Self {
            two: false,
            order: ByteOrder::Little,
            pair: false,
            dim: vec![4, 2, 3, 2, 2, 1, 1, 1],
            datatype: 4,
            bitpix: 16,
            pixdim: [1.0, 2.0, 3.0, 5.0, 0.25, 1.0, 1.0, 1.0],
            offset: 352.0,
            scaling: [0.0, 0.0],
            units: 2 | 8,
            codes: [0, 1],
            quaternion: [0.0; 6],
            srow: [
                0.0, -3.0, 0.0, 10.0, 2.0, 0.0, 0.0, 20.0, 0.0, 0.0, 5.0, 30.0,
            ],
            intent: 0,
            values: counted_up(24, Scalar::I16, ByteOrder::Little),
        }
    }
}

impl Nifti {
    /// The header, and the values unless they stand in another file.
    pub(super) fn bytes(&self) -> Vec<u8> {
        let mut bytes = vec![0; if self.two { 544 } else { 352 }];
        let mut put = |at: usize, scalar: Scalar, numbers: &[f64]| {
            for (index, number) in numbers.iter().enumerate() {
                let word = stored(*number, scalar, self.order);
                let at = at + index * word.len();
                bytes[at..at + word.len()].copy_from_slice(&word);
            }
        };
        let dim: Vec<f64> = self.dim.iter().map(|size| *size as f64).collect();
        let codes = self.codes.map(|code| code as f64);
        let kind = [self.datatype as f64, self.bitpix as f64];
        let (small, real) = (
            Scalar::I16,
            if self.two { Scalar::F64 } else { Scalar::F32 },
        );
        if self.two {
            put(0, Scalar::I32, &[540.0]);
            put(12, small, &kind);
            put(16, Scalar::I64, &dim);
            put(104, real, &self.pixdim);
            put(168, Scalar::I64, &[self.offset]);
            put(176, real, &self.scaling);
            put(344, Scalar::I32, &codes);
            put(352, real, &self.quaternion);
            put(400, real, &self.srow);
            put(500, Scalar::I32, &[self.units as f64, self.intent as f64]);
        } else {
            put(0, Scalar::I32, &[348.0]);
            put(40, small, &dim);
            put(68, small, &[self.intent as f64]);
            put(70, small, &kind);
            put(76, real, &self.pixdim);
            put(108, real, &[self.offset]);
            put(112, real, &self.scaling);
            put(123, Scalar::U8, &[self.units as f64]);
            put(252, small, &codes);
            put(256, real, &self.quaternion);
            put(280, real, &self.srow);
        }
        let (at, magic): (usize, &[u8]) = match (self.two, self.pair) {
            (true, false) => (4, b"n+2\0\r\n\x1a\n"),
            (true, true) => (4, b"ni2\0\r\n\x1a\n"),
            (false, false) => (344, b"n+1\0"),
            (false, true) => (344, b"ni1\0"),
        };
        bytes[at..at + magic.len()].copy_from_slice(magic);
        // Free text, which must get nowhere.
        let text = if self.two { 240 } else { 148 };
        bytes[text..text + 6].copy_from_slice(b"SEEDED");
        if !self.pair {
            bytes.resize(bytes.len().max(self.offset.max(0.0) as usize), b'S');
            bytes.extend_from_slice(&self.values);
        }
        bytes
    }

    pub(super) fn read(&self) -> Result<ImageSeries, ReadImageError> {
        read("a.nii", &self.bytes())
    }

    /// What is said against it.
    pub(super) fn refused(&self) -> String {
        self.read().unwrap_err().to_string()
    }
}

/// An NRRD file of these header lines and bytes.
pub(super) fn nrrd(lines: &[&str], values: &[u8]) -> Vec<u8> {
    let mut bytes = format!("NRRD0005\n# made by hand\n{}\n\n", lines.join("\n")).into_bytes();
    bytes.extend_from_slice(values);
    bytes
}

/// A MetaImage file of these header lines, without the last, and bytes.
pub(super) fn metaimage(lines: &[&str], place: &str, values: &[u8]) -> Vec<u8> {
    let lines = lines.join("\n");
    let mut bytes =
        format!("ObjectType = Image\n{lines}\nElementDataFile = {place}\n").into_bytes();
    bytes.extend_from_slice(values);
    bytes
}
