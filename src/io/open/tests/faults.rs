//! What is wrong, missing, too large or stopped, and what can be opened at all.

use super::*;

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
    assert_eq!(few_frames.errors[0].reason, "3 frames; the limit is 2");
    let few_bytes = opened(Limits {
        file_bytes: 100,
        ..Limits::default()
    });
    assert_eq!(few_bytes.errors.len(), 3);
    assert!(few_bytes.errors[0].reason.ends_with("the limit is 100"));
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
    let twice = open(&[root.path().to_owned(), root.path().join("a/again")]);
    assert_eq!((ids(&twice), twice.errors.len()), (vec!["a"], 0));
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
