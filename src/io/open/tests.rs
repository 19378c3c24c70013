//! Paths of every kind, small and made on the spot.

use std::fs;

use super::*;
use crate::io::write_obj;
use crate::mesh::{Point3, TriMesh, phantom};
use crate::study::{Severity, SurfaceKind};
use crate::units::LengthUnit;

fn ball(radius: f64) -> TriMesh {
    phantom::sphere(1, radius)
}

fn put(folder: &Path, name: &str, mesh: &TriMesh) {
    let path = folder.join(name);
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    let mut bytes = Vec::new();
    write_obj(&mut bytes, mesh).unwrap();
    fs::write(path, bytes).unwrap();
}

fn open(paths: &[PathBuf]) -> Opened {
    open_paths(paths, &Limits::default(), &Progress::default()).unwrap()
}

fn ids(opened: &Opened) -> Vec<&str> {
    opened
        .study
        .subjects
        .iter()
        .map(|s| s.id.as_str())
        .collect()
}

/// Radius of each frame, to see their order.
fn radii(opened: &Opened, subject: usize) -> Vec<f64> {
    let surface = &opened.study.subjects[subject].sequence.surfaces()[0];
    surface
        .frames()
        .iter()
        .map(|mesh| mesh.vertices()[0].coords.norm().round())
        .collect()
}

#[test]
fn a_folder_of_folders_is_a_cohort_and_other_files_are_passed_over() {
    let root = tempfile::tempdir().unwrap();
    for (subject, factor) in [("p10", 1.0), ("p2", 1.1)] {
        for frame in [10, 9, 8] {
            let radius = factor * f64::from(20 + frame);
            put(
                root.path(),
                &format!("{subject}/endo_g{frame}.obj"),
                &ball(radius),
            );
            put(
                root.path(),
                &format!("{subject}/epi_g{frame}.obj"),
                &ball(radius + 9.0),
            );
        }
    }
    fs::write(root.path().join("subjects.csv"), "id,ef\np2,0.6\n").unwrap();
    fs::write(root.path().join("p2/notes.md"), "# hello").unwrap();
    fs::write(root.path().join("p2/index.csv"), "0\n1\n2\n").unwrap();
    let opened = open(&[root.path().to_owned()]);
    assert_eq!(opened.errors, []);
    assert_eq!(ids(&opened), ["p2", "p10"]);
    assert_eq!(radii(&opened, 1), [28.0, 29.0, 30.0]);
    assert_eq!(opened.study.subjects[0].unit, LengthUnit::Millimetre);
    assert_eq!(
        opened.notices,
        [Notice::info(
            "both subjects have the same faces: their vertices are taken to correspond"
        )]
    );
}

