//! What a file says of a patient stays in it.

use super::writer::{Made, image, packed, read};
use crate::io::dicom::tag::*;

/// Attributes that are names, numbers, dates or free text.
fn with_words(mut made: Made) -> Made {
    const TEXTS: [(u16, u16, &str); 14] = [
        (0x0008, 0x0050, "SH"),
        (0x0008, 0x0080, "LO"),
        (0x0008, 0x0090, "PN"),
        (0x0008, 0x1030, "LO"),
        (0x0008, 0x103e, "LO"),
        (0x0010, 0x0010, "PN"),
        (0x0010, 0x0020, "LO"),
        (0x0010, 0x1040, "LO"),
        (0x0010, 0x21b0, "LT"),
        (0x0018, 0x1030, "LO"),
        (0x0020, 0x0010, "SH"),
        (0x0020, 0x4000, "LT"),
        (0x0011, 0x0010, "LO"),
        (0x0033, 0x1013, "LO"),
    ];
    for (group, element, letters) in TEXTS {
        made = made.text(Tag(group, element), letters, "SEEDED^NAME");
    }
    made.text(Tag(0x0010, 0x0030), "DA", "19310723")
}

/// Every text of what was read, also of what cannot be shown.
fn all_text(file: &[u8]) -> String {
    format!("{:?}", read(file))
}

#[test]
fn no_word_of_a_patient_is_in_what_is_read_or_said() {
    let made = with_words(image(0.0, 0));
    let mut files = vec![made.file(), made.file_as("1.2.840.10008.1.2")];
    // Also where what is said should be a number or a technical word.
    let places = [
        (IMAGE_TYPE, "CS"),
        (MODALITY, "CS"),
        (SOP_CLASS, "UI"),
        (PHOTOMETRIC, "CS"),
        (NUMBER_OF_FRAMES, "IS"),
        (POSITION, "DS"),
        (ORIENTATION, "DS"),
        (PIXEL_SPACING, "DS"),
        (TRIGGER_TIME, "DS"),
        (SEGMENTATION_TYPE, "CS"),
        (SERIES, "UI"),
        (SERIES_NUMBER, "IS"),
        (ROWS, "UT"),
        (BITS_STORED, "UT"),
    ];
    for (tag, letters) in places {
        files.push(
            made.clone()
                .text(tag, letters, "SEEDED^NAME19310723")
                .file(),
        );
    }
    files.push(made.file_as("SEEDED^NAME"));
    let packed = made.bytes(PIXEL_DATA, "OB", packed(&[b"SEEDED^NAME"]));
    for syntax in ["5", "4.50", "4.70", "4.90"] {
        files.push(packed.file_as(&format!("1.2.840.10008.1.2.{syntax}")));
    }
    for file in files {
        let text = all_text(&file);
        assert!(
            !text.contains("SEEDED") && !text.contains("19310723"),
            "{text}"
        );
    }
}
