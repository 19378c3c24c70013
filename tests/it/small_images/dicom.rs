//! A writer of small DICOM files.

use std::collections::BTreeMap;
use std::io::{Cursor, Write};

use flate2::Compression;
use flate2::write::DeflateEncoder;
use zip::ZipWriter;
use zip::write::SimpleFileOptions;

pub const IMPLICIT: &str = "1.2.840.10008.1.2";
pub const EXPLICIT: &str = "1.2.840.10008.1.2.1";
pub const DEFLATED: &str = "1.2.840.10008.1.2.1.99";
pub const BIG: &str = "1.2.840.10008.1.2.2";
pub const RLE: &str = "1.2.840.10008.1.2.5";
pub const JPEG: &str = "1.2.840.10008.1.2.4.70";
pub const JPEG_LS: &str = "1.2.840.10008.1.2.4.80";
pub const JPEG_2000: &str = "1.2.840.10008.1.2.4.90";

/// Attributes that become a file or an item of a sequence.
#[derive(Clone, Debug, Default)]
pub struct Dicom(BTreeMap<(u16, u16), (&'static str, Value)>);

#[derive(Clone, Debug)]
enum Value {
    Bytes(Vec<u8>),
    Words(Vec<u16>),
    Items(Vec<Dicom>),
    /// Pixels in parts, without a length.
    Parts(Vec<Vec<u8>>),
}

#[derive(Clone, Copy)]
struct Way {
    explicit: bool,
    big: bool,
}

impl Way {
    fn short(self, number: u16) -> [u8; 2] {
        match self.big {
            true => number.to_be_bytes(),
            false => number.to_le_bytes(),
        }
    }

    fn long(self, number: u32) -> [u8; 4] {
        match self.big {
            true => number.to_be_bytes(),
            false => number.to_le_bytes(),
        }
    }

    /// The head of an item, or of what ends one.
    fn item(self, element: u16, length: u32) -> Vec<u8> {
        let tag = [self.short(0xfffe), self.short(element)].concat();
        [&tag[..], &self.long(length)].concat()
    }
}

impl Dicom {
    pub fn text(mut self, group: u16, element: u16, letters: &'static str, text: &str) -> Self {
        let mut bytes = text.as_bytes().to_vec();
        bytes.resize(bytes.len().next_multiple_of(2), b' ');
        (self.0).insert((group, element), (letters, Value::Bytes(bytes)));
        self
    }

    pub fn decimals(self, group: u16, element: u16, numbers: &[f64]) -> Self {
        let words: Vec<String> = numbers.iter().map(f64::to_string).collect();
        self.text(group, element, "DS", &words.join("\\"))
    }

    pub fn words(mut self, group: u16, element: u16, numbers: &[u16]) -> Self {
        let letters = if group == 0x7fe0 { "OW" } else { "US" };
        (self.0).insert((group, element), (letters, Value::Words(numbers.to_vec())));
        self
    }

    pub fn bytes(mut self, group: u16, element: u16, letters: &'static str, bytes: &[u8]) -> Self {
        (self.0).insert((group, element), (letters, Value::Bytes(bytes.to_vec())));
        self
    }

    pub fn items(mut self, group: u16, element: u16, items: Vec<Self>) -> Self {
        (self.0).insert((group, element), ("SQ", Value::Items(items)));
        self
    }

    pub fn packed(mut self, parts: &[&[u8]]) -> Self {
        let even = |part: &&[u8]| {
            let mut part = part.to_vec();
            part.resize(part.len().next_multiple_of(2), 0);
            part
        };
        let parts = parts.iter().map(even).collect();
        self.0.insert((0x7fe0, 0x0010), ("OB", Value::Parts(parts)));
        self
    }

    /// An MR image of 3 columns and 2 rows, 2 mm × 1.5 mm a pixel, at a height, with numbers from `first` on.
    pub fn image(z_mm: f64, first: u16) -> Self {
        let pixels: Vec<u16> = (first..first + 6).collect();
        Self::default()
            .text(0x0008, 0x0008, "CS", "ORIGINAL\\PRIMARY\\M")
            .text(0x0008, 0x0016, "UI", "1.2.840.10008.5.1.4.1.1.4")
            .text(0x0008, 0x0060, "CS", "MR")
            .text(0x0010, 0x0010, "PN", "SEEDED^NAME")
            .decimals(0x0018, 0x0050, &[5.0])
            .text(0x0020, 0x000d, "UI", "1.2")
            .text(0x0020, 0x000e, "UI", "1.2.3")
            .decimals(0x0020, 0x0032, &[-10.0, -20.0, z_mm])
            .decimals(0x0020, 0x0037, &[1.0, 0.0, 0.0, 0.0, 1.0, 0.0])
            .words(0x0028, 0x0002, &[1])
            .text(0x0028, 0x0004, "CS", "MONOCHROME2")
            .words(0x0028, 0x0010, &[2])
            .words(0x0028, 0x0011, &[3])
            .decimals(0x0028, 0x0030, &[2.0, 1.5])
            .words(0x0028, 0x0100, &[16])
            .words(0x0028, 0x0101, &[16])
            .words(0x0028, 0x0102, &[15])
            .words(0x0028, 0x0103, &[0])
            .words(0x7fe0, 0x0010, &pixels)
    }

    /// Two slices at two instants in one file, with their places in groups of each frame.
    pub fn enhanced() -> Self {
        let frame = |number: u32| {
            let place =
                Self::default().decimals(0x0020, 0x0032, &[0.0, 0.0, f64::from(number % 2)]);
            let instant = (number / 2 + 1).to_le_bytes();
            let content = Self::default().bytes(0x0020, 0x9128, "UL", &instant);
            Self::default()
                .items(0x0020, 0x9113, vec![place])
                .items(0x0020, 0x9111, vec![content])
        };
        let pixels: Vec<u16> = (0..24).collect();
        Self::image(0.0, 0)
            .text(0x0028, 0x0008, "IS", "4")
            .items(0x5200, 0x9230, (0..4).map(frame).collect())
            .words(0x7fe0, 0x0010, &pixels)
    }

    /// Two gates of two slices of a gamma camera; the place stands with the detector.
    pub fn gated() -> Self {
        let detector = Self::default()
            .decimals(0x0020, 0x0032, &[1.0, 2.0, 3.0])
            .decimals(0x0020, 0x0037, &[1.0, 0.0, 0.0, 0.0, 1.0, 0.0]);
        let slot = Self::default().decimals(0x0018, 0x1063, &[400.0]);
        let beat =
            Self::default()
                .decimals(0x0018, 0x1062, &[800.0])
                .items(0x0054, 0x0072, vec![slot]);
        let pixels: Vec<u16> = (0..24).collect();
        Self::image(0.0, 0)
            .text(
                0x0008,
                0x0008,
                "CS",
                "ORIGINAL\\PRIMARY\\RECON GATED TOMO\\EMISSION",
            )
            .text(0x0008, 0x0016, "UI", "1.2.840.10008.5.1.4.1.1.20")
            .text(0x0008, 0x0060, "CS", "NM")
            .decimals(0x0018, 0x0088, &[-6.4])
            .text(0x0028, 0x0008, "IS", "4")
            .items(0x0054, 0x0022, vec![detector])
            .words(0x0054, 0x0061, &[1])
            .items(0x0054, 0x0062, vec![beat])
            .words(0x0054, 0x0070, &[1, 1, 2, 2])
            .words(0x0054, 0x0071, &[2])
            .words(0x0054, 0x0080, &[1, 2, 1, 2])
            .words(0x0054, 0x0081, &[2])
            .words(0x7fe0, 0x0010, &pixels)
    }

    /// Two slices of a segment, one bit a pixel.
    pub fn segments() -> Self {
        let frame = |number: u32| {
            let place = Self::default().decimals(0x0020, 0x0032, &[0.0, 0.0, f64::from(number)]);
            let of = Self::default().words(0x0062, 0x000b, &[1]);
            Self::default()
                .items(0x0020, 0x9113, vec![place])
                .items(0x0062, 0x000a, vec![of])
        };
        let straight = Self::default().decimals(0x0020, 0x0037, &[1.0, 0.0, 0.0, 0.0, 1.0, 0.0]);
        let measures = Self::default().decimals(0x0028, 0x0030, &[2.0, 1.5]);
        let shared = Self::default().items(0x0020, 0x9116, vec![straight]).items(
            0x0028,
            0x9110,
            vec![measures],
        );
        Self::image(0.0, 0)
            .text(0x0008, 0x0016, "UI", "1.2.840.10008.5.1.4.1.1.66.4")
            .text(0x0008, 0x0060, "CS", "SEG")
            .text(0x0028, 0x0008, "IS", "2")
            .words(0x0028, 0x0100, &[1])
            .words(0x0028, 0x0101, &[1])
            .words(0x0028, 0x0102, &[0])
            .text(0x0062, 0x0001, "CS", "BINARY")
            .items(0x5200, 0x9229, vec![shared])
            .items(0x5200, 0x9230, (0..2).map(frame).collect())
            .bytes(0x7fe0, 0x0010, "OB", &[0b1010_0101, 0b0000_1001])
    }

    /// One polygon of one structure.
    pub fn contours() -> Self {
        let polygon = Self::default()
            .text(0x3006, 0x0042, "CS", "CLOSED_PLANAR")
            .decimals(
                0x3006,
                0x0050,
                &[0.0, 0.0, 5.0, 1.0, 0.0, 5.0, 1.0, 1.0, 5.0],
            );
        let structure = Self::default().text(0x3006, 0x0022, "IS", "1").text(
            0x3006,
            0x0026,
            "LO",
            "SEEDED heart",
        );
        let contours =
            Self::default()
                .text(0x3006, 0x0084, "IS", "1")
                .items(0x3006, 0x0040, vec![polygon]);
        Self::default()
            .text(0x0008, 0x0016, "UI", "1.2.840.10008.5.1.4.1.1.481.3")
            .text(0x0008, 0x0060, "CS", "RTSTRUCT")
            .items(0x3006, 0x0020, vec![structure])
            .items(0x3006, 0x0039, vec![contours])
    }

    fn value(&self, value: &Value, way: Way) -> Vec<u8> {
        match value {
            Value::Bytes(bytes) => bytes.clone(),
            Value::Words(words) => words.iter().flat_map(|&word| way.short(word)).collect(),
            Value::Items(items) => (items.iter())
                .flat_map(|item| {
                    let body = item.written(way);
                    [way.item(0xe000, body.len() as u32), body].concat()
                })
                .collect(),
            Value::Parts(parts) => {
                let mut out = way.item(0xe000, 0);
                for part in parts {
                    out.extend(way.item(0xe000, part.len() as u32));
                    out.extend(part);
                }
                out.extend(way.item(0xe0dd, 0));
                out
            }
        }
    }

    fn written(&self, way: Way) -> Vec<u8> {
        let mut out = Vec::new();
        for (&(group, element), (letters, value)) in &self.0 {
            let bytes = self.value(value, way);
            let length = match value {
                Value::Parts(_) => u32::MAX,
                _ => bytes.len() as u32,
            };
            out.extend(way.short(group));
            out.extend(way.short(element));
            let long = ["OB", "OW", "SQ", "UN", "UT"].contains(letters);
            match (way.explicit, long) {
                (true, true) => {
                    out.extend(letters.as_bytes());
                    out.extend([0; 2]);
                    out.extend(way.long(length));
                }
                (true, false) => {
                    out.extend(letters.as_bytes());
                    out.extend(way.short(length as u16));
                }
                (false, _) => out.extend(way.long(length)),
            }
            out.extend(bytes);
        }
        out
    }

    /// The file, in a transfer syntax.
    pub fn file(&self, syntax: &str) -> Vec<u8> {
        let little = Way {
            explicit: true,
            big: false,
        };
        let mut meta = Self::default().text(0x0002, 0x0010, "UI", syntax);
        if let Some((_, Value::Bytes(bytes))) = meta.0.get_mut(&(0x0002, 0x0010)) {
            // Names are filled up with a zero.
            bytes
                .iter_mut()
                .filter(|byte| **byte == b' ')
                .for_each(|byte| *byte = 0);
        }
        let way = Way {
            explicit: syntax != IMPLICIT,
            big: syntax == BIG,
        };
        let mut body = self.written(way);
        if syntax == DEFLATED {
            let mut encoder = DeflateEncoder::new(Vec::new(), Compression::fast());
            encoder.write_all(&body).unwrap();
            body = encoder.finish().unwrap();
        }
        [vec![0; 128], b"DICM".to_vec(), meta.written(little), body].concat()
    }
}

/// An archive of files.
pub fn archive(files: &[Vec<u8>]) -> Vec<u8> {
    let mut writer = ZipWriter::new(Cursor::new(Vec::new()));
    for (number, bytes) in files.iter().enumerate() {
        writer
            .start_file(format!("study/{number}"), SimpleFileOptions::default())
            .unwrap();
        writer.write_all(bytes).unwrap();
    }
    writer.finish().unwrap().into_inner()
}
