//! The attributes that are read, by the numbers and representations of DICOM PS3.6.

use std::fmt;

/// The group and the element number of an attribute.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug, Hash)]
pub(super) struct Tag(pub(super) u16, pub(super) u16);

impl fmt::Display for Tag {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "({:04X},{:04X})", self.0, self.1)
    }
}

/// How the value of an attribute is written, as far as numbers and words go.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Kind {
    /// Decimal numbers, whole numbers or words as text: DS, IS, CS, UI, DA, TM, SH.
    Text,
    /// Unsigned 16-bit.
    U16,
    /// Signed 16-bit.
    I16,
    /// Unsigned 32-bit.
    U32,
    /// Signed 32-bit.
    I32,
    /// 32-bit floating point.
    F32,
    /// 64-bit floating point.
    F64,
    /// Pairs of a group and an element number.
    Tags,
    /// Bytes, or what is not read as numbers.
    Bytes,
}

impl Kind {
    /// That of two letters of a file.
    pub(super) fn of_letters(letters: [u8; 2]) -> Self {
        match &letters {
            b"US" => Self::U16,
            b"SS" => Self::I16,
            b"UL" => Self::U32,
            b"SL" => Self::I32,
            b"FL" => Self::F32,
            b"FD" => Self::F64,
            b"AT" => Self::Tags,
            b"DS" | b"IS" | b"CS" | b"UI" | b"DA" | b"TM" | b"DT" | b"SH" | b"LO" => Self::Text,
            _ => Self::Bytes,
        }
    }

    /// That of an attribute whose file does not say it (implicit, or unknown to who wrote it).
    pub(super) fn implied(tag: Tag) -> Self {
        match tag {
            SAMPLES_PER_PIXEL
            | ROWS
            | COLUMNS
            | BITS_ALLOCATED
            | BITS_STORED
            | HIGH_BIT
            | PIXEL_REPRESENTATION
            | PLANAR_CONFIGURATION
            | PADDING
            | PADDING_LIMIT
            | RR_INTERVAL_VECTOR
            | NUMBER_OF_RR_INTERVALS
            | TIME_SLOT_VECTOR
            | NUMBER_OF_TIME_SLOTS
            | SLICE_VECTOR
            | NUMBER_OF_SLICES
            | REFERENCED_SEGMENT => Self::U16,
            TEMPORAL_POSITION_INDEX | DIMENSION_INDEX_VALUES => Self::U32,
            CARDIAC_PERCENT | CARDIAC_DELAY | RR_INTERVAL_NOMINAL => Self::F64,
            DIMENSION_POINTER | FRAME_INCREMENT_POINTER => Self::Tags,
            PIXEL_DATA | FLOAT_PIXELS | DOUBLE_PIXELS => Self::Bytes,
            _ => Self::Text,
        }
    }
}

