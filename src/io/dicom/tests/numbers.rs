//! Which number a pixel means.

use super::writer::{CT, EXPLICIT, IMPLICIT, Made, image, packed, read, said};
use crate::io::dicom::tag::*;

fn values(made: &Made) -> Vec<f32> {
    values_of(&made.file())
}

fn values_of(file: &[u8]) -> Vec<f32> {
    let reading = read(file);
    assert_eq!(reading.series.len(), 1, "{:?}", reading.left_out);
    reading.series[0].image.volumes()[0].to_vec()
}

/// <https://github.com/fo-dicom/fo-dicom/issues/187>, <https://github.com/rordenlab/dcm2niix/issues/688>
#[test]
fn twelve_bits_with_a_sign_within_sixteen_are_extended_and_the_others_masked() {
    let made = image(0.0, 0)
        .shorts(BITS_STORED, &[12])
        .shorts(HIGH_BIT, &[11])
        .shorts(PIXEL_REPRESENTATION, &[1])
        .words(&[0x0fff, 0x0800, 0x07ff, 0xf001, 0x0000, 0x1002]);
    assert_eq!(values(&made), [-1.0, -2048.0, 2047.0, 1.0, 0.0, 2.0]);
    let shifted = made
        .shorts(HIGH_BIT, &[15])
        .words(&[0xfff0, 0x8000, 0x7ff0, 0x001f, 0, 0x0020]);
    assert_eq!(values(&shifted), [-1.0, -2048.0, 2047.0, 1.0, 0.0, 2.0]);
}

/// <https://github.com/Enet4/dicom-rs/issues/460>
#[test]
fn padding_has_the_sign_of_the_pixels_also_where_the_file_says_no_letters() {
    let made = image(0.0, 0)
        .shorts(PIXEL_REPRESENTATION, &[1])
        .shorts(PADDING, &[63_536])
        .words(&[63_536, 0, 1, 2, 3, 4]);
    for file in [made.file(), made.file_as(IMPLICIT)] {
        let values = values_of(&file);
        assert!(values[0].is_nan());
        assert_eq!(values[1..], [0.0, 1.0, 2.0, 3.0, 4.0]);
    }
}

/// <https://github.com/dgobbi/vtk-dicom/issues/173>, <https://github.com/fo-dicom/fo-dicom/issues/406>
#[test]
fn padding_is_masked_before_numbers_are_rescaled() {
    let made = image(0.0, 0)
        .shorts(PADDING, &[10])
        .shorts(PADDING_LIMIT, &[12])
        .decimals(SLOPE, &[2.0])
        .decimals(INTERCEPT, &[-1024.0])
        .words(&[9, 10, 11, 12, 13, 517]);
    let values = values(&made);
    assert_eq!(values[0], -1006.0);
    assert!(values[1..4].iter().all(|value| value.is_nan()));
    assert_eq!(values[4..], [-998.0, 10.0]);
}

#[test]
fn padding_that_stands_outside_of_the_bits_that_count_is_found() {
    let made = image(0.0, 0)
        .shorts(BITS_STORED, &[12])
        .shorts(HIGH_BIT, &[11])
        .shorts(PADDING, &[0x8000])
        .words(&[0x8000, 0, 1, 2, 3, 4]);
    let values = values(&made);
    assert!(values[0].is_nan());
    assert_eq!(values[1], 0.0);
}

/// <https://github.com/cornerstonejs/cornerstone3D/issues/2215>, <https://github.com/ivmartel/dwv/issues/435>
#[test]
fn numbers_whose_low_ones_are_bright_stay_as_they_are() {
    let made = image(0.0, 100).text(PHOTOMETRIC, "CS", "MONOCHROME1");
    assert_eq!(values(&made), [100.0, 101.0, 102.0, 103.0, 104.0, 105.0]);
    assert!(said(&read(&made.file())).contains("low values are meant to be shown bright"));
}

/// <https://github.com/FNNDSC/ami/issues/166>
#[test]
fn the_first_distance_is_that_of_rows() {
    let reading = read(&image(0.0, 0).file());
    let frame = *reading.series[0].image.frame();
    assert_eq!(frame.size(), [3, 2, 1]);
    assert_eq!(frame.spacing()[..2], [1.5, 2.0]);
    assert_eq!(frame.steps()[0].x, 1.5);
    assert_eq!(frame.steps()[1].y, 2.0);
}

