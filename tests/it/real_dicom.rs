//! Real and realistic DICOM files of the shared folder, read to the values that their descriptions give.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Instant;

use cardiomorph::io::{DicomReading, ImageSeries, Limits, read_dicom};
use cardiomorph::progress::Progress;

use crate::real_dicom_tables::{PLACED, READ, REFUSED, Row};
use crate::shared::shared_data;

fn read(place: &str) -> DicomReading {
    read_paths(&[shared_data(&format!("images/{place}"))])
}

fn read_paths(paths: &[PathBuf]) -> DicomReading {
    read_dicom(paths, &Limits::default(), &Progress::default()).unwrap()
}

/// The one series of a place.
fn one(place: &str) -> ImageSeries {
    let mut reading = read(place);
    assert_eq!(reading.series.len(), 1, "{place}: {:?}", reading.left_out);
    reading.series.remove(0)
}

fn values(series: &ImageSeries) -> Vec<f32> {
    series.image.volumes().concat()
}

/// All that is said of a place.
fn said(reading: &DicomReading) -> String {
    let notices = reading.series.iter().flat_map(|series| &series.notices);
    let notices = notices.map(|notice| notice.text.clone());
    let left = reading.left_out.iter().map(|out| out.reason.to_string());
    notices.chain(left).collect::<Vec<_>>().join("\n")
}

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn every_file_reads_to_the_values_of_its_description() {
    for row in READ {
        let series = one(row.place);
        let Row { place, .. } = row;
        let frame = series.image.frame();
        let [i, j, k] = frame.size();
        assert_eq!([i, j, k, series.image.volumes().len()], row.size, "{place}");
        for (own, expected) in frame.spacing().iter().zip(row.spacing) {
            assert!(
                (own - expected).abs() <= 1e-5 * expected.max(1.0),
                "{place}: {:?}",
                frame.spacing()
            );
        }
        // Numbers before they were rescaled.
        let stored = values(&series);
        let stored = stored
            .iter()
            .map(|&v| (f64::from(v) - row.intercept) / row.slope);
        let (mut low, mut high, mut sum) = (f64::INFINITY, f64::NEG_INFINITY, 0.0);
        for value in stored {
            assert!(!value.is_nan(), "{place}");
            (low, high, sum) = (low.min(value), high.max(value), sum + value);
        }
        let near = |own: f64, expected: f64, share: f64| {
            assert!(
                (own - expected).abs() <= share * expected.abs().max(1.0),
                "{place}: {own} is not {expected}"
            );
        };
        // A sum of 32-bit values that were rescaled by a thousandth loses some digits.
        let digits = if row.slope < 0.01 { 1e-4 } else { 6e-6 };
        near(low, row.low, digits * 100.0);
        near(high, row.high, digits);
        near(sum, row.sum, digits);
    }
}

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn every_volume_stands_where_its_description_says() {
    for (place, origin, step) in PLACED {
        let series = one(place);
        let frame = series.image.frame();
        assert!(series.position_known, "{place}");
        let own = frame.origin();
        assert!(
            (0..3).all(|n| (own[n] - origin[n]).abs() < 1e-3),
            "{place}: {own}"
        );
        let own = frame.steps()[2];
        assert!(
            (0..3).all(|n| (own[n] - step[n]).abs() < 1e-3),
            "{place}: {own}"
        );
    }
}

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn what_is_no_image_of_a_place_is_refused_with_the_reason() {
    for (place, reason) in REFUSED {
        let reading = read(place);
        assert!(reading.series.is_empty(), "{place}");
        assert!(
            said(&reading).contains(reason),
            "{place}: {}",
            said(&reading)
        );
    }
}

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn no_file_is_forgotten_by_the_tables() {
    let others = ["md", "nrrd", "txt", "gz"];
    let folders = [
        "gated_spect_dicom",
        "bivme_cine",
        "acdc_cine_dicom",
        "dicom_encodings",
        "dicom_series_quirks",
        "seg_rtstruct",
        "sunnybrook_scd",
    ];
    let root = shared_data("images");
    let mut files = Vec::new();
    folders
        .iter()
        .for_each(|folder| list(&root.join(folder), &mut files));
    let read = READ.iter().map(|row| row.place);
    let refused = REFUSED.iter().map(|(place, _)| *place);
    // These folders have tests of their own.
    let own = [
        "acdc_cine_dicom/study",
        "bivme_cine/",
        "dicom_encodings/dicomdirtests",
        "dicom_series_quirks/mixed_orientation",
        "seg_rtstruct/pydicom/rtstruct.dcm",
    ];
    let places: Vec<&str> = read.chain(refused).chain(own).collect();
    for file in files {
        let ending = file.extension().and_then(|ending| ending.to_str());
        if ending.is_some_and(|ending| others.contains(&ending)) {
            continue;
        }
        let relative = file.strip_prefix(&root).unwrap().to_str().unwrap();
        assert!(
            places.iter().any(|place| relative.starts_with(place)),
            "{relative}"
        );
    }
}