pub(super) const TRANSFER_SYNTAX: Tag = Tag(0x0002, 0x0010);
pub(super) const DIRECTORY: Tag = Tag(0x0004, 0x1220);
pub(super) const IMAGE_TYPE: Tag = Tag(0x0008, 0x0008);
pub(super) const SOP_CLASS: Tag = Tag(0x0008, 0x0016);
pub(super) const SOP_INSTANCE: Tag = Tag(0x0008, 0x0018);
pub(super) const ACQUISITION_TIME: Tag = Tag(0x0008, 0x0032);
pub(super) const CONTENT_TIME: Tag = Tag(0x0008, 0x0033);
pub(super) const MODALITY: Tag = Tag(0x0008, 0x0060);
pub(super) const SCANNING_SEQUENCE: Tag = Tag(0x0018, 0x0020);
pub(super) const SEQUENCE_VARIANT: Tag = Tag(0x0018, 0x0021);
pub(super) const SLICE_THICKNESS: Tag = Tag(0x0018, 0x0050);
pub(super) const ECHO_TIME: Tag = Tag(0x0018, 0x0081);
pub(super) const SPACING_BETWEEN_SLICES: Tag = Tag(0x0018, 0x0088);
pub(super) const TRIGGER_TIME: Tag = Tag(0x0018, 0x1060);
pub(super) const NOMINAL_INTERVAL: Tag = Tag(0x0018, 0x1062);
pub(super) const REFERENCED_INSTANCE: Tag = Tag(0x0008, 0x1155);
pub(super) const FRAME_TIME: Tag = Tag(0x0018, 0x1063);
pub(super) const FRAME_TIME_VECTOR: Tag = Tag(0x0018, 0x1065);
pub(super) const IMAGES_OF_A_BEAT: Tag = Tag(0x0018, 0x1090);
pub(super) const CARDIAC_SYNCHRONIZATION: Tag = Tag(0x0018, 0x9118);
pub(super) const FRAME_REFERENCE_TIME: Tag = Tag(0x0054, 0x1300);
pub(super) const STUDY: Tag = Tag(0x0020, 0x000d);
pub(super) const SERIES: Tag = Tag(0x0020, 0x000e);
pub(super) const SERIES_NUMBER: Tag = Tag(0x0020, 0x0011);
pub(super) const ACQUISITION_NUMBER: Tag = Tag(0x0020, 0x0012);
pub(super) const INSTANCE_NUMBER: Tag = Tag(0x0020, 0x0013);
pub(super) const POSITION: Tag = Tag(0x0020, 0x0032);
pub(super) const ORIENTATION: Tag = Tag(0x0020, 0x0037);
pub(super) const FRAME_OF_REFERENCE: Tag = Tag(0x0020, 0x0052);
pub(super) const TEMPORAL_POSITION: Tag = Tag(0x0020, 0x0100);
pub(super) const FRAME_CONTENT: Tag = Tag(0x0020, 0x9111);
pub(super) const PLANE_POSITION: Tag = Tag(0x0020, 0x9113);
pub(super) const PLANE_ORIENTATION: Tag = Tag(0x0020, 0x9116);
pub(super) const TEMPORAL_POSITION_INDEX: Tag = Tag(0x0020, 0x9128);
pub(super) const CARDIAC_DELAY: Tag = Tag(0x0020, 0x9153);
pub(super) const DIMENSION_INDEX_VALUES: Tag = Tag(0x0020, 0x9157);
pub(super) const DIMENSION_POINTER: Tag = Tag(0x0020, 0x9165);
pub(super) const DIMENSION_INDEX_SEQUENCE: Tag = Tag(0x0020, 0x9222);
pub(super) const CARDIAC_PERCENT: Tag = Tag(0x0020, 0x9241);
pub(super) const RR_INTERVAL_NOMINAL: Tag = Tag(0x0020, 0x9251);
pub(super) const SAMPLES_PER_PIXEL: Tag = Tag(0x0028, 0x0002);
pub(super) const PHOTOMETRIC: Tag = Tag(0x0028, 0x0004);
pub(super) const PLANAR_CONFIGURATION: Tag = Tag(0x0028, 0x0006);
pub(super) const NUMBER_OF_FRAMES: Tag = Tag(0x0028, 0x0008);
pub(super) const FRAME_INCREMENT_POINTER: Tag = Tag(0x0028, 0x0009);
pub(super) const ROWS: Tag = Tag(0x0028, 0x0010);
pub(super) const COLUMNS: Tag = Tag(0x0028, 0x0011);
pub(super) const PIXEL_SPACING: Tag = Tag(0x0028, 0x0030);
pub(super) const BITS_ALLOCATED: Tag = Tag(0x0028, 0x0100);
pub(super) const BITS_STORED: Tag = Tag(0x0028, 0x0101);
pub(super) const HIGH_BIT: Tag = Tag(0x0028, 0x0102);
pub(super) const PIXEL_REPRESENTATION: Tag = Tag(0x0028, 0x0103);
pub(super) const PADDING: Tag = Tag(0x0028, 0x0120);
pub(super) const PADDING_LIMIT: Tag = Tag(0x0028, 0x0121);
pub(super) const INTERCEPT: Tag = Tag(0x0028, 0x1052);
pub(super) const SLOPE: Tag = Tag(0x0028, 0x1053);
pub(super) const PIXEL_MEASURES: Tag = Tag(0x0028, 0x9110);
pub(super) const VALUE_TRANSFORMATION: Tag = Tag(0x0028, 0x9145);
pub(super) const DETECTOR_INFORMATION: Tag = Tag(0x0054, 0x0022);
pub(super) const RR_INTERVAL_VECTOR: Tag = Tag(0x0054, 0x0060);
pub(super) const NUMBER_OF_RR_INTERVALS: Tag = Tag(0x0054, 0x0061);
pub(super) const GATED_INFORMATION: Tag = Tag(0x0054, 0x0062);
pub(super) const DATA_INFORMATION: Tag = Tag(0x0054, 0x0063);
pub(super) const TIME_SLOT_VECTOR: Tag = Tag(0x0054, 0x0070);
pub(super) const NUMBER_OF_TIME_SLOTS: Tag = Tag(0x0054, 0x0071);
pub(super) const TIME_SLOT_INFORMATION: Tag = Tag(0x0054, 0x0072);
pub(super) const TIME_SLOT_TIME: Tag = Tag(0x0054, 0x0073);
pub(super) const SLICE_VECTOR: Tag = Tag(0x0054, 0x0080);
pub(super) const NUMBER_OF_SLICES: Tag = Tag(0x0054, 0x0081);
pub(super) const SEGMENTATION_TYPE: Tag = Tag(0x0062, 0x0001);
pub(super) const SEGMENTS: Tag = Tag(0x0062, 0x0002);
pub(super) const SEGMENT_NUMBER: Tag = Tag(0x0062, 0x0004);
pub(super) const SEGMENT_LABEL: Tag = Tag(0x0062, 0x0005);
pub(super) const SEGMENT_TYPE: Tag = Tag(0x0062, 0x000f);
pub(super) const CODE_MEANING: Tag = Tag(0x0008, 0x0104);
pub(super) const SEGMENT_IDENTIFICATION: Tag = Tag(0x0062, 0x000a);
pub(super) const REFERENCED_SEGMENT: Tag = Tag(0x0062, 0x000b);
pub(super) const MAXIMUM_FRACTION: Tag = Tag(0x0062, 0x000e);
pub(super) const CONTOUR_IMAGES: Tag = Tag(0x3006, 0x0016);
pub(super) const STRUCTURES: Tag = Tag(0x3006, 0x0020);
pub(super) const STRUCTURE_NUMBER: Tag = Tag(0x3006, 0x0022);
pub(super) const STRUCTURE_NAME: Tag = Tag(0x3006, 0x0026);
pub(super) const STRUCTURE_CONTOURS: Tag = Tag(0x3006, 0x0039);
pub(super) const CONTOURS: Tag = Tag(0x3006, 0x0040);
pub(super) const CONTOUR_KIND: Tag = Tag(0x3006, 0x0042);
pub(super) const CONTOUR_DATA: Tag = Tag(0x3006, 0x0050);
pub(super) const REFERENCED_STRUCTURE: Tag = Tag(0x3006, 0x0084);
pub(super) const SHARED_GROUPS: Tag = Tag(0x5200, 0x9229);
pub(super) const PER_FRAME_GROUPS: Tag = Tag(0x5200, 0x9230);
pub(super) const FLOAT_PIXELS: Tag = Tag(0x7fe0, 0x0008);
pub(super) const DOUBLE_PIXELS: Tag = Tag(0x7fe0, 0x0009);
pub(super) const PIXEL_DATA: Tag = Tag(0x7fe0, 0x0010);
