//! Bug reports that others got about reading such images, each with what is right and the tests that show it here.
//!
//! The table is checked: each test that it names exists, is one, and needs no file from elsewhere. What no unit test showed
//! is tested in `known_trouble/`.

#[cfg(test)]
mod shown_here;

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

/// A report or several of one kind: threads, what is right, and where it is shown (a file, the names of its tests).
struct Report {
    number: usize,
    threads: &'static [&'static str],
    right: &'static str,
    shown: &'static [(&'static str, &'static [&'static str])],
}

const fn report(
    number: usize,
    threads: &'static [&'static str],
    right: &'static str,
    shown: &'static [(&'static str, &'static [&'static str])],
) -> Report {
    Report {
        number,
        threads,
        right,
        shown,
    }
}

const HERE: &str = "tests/it/known_trouble/shown_here.rs";
const NUCLEAR: &str = "src/io/dicom/tests/nuclear.rs";
const STACKS: &str = "src/io/dicom/tests/stacks.rs";
const TIMES: &str = "src/io/dicom/tests/times.rs";
const ENHANCED: &str = "src/io/dicom/tests/enhanced.rs";
const NUMBERS: &str = "src/io/dicom/tests/numbers.rs";
const RLE: &str = "src/io/dicom/rle.rs";
const NIFTI: &str = "src/io/nifti/tests.rs";
const BLUR: &str = "src/image/blur/tests.rs";
const RESAMPLE: &str = "src/image/resample/tests.rs";

