//! Writing and reading back is the identity.

use std::sync::Arc;

use proptest::prelude::*;

use super::*;
use crate::io::{Limits, Opened, open_paths};
use crate::mesh::{Point3, TriMesh, phantom};
use crate::study::checks::LandmarkDoubt;
use crate::study::{LabelClasses, Revision, SurfaceSequence};
use crate::units::Seconds;

fn format(extension: &str) -> MeshFormat {
    MeshFormat::of_extension(extension).unwrap()
}

fn read_back(folder: &Path) -> Opened {
    open_paths(
        &[folder.to_owned()],
        &Limits::default(),
        &Progress::default(),
    )
    .unwrap()
}

fn sequence(kinds: &[SurfaceKind], factors: &[f64]) -> MeshSequence {
    let surfaces = kinds
        .iter()
        .enumerate()
        .map(|(place, &kind)| {
            let rest = phantom::bowl(20.0 + 9.0 * place as f64, 4, 7);
            let frames = factors
                .iter()
                .map(|factor| {
                    let points: Vec<Point3> = rest.vertices().iter().map(|p| p * *factor).collect();
                    TriMesh::new(points, Arc::clone(rest.faces())).unwrap()
                })
                .collect();
            SurfaceSequence::new(kind, frames).unwrap()
        })
        .collect();
    MeshSequence::new(surfaces).unwrap()
}

fn kinds() -> impl Strategy<Value = Vec<SurfaceKind>> {
    prop_oneof![
        Just(vec![SurfaceKind::Endocardium, SurfaceKind::Epicardium]),
        Just(vec![SurfaceKind::Wall]),
        Just(vec![SurfaceKind::Cavity]),
        Just(vec![SurfaceKind::Other]),
        Just(vec![SurfaceKind::Endocardium]),
    ]
}

prop_compose! {
    fn anatomy()(numbers in prop::array::uniform12(-100.0..100.0)) -> Option<Anatomy> {
        let point = |i: usize| Point3::new(numbers[i], numbers[i + 1], numbers[i + 2]);
        Anatomy::from_landmarks(point(0), point(3), point(6), point(9))
    }
}

prop_compose! {
    fn subject()(
        id in "[a-zA-Z0-9 äß/\"\\\\._-]{1,12}",
        label in prop::option::of("[A-Z\"\n]{0,5}"),
        kinds in kinds(),
        factors in prop::collection::vec(0.5..1.5, 1..4),
        in_mm in any::<bool>(),
        first_ms in prop::option::of(0.0..1000.0),
        rr in prop::option::of(300..1500),
        phases in prop::option::of((0..4_usize, 0..4_usize)),
        sizes in prop::option::of((50.0..200.0, 3.0..150.0)),
        anatomy in prop::option::of(anatomy()),
    ) -> Subject {
        let sequence = sequence(&kinds, &factors);
        let frames = sequence.frame_count();
        let unit = if in_mm { LengthUnit::Millimetre } else { LengthUnit::FileUnit };
        let mut subject = Subject::new(id, sequence, unit);
        subject.label = label;
        subject.timing.frame_times_s = first_ms.map(|first: f64| {
            (0..frames).map(|frame| (first.round() + 40.5 * frame as f64) / 1000.0).collect()
        });
        subject.timing.rr = rr.map(|ms: i32| Seconds(f64::from(ms) / 1000.0));
        subject.end_diastole = phases.map(|(ed, _)| ed % frames);
        subject.end_systole = phases.map(|(_, es)| es % frames);
        subject.height_cm = sizes.map(|(height, _)| height);
        subject.weight_kg = sizes.map(|(_, weight)| weight);
        subject.anatomy = anatomy.flatten();
        // Landmarks that cannot be those of the surfaces are not read back.
        if LandmarkDoubt::of(&subject).is_some() {
            subject.anatomy = None;
        }
        subject
    }
}

