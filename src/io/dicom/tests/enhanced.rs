//! Files of many frames, and segmentations.

use super::writer::{Made, image, read, said};
use crate::io::dicom::reading::DicomReading;
use crate::io::dicom::tag::*;
use crate::io::dicom::{is_segmentation_head, segment_parts};
use crate::io::limits::Limits;

fn firsts(reading: &DicomReading) -> Vec<Vec<f32>> {
    let volumes = reading.series[0].image.volumes().iter();
    volumes
        .map(|volume| volume.iter().step_by(6).copied().collect())
        .collect()
}

fn group(tag: Tag, made: Made) -> Made {
    Made::default().items(tag, vec![made])
}

fn orientation() -> Made {
    Made::default().decimals(ORIENTATION, &[0.0, 1.0, 0.0, 0.0, 0.0, -1.0])
}

/// Frames at two places and two instants, slices fastest. Numbers are 100 · frame.
fn four_frames(index: impl Fn(usize) -> Made) -> Made {
    let frames = (0..4).map(|frame| {
        let x = -8.0 * (frame % 2) as f64;
        group(
            PLANE_POSITION,
            Made::default().decimals(POSITION, &[x, 1.0, 2.0]),
        )
        .items(FRAME_CONTENT, vec![index(frame)])
    });
    let pixels: Vec<u16> = (0..24).map(|n| 100 * (n / 6) + n % 6).collect();
    let measures = Made::default().decimals(PIXEL_SPACING, &[2.0, 1.5]);
    let shared = group(PIXEL_MEASURES, measures).items(PLANE_ORIENTATION, vec![orientation()]);
    image(0.0, 0)
        .without(POSITION)
        .without(ORIENTATION)
        .without(PIXEL_SPACING)
        .text(NUMBER_OF_FRAMES, "IS", "4")
        .items(SHARED_GROUPS, vec![shared])
        .items(PER_FRAME_GROUPS, frames.collect())
        .words(&pixels)
}

/// <https://github.com/rordenlab/dcm2niix/issues/372>
#[test]
fn what_all_frames_share_is_looked_up_there() {
    let made = four_frames(|frame| {
        Made::default().longs(TEMPORAL_POSITION_INDEX, &[1 + frame as u32 / 2])
    });
    let reading = read(&made.file());
    let frame = *reading.series[0].image.frame();
    assert_eq!(frame.size(), [3, 2, 2]);
    assert_eq!(frame.spacing(), [1.5, 2.0, 8.0]);
    assert_eq!(frame.steps()[0].y, 1.5);
    assert_eq!(firsts(&reading), [[0.0, 100.0], [200.0, 300.0]]);
}

/// <https://github.com/rordenlab/dcm2niix/issues/809>: the index of time is the one whose tag is named, and one that
/// contradicts positions is not used.
#[test]
fn dimensions_go_by_the_tags_that_are_named() {
    let pointer = |tag: Tag| {
        let bytes = [tag.0.to_le_bytes(), tag.1.to_le_bytes()].concat();
        Made::default().bytes(DIMENSION_POINTER, "AT", bytes)
    };
    let index = |frame: usize| {
        let values = [2 - frame as u32 / 2, 1 + frame as u32 % 2];
        Made::default().longs(DIMENSION_INDEX_VALUES, &values)
    };
    let named = |first: Tag, second: Tag| {
        four_frames(index).items(
            DIMENSION_INDEX_SEQUENCE,
            vec![pointer(first), pointer(second)],
        )
    };
    let reading = read(&named(TEMPORAL_POSITION_INDEX, POSITION).file());
    assert_eq!(firsts(&reading), [[200.0, 300.0], [0.0, 100.0]]);
    let reading = read(&named(POSITION, TEMPORAL_POSITION_INDEX).file());
    assert_eq!(firsts(&reading), [[0.0, 100.0], [200.0, 300.0]]);
    assert!(
        said(&reading).contains("ordered by InstanceNumber"),
        "{}",
        said(&reading)
    );
}

