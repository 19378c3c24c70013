//! A writer of small DICOM files for tests.

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::io::dicom::read::read_dicom_bytes;
use crate::io::dicom::reading::DicomReading;
use crate::io::dicom::tag::*;
use crate::io::limits::Limits;
use crate::progress::Progress;

pub(super) const EXPLICIT: &str = "1.2.840.10008.1.2.1";
pub(super) const IMPLICIT: &str = "1.2.840.10008.1.2";
pub(super) const MR: &str = "1.2.840.10008.5.1.4.1.1.4";
pub(super) const CT: &str = "1.2.840.10008.5.1.4.1.1.2";
pub(super) const NM: &str = "1.2.840.10008.5.1.4.1.1.20";

/// Attributes that become a file or an item of a sequence.
#[derive(Clone, Debug, Default)]
pub(super) struct Made {
    elements: BTreeMap<Tag, (&'static str, Value)>,
}

#[derive(Clone, Debug)]
enum Value {
    Bytes(Vec<u8>),
    Items(Vec<Made>),
}

impl Made {
    /// An attribute of text or numbers as text.
    pub(super) fn text(mut self, tag: Tag, letters: &'static str, text: impl Into<String>) -> Self {
        let mut bytes = text.into().into_bytes();
        if bytes.len() % 2 == 1 {
            bytes.push(b' ');
        }
        self.elements.insert(tag, (letters, Value::Bytes(bytes)));
        self
    }

    /// Numbers as text.
    pub(super) fn decimals(self, tag: Tag, numbers: &[f64]) -> Self {
        let words: Vec<String> = numbers.iter().map(f64::to_string).collect();
        self.text(tag, "DS", words.join("\\"))
    }

    /// Unsigned 16-bit numbers.
    pub(super) fn shorts(self, tag: Tag, numbers: &[u16]) -> Self {
        self.bytes(
            tag,
            "US",
            numbers.iter().flat_map(|n| n.to_le_bytes()).collect(),
        )
    }

    /// Unsigned 32-bit numbers.
    pub(super) fn longs(self, tag: Tag, numbers: &[u32]) -> Self {
        self.bytes(
            tag,
            "UL",
            numbers.iter().flat_map(|n| n.to_le_bytes()).collect(),
        )
    }

    /// Numbers of 64 bits with a point.
    pub(super) fn double(self, tag: Tag, number: f64) -> Self {
        self.bytes(tag, "FD", number.to_le_bytes().to_vec())
    }

    pub(super) fn bytes(mut self, tag: Tag, letters: &'static str, bytes: Vec<u8>) -> Self {
        self.elements.insert(tag, (letters, Value::Bytes(bytes)));
        self
    }

    pub(super) fn items(mut self, tag: Tag, items: Vec<Self>) -> Self {
        self.elements.insert(tag, ("SQ", Value::Items(items)));
        self
    }

    pub(super) fn without(mut self, tag: Tag) -> Self {
        self.elements.remove(&tag);
        self
    }

    fn written(&self, explicit: bool) -> Vec<u8> {
        let mut out = Vec::new();
        for (tag, (letters, value)) in &self.elements {
            let bytes = match value {
                Value::Bytes(bytes) => bytes.clone(),
                Value::Items(items) => items
                    .iter()
                    .flat_map(|item| item.as_item(explicit))
                    .collect(),
            };
            out.extend(tag.0.to_le_bytes());
            out.extend(tag.1.to_le_bytes());
            let long = ["OB", "OW", "OF", "OD", "SQ", "UN", "UT"].contains(letters);
            if explicit {
                out.extend(letters.as_bytes());
            }
            if explicit && !long {
                out.extend((bytes.len() as u16).to_le_bytes());
            } else {
                out.extend(&[0; 2][..if explicit { 2 } else { 0 }]);
                // Packed pixels have no stated length.
                let packed = bytes.starts_with(b"\xfe\xff\x00\xe0") && *tag == PIXEL_DATA;
                let length = if packed { u32::MAX } else { bytes.len() as u32 };
                out.extend(length.to_le_bytes());
            }
            out.extend(bytes);
        }
        out
    }

