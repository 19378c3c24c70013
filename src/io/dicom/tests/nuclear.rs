//! Tomograms of a gamma camera.

use super::writer::{Made, NM, image, read, said};
use crate::io::dicom::reading::DicomReading;
use crate::io::dicom::tag::*;
use crate::io::image_file::Provenance;

/// Where frame n belongs: its gate and slice, from 1.
type Order = fn(usize) -> (u16, u16);

/// Three slices of two gates. The first number of a frame is 100 · gate + 10 · slice.
fn study(order: Order) -> Made {
    let places: Vec<(u16, u16)> = (0..6).map(order).collect();
    let pixels: Vec<u16> = (places.iter())
        .flat_map(|&(gate, slice)| (0..6).map(move |n| 100 * gate + 10 * slice + n))
        .collect();
    let gates: Vec<u16> = places.iter().map(|place| place.0).collect();
    let slices: Vec<u16> = places.iter().map(|place| place.1).collect();
    let detector = Made::default()
        .decimals(POSITION, &[1.0, 2.0, 3.0])
        .decimals(ORIENTATION, &[1.0, 0.0, 0.0, 0.0, 0.6, 0.8]);
    let beat = Made::default()
        .decimals(NOMINAL_INTERVAL, &[800.0])
        .decimals(FRAME_TIME, &[400.0]);
    image(0.0, 0)
        .without(POSITION)
        .without(ORIENTATION)
        .text(SOP_CLASS, "UI", NM)
        .text(MODALITY, "CS", "NM")
        .text(
            IMAGE_TYPE,
            "CS",
            "ORIGINAL\\PRIMARY\\RECON GATED TOMO\\EMISSION",
        )
        .text(NUMBER_OF_FRAMES, "IS", "6")
        .decimals(SPACING_BETWEEN_SLICES, &[-6.4])
        .items(DETECTOR_INFORMATION, vec![detector])
        .items(
            GATED_INFORMATION,
            vec![Made::default().items(DATA_INFORMATION, vec![beat])],
        )
        .shorts(RR_INTERVAL_VECTOR, &[1; 6])
        .shorts(TIME_SLOT_VECTOR, &gates)
        .shorts(NUMBER_OF_TIME_SLOTS, &[2])
        .shorts(SLICE_VECTOR, &slices)
        .shorts(NUMBER_OF_SLICES, &[3])
        .words(&pixels)
}

fn gates_slow(frame: usize) -> (u16, u16) {
    (frame as u16 / 3 + 1, frame as u16 % 3 + 1)
}

fn gates_fast(frame: usize) -> (u16, u16) {
    (frame as u16 % 2 + 1, frame as u16 / 2 + 1)
}

fn slices_down(frame: usize) -> (u16, u16) {
    (frame as u16 / 3 + 1, 3 - frame as u16 % 3)
}

fn firsts(reading: &DicomReading) -> Vec<Vec<f32>> {
    let volumes = reading.series[0].image.volumes().iter();
    volumes
        .map(|volume| volume.iter().step_by(6).copied().collect())
        .collect()
}

/// <https://github.com/rordenlab/dcm2niix/issues/885>, <https://github.com/ClearCanvas/ClearCanvas/issues/209>,
/// <https://github.com/OHIF/Viewers/issues/5554>
#[test]
fn slices_go_to_the_side_that_the_sign_of_their_distance_says_from_where_the_detector_says() {
    let reading = read(&study(gates_slow).file());
    let series = &reading.series[0];
    let frame = series.image.frame();
    assert_eq!(frame.size(), [3, 2, 3]);
    assert_eq!(frame.origin().coords.as_slice(), [1.0, 2.0, 3.0]);
    let step = frame.steps()[2];
    // row × column = (0, −0.8, 0.6), and the distance is negative.
    assert!((step - crate::mesh::Vector3::new(0.0, 5.12, -3.84)).norm() < 1e-12);
    assert!(series.position_known);
    assert_eq!(series.image.times_ms(), Some(&[0.0, 400.0][..]));
    let gates = series.gates.as_ref().unwrap();
    assert_eq!(
        (gates.numbers.clone(), gates.cycle_ms),
        (vec![1, 2], Some(800.0))
    );
}

#[test]
fn vectors_decide_whatever_runs_fastest_or_down() {
    let expected = [vec![110.0, 120.0, 130.0], vec![210.0, 220.0, 230.0]];
    for order in [gates_slow as Order, gates_fast, slices_down] {
        assert_eq!(firsts(&read(&study(order).file())), expected);
    }
}

#[test]
fn without_vectors_the_named_order_counts_and_without_that_nothing_is_guessed() {
    let pointer = |tags: &[Tag]| {
        tags.iter()
            .flat_map(|tag| [tag.0.to_le_bytes(), tag.1.to_le_bytes()].concat())
            .collect()
    };
    let without = study(gates_fast)
        .without(TIME_SLOT_VECTOR)
        .without(SLICE_VECTOR);
    let named = [RR_INTERVAL_VECTOR, SLICE_VECTOR, TIME_SLOT_VECTOR];
    let told = without
        .clone()
        .bytes(FRAME_INCREMENT_POINTER, "AT", pointer(&named));
    let expected = [vec![110.0, 120.0, 130.0], vec![210.0, 220.0, 230.0]];
    assert_eq!(firsts(&read(&told.file())), expected);
    let reading = read(&without.file());
    assert!(reading.series.is_empty());
    assert!(
        said(&reading).contains("Vector: it is missing"),
        "{}",
        said(&reading)
    );
}

