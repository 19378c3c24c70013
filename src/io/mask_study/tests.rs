//! Tests of masks of cohorts on disk.
#![allow(clippy::unwrap_used)] // A test that fails here says so.

use std::fs;
use std::path::{Path, PathBuf};

use super::{MaskFiles, MaskKind, MaskStudyError, NamedLabels, find_mask_studies, read_masks};
use crate::io::{Limits, OpenError};
use crate::progress::{Progress, Stopped};

/// A folder with empty files of these names.
fn folder(names: &[&str]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for name in names {
        let path = folder.path().join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, "").unwrap();
    }
    folder
}

fn found(path: &Path) -> (Vec<MaskFiles>, Vec<OpenError>) {
    find_mask_studies(&[path.to_owned()], &Limits::default(), &Progress::default()).unwrap()
}

fn ids(files: &[MaskFiles]) -> Vec<&str> {
    files.iter().map(|files| files.id.as_str()).collect()
}

/// A NIfTI-1 file of bytes with steps of 2, 2 and 8 mm.
fn nifti(size: [u16; 3], voxels: &[u8]) -> Vec<u8> {
    let mut bytes = vec![0_u8; 352];
    bytes[0..4].copy_from_slice(&348_i32.to_le_bytes());
    for (place, n) in [3, size[0], size[1], size[2], 1].into_iter().enumerate() {
        bytes[40 + 2 * place..42 + 2 * place].copy_from_slice(&n.to_le_bytes());
    }
    bytes[70..72].copy_from_slice(&2_i16.to_le_bytes());
    bytes[72..74].copy_from_slice(&8_i16.to_le_bytes());
    for (place, step) in [1.0_f32, 2.0, 2.0, 8.0].into_iter().enumerate() {
        bytes[76 + 4 * place..80 + 4 * place].copy_from_slice(&step.to_le_bytes());
    }
    bytes[108..112].copy_from_slice(&352.0_f32.to_le_bytes());
    bytes[123] = 2;
    bytes[344..348].copy_from_slice(b"n+1\0");
    bytes.extend_from_slice(voxels);
    bytes
}

#[test]
fn frames_of_a_subject_are_put_together_in_the_order_of_their_numbers() {
    let cohort = folder(&[
        "patient10/patient10_frame01_gt.nii.gz",
        "patient10/patient10_frame01.nii.gz",
        "patient10/patient10_frame12_gt.nii.gz",
        "patient2/patient2_frame9_gt.nii.gz",
        "patient2/patient2_frame10_gt.nii.gz",
        "patient2/Info.cfg",
        ".hidden/x_gt.nii.gz",
        "notes.txt",
    ]);
    let (subjects, errors) = found(cohort.path());
    assert_eq!(errors, []);
    assert_eq!(ids(&subjects), ["patient2", "patient10"]);
    let MaskKind::Labels(files) = &subjects[0].kind else {
        panic!("{subjects:?}");
    };
    let numbers: Vec<_> = files.iter().map(|(number, _)| *number).collect();
    assert_eq!(numbers, [Some(9), Some(10)]);
    assert!(subjects.iter().all(|subject| subject.alone));
}

#[test]
fn pairs_are_found_and_halves_of_pairs_are_told() {
    let cohort = folder(&[
        "a_rest_endo.nii.gz",
        "a_rest_epi.nii.gz",
        "a_rest_image.nii.gz",
        "b_endo.nii",
    ]);
    let (subjects, errors) = found(cohort.path());
    assert_eq!(ids(&subjects), ["a_rest"]);
    assert!(matches!(subjects[0].kind, MaskKind::Pair { .. }));
    assert_eq!(errors.len(), 1);
    assert_eq!(errors[0].subject.as_deref(), Some("b"));
    assert_eq!(
        errors[0].reason,
        "a mask of the endocardium without one of the epicardium"
    );
}

#[test]
fn equal_names_in_two_folders_are_two_subjects() {
    let cohort = folder(&["one/mask_gt.nii", "two/mask_gt.nii", "two/other_gt.nii"]);
    let (subjects, _) = found(cohort.path());
    assert_eq!(ids(&subjects), ["one/mask", "two/mask", "other"]);
    assert_eq!(
        subjects.iter().map(|s| s.alone).collect::<Vec<_>>(),
        [true, false, false]
    );
    let twice = folder(&["a_frame1_gt.nii", "a_frame01_gt.nii.gz"]);
    let (subjects, errors) = found(twice.path());
    assert_eq!((subjects.len(), errors.len()), (0, 1));
}

#[test]
fn rest_and_stress_of_one_patient_are_told_apart_by_their_folders() {
    let cohort = folder(&[
        "rest/p1/p1_gt.nii",
        "stress/p1/p1_gt.nii",
        "rest/p2/p2_gt.nii",
    ]);
    let (subjects, _) = found(cohort.path());
    assert_eq!(ids(&subjects), ["rest/p1", "p2", "stress/p1"]);
    assert!(subjects.iter().all(|subject| subject.notices.is_empty()));
    let cohort = folder(&["a/p1/p1_gt.nii", "b/a/p1/p1_gt.nii"]);
    let (subjects, _) = found(cohort.path());
    assert_eq!(ids(&subjects), ["a/p1", "a/p1 (2)"]);
    let text = &subjects[1].notices[0].text;
    assert!(text.contains("another subject has the id"), "{text}");
}