#[test]
fn each_frame_has_its_own_factor_and_time_in_the_beat() {
    let made =
        four_frames(|frame| Made::default().longs(TEMPORAL_POSITION_INDEX, &[frame as u32 / 2]));
    let frames = (0..4).map(|frame| {
        let x = -8.0 * (frame % 2) as f64;
        let value = Made::default()
            .decimals(SLOPE, &[1.0 + frame as f64])
            .decimals(INTERCEPT, &[0.5]);
        let beat = Made::default()
            .double(CARDIAC_DELAY, 50.0 * (frame / 2) as f64)
            .double(RR_INTERVAL_NOMINAL, 800.0);
        group(
            PLANE_POSITION,
            Made::default().decimals(POSITION, &[x, 1.0, 2.0]),
        )
        .items(VALUE_TRANSFORMATION, vec![value])
        .items(CARDIAC_SYNCHRONIZATION, vec![beat])
    });
    let reading = read(&made.items(PER_FRAME_GROUPS, frames.collect()).file());
    assert_eq!(firsts(&reading), [[0.5, 200.5], [600.5, 1200.5]]);
    let series = &reading.series[0];
    assert_eq!(series.image.times_ms(), Some(&[0.0, 50.0][..]));
    assert_eq!(series.gates.as_ref().unwrap().cycle_ms, Some(800.0));
}

#[test]
fn frames_without_places_are_a_film_or_slices_whose_distance_is_asked_for() {
    let pixels: Vec<u16> = (0..12).collect();
    let two = image(0.0, 0)
        .text(NUMBER_OF_FRAMES, "IS", "2")
        .words(&pixels);
    let film = read(&two.clone().decimals(FRAME_TIME, &[33.0]).file());
    assert_eq!(film.series[0].image.volumes().len(), 2);
    assert_eq!(film.series[0].image.times_ms(), Some(&[0.0, 33.0][..]));
    assert!(film.series[0].position_known);
    assert_eq!(film.series[0].image.frame().origin().x, -10.0);
    let slices = read(&two.file());
    assert_eq!(slices.series[0].image.frame().size(), [3, 2, 2]);
    assert!(!slices.series[0].spacing_known() && !slices.series[0].position_known);
}

/// A segmentation of 3 × 3 pixels: frames are (segment, height, bits).
fn segmentation(frames: &[(u16, f64, [u8; 9])]) -> Made {
    let mut stream = vec![0_u8; (frames.len() * 9).div_ceil(8)];
    let bits = frames.iter().flat_map(|frame| frame.2);
    for (n, bit) in bits.enumerate() {
        stream[n / 8] |= bit << (n % 8);
    }
    let groups = frames.iter().map(|&(segment, z, _)| {
        group(
            PLANE_POSITION,
            Made::default().decimals(POSITION, &[0.0, 0.0, z]),
        )
        .items(
            SEGMENT_IDENTIFICATION,
            vec![Made::default().shorts(REFERENCED_SEGMENT, &[segment])],
        )
    });
    let measures = Made::default()
        .decimals(PIXEL_SPACING, &[1.0, 1.0])
        .decimals(SPACING_BETWEEN_SLICES, &[4.0]);
    let straight = Made::default().decimals(ORIENTATION, &[1.0, 0.0, 0.0, 0.0, 1.0, 0.0]);
    let shared = group(PIXEL_MEASURES, measures).items(PLANE_ORIENTATION, vec![straight]);
    image(0.0, 0)
        .without(POSITION)
        .without(ORIENTATION)
        .text(MODALITY, "CS", "SEG")
        .text(SOP_CLASS, "UI", "1.2.840.10008.5.1.4.1.1.66.4")
        .text(SEGMENTATION_TYPE, "CS", "BINARY")
        .text(NUMBER_OF_FRAMES, "IS", frames.len().to_string())
        .shorts(ROWS, &[3])
        .shorts(COLUMNS, &[3])
        .shorts(BITS_ALLOCATED, &[1])
        .shorts(BITS_STORED, &[1])
        .shorts(HIGH_BIT, &[0])
        .items(SHARED_GROUPS, vec![shared])
        .items(PER_FRAME_GROUPS, groups.collect())
        .bytes(PIXEL_DATA, "OB", stream)
}

/// The file of a segmentation of two slices whose segments 4 and 2 are cavity and wall, by their names and codes.
pub(in crate::io) fn named_segmentation() -> Vec<u8> {
    let segment = |number: u16, label: &str, meaning: &str| {
        Made::default()
            .shorts(SEGMENT_NUMBER, &[number])
            .text(SEGMENT_LABEL, "LO", label)
            .items(
                SEGMENT_TYPE,
                vec![Made::default().text(CODE_MEANING, "LO", meaning)],
            )
    };
    let named = vec![
        segment(2, "Segment_2", "Myocardium"),
        segment(4, "LV cavity", "Structure"),
        segment(5, "SEEDED^NAME", "Thing"),
    ];
    segmentation(&[(2, 0.0, CORNER), (4, 0.0, MIDDLE), (2, 4.0, MIDDLE)])
        .items(SEGMENTS, named)
        .file()
}