/// <https://github.com/FNNDSC/ami/issues/293>: a distance is a decimal, and a missing position stays missing.
#[test]
fn a_missing_place_stays_missing() {
    for made in [
        study(gates_slow).without(DETECTOR_INFORMATION),
        study(gates_slow).items(DETECTOR_INFORMATION, vec![]),
        study(gates_slow).items(
            DETECTOR_INFORMATION,
            vec![Made::default().text(POSITION, "DS", "")],
        ),
    ] {
        let reading = read(&made.file());
        let series = &reading.series[0];
        assert!(!series.position_known);
        assert!(said(&reading).contains("neither position nor orientation"));
        assert_eq!(series.image.frame().steps()[2].z, -6.4);
        assert_eq!(series.spacing, Provenance::Stated);
    }
}

#[test]
fn thickness_stands_for_a_missing_distance_with_a_warning() {
    let reading = read(&study(gates_slow).without(SPACING_BETWEEN_SLICES).file());
    assert_eq!(reading.series[0].image.frame().spacing()[2], 5.0);
    assert!(said(&reading).contains("their thickness of 5 mm stands for it"));
    let neither = study(gates_slow)
        .without(SPACING_BETWEEN_SLICES)
        .without(SLICE_THICKNESS);
    let reading = read(&neither.file());
    assert!(!reading.series[0].spacing_known());
}

#[test]
fn projections_and_planar_pictures_are_refused_by_their_kind() {
    for (kind, words) in [
        (
            "GATED TOMO",
            "projections, not a reconstructed volume (its kind is GATED TOMO)",
        ),
        ("TOMO", "projections"),
        ("WHOLE BODY", "planar"),
        ("STATIC", "planar"),
        ("DYNAMIC", "planar"),
    ] {
        let made = study(gates_slow).text(IMAGE_TYPE, "CS", format!("ORIGINAL\\PRIMARY\\{kind}"));
        let reading = read(&made.file());
        assert!(reading.series.is_empty());
        assert!(said(&reading).contains(words), "{}", said(&reading));
    }
}

#[test]
fn of_several_intervals_between_r_waves_one_is_taken_and_never_mixed() {
    let made = study(gates_slow)
        .shorts(TIME_SLOT_VECTOR, &[1; 6])
        .shorts(RR_INTERVAL_VECTOR, &[1, 1, 1, 2, 2, 2]);
    let reading = read(&made.file());
    assert_eq!(firsts(&reading), [vec![110.0, 120.0, 130.0]]);
    assert!(
        said(&reading).contains("2 intervals between R waves; the volumes are those of the first")
    );
}

#[test]
fn slices_may_be_counted_from_any_number_but_without_gaps() {
    let from_zero = study(gates_slow).shorts(SLICE_VECTOR, &[0, 1, 2, 0, 1, 2]);
    assert_eq!(firsts(&read(&from_zero.file()))[0], [110.0, 120.0, 130.0]);
    let gap = study(gates_slow).shorts(SLICE_VECTOR, &[1, 2, 4, 1, 2, 4]);
    assert!(said(&read(&gap.file())).contains("have gaps"));
}

#[test]
fn missing_and_doubled_frames_are_named() {
    let doubled = study(|frame| {
        if frame == 5 {
            (2, 2)
        } else {
            gates_slow(frame)
        }
    });
    assert!(said(&read(&doubled.file())).contains("slice 2 of gate 2 comes twice"));
    let missing = study(|frame| {
        if frame == 5 {
            (3, 3)
        } else {
            gates_slow(frame)
        }
    });
    assert!(said(&read(&missing.file())).contains("slice 3 of gate 2 is missing"));
    let short = study(gates_slow).shorts(SLICE_VECTOR, &[1, 2, 3]);
    assert!(said(&read(&short.file())).contains("SliceVector: 3 numbers for 6 frames"));
}

#[test]
fn times_come_from_slots_or_the_beat_where_no_frame_time_is_said() {
    let beat = |made: Made| {
        let gated = Made::default().items(DATA_INFORMATION, vec![made]);
        let reading = read(
            &study(gates_slow)
                .items(GATED_INFORMATION, vec![gated])
                .file(),
        );
        let series = &reading.series[0];
        (series.image.times_ms().map(<[f64]>::to_vec), series.times)
    };
    let slots = [300.0, 500.0].map(|ms| Made::default().decimals(TIME_SLOT_TIME, &[ms]));
    let slots = Made::default().items(TIME_SLOT_INFORMATION, slots.to_vec());
    assert_eq!(beat(slots), (Some(vec![0.0, 300.0]), Provenance::Stated));
    let cycle = Made::default().decimals(NOMINAL_INTERVAL, &[900.0]);
    assert_eq!(beat(cycle), (Some(vec![0.0, 450.0]), Provenance::Stated));
    assert_eq!(beat(Made::default()), (None, Provenance::Missing));
}

#[test]
fn signed_counts_and_an_orientation_that_may_be_made_up_are_told() {
    let detector = Made::default()
        .decimals(POSITION, &[1.0, 2.0, 3.0])
        .decimals(ORIENTATION, &[1.0, 0.0, 0.0, 0.0, 1.0, 0.0]);
    let made = study(gates_slow)
        .shorts(PIXEL_REPRESENTATION, &[1])
        .items(DETECTOR_INFORMATION, vec![detector]);
    let reading = read(&made.file());
    assert_eq!(firsts(&reading)[0][0], 110.0);
    assert!(said(&reading).contains("some programs write it also for slices of other directions"));
}
