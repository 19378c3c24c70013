//! Real ventricles of the shared folder, opened as a clinician would drop them.

use cardiomorph::io::{Limits, Opened, open_paths};
use cardiomorph::progress::Progress;
use cardiomorph::study::{Notice, Severity, Subject, SurfaceKind};
use cardiomorph::units::LengthUnit;

use crate::shared::shared_data;

const SHEETS: [SurfaceKind; 2] = [SurfaceKind::Endocardium, SurfaceKind::Epicardium];

/// The study under `data` with its load report printed, which must have no error.
fn opened(place: &str) -> Opened {
    let path = shared_data(place);
    let opened = open_paths(&[path], &Limits::default(), &Progress::default()).unwrap();
    assert!(opened.errors.is_empty(), "{:?}", opened.errors);
    println!("{place}: {} subjects", opened.study.subjects.len());
    for notice in &opened.notices {
        println!("  {:?}: {}", notice.severity, notice.text);
    }
    if let Some(first) = opened.study.subjects.first() {
        for notice in &first.notices {
            println!("  {}, {:?}: {}", first.id, notice.severity, notice.text);
        }
    }
    opened
}

fn kinds(subject: &Subject) -> Vec<SurfaceKind> {
    let surfaces = subject.sequence.surfaces().iter();
    surfaces.map(|surface| surface.kind()).collect()
}

fn warnings(notices: &[Notice]) -> Vec<&str> {
    let warnings = notices.iter().filter(|n| n.severity == Severity::Warning);
    warnings.map(|n| n.text.as_str()).collect()
}