#[test]
fn a_bad_file_brings_one_error_and_its_siblings_stay() {
    let root = tempfile::tempdir().unwrap();
    for subject in ["a", "b", "c"] {
        for frame in 0..3 {
            put(
                root.path(),
                &format!("{subject}/cavity_{frame}.obj"),
                &ball(30.0 + f64::from(frame)),
            );
        }
    }
    let bad = root.path().join("b/cavity_1.obj");
    fs::write(&bad, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n").unwrap();
    let opened = open(&[root.path().to_owned()]);
    assert_eq!(ids(&opened), ["a", "c"]);
    assert_eq!(opened.errors.len(), 1);
    let error = &opened.errors[0];
    assert_eq!((error.subject.as_deref(), &error.path), (Some("b"), &bad));
    assert!(error.reason.starts_with("line 4: "), "{}", error.reason);
    assert!(error.to_string().ends_with("cavity_1.obj"));
}

#[test]
fn a_frame_with_other_faces_is_named() {
    let root = tempfile::tempdir().unwrap();
    put(root.path(), "cavity_0.obj", &ball(30.0));
    put(root.path(), "cavity_1.obj", &phantom::sphere(2, 30.0));
    let opened = open(&[root.path().to_owned()]);
    assert!(opened.study.subjects.is_empty());
    assert_eq!(opened.errors.len(), 1);
    assert_eq!(opened.errors[0].path, root.path().join("cavity_1.obj"));
    assert!(
        opened.errors[0]
            .reason
            .starts_with("frame 1 has 162 vertices")
    );
}

#[test]
fn a_manifest_rules_its_folder() {
    let root = tempfile::tempdir().unwrap();
    for frame in 0..3 {
        put(
            root.path(),
            &format!("n01/x{frame}.obj"),
            &ball(30.0 - f64::from(frame)),
        );
        put(
            root.path(),
            &format!("n02/cavity_{frame}.obj"),
            &ball(31.0 - f64::from(frame)),
        );
    }
    let manifest = root.path().join("study.toml");
    fs::write(
        &manifest,
        "name = \"Trial\"\nunits = \"mm\"\n\n[[subject]]\nid = \"one\"\nlabel = \"normal\"\ncavity = \"n01/*.obj\"\n\
         time_ms = [0, 300, 600]\nend_systole = 2\n\n[[subject]]\nid = \"two\"\nwall = \"n03/*.obj\"\n\n\
         [[subject]]\nid = \"n02\"\nend_systole = 7\ntime_ms = [0, 1]\n",
    )
    .unwrap();
    for path in [root.path().to_owned(), manifest.clone()] {
        let opened = open(&[path]);
        assert_eq!(opened.study.name, "Trial");
        assert_eq!(ids(&opened), ["one", "n02"]);
        assert_eq!(
            opened.errors[0].to_string(),
            format!(
                "line 11: no file is named by \"n03/*.obj\": {}",
                manifest.display()
            )
        );
        assert_eq!(opened.errors.len(), 1);
        let one = &opened.study.subjects[0];
        assert_eq!(one.timing.frame_times_s, Some(vec![0.0, 0.3, 0.6]));
        assert_eq!((one.end_diastole, one.end_systole), (None, Some(2)));
        assert_eq!(one.label.as_deref(), Some("normal"));
        let found = &opened.study.subjects[1];
        assert_eq!(found.end_systole, None);
        let warnings: Vec<&str> = found
            .notices
            .iter()
            .filter(|n| n.severity == Severity::Warning)
            .map(|n| n.text.as_str())
            .collect();
        assert_eq!(
            warnings,
            [
                "2 times for 3 frames: times are left out",
                "end-systole is stated at frame 7, but the last frame is 2; it is found from the volumes"
            ]
        );
    }
}

#[test]
fn centimetres_become_millimetres_with_a_notice() {
    let root = tempfile::tempdir().unwrap();
    put(root.path(), "a/cavity_0.obj", &ball(3.0));
    fs::write(root.path().join("study.toml"), "units = \"cm\"\n").unwrap();
    let opened = open(&[root.path().to_owned()]);
    let subject = &opened.study.subjects[0];
    assert_eq!(subject.unit, LengthUnit::Millimetre);
    assert_eq!(radii(&opened, 0), [30.0]);
    assert!(
        subject
            .notices
            .iter()
            .any(|n| n.text.contains("multiplied by 10"))
    );
}

#[test]
fn files_and_folders_dropped_together_are_one_study() {
    let root = tempfile::tempdir().unwrap();
    put(root.path(), "loose/endo_1.obj", &ball(20.0));
    put(root.path(), "loose/epi_1.obj", &ball(30.0));
    put(root.path(), "loose/endo_2.obj", &ball(18.0));
    put(root.path(), "folder/cavity_1.obj", &ball(30.0));
    let at = |name: &str| root.path().join(name);
    let opened = open(&[at("loose/epi_1.obj"), at("folder"), at("loose/endo_1.obj")]);
    assert_eq!(opened.errors, []);
    assert_eq!(ids(&opened), ["folder", "loose"]);
    assert_eq!(opened.study.subjects[1].sequence.surfaces().len(), 2);
    assert_eq!(opened.study.subjects[1].sequence.frame_count(), 1);
    let single = open(&[at("loose/endo_2.obj")]);
    assert_eq!(
        (ids(&single), single.study.name.as_str()),
        (vec!["endo_2"], "endo_2")
    );
}

#[test]
fn sheets_may_lie_in_folders_of_their_own() {
    let root = tempfile::tempdir().unwrap();
    for frame in 0..2 {
        put(root.path(), &format!("p1/endo/{frame}.obj"), &ball(20.0));
        put(root.path(), &format!("p1/epi/{frame}.obj"), &ball(30.0));
    }
    let opened = open(&[root.path().join("p1")]);
    assert_eq!((ids(&opened), opened.errors.len()), (vec!["p1"], 0));
    assert_eq!(
        opened.study.subjects[0].sequence.surfaces()[1].kind(),
        SurfaceKind::Epicardium
    );
}

#[test]
fn a_series_file_gives_order_and_times() {
    let root = tempfile::tempdir().unwrap();
    for (name, radius) in [("cavity_b.obj", 28.0), ("cavity_a.obj", 30.0)] {
        put(root.path(), name, &ball(radius));
    }
    let list = "{\"files\": [{\"name\": \"cavity_b.obj\", \"time\": 0.25}, {\"name\": \"cavity_a.obj\", \"time\": 0}]}";
    fs::write(root.path().join("heart.obj.series"), list).unwrap();
    for path in [root.path().to_owned(), root.path().join("heart.obj.series")] {
        let opened = open(&[path]);
        assert_eq!(opened.errors, []);
        assert_eq!(radii(&opened, 0), [30.0, 28.0]);
        let subject = &opened.study.subjects[0];
        assert_eq!(subject.sequence.surfaces()[0].kind(), SurfaceKind::Cavity);
        assert_eq!(subject.timing.frame_times_s, Some(vec![0.0, 0.25]));
    }
}

#[test]
fn subjects_of_one_name_are_told_apart() {
    let root = tempfile::tempdir().unwrap();
    for patient in ["p1", "p2"] {
        put(
            root.path(),
            &format!("{patient}/rest/cavity_0.obj"),
            &ball(30.0),
        );
    }
    assert_eq!(
        ids(&open(&[root.path().to_owned()])),
        ["p1/rest", "p2/rest"]
    );
    fs::write(
        root.path().join("study.toml"),
        "[[subject]]\nid = \"x\"\ncavity = \"p1/rest/*.obj\"\n[[subject]]\nid = \"x\"\ncavity = \"p2/rest/*.obj\"\n",
    )
    .unwrap();
    let opened = open(&[root.path().to_owned()]);
    assert_eq!(ids(&opened), ["x", "x (2)"]);
    assert!(
        opened.study.subjects[1].notices[0]
            .text
            .contains("another subject")
    );
}

#[test]
fn limits_are_errors_and_name_their_file() {
    let root = tempfile::tempdir().unwrap();
    for frame in 0..3 {
        put(root.path(), &format!("cavity_{frame}.obj"), &ball(30.0));
    }
    let opened = |limits: Limits| {
        open_paths(&[root.path().to_owned()], &limits, &Progress::default()).unwrap()
    };
    let few_frames = opened(Limits {
        frames: 2,
        ..Limits::default()
    });
    assert_eq!(few_frames.errors[0].reason, "3 frames; at most 2 are read");
    let few_bytes = opened(Limits {
        file_bytes: 100,
        ..Limits::default()
    });
    assert_eq!(few_bytes.errors.len(), 3);
    assert!(few_bytes.errors[0].reason.ends_with("at most 100 are read"));
}

#[test]
fn what_is_not_there_or_holds_nothing_is_an_error() {
    let root = tempfile::tempdir().unwrap();
    fs::write(root.path().join("notes.txt"), "x").unwrap();
    let missing = root.path().join("missing.obj");
    let opened = open(&[root.path().to_owned(), missing.clone()]);
    assert_eq!(opened.errors[0].path, root.path());
    assert!(
        opened.errors[0]
            .reason
            .starts_with("no meshes found (obj, ply")
    );
    assert_eq!(
        (&opened.errors[1].path, opened.errors[1].reason.as_str()),
        (&missing, "there is no such file")
    );
    let text = open(&[root.path().join("notes.txt")]);
    assert!(
        text.errors[0].reason.starts_with("not a mesh format"),
        "{text:?}"
    );
}

#[test]
fn opening_stops_when_asked() {
    let root = tempfile::tempdir().unwrap();
    put(root.path(), "cavity_0.obj", &ball(30.0));
    let progress = Progress::default();
    progress.stop();
    let outcome = open_paths(&[root.path().to_owned()], &Limits::default(), &progress);
    assert_eq!(outcome.err(), Some(Stopped));
}

#[test]
fn a_bar_that_is_done_is_full() {
    let root = tempfile::tempdir().unwrap();
    put(root.path(), "a/endo_0.obj", &ball(20.0));
    put(root.path(), "a/epi_0.obj", &ball(30.0));
    put(root.path(), "b/cavity_0.obj", &ball(30.0));
    let progress = Progress::default();
    open_paths(&[root.path().to_owned()], &Limits::default(), &progress).unwrap();
    assert_eq!(progress.fraction(), 1.0);
}

#[cfg(unix)]
#[test]
fn a_folder_that_holds_itself_ends() {
    let root = tempfile::tempdir().unwrap();
    put(root.path(), "a/cavity_0.obj", &ball(30.0));
    std::os::unix::fs::symlink(root.path(), root.path().join("a/again")).unwrap();
    assert_eq!(ids(&open(&[root.path().to_owned()])), ["a"]);
}

#[test]
fn findings_stand_with_their_subject_warnings_first() {
    let root = tempfile::tempdir().unwrap();
    let still = ball(30.0);
    let mut points: Vec<Point3> = still.vertices().to_vec();
    points.reverse();
    let shuffled = TriMesh::new(points, still.faces().clone()).unwrap();
    put(root.path(), "cavity_0.obj", &still);
    put(root.path(), "cavity_1.obj", &shuffled);
    let opened = open(&[root.path().to_owned()]);
    let notices = &opened.study.subjects[0].notices;
    assert_eq!(notices[0].severity, Severity::Warning);
    assert!(notices.iter().any(|n| n.text == "cavity: closed"));
}

#[test]
fn what_can_be_opened_is_told_by_its_name() {
    let folder = tempfile::tempdir().unwrap();
    assert!(looks_openable(folder.path()));
    for name in [
        "a.OBJ",
        "study.toml",
        "x.pvd",
        "x.vtk.series",
        "a.glb",
        "a.csv",
    ] {
        assert!(looks_openable(Path::new(name)), "{name}");
    }
    for name in ["a.txt", "a", "a.nii.gz"] {
        assert!(!looks_openable(Path::new(name)), "{name}");
    }
}