fn list(folder: &Path, files: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        match path.is_dir() {
            true => list(&path, files),
            false => files.push(path),
        }
    }
}

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn one_image_in_all_its_encodings_is_one_image() {
    let families: [&[&str]; 4] = [
        &[
            "gated_spect_dicom/p2/gated_rle.dcm",
            "gated_spect_dicom/p2/gated_timefast.dcm",
            "gated_spect_dicom/p2/gated_nogeom.dcm",
        ],
        &[
            "dicom_encodings/MR_small.dcm",
            "dicom_encodings/MR_small_RLE.dcm",
            "dicom_encodings/MR_small_bigendian.dcm",
            "dicom_encodings/MR_small_expb.dcm",
            "dicom_encodings/MR_small_implicit.dcm",
            "dicom_encodings/MR_small_jp2klossless.dcm",
            "dicom_encodings/MR_small_jpeg_ls_lossless.dcm",
        ],
        &[
            "dicom_encodings/emri_small.dcm",
            "dicom_encodings/emri_small_RLE.dcm",
            "dicom_encodings/emri_small_jpeg_2k_lossless.dcm",
            "dicom_encodings/emri_small_jpeg_ls_lossless.dcm",
        ],
        &[
            "dicom_series_quirks/mr_j2k",
            "dicom_series_quirks/mr_jpeg",
            "dicom_series_quirks/mr_rle",
            "dicom_series_quirks/mr_jpegls",
        ],
    ];
    for family in families {
        let first = values(&one(family[0]));
        for place in &family[1..] {
            assert_eq!(values(&one(place)), first, "{place}");
        }
    }
}

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn gates_have_their_times_and_a_mixed_folder_is_two_series() {
    let reading = read("gated_spect_dicom/p1");
    assert_eq!(reading.series.len(), 2);
    let gated = reading
        .series
        .iter()
        .find(|series| series.image.volumes().len() == 8)
        .unwrap();
    assert_eq!(gated.gates.as_ref().unwrap().cycle_ms, Some(857.0));
    assert_eq!(gated.image.times_ms().unwrap()[7], 7.0 * 107.125);
    let missing = one("gated_spect_dicom/p2/gated_nogeom.dcm");
    assert!(!missing.position_known && missing.spacing_known());
    assert!(
        missing
            .notices
            .iter()
            .any(|n| n.text.contains("neither position nor orientation"))
    );
}

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn a_shuffled_cine_folder_is_one_stack_of_its_phases() {
    let reading = read("acdc_cine_dicom/study");
    assert_eq!(reading.series.len(), 1, "{:?}", reading.left_out);
    let image = &reading.series[0].image;
    assert_eq!(image.frame().size(), [88, 88, 7]);
    let phases = [
        40.953, 41.218, 41.438, 41.406, 41.192, 40.591, 39.784, 39.419, 39.454, 39.899, 40.584,
        41.154,
    ];
    let mean = |values: &[f32]| {
        values.iter().map(|&v| f64::from(v) / 1.75).sum::<f64>() / values.len() as f64
    };
    assert_eq!(image.volumes().len(), phases.len());
    for (volume, expected) in image.volumes().iter().zip(phases) {
        assert!((mean(volume) - expected).abs() < 6e-4);
    }
    let slices = [47.288, 44.374, 41.106, 38.063, 37.343, 38.054, 37.906];
    for (k, expected) in slices.iter().enumerate() {
        let of_slice = |volume: &Arc<[f32]>| mean(&volume[k * 88 * 88..(k + 1) * 88 * 88]);
        let own = image.volumes().iter().map(of_slice).sum::<f64>() / 12.0;
        assert!((own - expected).abs() < 6e-4, "slice {k}: {own}");
    }
    let said = said(&reading);
    for words in [
        "copies of images",
        "a localizer",
        "a picture in colours",
        "matched by their rank",
    ] {
        assert!(said.contains(words), "{said}");
    }
}

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn a_cine_of_one_series_a_slice_is_one_stack() {
    let table = [
        ("Se11", 3.8507, 34.520, 828.480),
        ("Se1", -13.8493, 34.400, 825.600),
        ("Se2", -31.5493, 33.160, 795.840),
        ("Se3", -49.2493, 31.040, 744.960),
        ("Se4", -66.9493, 32.560, 781.440),
        ("Se5", -84.6493, 33.240, 797.760),
    ];
    for (name, along, step, last) in table {
        let series = one(&format!("bivme_cine/sax_full/{name}.zip"));
        let frame = series.image.frame();
        let normal = frame.directions()[0].cross(&frame.directions()[1]);
        assert!(
            (frame.origin().coords.dot(&normal) - along).abs() < 2e-3,
            "{name}"
        );
        let times = series.image.times_ms().unwrap();
        assert_eq!(times.len(), 25);
        assert!(
            (times[1] - step).abs() < 2e-3 && (times[24] - last).abs() < 2e-3,
            "{name}"
        );
    }
    let begun = Instant::now();
    let stack = one("bivme_cine/sax_full");
    println!("150 files in {:?}", begun.elapsed());
    let frame = stack.image.frame();
    assert_eq!(frame.size(), [256, 208, 6]);
    assert_eq!(stack.image.volumes().len(), 25);
    assert!((frame.spacing()[2] - 17.7).abs() < 1e-3);
    let first = frame.position(cardiomorph::mesh::Point3::new(0.0, 0.0, 5.0));
    assert!((first - cardiomorph::mesh::Point3::new(-202.214, -79.6032, -70.5046)).norm() < 1e-2);
}

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn two_directions_in_a_series_are_two_series_and_lists_of_files_are_passed_over() {
    let reading = read("dicom_series_quirks/mixed_orientation");
    assert_eq!(reading.series.len(), 2);
    assert!(said(&reading).contains("2 sorts of slices"));
    let sums: Vec<f64> = (reading.series.iter())
        .map(|series| values(series).iter().map(|&v| f64::from(v)).sum())
        .collect();
    assert!(
        (sums[0] - (1.05243e7 + 1.04964e7)).abs() < 100.0,
        "{sums:?}"
    );
    assert!(
        (sums[1] - (1.05256e7 + 1.05272e7)).abs() < 100.0,
        "{sums:?}"
    );
    assert!(said(&read("dicom_encodings/dicomdirtests")).contains("DICOMDIR"));
}

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn contours_of_radiotherapy_are_polygons_in_the_patient() {
    let reading = read("seg_rtstruct/pydicom/rtstruct.dcm");
    assert_eq!(reading.contours.len(), 1);
    let structure = &reading.contours[0];
    assert_eq!((structure.number, structure.part), (1, None));
    let points: Vec<usize> = structure.polygons.iter().map(Vec::len).collect();
    assert_eq!(points, [4, 5, 5]);
    assert_eq!(
        structure.polygons[0][0].coords.as_slice(),
        [-200.0, 150.0, -200.0]
    );
}

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn two_of_twenty_phases_are_read_with_a_warning_and_each_image_is_found_again() {
    let reading = read("sunnybrook_scd");
    assert_eq!(
        reading.series[0].image.times_ms(),
        Some(&[286.0, 886.0][..])
    );
    assert_eq!(
        reading.series[0].gates.as_ref().unwrap().cycle_ms,
        Some(923.0)
    );
    assert!(said(&reading).contains("20 instants of the beat were taken, but only 2 are here"));
    assert_eq!(reading.sources.len(), 20);
    // The first file by its name is `100.dcm`: slice 5 of 10 from the top, phase 20.
    let source = reading
        .sources
        .iter()
        .find(|source| source.file == 0)
        .unwrap();
    assert_eq!((source.slice, source.instant), (5, 1));
}
