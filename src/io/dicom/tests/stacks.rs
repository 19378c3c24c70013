//! From single images to stacks.

use super::writer::{CT, Made, image, read_all, said};
use crate::io::dicom::reading::DicomReading;
use crate::io::dicom::tag::*;
use crate::mesh::Vector3;

fn sizes(reading: &DicomReading) -> Vec<[usize; 3]> {
    reading
        .series
        .iter()
        .map(|series| series.image.frame().size())
        .collect()
}

/// <https://github.com/rordenlab/dcm2niix/issues/555>, <https://github.com/QIICR/dcmqi/issues/89>,
/// <https://github.com/horosproject/horos/issues/386>: 5 mm thick, said to be 6 mm apart, and 10 mm apart.
#[test]
fn distances_come_from_positions_never_from_thickness() {
    let slices = [0.0, 10.0, 20.0].map(|z| image(z, 0).decimals(SPACING_BETWEEN_SLICES, &[6.0]));
    let reading = read_all(&slices);
    let frame = *reading.series[0].image.frame();
    assert_eq!(frame.spacing()[2], 10.0);
    assert_eq!(frame.voxel_mm3(), 30.0);
}

/// <https://github.com/imageio/imageio/issues/349>
#[test]
fn slices_are_ordered_by_position_not_by_number_or_name() {
    let slices = [(20.0, 30, 1.0), (0.0, 10, 3.0), (10.0, 20, 2.0)];
    let slices =
        slices.map(|(z, first, number)| image(z, first).decimals(INSTANCE_NUMBER, &[number]));
    let reading = read_all(&slices);
    let values = &reading.series[0].image.volumes()[0];
    assert_eq!([values[0], values[6], values[12]], [10.0, 20.0, 30.0]);
    assert_eq!(reading.series[0].image.frame().origin().z, 0.0);
}

/// <https://github.com/InsightSoftwareConsortium/ITK/issues/441>
#[test]
fn a_missing_slice_is_named() {
    let reading = read_all(&[0.0, 10.0, 20.0, 40.0, 50.0].map(|z| image(z, 0)));
    assert!(reading.series.is_empty());
    let said = said(&reading);
    assert!(
        said.contains("20.00 mm between slices 3 and 4 (at 20.00 and 40.00 mm"),
        "{said}"
    );
    assert!(said.contains("10.00 mm between the others"), "{said}");
}

/// <https://github.com/icometrix/dicom2nifti/issues/21>, <https://github.com/rordenlab/dcm2niix/issues/168>
#[test]
fn copies_are_dropped_by_place_and_numbers_only() {
    let slices = [
        image(0.0, 0),
        image(10.0, 50),
        image(20.0, 90),
        image(10.0, 50),
    ];
    let slices: Vec<Made> = (slices.into_iter().zip(1..))
        .map(|(slice, number)| slice.decimals(INSTANCE_NUMBER, &[f64::from(number)]))
        .collect();
    let reading = read_all(&slices);
    assert_eq!(sizes(&reading), [[3, 2, 3]]);
    assert_eq!(reading.series[0].image.volumes().len(), 1);
    assert!(said(&reading).contains("copies"), "{}", said(&reading));
    // Equal numbers of images are no reason to drop one.
    let slices = [0.0, 10.0, 20.0].map(|z| image(z, z as u16).decimals(INSTANCE_NUMBER, &[1.0]));
    assert_eq!(sizes(&read_all(&slices)), [[3, 2, 3]]);
}

#[test]
fn the_same_image_twice_is_dropped() {
    let named = |z: f64, first, name: &str| image(z, first).text(SOP_INSTANCE, "UI", name);
    let slices = [
        named(0.0, 1, "1.1"),
        named(10.0, 2, "1.2"),
        named(0.0, 1, "1.1"),
    ];
    let reading = read_all(&slices);
    assert_eq!(sizes(&reading), [[3, 2, 2]]);
    assert!(said(&reading).contains("copies of images that are there already"));
}

/// <https://github.com/DIAGNijmegen/rse-panimg/issues/126>
#[test]
fn slices_of_other_directions_are_split_off_and_told() {
    let turned = |y: f64| {
        image(0.0, 0)
            .decimals(POSITION, &[0.0, y, 0.0])
            .decimals(ORIENTATION, &[1.0, 0.0, 0.0, 0.0, 0.0, -1.0])
    };
    let reading = read_all(&[image(0.0, 0), turned(0.0), image(10.0, 0), turned(6.0)]);
    assert_eq!(sizes(&reading), [[3, 2, 2], [3, 2, 2]]);
    assert!(said(&reading).contains("one series holds 2 sorts of slices"));
}