#[rustfmt::skip] // A table.
const REPORTS: [Report; 32] = [
    report(1, &["rordenlab/dcm2niix#885"],
        "slice k of a gamma camera stands at position + k · distance · (row × column), whose sign is kept",
        &[(NUCLEAR, &["slices_go_to_the_side_that_the_sign_of_their_distance_says_from_where_the_detector_says"])]),
    report(2, &["ClearCanvas/ClearCanvas#209"],
        "position and orientation are looked for in the description of the detector",
        &[(NUCLEAR, &["slices_go_to_the_side_that_the_sign_of_their_distance_says_from_where_the_detector_says"])]),
    report(3, &["OHIF/Viewers#5554"],
        "gated counts are a volume for each gate",
        &[(NUCLEAR, &["vectors_decide_whatever_runs_fastest_or_down", "missing_and_doubled_frames_are_named"])]),
    report(4, &["FNNDSC/ami#293"],
        "a distance is a decimal; a position that is missing stays missing",
        &[(NUCLEAR, &["a_missing_place_stays_missing"]), (HERE, &["a_distance_keeps_its_decimals"])]),
    report(5, &["rordenlab/dcm2niix#555"],
        "slices are as far apart as their positions along the normal",
        &[(STACKS, &["distances_come_from_positions_never_from_thickness"]),
          (HERE, &["the_distance_is_measured_along_the_normal"])]),
    report(6, &["QIICR/dcmqi#89", "InsightSoftwareConsortium/ITK#112"],
        "thickness is no distance; a distance that is said besides positions is not used",
        &[(STACKS, &["distances_come_from_positions_never_from_thickness"])]),
    report(7, &["horosproject/horos#386"],
        "a volume is area times distance: gaps between slices count",
        &[(HERE, &["millilitres_count_the_gaps_between_slices"])]),
    report(8, &["InsightSoftwareConsortium/ITK#441"],
        "a slice that is missing is found and named",
        &[(STACKS, &["a_missing_slice_is_named"])]),
    report(9, &["rordenlab/dcm2niix#395", "#408", "#428"],
        "times after an R wave count only where positions repeat, and within a beat",
        &[(TIMES, &["trigger_times_count_only_where_positions_repeat_and_within_a_beat"])]),
    report(10, &["rordenlab/dcm2niix#689"],
        "images are grouped by position, then by time",
        &[(TIMES, &["repeated_positions_are_instants_ordered_by_time_within_each_slice"])]),
    report(11, &["rordenlab/dcm2niix#809"],
        "an index is of the dimension whose tag is named, and is checked by positions",
        &[(ENHANCED, &["dimensions_go_by_the_tags_that_are_named"])]),
    report(12, &["SimpleITK/SimpleITK#879"],
        "repeated positions are instants: 25 volumes of 4 slices are not 100 slices",
        &[(HERE, &["a_hundred_images_at_four_places_are_25_volumes"])]),
    report(13, &["fedorov/MultiVolumeImporter#49", "#29", "#19"],
        "instants are distinguished by trigger time, percent of the beat or clock, whichever is said",
        &[(TIMES, &["repeated_positions_are_instants_ordered_by_time_within_each_slice",
                    "instants_come_from_percents_indices_clocks_or_numbers_where_they_must"]),
          (STACKS, &["phases_in_series_of_their_own_are_one_series_where_their_times_are_said"])]),
    report(14, &["imageio/imageio#349"],
        "slices are in the order of their positions, not of their numbers",
        &[(STACKS, &["slices_are_ordered_by_position_not_by_number_or_name"])]),
    report(15, &["icometrix/dicom2nifti#21", "rordenlab/dcm2niix#168"],
        "copies are told by position and pixels, never by an equal number or time alone",
        &[(STACKS, &["copies_are_dropped_by_place_and_numbers_only", "the_same_image_twice_is_dropped"]),
          (TIMES, &["slices_that_are_empty_at_all_instants_are_no_copies"])]),
    report(16, &["Project-MONAI/monai-deploy-app-sdk#532"],
        "acquisitions of the same slices stand for themselves",
        &[(TIMES, &["acquisitions_of_the_same_slices_stand_for_themselves"])]),
    report(17, &["DIAGNijmegen/rse-panimg#126"],
        "slices of other directions are split off, and it is said",
        &[(STACKS, &["slices_of_other_directions_are_split_off_and_told"])]),
    report(18, &["rordenlab/dcm2niix#253", "#697", "Slicer/Slicer#4409", "icometrix/dicom2nifti#23"],
        "a tilted gantry keeps its shear",
        &[(STACKS, &["a_tilted_gantry_keeps_its_shear"])]),
    report(19, &["Enet4/dicom-rs#460"],
        "padding has the sign of the pixels also where the file says no letters",
        &[(NUMBERS, &["padding_has_the_sign_of_the_pixels_also_where_the_file_says_no_letters"])]),
    report(20, &["pydicom/pydicom#1149"],
        "a JPEG 2000 stream that contradicts its file about signs keeps its bits",
        &[(HERE, &["streams_keep_their_bits_whatever_their_heads_say_of_signs"])]),
    report(21, &["pydicom/pydicom#2009"],
        "a sign is extended from the bits that count, after JPEG-LS, too",
        &[(NUMBERS, &["a_sign_is_extended_from_the_bits_that_count_also_after_unpacking"])]),
    report(22, &["Enet4/dicom-rs#457", "#413", "#414"],
        "bytes of words are not mixed up, and parts belong to their frames",
        &[(RLE, &["the_first_segment_holds_the_high_bytes"]),
          (NUMBERS, &["packed_frames_in_several_parts_are_joined"])]),
    report(23, &["fo-dicom/fo-dicom#187", "rordenlab/dcm2niix#688"],
        "12 bits with a sign within 16 are masked and extended",
        &[(NUMBERS, &["twelve_bits_with_a_sign_within_sixteen_are_extended_and_the_others_masked"])]),
    report(24, &["dgobbi/vtk-dicom#173", "#128", "rordenlab/dcm2niix#262", "fo-dicom/fo-dicom#406"],
        "padding is masked first: it is rescaled, counted, mixed and blurred into nothing",
        &[(NUMBERS, &["padding_is_masked_before_numbers_are_rescaled",
                      "padding_that_stands_outside_of_the_bits_that_count_is_found"]),
          (HERE, &["padding_is_no_lowest_value"]),
          (BLUR, &["missing_values_stay_missing_and_are_mixed_into_nothing"]),
          (RESAMPLE, &["padding_is_mixed_into_nothing"])]),
    report(25, &["cornerstonejs/cornerstone3D#2215", "ivmartel/dwv#435"],
        "that low numbers are bright is a matter of display and never changes the numbers",
        &[(NUMBERS, &["numbers_whose_low_ones_are_bright_stay_as_they_are"])]),
    report(26, &["FNNDSC/ami#166"],
        "the first distance of pixels is that of rows",
        &[(NUMBERS, &["the_first_distance_is_that_of_rows"])]),
    report(27, &["nipy/nibabel#624", "simnibs/simnibs#110"],
        "codes decide: sform, then qform, then pixdim; a matrix that spans nothing is an error",
        &[(NIFTI, &["codes_choose_the_matrix", "a_matrix_that_spans_nothing_is_an_error_whatever_else_is_there"])]),
    report(28, &["FNNDSC/ami#250", "JuliaNeuroscience/NIfTI.jl#23"],
        "the intercept is read with its slope; pixdim keeps its order where both codes are 0",
        &[(NIFTI, &["slope_and_intercept_hold_only_together", "codes_choose_the_matrix"])]),
    report(29, &["QIICR/dcmqi#341", "pydicom/pydicom#2134"],
        "bits of frames follow each other without a gap",
        &[(ENHANCED, &["bits_of_frames_follow_each_other_without_a_gap_and_empty_slices_are_filled_in"])]),
    report(30, &["rordenlab/dcm2niix#372"],
        "what all frames share is looked up there, then frame by frame",
        &[(ENHANCED, &["what_all_frames_share_is_looked_up_there", "each_frame_has_its_own_factor_and_time_in_the_beat"])]),
    report(31, &["ivmartel/dwv#1490"],
        "several times at one position are no slices without a distance",
        &[(HERE, &["a_film_of_one_slice_is_one_slice"])]),
    report(32, &["rordenlab/dcm2niix#830"],
        "an instant that is not complete is dropped and named, or the series refused",
        &[(TIMES, &["an_incomplete_instant_is_dropped_and_named_or_the_series_refused"])]),
];

