//! Walls from real gated SPECT without masks, held against the masks.
//!
//! Settings were chosen on the first five patients (and on built-in hearts), each at rest and under stress. The other five are
//! reported apart: the aim of 0.06 is missed for most of them. Their ejection fraction is found too great; why is not established
//! (their masks have thinner inner walls, or a middle beside the peak of counts, at end-systole). The numbers below are what was
//! measured: they guard against getting worse.

use std::time::Instant;

use cardiomorph::analysis::walls_from_masks::{Masks, Tissue};
use cardiomorph::analysis::walls_from_spect::{
    CheckedSpectParams, SpectError, SpectSegmentation, segment_spect,
};
use cardiomorph::image::{Image, MarkedPoints, VolumeFrame};
use cardiomorph::io::{Limits, read_dicom, read_image_file};
use cardiomorph::mesh::{Point3, Vector3};
use cardiomorph::progress::Progress;

use crate::shared::shared_data;

/// Distance of voxels that the files leave out, as their description assumes.
const SPACING_MM: f64 = 3.3;
const CHOSEN_ON: [&str; 5] = ["000151", "000164", "000196", "000214", "000233"];

fn segmented(image: &Image) -> Result<SpectSegmentation, SpectError> {
    let (points, params) = (MarkedPoints::default(), CheckedSpectParams::default());
    segment_spect(image, &points, &[], &params, &Progress::default())
}

fn of_file(id: &str) -> Image {
    let path = shared_data(&format!("gated_spect/nifti/{id}_image.nii.gz"));
    read_image_file(&path, &Limits::default()).unwrap().image
}

/// An image whose voxels stand apart as assumed.
fn spaced(image: &Image) -> Image {
    let steps = [0, 1, 2].map(|axis| Vector3::ith(axis, SPACING_MM));
    let frame = VolumeFrame::new(image.frame().size(), Point3::origin(), steps).unwrap();
    Image::new(frame, image.volumes().to_vec(), None).unwrap()
}

fn ejection_fraction(masks: &Masks) -> f64 {
    let volumes = (0..masks.instants().len()).map(|instant| masks.count(instant, Tissue::Cavity));
    let (least, most) = (volumes.clone().min().unwrap(), volumes.max().unwrap());
    1.0 - least as f64 / most as f64
}

/// Patient and state, the ejection fraction of the masks, and the difference of that found without them.
fn differences() -> Vec<(String, f64, f64)> {
    let table = std::fs::read_to_string(shared_data("gated_spect/subjects.csv")).unwrap();
    let mut lines = table
        .lines()
        .map(|line| line.split(',').collect::<Vec<_>>());
    let head = lines.next().unwrap();
    let column = |name: &str| head.iter().position(|other| *other == name).unwrap();
    let study = |row: Vec<&str>| {
        let id = format!("{}_{}", row[column("subject")], row[column("state")]);
        let truth: f64 = row[column("EF_mask")].parse().unwrap();
        let found = segmented(&spaced(&of_file(&id))).unwrap();
        (id, truth, ejection_fraction(&found.masks) - truth)
    };
    lines.map(study).collect()
}

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn every_real_study_is_followed_and_its_ejection_fraction_stated() {
    let begin = Instant::now();
    let found = differences();
    let seconds = begin.elapsed().as_secs_f64();
    assert_eq!(found.len(), 20);
    let mut within = [0, 0];
    for (id, truth, difference) in &found {
        let other = usize::from(!CHOSEN_ON.iter().any(|patient| id.contains(patient)));
        within[other] += usize::from(difference.abs() <= 0.06);
        println!("{id}: masks {truth:.3}, without {difference:+.3}");
    }
    println!("{within:?} of [10, 10] within 0.06, in {seconds:.1} s");
    assert!(within[0] >= 9 && within[1] >= 3, "{within:?}");
}

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn both_roads_of_one_patient_give_the_same_ejection_fraction() {
    for (id, place) in [
        ("Patient000164_rest", "p1/IM000003"),
        ("Patient000151_stress", "p2/gated_rle.dcm"),
    ] {
        let path = shared_data(&format!("images/gated_spect_dicom/{place}"));
        let reading = read_dicom(&[path], &Limits::default(), &Progress::default()).unwrap();
        let dicom = segmented(&reading.series[0].image).unwrap();
        let nifti = segmented(&spaced(&of_file(id))).unwrap();
        let [dicom, nifti] = [dicom, nifti].map(|found| ejection_fraction(&found.masks));
        println!("{id}: NIfTI {nifti:.3}, DICOM {dicom:.3}");
        assert!((dicom - nifti).abs() < 0.03, "{id}: {dicom} {nifti}");
    }
}

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn voxels_of_a_size_that_no_heart_has_are_not_taken_for_one() {
    // As the files have them: 1 mm, so that the ventricle would be as small as a walnut.
    let error = segmented(&of_file("Patient000214_rest")).unwrap_err();
    assert!(error.to_string().contains("spacing"), "{error}");
}