/// <https://github.com/rordenlab/dcm2niix/issues/253> and 697, <https://github.com/Slicer/Slicer/issues/4409>,
/// <https://github.com/icometrix/dicom2nifti/issues/23>
#[test]
fn a_tilted_gantry_keeps_its_shear() {
    let slices = [0.0, 1.0, 2.0].map(|k| {
        image(0.0, 0)
            .text(SOP_CLASS, "UI", CT)
            .text(MODALITY, "CS", "CT")
            .decimals(POSITION, &[0.0, -2.0 * k, 8.0 * k])
    });
    let reading = read_all(&slices);
    let frame = *reading.series[0].image.frame();
    assert!((frame.steps()[2] - Vector3::new(0.0, -2.0, 8.0)).norm() < 1e-12);
    assert!((frame.voxel_mm3() - 24.0).abs() < 1e-12);
    assert!(said(&reading).contains("tilted by 14.0°"));
}

#[test]
fn slices_off_the_line_and_images_aside_of_each_other_are_refused() {
    let at = |x: f64, z: f64| image(0.0, z as u16).decimals(POSITION, &[x, 0.0, z]);
    let reading = read_all(&[at(0.0, 0.0), at(9.0, 10.0), at(0.0, 20.0)]);
    assert!(
        said(&reading).contains("slice 2 does not stand on a line"),
        "{}",
        said(&reading)
    );
    let reading = read_all(&[at(0.0, 0.0), at(9.0, 0.0), at(0.0, 20.0)]);
    assert!(
        said(&reading).contains("shifted against each other"),
        "{}",
        said(&reading)
    );
}

#[test]
fn magnitude_and_phase_of_one_series_stand_for_themselves() {
    let phase = |z: f64| image(z, 90).text(IMAGE_TYPE, "CS", "ORIGINAL\\PRIMARY\\P");
    let reading = read_all(&[image(0.0, 0), phase(0.0), image(10.0, 0), phase(10.0)]);
    assert_eq!(sizes(&reading), [[3, 2, 2], [3, 2, 2]]);
}

/// A stack whose slices are series of their own, each with its instants.
fn one_series_a_slice(z: f64, again: u32) -> Vec<Made> {
    let instants = [0.0, 40.0, 80.0].map(|ms| {
        image(z, (z + ms) as u16 + again as u16)
            .text(SERIES, "UI", format!("1.2.{z}.{again}"))
            .decimals(SERIES_NUMBER, &[1000.0 - z + f64::from(again)])
            .decimals(TRIGGER_TIME, &[ms * (1.0 + z / 1000.0)])
            .decimals(NOMINAL_INTERVAL, &[900.0])
    });
    instants.to_vec()
}

#[test]
fn series_of_one_slice_each_make_a_stack() {
    let files: Vec<Made> = [0.0, 10.0, 20.0]
        .iter()
        .flat_map(|&z| one_series_a_slice(z, 0))
        .collect();
    let reading = read_all(&files);
    assert_eq!(sizes(&reading), [[3, 2, 3]]);
    let series = &reading.series[0];
    assert_eq!(series.image.volumes().len(), 3);
    let times = series.image.times_ms().unwrap();
    assert!((times[1] - 40.4).abs() < 1e-9 && (times[2] - 80.8).abs() < 1e-9);
    assert_eq!(series.gates.as_ref().unwrap().cycle_ms, Some(900.0));
    assert!(said(&reading).contains("3 series of one slice each make one stack"));
    assert!(said(&reading).contains("matched by their rank"));
}

#[test]
fn of_a_slice_that_was_taken_again_the_later_is_in_the_stack() {
    let mut files: Vec<Made> = [0.0, 10.0, 20.0]
        .iter()
        .flat_map(|&z| one_series_a_slice(z, 0))
        .collect();
    files.extend(one_series_a_slice(10.0, 5));
    let reading = read_all(&files);
    let mut sizes = sizes(&reading);
    sizes.sort_unstable();
    assert_eq!(sizes, [[3, 2, 1], [3, 2, 3]]);
    let stack = reading
        .series
        .iter()
        .find(|series| series.image.frame().size()[2] == 3);
    assert_eq!(stack.unwrap().image.volumes()[0][6], 15.0);
    assert!(said(&reading).contains("taken again: 1"));
}

#[test]
fn localizers_and_pictures_are_left_out_with_the_reason() {
    let scout = image(3.0, 0)
        .text(SERIES, "UI", "1.9")
        .decimals(ORIENTATION, &[0.0, 1.0, 0.0, 0.0, 0.0, -1.0]);
    let picture = image(0.0, 0).shorts(SAMPLES_PER_PIXEL, &[3]);
    let unplaced = image(0.0, 0).text(SERIES, "UI", "1.8").without(POSITION);
    let reading = read_all(&[
        image(0.0, 0),
        image(10.0, 0),
        scout.clone(),
        picture,
        unplaced,
    ]);
    assert_eq!(sizes(&reading), [[3, 2, 2]]);
    let said = said(&reading);
    for reason in [
        "a localizer",
        "a picture in colours",
        "its position and orientation are not said",
    ] {
        assert!(said.contains(reason), "{said}");
    }
    // Alone, such an image is what was asked for.
    assert_eq!(read_all(&[scout]).series.len(), 1);
}

