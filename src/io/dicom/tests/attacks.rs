//! Files that lie, and damaged copies of files.

use std::sync::Arc;

use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::writer::{IMPLICIT, Made, image, packed, read, said};
use crate::io::dicom::read::read_dicom_bytes;
use crate::io::dicom::tag::*;
use crate::io::limits::Limits;
use crate::progress::{Progress, Stopped};

#[test]
fn a_length_of_gigabytes_in_a_file_of_bytes_takes_none() {
    let mut file = image(0.0, 0).without(PIXEL_DATA).file();
    for length in [0xc000_0000_u32, u32::MAX, u32::MAX - 1] {
        let mut lying = file.clone();
        lying.extend(b"\xe0\x7f\x10\x00OW\0\0");
        lying.extend(length.to_le_bytes());
        lying.extend([1, 2, 3]);
        assert!(read(&lying).series.is_empty());
    }
    file.extend(b"\x09\x00\x01\x00UT\0\0\0\0\0\xc0abc");
    assert!(read(&file).series.is_empty());
}

#[test]
fn sizes_beyond_the_bytes_that_are_there_are_refused_before_memory_is_taken() {
    let large = image(0.0, 0)
        .shorts(ROWS, &[65_535])
        .shorts(COLUMNS, &[65_535])
        .text(NUMBER_OF_FRAMES, "IS", "4000000000");
    assert!(said(&read(&large.file())).contains("voxels; the limit is"));
    let medium = image(0.0, 0)
        .shorts(ROWS, &[16_000])
        .shorts(COLUMNS, &[16_000]);
    assert!(said(&read(&medium.file())).contains("only 12 are there"));
    let streams: [(&str, Vec<u8>); 4] = [
        ("5", vec![1, 0, 0, 0, 64, 0, 0, 0]),
        ("4.70", jpeg_head(16_000, 16_000)),
        ("4.80", jpeg_ls_head(16_000, 16_000)),
        ("4.90", jpeg2000_head(16_000, 16_000)),
    ];
    for (syntax, stream) in streams {
        let made = medium.clone().bytes(PIXEL_DATA, "OB", packed(&[&stream]));
        let reading = read(&made.file_as(&format!("1.2.840.10008.1.2.{syntax}")));
        assert!(reading.series.is_empty());
        assert_eq!(reading.left_out.len(), 1);
        assert!(
            said(&reading).contains("from so few bytes"),
            "{}",
            said(&reading)
        );
    }
}

fn jpeg_head(rows: u16, columns: u16) -> Vec<u8> {
    let mut bytes = vec![0xff, 0xd8, 0xff, 0xc3, 0, 11, 16];
    bytes.extend(rows.to_be_bytes());
    bytes.extend(columns.to_be_bytes());
    bytes.extend([1, 1, 0x11, 0]);
    bytes
}

fn jpeg_ls_head(rows: u16, columns: u16) -> Vec<u8> {
    let mut bytes = b"\xff\xd8\xff\xf7\0\x0b\x10".to_vec();
    bytes.extend(rows.to_be_bytes());
    bytes.extend(columns.to_be_bytes());
    bytes.extend(b"\x01\x01\x11\0\xff\xda\0\x08\x01\x01\0\0\0\0");
    bytes
}

fn jpeg2000_head(rows: u32, columns: u32) -> Vec<u8> {
    let mut bytes = vec![0xff, 0x4f, 0xff, 0x51, 0, 41, 0, 0];
    for number in [columns, rows, 0, 0, 1, 1, 0, 0] {
        bytes.extend(number.to_be_bytes());
    }
    bytes.extend([0, 1, 15, 1, 1, 0, 0]);
    bytes
}

#[test]
fn sequences_within_sequences_without_end_are_no_danger() {
    let mut file = image(0.0, 0).without(PIXEL_DATA).file();
    for _ in 0..200_000 {
        file.extend(b"\x40\x00\x75\xa1SQ\0\0\xff\xff\xff\xff\xfe\xff\x00\xe0\xff\xff\xff\xff");
    }
    assert!(read(&file).series.is_empty());
}

