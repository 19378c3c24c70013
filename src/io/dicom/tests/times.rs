//! Which images of a place belong to which instant.

use super::writer::{Made, image, read_all, said};
use crate::io::dicom::reading::DicomReading;
use crate::io::dicom::tag::*;
use crate::io::image_file::Provenance;

/// The first number of each slice of each volume.
fn firsts(reading: &DicomReading) -> Vec<Vec<f32>> {
    let volumes = reading.series[0].image.volumes().iter();
    volumes
        .map(|volume| volume.iter().step_by(6).copied().collect())
        .collect()
}

/// Two slices of three instants, in an order that no name or number follows. Numbers are 100 · instant + z.
fn film(change: impl Fn(Made, usize, f64) -> Made) -> Vec<Made> {
    let order = [
        (2, 0.0),
        (0, 10.0),
        (1, 0.0),
        (2, 10.0),
        (0, 0.0),
        (1, 10.0),
    ];
    let made = |(n, (instant, z)): (usize, (usize, f64))| {
        let made = image(z, 100 * instant as u16 + z as u16);
        let made = made.decimals(INSTANCE_NUMBER, &[(n * 7 % 6) as f64]);
        change(made, instant, z)
    };
    order.into_iter().enumerate().map(made).collect()
}

const EXPECTED: [[f32; 2]; 3] = [[0.0, 10.0], [100.0, 110.0], [200.0, 210.0]];

/// <https://github.com/rordenlab/dcm2niix/issues/689>, <https://github.com/SimpleITK/SimpleITK/issues/879>,
/// <https://github.com/ivmartel/dwv/issues/1490>, <https://github.com/fedorov/MultiVolumeImporter/issues/49>
#[test]
fn repeated_positions_are_instants_ordered_by_time_within_each_slice() {
    let reading = read_all(&film(|made, instant, z| {
        let step = 40.0 + z;
        made.decimals(TRIGGER_TIME, &[instant as f64 * step])
    }));
    assert_eq!(firsts(&reading), EXPECTED);
    let series = &reading.series[0];
    assert_eq!(series.image.times_ms(), Some(&[0.0, 45.0, 90.0][..]));
    assert_eq!(series.times, Provenance::Stated);
    assert_eq!(series.gates.as_ref().unwrap().numbers, [1, 2, 3]);
    assert!(said(&reading).contains("differ by up to 20 ms"));
}

/// <https://github.com/rordenlab/dcm2niix/issues/395>, 408 and 428
#[test]
fn trigger_times_count_only_where_positions_repeat_and_within_a_beat() {
    let slices = [0.0, 10.0, 20.0].map(|z| image(z, 0).decimals(TRIGGER_TIME, &[z * 7.0]));
    let reading = read_all(&slices);
    assert_eq!(reading.series.len(), 1);
    assert_eq!(reading.series[0].image.volumes().len(), 1);
    assert_eq!(reading.series[0].image.times_ms(), None);
    // 20 s after an R wave is no time in a beat: its order (here wrong) is not used, that of the index is.
    let reading = read_all(&film(|made, instant, z| {
        made.decimals(TRIGGER_TIME, &[20_000.0 - instant as f64 * 2000.0 + z])
            .decimals(TEMPORAL_POSITION, &[instant as f64])
    }));
    assert_eq!(firsts(&reading), EXPECTED);
    assert_eq!(reading.series[0].image.times_ms(), None);
    assert_eq!(reading.series[0].times, Provenance::Missing);
}