fn says(notices: &[Notice], words: &str) -> bool {
    notices.iter().any(|notice| notice.text.contains(words))
}

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn gated_spect_opens_as_one_cohort_in_file_units() {
    let opened = opened("gated_spect/meshes");
    assert_eq!(opened.study.name, "gated_spect/meshes");
    assert_eq!(opened.study.subjects.len(), 20);
    assert!(says(&opened.notices, "all 20 subjects have the same faces"));
    assert!(!says(&opened.notices, "upon each other"));
    assert_eq!(opened.study.subjects[0].id, "Patient000151_rest");
    for subject in &opened.study.subjects {
        assert_eq!(kinds(subject), SHEETS);
        assert_eq!(subject.sequence.frame_count(), 8);
        assert_eq!(subject.sequence.vertex_count(), 2 * 449);
        assert_eq!(subject.unit, LengthUnit::FileUnit);
        assert!(says(
            &subject.notices,
            "too short for a left ventricle in mm"
        ));
        assert!(
            warnings(&subject.notices).is_empty(),
            "{:?}",
            subject.notices
        );
    }
}

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn acdc_walls_open_by_their_manifest_with_labels() {
    let opened = opened("acdc_walls/study.toml");
    assert_eq!(opened.study.name, "ACDC walls");
    assert_eq!(opened.study.label_classes.normal, ["NOR"]);
    assert_eq!(opened.study.label_classes.abnormal, ["MINF", "DCM", "HCM"]);
    assert_eq!(opened.study.subjects.len(), 100);
    for label in ["NOR", "MINF", "DCM", "HCM", "RV"] {
        let with = opened.study.subjects.iter();
        let with = with.filter(|subject| subject.label.as_deref() == Some(label));
        assert_eq!(with.count(), 20, "{label}");
    }
    for subject in &opened.study.subjects {
        assert_eq!(kinds(subject), SHEETS);
        assert_eq!(subject.sequence.frame_count(), 2);
        assert_eq!(subject.unit, LengthUnit::Millimetre);
        assert_eq!(
            (subject.end_diastole, subject.end_systole),
            (Some(0), Some(1))
        );
        assert!(subject.height_cm.is_some() && subject.weight_kg.is_some());
        assert!(
            warnings(&subject.notices).is_empty(),
            "{:?}",
            subject.notices
        );
    }
}

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn cine_mri_opens_with_all_frames_in_millimetres() {
    let opened = opened("cine_mri");
    let facts: Vec<(&str, usize)> = opened
        .study
        .subjects
        .iter()
        .map(|subject| (subject.id.as_str(), subject.sequence.frame_count()))
        .collect();
    assert_eq!(
        facts,
        [("bivme_patient1", 25), ("bivme_testpatient2_EDES", 2)]
    );
    assert!(says(&opened.notices, "both subjects have the same faces"));
    for subject in &opened.study.subjects {
        assert_eq!(kinds(subject), SHEETS);
        assert_eq!(subject.unit, LengthUnit::Millimetre);
        assert!(says(&subject.notices, "unit mm assumed"));
        assert!(says(
            &subject.notices,
            "boundary loops of 48 and 24 vertices"
        ));
        assert!(
            warnings(&subject.notices).is_empty(),
            "{:?}",
            subject.notices
        );
    }
    assert_eq!(
        opened.study.subjects[0].sequence.surfaces()[1]
            .faces()
            .vertex_count(),
        1652
    );
}

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn mesa_opens_with_its_phases_and_says_that_frames_were_aligned() {
    let opened = opened("mesa/meshes");
    assert_eq!(opened.study.subjects.len(), 25);
    assert_eq!(opened.study.subjects[0].id, "subj0062");
    assert!(says(
        &opened.notices,
        "25 subjects appear pre-aligned, as for an atlas, each frame separately"
    ));
    for subject in &opened.study.subjects {
        assert_eq!(kinds(subject), SHEETS);
        assert_eq!(subject.sequence.vertex_count(), 2 * 785);
        assert_eq!(
            (subject.end_diastole, subject.end_systole),
            (Some(0), Some(1))
        );
        assert_eq!(subject.unit, LengthUnit::Millimetre);
        assert!(says(&subject.notices, "from the file names"));
        assert!(
            warnings(&subject.notices).is_empty(),
            "{:?}",
            subject.notices
        );
    }
}

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn the_horse_opens_and_is_no_heart() {
    let opened = opened("horse_gallop");
    let horse = &opened.study.subjects[0];
    assert_eq!(
        (horse.id.as_str(), kinds(horse)),
        ("horse_gallop", vec![SurfaceKind::Other])
    );
    assert_eq!(horse.sequence.frame_count(), 12);
    assert_eq!(horse.unit, LengthUnit::FileUnit);
    assert!(says(&horse.notices, "surface not identified"));
    assert!(says(&horse.notices, "numbered 0 to 44 in steps of 4"));
    assert_eq!(
        warnings(&horse.notices),
        [
            "surface: open in 2 places, boundary loops of 16 and 3 vertices",
            "surface: frame 9 is identical to frame 3",
        ]
    );
}

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn the_population_mean_opens_as_a_wall_cut_in_two() {
    for place in ["population_mean", "population_mean/LV_ED_mean.vtk"] {
        let opened = opened(place);
        let mean = &opened.study.subjects[0];
        assert_eq!(kinds(mean), [SurfaceKind::Wall]);
        assert_eq!(mean.sequence.vertex_count(), 22_043);
        assert_eq!(mean.sequence.face_count(), 43_840);
        assert_eq!(mean.unit, LengthUnit::Millimetre);
        assert_eq!(mean.end_diastole, Some(0));
        assert!(says(&mean.notices, "identified as a wall"));
        assert!(says(
            &mean.notices,
            "two separate pieces of 25,549 faces and 18,291 faces"
        ));
        assert!(says(&mean.notices, "closed in shape, but cut"));
        assert!(warnings(&mean.notices).is_empty(), "{:?}", mean.notices);
    }
}

#[test]
#[cfg_attr(
    not(shared_data),
    ignore = "needs the folder shared beside the checkout"
)]
fn a_folder_of_images_says_that_they_are_not_read() {
    let path = shared_data("acdc");
    let opened = open_paths(&[path], &Limits::default(), &Progress::default()).unwrap();
    assert_eq!(opened.errors.len(), 1);
    assert!(
        opened.errors[0].reason.contains("images are not read"),
        "{:?}",
        opened.errors
    );
}