/// Copies of small files of every way of writing, with bytes changed, taken out or put in.
#[test]
fn a_thousand_damaged_copies_are_read_or_refused() {
    let groups = Made::default().items(
        PLANE_POSITION,
        vec![Made::default().decimals(POSITION, &[1.0, 2.0, 3.0])],
    );
    let frames = image(0.0, 0)
        .text(NUMBER_OF_FRAMES, "IS", "1")
        .items(PER_FRAME_GROUPS, vec![groups]);
    let mut run = vec![1, 0, 0, 0, 64, 0, 0, 0];
    run.resize(64, 0);
    run.extend([5, 1, 2, 3, 4, 5, 6, 0x80]);
    let runs = image(0.0, 0)
        .shorts(BITS_ALLOCATED, &[8])
        .shorts(BITS_STORED, &[8])
        .shorts(HIGH_BIT, &[7])
        .bytes(PIXEL_DATA, "OB", packed(&[&run]));
    let originals = [
        image(0.0, 0).file(),
        frames.file_as(IMPLICIT),
        frames.file(),
        runs.file_as("1.2.840.10008.1.2.5"),
    ];
    for (seed, original) in (0..1000).zip(originals.iter().cycle()) {
        let damaged = damaged(original, seed);
        let limits = Limits {
            voxels: 1 << 16,
            voxels_in_all: 1 << 16,
            ..Limits::default()
        };
        let reading = read_dicom_bytes("f", damaged.into(), &limits, &Progress::default()).unwrap();
        assert!(reading.series.len() + reading.left_out.len() > 0);
    }
}

/// A copy with up to eight changes, most of them beyond the preamble.
fn damaged(original: &[u8], seed: u64) -> Vec<u8> {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let mut bytes = original.to_vec();
    for _ in 0..random.random_range(1..8) {
        let at = random.random_range(100.min(bytes.len() - 1)..bytes.len());
        match random.random_range(0..6) {
            0 => bytes.truncate(at.max(140)),
            1 => bytes.insert(at, random.random()),
            2 => drop(bytes.remove(at)),
            3 => bytes[at] ^= 1 << random.random_range(0..8),
            4 => bytes[at] = [0, 0xff, 0x7f, 0x80][random.random_range(0..4)],
            _ => bytes[at] = random.random(),
        }
    }
    bytes
}

#[test]
fn a_stopped_reading_says_so() {
    let progress = Progress::default();
    progress.stop();
    let bytes: Arc<[u8]> = image(0.0, 0).file().into();
    let stopped = read_dicom_bytes("f", bytes, &Limits::default(), &progress);
    assert_eq!(stopped.err(), Some(Stopped));
}

#[test]
fn counters_that_name_more_slices_than_there_are_frames_take_no_memory() {
    let frames = 60_000_u16;
    let numbers: Vec<u16> = (1..=frames).collect();
    let made = image(0.0, 0)
        .text(SOP_CLASS, "UI", super::writer::NM)
        .text(IMAGE_TYPE, "CS", "ORIGINAL\\PRIMARY\\RECON GATED TOMO")
        .text(NUMBER_OF_FRAMES, "IS", frames.to_string())
        .shorts(ROWS, &[1])
        .shorts(COLUMNS, &[1])
        .shorts(NUMBER_OF_SLICES, &[frames])
        .bytes(
            SLICE_VECTOR,
            "OW",
            numbers.iter().flat_map(|n| n.to_le_bytes()).collect(),
        )
        .bytes(
            TIME_SLOT_VECTOR,
            "OW",
            numbers.iter().flat_map(|n| n.to_le_bytes()).collect(),
        )
        .words(&numbers);
    let reading = read(&made.file());
    assert!(
        said(&reading).contains("there are not 60000 slices of 60000 gates"),
        "{}",
        said(&reading)
    );
    let far = made
        .longs(SLICE_VECTOR, &[0, u32::MAX])
        .text(NUMBER_OF_FRAMES, "IS", "2");
    let far = far.without(TIME_SLOT_VECTOR);
    assert!(said(&read(&far.file())).contains("have gaps"));
}