#[test]
fn bytes_words_and_points_of_both_lengths_are_read() {
    let bytes = image(0.0, 0)
        .shorts(BITS_ALLOCATED, &[8])
        .shorts(BITS_STORED, &[8])
        .shorts(HIGH_BIT, &[7])
        .bytes(PIXEL_DATA, "OB", vec![0, 1, 2, 253, 254, 255]);
    assert_eq!(values(&bytes), [0.0, 1.0, 2.0, 253.0, 254.0, 255.0]);
    let long: Vec<u8> = [1_u32, 2, 3, 4, 5, u32::MAX]
        .iter()
        .flat_map(|n| n.to_le_bytes())
        .collect();
    let long = image(0.0, 0)
        .shorts(BITS_ALLOCATED, &[32])
        .shorts(BITS_STORED, &[32])
        .shorts(HIGH_BIT, &[31])
        .bytes(PIXEL_DATA, "OW", long);
    assert_eq!(values(&long)[5], u32::MAX as f32);
    let points: Vec<u8> = (0..6)
        .flat_map(|n| (n as f32 / 4.0).to_le_bytes())
        .collect();
    let points = image(0.0, 0)
        .without(PIXEL_DATA)
        .bytes(FLOAT_PIXELS, "OF", points);
    assert_eq!(values(&points)[3], 0.75);
    let points: Vec<u8> = (0..6)
        .flat_map(|n| (f64::from(n) / 4.0).to_le_bytes())
        .collect();
    let points = image(0.0, 0)
        .without(PIXEL_DATA)
        .bytes(DOUBLE_PIXELS, "OD", points);
    assert_eq!(values(&points)[5], 1.25);
}

#[test]
fn a_factor_of_zero_is_none() {
    assert_eq!(values(&image(0.0, 5).decimals(SLOPE, &[0.0]))[0], 5.0);
}

#[test]
fn colours_and_palettes_are_refused() {
    for made in [
        image(0.0, 0).shorts(SAMPLES_PER_PIXEL, &[3]),
        image(0.0, 0).text(PHOTOMETRIC, "CS", "PALETTE COLOR"),
    ] {
        let reading = read(&made.file());
        assert!(reading.series.is_empty());
        assert!(said(&reading).contains("a picture in colours"));
    }
}

#[test]
fn codecs_that_are_not_read_are_refused_by_name() {
    let made = image(0.0, 0).bytes(PIXEL_DATA, "OB", packed(&[b"abcd"]));
    for (syntax, name) in [
        ("1.2.840.10008.1.2.4.93", "JPEG 2000 part 2"),
        ("1.2.840.10008.1.2.4.102", "MPEG-4"),
        ("1.2.840.10008.1.2.4.107", "HEVC"),
        ("1.2.840.10008.1.2.4.110", "JPEG XL"),
        ("1.2.840.10008.1.2.4.201", "high-throughput JPEG 2000"),
    ] {
        let reading = read(&made.file_as(syntax));
        assert!(said(&reading).contains(name), "{}", said(&reading));
    }
}