#[test]
fn a_file_that_is_named_needs_no_special_name() {
    let one = folder(&["heart.nii", "readme.txt"]);
    let (subjects, errors) = found(&one.path().join("heart.nii"));
    assert_eq!((ids(&subjects), errors.len()), (vec!["heart"], 0));
    for (wrong, reason) in [
        ("readme.txt", "not a file of masks"),
        ("absent.nii", "no such file"),
    ] {
        let (subjects, errors) = found(&one.path().join(wrong));
        assert_eq!((subjects.len(), errors.len()), (0, 1));
        assert!(errors[0].reason.starts_with(reason), "{errors:?}");
    }
    let (_, errors) = found(folder(&["image.nii.gz"]).path());
    assert!(errors[0].reason.starts_with("no masks were found here"));
}

#[test]
fn looking_ends_at_the_limit_and_when_it_is_stopped() {
    let cohort = folder(&["a_gt.nii", "b_gt.nii", "c_gt.nii"]);
    let limits = Limits {
        image_files: 2,
        ..Limits::default()
    };
    let paths = [cohort.path().to_owned()];
    let (subjects, errors) = find_mask_studies(&paths, &limits, &Progress::default()).unwrap();
    assert_eq!((subjects.len(), errors.len()), (2, 1));
    let progress = Progress::default();
    progress.stop();
    assert_eq!(find_mask_studies(&paths, &limits, &progress), Err(Stopped));
}

#[test]
fn masks_are_read_with_what_is_said_beside_them() {
    let cohort = tempfile::tempdir().unwrap();
    let write = |name: &str, bytes: &[u8]| fs::write(cohort.path().join(name), bytes).unwrap();
    write("p_frame01_gt.nii", &nifti([2, 2, 1], &[0, 1, 2, 3]));
    write("p_frame07_gt.nii", &nifti([2, 2, 1], &[3, 2, 1, 0]));
    write("Info.cfg", b"ED: 1\nES: 7\nGroup: NOR\nHeight: 170\n");
    let (subjects, _) = found(cohort.path());
    let read = |limits: Limits| read_masks(&subjects[0], &limits, &Progress::default());
    let series = read(Limits::default()).unwrap();
    assert_eq!(series.frame_numbers, [Some(1), Some(7)]);
    assert_eq!(
        series.images[1].image.volumes()[0].as_ref(),
        [3.0, 2.0, 1.0, 0.0]
    );
    assert_eq!(series.facts.label.as_deref(), Some("NOR"));
    assert_eq!(series.facts.end_systole, Some(7));
    let few = Limits {
        frames: 1,
        ..Limits::default()
    };
    assert_eq!(
        read(few),
        Err(MaskStudyError::TooManyFrames { files: 2, most: 1 })
    );
    let small = Limits {
        voxels_in_all: 7,
        ..Limits::default()
    };
    assert_eq!(read(small), Err(MaskStudyError::TooManyVoxels { most: 7 }));
    write("p_frame07_gt.nii", &nifti([2, 2, 9], &[3]));
    assert!(matches!(
        read(Limits::default()),
        Err(MaskStudyError::File(_))
    ));
}

#[test]
fn labels_of_dicom_segmentations_name_themselves() {
    let cohort = folder(&[]);
    let bytes = crate::io::dicom::tests::named_segmentation();
    for name in ["p_frame1_seg.dcm", "p_frame9_seg.dcm", "IM0001"] {
        fs::write(cohort.path().join(name), &bytes).unwrap();
    }
    fs::write(cohort.path().join("other.dcm"), "no DICOM").unwrap();
    let (subjects, errors) = found(cohort.path());
    assert_eq!((ids(&subjects), errors), (vec!["IM0001", "p"], Vec::new()));
    let read = |files: &MaskFiles| read_masks(files, &Limits::default(), &Progress::default());
    let series = read(&subjects[1]).unwrap();
    assert_eq!(series.frame_numbers, [Some(1), Some(9)]);
    let expected = NamedLabels {
        cavity: 4,
        wall: 2,
        right: None,
    };
    assert_eq!(series.labels, Some(expected));
    let values = &series.images[0].image.volumes()[0];
    assert_eq!(values.iter().filter(|&&value| value == 4.0).count(), 7);
    fs::write(cohort.path().join("IM0001"), &bytes[..bytes.len() / 2]).unwrap();
    assert!(matches!(read(&subjects[0]), Err(MaskStudyError::File(_))));
    let one = found(&cohort.path().join("IM0001"));
    assert_eq!(ids(&one.0), ["IM0001"]);
}

#[test]
fn a_path_with_nothing_is_an_error() {
    let (subjects, errors) = found(&PathBuf::from("/nowhere/at/all"));
    assert_eq!((subjects.len(), errors.len()), (0, 1));
}