    fn as_item(&self, explicit: bool) -> Vec<u8> {
        let body = self.written(explicit);
        let mut out = b"\xfe\xff\x00\xe0".to_vec();
        out.extend((body.len() as u32).to_le_bytes());
        out.extend(body);
        out
    }

    /// The file, in a transfer syntax.
    pub(super) fn file_as(&self, syntax: &str) -> Vec<u8> {
        let meta = Self::default().text(TRANSFER_SYNTAX, "UI", syntax);
        let mut out = vec![0; 128];
        out.extend(b"DICM");
        out.extend(meta.written(true));
        out.extend(self.written(syntax != IMPLICIT));
        out
    }

    /// The file, explicit and little endian.
    pub(super) fn file(&self) -> Vec<u8> {
        self.file_as(EXPLICIT)
    }
}

/// Packed pixels: a table of no offsets, the parts, and the end.
pub(super) fn packed(parts: &[&[u8]]) -> Vec<u8> {
    let mut out = Vec::new();
    for part in [&[][..]].iter().chain(parts) {
        out.extend(b"\xfe\xff\x00\xe0");
        out.extend((part.len() as u32).to_le_bytes());
        out.extend(*part);
    }
    out.extend(b"\xfe\xff\xdd\xe0\0\0\0\0");
    out
}

/// An MR image of 3 columns and 2 rows at a height, whose numbers are `first`, `first + 1`, …
pub(super) fn image(z_mm: f64, first: u16) -> Made {
    let pixels: Vec<u16> = (first..first + 6).collect();
    Made::default()
        .text(IMAGE_TYPE, "CS", "ORIGINAL\\PRIMARY\\M")
        .text(SOP_CLASS, "UI", MR)
        .text(MODALITY, "CS", "MR")
        .text(STUDY, "UI", "1.2")
        .text(SERIES, "UI", "1.2.3")
        .decimals(SERIES_NUMBER, &[7.0])
        .decimals(SLICE_THICKNESS, &[5.0])
        .decimals(POSITION, &[-10.0, -20.0, z_mm])
        .decimals(ORIENTATION, &[1.0, 0.0, 0.0, 0.0, 1.0, 0.0])
        .decimals(PIXEL_SPACING, &[2.0, 1.5])
        .shorts(SAMPLES_PER_PIXEL, &[1])
        .text(PHOTOMETRIC, "CS", "MONOCHROME2")
        .shorts(ROWS, &[2])
        .shorts(COLUMNS, &[3])
        .shorts(BITS_ALLOCATED, &[16])
        .shorts(BITS_STORED, &[16])
        .shorts(HIGH_BIT, &[15])
        .shorts(PIXEL_REPRESENTATION, &[0])
        .words(&pixels)
}

impl Made {
    /// Pixels of 16 bits.
    pub(super) fn words(self, pixels: &[u16]) -> Self {
        self.bytes(
            PIXEL_DATA,
            "OW",
            pixels.iter().flat_map(|n| n.to_le_bytes()).collect(),
        )
    }
}

/// What one file reads to.
pub(super) fn read(file: &[u8]) -> DicomReading {
    read_dicom_bytes(
        "file",
        Arc::from(file),
        &Limits::default(),
        &Progress::default(),
    )
    .unwrap()
}

/// What a folder of files reads to.
pub(super) fn read_all(files: &[Made]) -> DicomReading {
    let folder = tempfile::tempdir().unwrap();
    for (number, file) in files.iter().enumerate() {
        std::fs::write(folder.path().join(format!("{number:05}")), file.file()).unwrap();
    }
    let paths = [folder.path().to_owned()];
    crate::io::dicom::read::read_dicom(&paths, &Limits::default(), &Progress::default()).unwrap()
}

/// All that is said, in one text.
pub(super) fn said(reading: &DicomReading) -> String {
    let notices = reading.series.iter().flat_map(|series| &series.notices);
    let notices = notices.map(|notice| notice.text.clone());
    let left = reading.left_out.iter().map(|out| out.reason.to_string());
    notices.chain(left).collect::<Vec<_>>().join("\n")
}