#[test]
fn phases_in_series_of_their_own_are_one_series_where_their_times_are_said() {
    let phase = |percent: f64, z: f64| {
        image(z, (percent + z) as u16)
            .text(SERIES, "UI", format!("1.2.{percent}"))
            .text(SOP_CLASS, "UI", CT)
            .text(MODALITY, "CS", "CT")
            .double(CARDIAC_PERCENT, percent)
            .decimals(NOMINAL_INTERVAL, &[1000.0])
    };
    let files: Vec<Made> = [40.0, 0.0, 80.0]
        .iter()
        .flat_map(|&percent| [0.0, 10.0].map(|z| phase(percent, z)))
        .collect();
    let reading = read_all(&files);
    assert_eq!(sizes(&reading), [[3, 2, 2]]);
    let image = &reading.series[0].image;
    assert_eq!(image.times_ms(), Some(&[0.0, 400.0, 800.0][..]));
    assert_eq!(image.volumes()[2][6], 90.0);
    assert!(said(&reading).contains("3 series of one instant each make one"));
    let untold: Vec<Made> = files
        .into_iter()
        .map(|made| made.without(CARDIAC_PERCENT))
        .collect();
    assert_eq!(read_all(&untold).series.len(), 3);
}

#[test]
fn slices_of_another_sequence_are_not_joined_with_a_stack() {
    let mut files: Vec<Made> = [0.0, 10.0, 20.0]
        .iter()
        .flat_map(|&z| one_series_a_slice(z, 0))
        .collect();
    let tagged = one_series_a_slice(10.0, 5).into_iter();
    files.extend(tagged.map(|made| made.text(SEQUENCE_VARIANT, "CS", "SP")));
    let reading = read_all(&files);
    let stack = reading
        .series
        .iter()
        .find(|series| series.image.frame().size()[2] == 3);
    assert_eq!(stack.unwrap().image.volumes()[0][6], 10.0);
    assert_eq!(reading.series.len(), 2);
}

#[test]
fn what_says_that_it_is_a_localizer_is_left_out() {
    let scout = |z: f64| {
        image(z, 0)
            .text(SERIES, "UI", "1.7")
            .text(IMAGE_TYPE, "CS", "ORIGINAL\\PRIMARY\\LOCALIZER")
    };
    let reading = read_all(&[scout(0.0), scout(5.0), image(0.0, 0), image(10.0, 0)]);
    assert_eq!(sizes(&reading), [[3, 2, 2]]);
    assert!(said(&reading).contains("a localizer, as its file says"));
}

#[test]
fn it_is_known_which_slice_an_image_became_and_said_that_instants_are_missing() {
    let files: Vec<Made> = [10.0, 0.0]
        .iter()
        .flat_map(|&z| [40.0, 0.0].map(|ms| (z, ms)))
        .map(|(z, ms)| {
            image(z, z as u16)
                .text(SOP_INSTANCE, "UI", format!("1.{z}.{ms}"))
                .text(FRAME_OF_REFERENCE, "UI", format!("2.{z}.{ms}"))
                .decimals(IMAGES_OF_A_BEAT, &[20.0])
                .decimals(TRIGGER_TIME, &[ms])
        })
        .collect();
    let reading = read_all(&files);
    let source = reading
        .sources
        .iter()
        .find(|source| source.instance == "1.10.0")
        .unwrap();
    assert_eq!(
        (source.series, source.slice, source.instant, source.file),
        (0, 1, 0, 1)
    );
    assert_eq!(reading.sources.len(), 4);
    assert!(!format!("{reading:?}").contains("1.10.0"));
    assert!(said(&reading).contains("20 instants of the beat were taken, but only 2 are here"));
}

#[test]
fn series_of_several_studies_say_which_is_of_which() {
    let of = |study: &str, z: f64, number: f64| {
        image(z, 0)
            .text(STUDY, "UI", study)
            .text(SERIES, "UI", format!("{study}.{number}"))
            .decimals(SERIES_NUMBER, &[number])
    };
    let files = [("1.5", 9.0), ("1.4", 2.0), ("1.5", 3.0)]
        .map(|(study, number)| [0.0, 10.0].map(|z| of(study, z, number)));
    let reading = read_all(&files.concat());
    assert_eq!(reading.series.len(), 3);
    assert_eq!(reading.studies, [0, 0, 1]);
}
