//! What reports are about and no unit test shows: small files, as they lie on a disk, to what is read.

use std::fs;
use std::process::Command;

use cardiomorph::image::Mask;
use cardiomorph::io::{DicomReading, Limits, read_dicom, read_dicom_bytes};
use cardiomorph::mesh::Vector3;
use cardiomorph::progress::Progress;

use crate::small_images::dicom::{Dicom, EXPLICIT, JPEG, JPEG_2000, JPEG_LS};
use crate::small_images::{
    JPEG_2000_STREAM, JPEG_LOSSLESS_STREAM, JPEG_LS_STREAM, UNPACKED, from_hex,
};

/// What a folder of files reads to.
fn read(files: &[Dicom]) -> DicomReading {
    let folder = tempfile::tempdir().unwrap();
    for (number, file) in files.iter().enumerate() {
        fs::write(
            folder.path().join(format!("{number:03}")),
            file.file(EXPLICIT),
        )
        .unwrap();
    }
    let paths = [folder.path().to_owned()];
    read_dicom(&paths, &Limits::default(), &Progress::default()).unwrap()
}

fn read_bytes(bytes: Vec<u8>) -> DicomReading {
    let limits = Limits::default();
    read_dicom_bytes("file", bytes.into(), &limits, &Progress::default()).unwrap()
}

/// Report 4: 6.4 mm are not 6 mm.
#[test]
fn a_distance_keeps_its_decimals() {
    let reading = read(&[Dicom::gated()]);
    let frame = *reading.series[0].image.frame();
    assert!((frame.steps()[2] - Vector3::new(0.0, 0.0, -6.4)).norm() < 1e-12);
}

/// Report 5: slices that are tilted against the axes of the scanner, 5 mm thick, 7 mm apart.
#[test]
fn the_distance_is_measured_along_the_normal() {
    let slices = [0.0, 7.0, 14.0].map(|mm| {
        Dicom::image(0.0, mm as u16)
            .decimals(0x0020, 0x0037, &[1.0, 0.0, 0.0, 0.0, 0.8, 0.6])
            .decimals(0x0020, 0x0032, &[3.0, -0.6 * mm, 0.8 * mm])
            .decimals(0x0018, 0x0088, &[5.0])
    });
    let frame = *read(&slices).series[0].image.frame();
    assert!((frame.spacing()[2] - 7.0).abs() < 1e-12);
    assert!((frame.directions()[2] - Vector3::new(0.0, -0.6, 0.8)).norm() < 1e-12);
}

/// Report 7: 18 voxels of 1.5 mm × 2 mm, in slices of 5 mm that are 10 mm apart, are 0.54 ml, not 0.27.
#[test]
fn millilitres_count_the_gaps_between_slices() {
    let slices = [0.0, 10.0, 20.0].map(|z| Dicom::image(z, 0).words(0x7fe0, 0x0010, &[1; 6]));
    let reading = read(&slices);
    let image = &reading.series[0].image;
    let mask = Mask::of_labels(image.frame().size(), &image.volumes()[0], &[1]).unwrap();
    assert!((mask.volume_ml(image.frame()) - 0.54).abs() < 1e-12);
}

/// Report 12: in whatever order the files lie.
#[test]
fn a_hundred_images_at_four_places_are_25_volumes() {
    let files: Vec<Dicom> = (0..100_u16)
        .map(|number| {
            let file = number * 37 % 100;
            let (instant, slice) = (file % 25, file / 25);
            Dicom::image(f64::from(slice) * 8.0, 100 * instant + slice).decimals(
                0x0018,
                0x1060,
                &[f64::from(instant) * 30.0],
            )
        })
        .collect();
    let reading = read(&files);
    assert_eq!(reading.series.len(), 1);
    let image = &reading.series[0].image;
    assert_eq!(image.frame().size(), [3, 2, 4]);
    assert_eq!(image.volumes().len(), 25);
    for (instant, volume) in image.volumes().iter().enumerate() {
        let firsts: Vec<f32> = volume.iter().step_by(6).copied().collect();
        let expected = [0.0, 1.0, 2.0, 3.0].map(|slice| 100.0 * instant as f32 + slice);
        assert_eq!(firsts, expected);
    }
    assert_eq!(image.times_ms().unwrap()[24], 720.0);
}

/// Report 20: the head of the JPEG 2000 stream says "without a sign", that of its file "with one". The other two streams
/// hold the same bits and say nothing of signs.
#[test]
fn streams_keep_their_bits_whatever_their_heads_say_of_signs() {
    let image = |signed: u16| Dicom::image(0.0, 0).words(0x0028, 0x0103, &[signed]);
    let unsigned = UNPACKED.map(|value| if value < 0.0 { value + 65_536.0 } else { value });
    for (syntax, stream) in [
        (JPEG_2000, JPEG_2000_STREAM),
        (JPEG, JPEG_LOSSLESS_STREAM),
        (JPEG_LS, JPEG_LS_STREAM),
    ] {
        for (signed, expected) in [(1, UNPACKED), (0, unsigned)] {
            let reading = read_bytes(image(signed).packed(&[&from_hex(stream)]).file(syntax));
            let values = reading.series[0].image.volumes()[0].to_vec();
            assert_eq!(values, expected, "{syntax}");
        }
    }
}

/// Report 24: what `image` prints as minimum is that of the pixels that are there, rescaled.
#[test]
fn padding_is_no_lowest_value() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("padded.dcm");
    let padded = Dicom::image(0.0, 0)
        .words(0x0028, 0x0103, &[1])
        .words(0x0028, 0x0120, &[63_536])
        .decimals(0x0028, 0x1052, &[-1024.0])
        .decimals(0x0028, 0x1053, &[2.0])
        .words(0x7fe0, 0x0010, &[63_536, 500, 520, 540, 560, 63_536]);
    fs::write(&file, padded.file(EXPLICIT)).unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_cardiomorph"))
        .args(["image", file.to_str().unwrap(), "--json"])
        .output()
        .unwrap();
    let said: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let series = &said["series"][0];
    assert_eq!(series["minimum"], -24.0);
    assert_eq!(series["maximum"], 96.0);
    assert_eq!(series["sums"][0], 144.0);
    assert_eq!(series["without_value"][0], 2);
}

/// Report 31.
#[test]
fn a_film_of_one_slice_is_one_slice() {
    let files: Vec<Dicom> = (0..5_u16)
        .map(|instant| {
            Dicom::image(12.0, instant).decimals(0x0018, 0x1060, &[f64::from(instant) * 40.0])
        })
        .collect();
    let reading = read(&files);
    assert_eq!(reading.series.len(), 1);
    let image = &reading.series[0].image;
    assert_eq!(image.frame().size(), [3, 2, 1]);
    assert_eq!(image.volumes().len(), 5);
    assert_eq!(image.times_ms(), Some(&[0.0, 40.0, 80.0, 120.0, 160.0][..]));
}