/// <https://github.com/Enet4/dicom-rs/issues/413> and 414
#[test]
fn packed_frames_in_several_parts_are_joined() {
    let segment: Vec<u8> = [&1_u32.to_le_bytes()[..], &64_u32.to_le_bytes()].concat();
    let head = |bytes: &[u8]| {
        let mut frame = segment.clone();
        frame.resize(64, 0);
        frame.extend(bytes);
        frame
    };
    let made = image(0.0, 0)
        .shorts(BITS_ALLOCATED, &[8])
        .shorts(BITS_STORED, &[8])
        .shorts(HIGH_BIT, &[7]);
    let whole = head(&[5, 1, 2, 3, 4, 5, 6, 0x80]);
    let parts = packed(&[&whole[..66], &whole[66..]]);
    let one = made.clone().bytes(PIXEL_DATA, "OB", parts);
    assert_eq!(
        values_of(&one.file_as("1.2.840.10008.1.2.5")),
        [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]
    );
    // Three parts for two frames, which nothing tells apart.
    let two = made.text(NUMBER_OF_FRAMES, "IS", "2").bytes(
        PIXEL_DATA,
        "OB",
        packed(&[&whole, &whole[..66], &whole[66..]]),
    );
    let reading = read(&two.file_as("1.2.840.10008.1.2.5"));
    assert!(said(&reading).contains("should be 2"), "{}", said(&reading));
    // The table of offsets tells: the second frame begins after the first part and its head of 8 bytes.
    let offsets = [0_u32.to_le_bytes(), (whole.len() as u32 + 8).to_le_bytes()].concat();
    let mut pixels = b"\xfe\xff\x00\xe0\x08\0\0\0".to_vec();
    pixels.extend(offsets);
    pixels.extend(&packed(&[&whole, &whole[..66], &whole[66..]])[8..]);
    let two = two
        .bytes(PIXEL_DATA, "OB", pixels)
        .decimals(FRAME_TIME, &[10.0]);
    let reading = read(&two.file_as("1.2.840.10008.1.2.5"));
    let volumes = reading.series[0].image.volumes();
    assert_eq!(volumes.len(), 2);
    assert_eq!(volumes[0], volumes[1]);
}

#[test]
fn pixels_that_are_cut_short_are_refused_with_both_counts() {
    let mut file = image(0.0, 0).file();
    file.truncate(file.len() - 4);
    let reading = read(&file);
    assert!(
        said(&reading).contains("12 bytes, but only 8 are there"),
        "{}",
        said(&reading)
    );
}

#[test]
fn files_without_preamble_or_group_of_their_own_are_read() {
    let made = image(0.0, 40)
        .text(SOP_CLASS, "UI", CT)
        .text(MODALITY, "CS", "CT");
    let meta = 132 + 8 + 20;
    for file in [made.file()[132..].to_vec(), made.file()[meta..].to_vec()] {
        assert_eq!(values_of(&file)[0], 40.0);
    }
    let implicit = made.file_as(IMPLICIT)[meta - 2..].to_vec();
    assert_eq!(values_of(&implicit)[0], 40.0);
}

#[test]
fn letters_count_whatever_the_head_of_the_file_says_of_them() {
    let made = image(0.0, 40);
    let swapped = |from: &str, to: &str| {
        let (file, head) = (made.file_as(from), made.file_as(to));
        let begin = |file: &[u8]| {
            file.windows(4)
                .position(|four| four == b"\x08\0\x08\0")
                .unwrap()
        };
        [&head[..begin(&head)], &file[begin(&file)..]].concat()
    };
    assert_eq!(values_of(&swapped(EXPLICIT, IMPLICIT))[0], 40.0);
    assert_eq!(values_of(&swapped(IMPLICIT, EXPLICIT))[0], 40.0);
}

/// <https://github.com/pydicom/pydicom/issues/2009>: JPEG-LS of fewer bits than are allocated, with a sign.
#[test]
fn a_sign_is_extended_from_the_bits_that_count_also_after_unpacking() {
    // The example of ITU-T T.87, H.3.
    let stream = b"\xff\xd8\xff\xf7\0\x0b\x08\0\x04\0\x04\x01\x01\x11\0\xff\xda\0\x08\x01\x01\0\0\0\0\
        \xc0\0\0\x6c\x80\x20\x8e\x01\xc0\0\0\x57\x40\0\0\x6e\xe6\0\0\x01\xbc\x18\0\0\x05\xd8\0\0\x91\x60\xff\xd9";
    let made = image(0.0, 0)
        .shorts(ROWS, &[4])
        .shorts(COLUMNS, &[4])
        .shorts(BITS_STORED, &[8])
        .shorts(HIGH_BIT, &[7])
        .shorts(PIXEL_REPRESENTATION, &[1])
        .bytes(PIXEL_DATA, "OB", packed(&[stream]));
    let values = values_of(&made.file_as("1.2.840.10008.1.2.4.80"));
    assert_eq!(
        values[..8],
        [0.0, 0.0, 90.0, 74.0, 68.0, 50.0, 43.0, 205.0 - 256.0]
    );
}
