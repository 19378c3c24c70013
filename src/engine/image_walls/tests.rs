//! Tests of what belongs together and what it is called.
#![allow(clippy::unwrap_used)] // A test that fails here says so.

use std::path::PathBuf;
use std::sync::Arc;

use super::made::{Outcome, made_of};
use super::studies::{ImageStudy, image_studies};
use super::*;
use crate::analysis::preparation::{Asked, BaseEnd, Preparation};
use crate::image::{Image, VolumeFrame};
use crate::io::{FoundImage, ImageSeries, Modality, Provenance};
use crate::mesh::{Point3, Vector3};

/// A series of some machine: a ramp, so that no values are labels.
fn series(modality: Option<Modality>, size: [usize; 3], instants: usize) -> ImageSeries {
    let steps = [Vector3::x() * 4.0, Vector3::y() * 4.0, Vector3::z() * 4.0];
    let frame = VolumeFrame::new(size, Point3::origin(), steps).unwrap();
    let values: Arc<[f32]> = (0..frame.voxel_count()).map(|n| n as f32 + 0.5).collect();
    ImageSeries {
        name: String::new(),
        format: "DICOM",
        modality,
        image: Image::new(frame, vec![values; instants], None).unwrap(),
        gates: None,
        spacing: Provenance::Stated,
        times: match instants {
            1 => Provenance::Stated,
            _ => Provenance::Missing,
        },
        position_known: true,
        notices: Vec::new(),
    }
}

fn found(study: Option<usize>, path: &str, series: ImageSeries) -> FoundImage {
    FoundImage {
        path: Some(PathBuf::from(path)),
        study,
        series,
    }
}

fn ids(studies: &[ImageStudy]) -> Vec<&str> {
    studies.iter().map(|study| study.id.as_str()).collect()
}

const NM: Option<Modality> = Some(Modality::NuclearMedicine);
const MR: Option<Modality> = Some(Modality::MagneticResonance);

#[test]
fn files_are_named_by_their_names_and_dicom_by_numbers() {
    let images = vec![
        found(None, "x/p1.nii.gz", series(None, [8, 8, 8], 2)),
        found(None, "y/p1.nii", series(None, [8, 8, 8], 2)),
        found(Some(4), "Doe^John.dcm", series(NM, [8, 8, 8], 2)),
        found(Some(9), "Roe^Jane.dcm", series(NM, [8, 8, 8], 2)),
    ];
    let studies = image_studies(
        images,
        &ImageWallSettings::default(),
        &ImageWalls::default(),
    );
    assert_eq!(ids(&studies), ["p1", "p1 (2)", "study1", "study2"]);
}

#[test]
fn rest_and_stress_are_two_subjects_and_a_localizer_is_none() {
    let images = vec![
        found(Some(0), "", series(NM, [8, 8, 8], 1)),
        found(Some(0), "", series(NM, [8, 8, 8], 8)),
        found(Some(0), "", series(NM, [9, 9, 9], 8)),
        found(Some(1), "", series(MR, [64, 64, 1], 1)),
        found(Some(1), "", series(MR, [32, 32, 9], 4)),
        found(Some(1), "", series(MR, [64, 64, 1], 4)),
    ];
    let studies = image_studies(
        images,
        &ImageWallSettings::default(),
        &ImageWalls::default(),
    );
    assert_eq!(ids(&studies), ["study1_1", "study1_2", "study2"]);
    let counts: Vec<usize> = studies.iter().map(|study| study.series.len()).collect();
    assert_eq!(counts, [2, 1, 3]);
    let first = |n: usize| studies[n].series[0].image.frame().size();
    assert_eq!(
        [first(0), first(1), first(2)],
        [[9, 9, 9], [8, 8, 8], [32, 32, 9]]
    );
}

#[test]
fn on_another_road_masks_are_no_images() {
    let images = || {
        vec![
            found(None, "p1_endo.nii", series(None, [8, 8, 8], 2)),
            found(None, "p1_image.nii", series(None, [8, 8, 8], 2)),
        ]
    };
    let mut settings = ImageWallSettings::default();
    let all = image_studies(images(), &settings, &ImageWalls::default());
    assert_eq!(ids(&all), ["p1_endo", "p1_image"]);
    settings.over.road = Some(Road::Spect);
    let of_counts = image_studies(images(), &settings, &ImageWalls::default());
    assert_eq!(ids(&of_counts), ["p1_image"]);
}

#[test]
fn images_that_need_a_word_come_without_walls_and_say_so() {
    let study = |series| ImageStudy {
        id: "a".to_owned(),
        path: PathBuf::new(),
        series: vec![series],
    };
    let settings = ImageWallSettings::default();
    let made = |series| made_of(study(series), &settings, &Progress::default()).unwrap();
    let cine = made(series(MR, [32, 32, 9], 4));
    let asked = [Asked::Apex, Asked::Base, Asked::Blood];
    assert!(matches!(&cine.outcome, Outcome::Asked(needs) if *needs == asked));
    let images = cine.images.unwrap();
    assert!(images.made.is_none() && images.notices[0].text.contains("walls need the apex"));
    let planar = made(series(NM, [32, 32, 1], 4));
    assert!(matches!(planar.outcome, Outcome::Unsuitable));
    let mut unsaid = series(NM, [8, 8, 8], 4);
    unsaid.spacing = Provenance::Missing;
    let unsaid = made(unsaid);
    assert!(matches!(&unsaid.outcome, Outcome::Asked(needs) if *needs == [Asked::Spacing]));
}

#[test]
fn own_settings_win_over_those_of_all_and_options_over_both() {
    let mut settings = ImageWallSettings {
        all: Some(Preparation::of_road(Road::Spect)),
        ..ImageWallSettings::default()
    };
    let mut own = Preparation::of_road(Road::Cine);
    own.vertices = 500;
    settings.each.insert("a".to_owned(), own);
    settings.over.base = Some(BaseEnd::Closed);
    let of = |id: &str| settings.of(id, Preparation::default());
    assert_eq!((of("a").road, of("a").vertices), (Road::Cine, 500));
    assert_eq!(of("b").road, Road::Spect);
    assert_eq!(of("b").base, BaseEnd::Closed);
}