/// <https://github.com/fedorov/MultiVolumeImporter/issues/29> and 19
#[test]
fn instants_come_from_percents_indices_clocks_or_numbers_where_they_must() {
    let percent = read_all(&film(|made, instant, _| {
        made.double(CARDIAC_PERCENT, 30.0 * instant as f64)
            .decimals(NOMINAL_INTERVAL, &[1000.0])
    }));
    assert_eq!(firsts(&percent), EXPECTED);
    assert_eq!(
        percent.series[0].image.times_ms(),
        Some(&[0.0, 300.0, 600.0][..])
    );
    let clock = read_all(&film(|made, instant, _| {
        made.text(CONTENT_TIME, "TM", format!("10595{}.25", 7 + instant))
    }));
    assert_eq!(firsts(&clock), EXPECTED);
    assert!(said(&clock).contains("ordered by ContentTime"));
    let number = read_all(&film(|made, instant, z| {
        made.decimals(INSTANCE_NUMBER, &[instant as f64 * 2.0 + z / 10.0])
    }));
    assert_eq!(firsts(&number), EXPECTED);
    assert!(said(&number).contains("ordered by InstanceNumber"));
}

#[test]
fn images_that_nothing_tells_apart_are_refused() {
    let reading = read_all(&film(|made, _, _| made.decimals(INSTANCE_NUMBER, &[1.0])));
    assert!(
        said(&reading).contains("nothing tells their instants apart"),
        "{}",
        said(&reading)
    );
}

/// <https://github.com/Project-MONAI/monai-deploy-app-sdk/issues/532>
#[test]
fn acquisitions_of_the_same_slices_stand_for_themselves() {
    let reading = read_all(&film(|made, instant, _| {
        made.decimals(ACQUISITION_NUMBER, &[instant as f64])
    }));
    assert_eq!(reading.series.len(), 3);
    assert!(said(&reading).contains("3 acquisitions of the same slices"));
    for (series, expected) in reading.series.iter().zip(EXPECTED) {
        assert_eq!(series.image.frame().size(), [3, 2, 2]);
        assert!(
            EXPECTED
                .iter()
                .flatten()
                .any(|n| *n == series.image.volumes()[0][0]),
            "{expected:?}"
        );
    }
    // Where times in the beat are said, they are instants whatever the number.
    let reading = read_all(&film(|made, instant, _| {
        made.decimals(ACQUISITION_NUMBER, &[instant as f64])
            .decimals(TRIGGER_TIME, &[instant as f64 * 40.0])
    }));
    assert_eq!(firsts(&reading), EXPECTED);
}

/// <https://github.com/rordenlab/dcm2niix/issues/830>
#[test]
fn an_incomplete_instant_is_dropped_and_named_or_the_series_refused() {
    let with = |step: fn(f64) -> f64, lacks: usize| {
        let mut files = Vec::new();
        for z in [0.0, 10.0, 20.0] {
            for instant in (0..5).filter(|&instant| z != 10.0 || instant != lacks) {
                let made = image(z, 100 * instant as u16 + z as u16);
                files.push(made.decimals(TRIGGER_TIME, &[instant as f64 * step(z)]));
            }
        }
        read_all(&files)
    };
    // All slices count by the same times: the lacking one shows.
    let even = with(|_| 40.0, 1);
    assert_eq!(even.series[0].image.volumes().len(), 4);
    assert!(
        said(&even).contains("instant 2 is left out"),
        "{}",
        said(&even)
    );
    assert_eq!(firsts(&even)[1], [200.0, 210.0, 220.0]);
    // Each has its own: only the last can be told to lack.
    let last = with(|z| 40.0 + z / 10.0, 4);
    assert_eq!(last.series[0].image.volumes().len(), 4);
    assert!(
        said(&last).contains("instant 5 is left out"),
        "{}",
        said(&last)
    );
    for lacks in [0, 2] {
        let refused = with(|z| 40.0 + z / 10.0, lacks);
        assert!(refused.series.is_empty());
        assert!(
            said(&refused).contains("slice 2 has 4 of 5 instants"),
            "{}",
            said(&refused)
        );
    }
}

#[test]
fn slices_that_are_empty_at_all_instants_are_no_copies() {
    let reading = read_all(&film(|made, instant, z| {
        let made = made.decimals(INSTANCE_NUMBER, &[instant as f64]);
        if z == 0.0 { made.words(&[0; 6]) } else { made }
    }));
    assert_eq!(reading.series[0].image.volumes().len(), 3);
}