fn assert_same(written: &Subject, read: &Subject) {
    let (mut left, mut right) = (written.clone(), read.clone());
    left.notices.clear();
    right.notices.clear();
    if let (Some(a), Some(b)) = (&left.anatomy, &right.anatomy) {
        assert_eq!((a.apex, a.base), (b.apex, b.base));
        assert!((a.septal - b.septal).norm() < 1e-12, "{a:?} {b:?}");
        assert!((a.anterior - b.anterior).norm() < 1e-12, "{a:?} {b:?}");
        right.anatomy = left.anatomy;
    }
    assert_eq!(left, right);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]
    #[test]
    fn a_study_reads_back_as_it_was_written(
        name in "[a-z \"\\\\]{0,8}",
        normal in prop::collection::vec("[A-Z]{1,4}", 0..3),
        subjects in prop::collection::vec(subject(), 1..5),
        excluded in prop::collection::vec(any::<bool>(), 3),
        format in prop::sample::select(MeshFormat::all().collect::<Vec<_>>()),
    ) {
        let mut subjects = subjects;
        for (index, subject) in subjects.iter_mut().enumerate() {
            subject.id = format!("{}{index}", subject.id);
        }
        let mut study = Study {
            name,
            subjects: subjects.into_iter().map(Arc::new).collect(),
            label_classes: LabelClasses { normal, abnormal: vec!["DCM".to_owned()] },
            ..Study::default()
        };
        for index in (0..excluded.len()).filter(|index| excluded[*index]) {
            study = study.excluding(index, Revision(1)).unwrap_or(study);
        }
        let folder = tempfile::tempdir().unwrap();
        write_study(&study, folder.path(), format, &Progress::default()).unwrap();
        let opened = read_back(folder.path());
        prop_assert!(opened.errors.is_empty(), "{:?}", opened.errors);
        prop_assert_eq!(&opened.study.name, &study.name);
        prop_assert_eq!(&opened.study.label_classes, &study.label_classes);
        prop_assert_eq!(opened.study.subjects.len(), study.subjects.len());
        prop_assert_eq!(opened.study.in_order(), study.in_order());
        for (written, read) in study.all().zip(opened.study.all()) {
            assert_same(written, read);
        }
    }
}

fn small_study(frames: &[f64]) -> Study {
    let heart = sequence(&[SurfaceKind::Cavity], frames);
    Study {
        name: "small".to_owned(),
        subjects: vec![Arc::new(Subject::new("a", heart, LengthUnit::Millimetre))],
        ..Study::default()
    }
}

#[test]
fn frames_of_another_study_are_never_mixed_in_or_deleted() {
    let folder = tempfile::tempdir().unwrap();
    let write = |frames: &[f64]| {
        write_study(
            &small_study(frames),
            folder.path(),
            format("obj"),
            &Progress::default(),
        )
    };
    write(&[1.0, 0.9, 0.8]).unwrap();
    write(&[1.0, 0.7, 0.8]).unwrap();
    let error = write(&[1.0, 0.9]).unwrap_err();
    assert!(
        matches!(&error, WriteStudyError::InTheWay { path, .. } if path.ends_with("cavity_002.obj")),
        "{error}"
    );
    assert_eq!(
        read_back(folder.path()).study.subjects[0]
            .sequence
            .frame_count(),
        3
    );
}

#[test]
fn the_series_files_of_a_study_open_by_themselves() {
    let folder = tempfile::tempdir().unwrap();
    let mut study = small_study(&[1.0, 0.9]);
    let mut subject = (*study.subjects[0]).clone();
    subject.timing.frame_times_s = Some(vec![0.0, 0.35]);
    study.subjects = vec![Arc::new(subject)];
    write_study(&study, folder.path(), format("vtp"), &Progress::default()).unwrap();
    for path in [folder.path().join("a/cavity.pvd"), folder.path().join("a")] {
        let opened = read_back(&path);
        assert!(opened.errors.is_empty(), "{:?}", opened.errors);
        let read = &opened.study.subjects[0];
        assert_eq!(read.sequence, study.subjects[0].sequence);
        assert_eq!(read.timing.frame_times_s, Some(vec![0.0, 0.35]));
    }
}

#[test]
fn a_study_that_excludes_all_its_subjects_excludes_none_and_says_so() {
    let folder = tempfile::tempdir().unwrap();
    write_study(
        &small_study(&[1.0]),
        folder.path(),
        format("obj"),
        &Progress::default(),
    )
    .unwrap();
    let manifest = folder.path().join("study.toml");
    let text = fs::read_to_string(&manifest).unwrap() + "excluded = true\n";
    fs::write(&manifest, text).unwrap();
    let opened = read_back(folder.path());
    assert_eq!((opened.study.subjects.len(), opened.study.count()), (1, 1));
    let mut notices = opened.notices.iter();
    assert!(notices.any(|notice| notice.text.contains("excludes all subjects")));
}

#[test]
fn a_stopped_writer_stops() {
    let folder = tempfile::tempdir().unwrap();
    let progress = Progress::default();
    progress.stop();
    let outcome = write_study(
        &small_study(&[1.0]),
        folder.path(),
        format("obj"),
        &progress,
    );
    assert!(matches!(outcome, Err(WriteStudyError::Stopped(_))));
    assert!(!folder.path().join("study.toml").exists());
}

#[test]
fn folder_names_are_safe_and_different() {
    assert_eq!(
        folder_names(&["../x", "a", "A", "", "é"]),
        ["___x", "a", "A_2", "_", "__2"]
    );
}

#[test]
fn a_folder_that_cannot_be_made_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let blocked = folder.path().join("file");
    fs::write(&blocked, "").unwrap();
    let error = write_study(
        &small_study(&[1.0]),
        &blocked,
        format("obj"),
        &Progress::default(),
    )
    .unwrap_err();
    assert!(error.to_string().contains("file"), "{error}");
}