#[test]
fn segments_are_known_by_words_of_anatomy() {
    let parts = segment_parts(named_segmentation(), &Limits::default()).unwrap();
    let expected = [
        (2, Some("myocardium")),
        (4, Some("left ventricle")),
        (5, None),
    ];
    assert_eq!(parts, expected);
    assert!(is_segmentation_head(&named_segmentation()));
    assert!(!is_segmentation_head(&image(0.0, 0).file()));
}

const CORNER: [u8; 9] = [1, 0, 0, 0, 0, 0, 0, 0, 1];
const MIDDLE: [u8; 9] = [0, 1, 1, 1, 1, 1, 1, 1, 0];

/// <https://github.com/QIICR/dcmqi/issues/341>, <https://github.com/pydicom/pydicom/issues/2134>
#[test]
fn bits_of_frames_follow_each_other_without_a_gap_and_empty_slices_are_filled_in() {
    let reading =
        read(&segmentation(&[(1, 0.0, CORNER), (2, 0.0, MIDDLE), (1, 8.0, MIDDLE)]).file());
    assert_eq!(reading.series.len(), 1, "{}", said(&reading));
    let image = &reading.series[0].image;
    assert_eq!(image.frame().size(), [3, 3, 3]);
    assert_eq!(image.frame().spacing()[2], 4.0);
    let labels: Vec<f32> = image.volumes()[0].to_vec();
    assert_eq!(labels[..9], [1.0, 2.0, 2.0, 2.0, 2.0, 2.0, 2.0, 2.0, 1.0]);
    assert_eq!(labels[9..18], [0.0; 9]);
    assert_eq!(labels[18..], MIDDLE.map(f32::from));
    assert!(said(&reading).contains("no label is in them: 1"));
}

#[test]
fn segments_that_overlap_are_volumes_of_their_own() {
    let reading = read(&segmentation(&[(1, 0.0, CORNER), (5, 0.0, [1; 9])]).file());
    assert_eq!(reading.series.len(), 2);
    assert_eq!(reading.series[1].image.volumes()[0].to_vec(), [1.0; 9]);
    assert!(reading.series[1].name.contains("segment 5"));
}

#[test]
fn contours_are_closed_polygons_in_the_patient() {
    let structure = |number: f64, name: &str| {
        Made::default()
            .decimals(STRUCTURE_NUMBER, &[number])
            .text(STRUCTURE_NAME, "LO", name)
    };
    let contour = |kind: &str, numbers: &[f64]| {
        let made = Made::default().text(CONTOUR_KIND, "CS", kind);
        made.decimals(CONTOUR_DATA, numbers)
    };
    let square = [0.0, 0.0, 5.0, 1.0, 0.0, 5.0, 1.0, 1.0, 5.0, 0.0, 0.0, 5.0];
    let contours = |number: f64, contours: Vec<Made>| {
        Made::default()
            .decimals(REFERENCED_STRUCTURE, &[number])
            .items(CONTOURS, contours)
    };
    let made = Made::default()
        .text(SOP_CLASS, "UI", "1.2.840.10008.5.1.4.1.1.481.3")
        .items(
            STRUCTURES,
            vec![structure(1.0, "SEEDED^NAME"), structure(4.0, "Heart_LV")],
        )
        .items(
            STRUCTURE_CONTOURS,
            vec![
                contours(1.0, vec![contour("POINT", &square[..3])]),
                contours(4.0, vec![contour("CLOSED_PLANAR", &square)]),
                contours(5.0, vec![contour("CLOSED_PLANAR", &square[..9])]),
            ],
        );
    let reading = read(&made.file());
    assert!(reading.left_out.is_empty(), "{}", said(&reading));
    let numbers: Vec<_> = reading
        .contours
        .iter()
        .map(|one| (one.number, one.part))
        .collect();
    assert_eq!(numbers, [(4, Some("heart")), (5, None)]);
    assert_eq!(reading.contours[0].polygons[0].len(), 3);
    assert_eq!(
        reading.contours[1].polygons[0][1].coords.as_slice(),
        [1.0, 0.0, 5.0]
    );
    let odd = made.items(
        STRUCTURE_CONTOURS,
        vec![contours(4.0, vec![contour("CLOSED_PLANAR", &square[..8])])],
    );
    assert!(said(&read(&odd.file())).contains("not three a point"));
}