/// The attributes above a test, if the file has it.
fn attributes<'a>(source: &'a str, test: &str) -> Option<&'a str> {
    let (before, _) = source.split_once(&format!("fn {test}()"))?;
    let from = before.rfind(['}', ';']).map_or(0, |at| at + 1);
    before.get(from..)
}

#[test]
fn every_report_has_a_test_that_always_runs() {
    for (row, report) in REPORTS.iter().enumerate() {
        let Report { number, right, .. } = report;
        assert_eq!(*number, row + 1, "{right}");
        assert!(
            !report.shown.is_empty() && !report.threads.is_empty(),
            "{number}"
        );
        for (file, tests) in report.shown {
            let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(file);
            let source = fs::read_to_string(path).unwrap();
            for test in *tests {
                let above = attributes(&source, test)
                    .unwrap_or_else(|| panic!("report {number}: {file} has no test {test}"));
                assert!(
                    above.contains("#[test]"),
                    "report {number}: {test} is no test"
                );
                assert!(
                    !above.contains("ignore"),
                    "report {number}: {test} may be ignored"
                );
            }
        }
    }
}

/// The list of the reports is that of the shared folder.
#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn the_table_names_every_report_of_the_list() {
    let list = fs::read_to_string(crate::shared::shared_data("images/KNOWN_TROUBLE.md")).unwrap();
    let mut found = BTreeSet::new();
    for line in list.lines() {
        let Some((number, text)) = line.split_once(". ") else {
            continue;
        };
        let Ok(number) = number.parse::<usize>() else {
            continue;
        };
        let report = &REPORTS[number - 1];
        for word in text
            .replace("/#", " #")
            .split([' ', ',', ':', ';', '(', ')'])
        {
            let digits = word.rsplit_once('#').map(|(_, digits)| digits);
            // Pull requests that mended a report are no reports.
            let mended = ["#296", "#496"].contains(&word);
            if digits.is_some_and(|digits| digits.parse::<u32>().is_ok()) && !mended {
                let threads = report.threads;
                let short = |thread: &&str| threads.iter().any(|other| other.ends_with(thread));
                let known = threads.contains(&word) || short(&word);
                assert!(known, "report {number} does not name {word}");
            }
        }
        found.insert(number);
    }
    assert_eq!(found, (1..=REPORTS.len()).collect());
}
