//! Links and pipes among the files of a study.

use super::habits::reports;
use super::*;
use std::os::unix::fs::symlink;

#[test]
fn a_link_to_nowhere_is_named_and_costs_its_subject_alone() {
    let root = tempfile::tempdir().unwrap();
    for frame in 0..2 {
        put(
            root.path(),
            &format!("a/endo_{frame}.obj"),
            &ball(20.0 - f64::from(frame)),
        );
        put(root.path(), &format!("a/epi_{frame}.obj"), &ball(30.0));
        put(
            root.path(),
            &format!("b/endo_{frame}.obj"),
            &ball(21.0 - f64::from(frame)),
        );
    }
    symlink("nowhere", root.path().join("a/endo_2.obj")).unwrap();
    let opened = open(&[root.path().to_owned()]);
    assert_eq!(ids(&opened), ["b"]);
    assert_eq!(opened.errors.len(), 1);
    assert_eq!(opened.errors[0].path, root.path().join("a/endo_2.obj"));
    assert_eq!(
        opened.errors[0].reason,
        "a link to nowhere, which is not there"
    );
    let toml = "[[subject]]\nid = \"a\"\nendo = \"a/endo_*.obj\"\n";
    fs::write(root.path().join("study.toml"), toml).unwrap();
    let opened = open(&[root.path().to_owned()]);
    assert!(
        opened.errors[0]
            .reason
            .contains("endo_2.obj: a link to nowhere"),
        "{:?}",
        opened.errors
    );
}

#[test]
fn links_out_of_a_study_and_pipes_are_told_and_not_followed() {
    let (root, store) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
    put(root.path(), "a/endo_0.obj", &ball(20.0));
    put(store.path(), "endo_0.obj", &ball(21.0));
    symlink("/", root.path().join("everything")).unwrap();
    symlink(store.path(), root.path().join("b")).unwrap();
    let made = std::process::Command::new("mkfifo")
        .arg(root.path().join("a/endo_1.obj"))
        .status();
    let opened = open(&[root.path().to_owned()]);
    assert!(reports(
        &opened,
        "everything: a link out of the study, to /, is not followed unless asked for"
    ));
    assert!(reports(&opened, "b: a link out of the study"));
    if made.is_ok_and(|status| status.success()) {
        assert!(
            opened.errors[0].reason.contains("pipe"),
            "{:?}",
            opened.errors
        );
        assert!(ids(&opened).is_empty());
    }
    let asked = open(&[root.path().join("b")]);
    assert_eq!(
        asked.study.subjects.len(),
        1,
        "a link that is named is followed"
    );
}

#[test]
fn links_out_of_a_study_are_followed_where_that_is_asked_for() {
    let (root, store) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
    for frame in 0..2 {
        put(
            store.path(),
            &format!("endo_{frame}.obj"),
            &ball(21.0 - f64::from(frame)),
        );
    }
    symlink(store.path(), root.path().join("b")).unwrap();
    symlink(root.path(), root.path().join("again")).unwrap();
    let asked = Limits {
        follow_links: true,
        ..Limits::default()
    };
    let opened = open_paths(&[root.path().to_owned()], &asked, &Progress::default()).unwrap();
    assert_eq!(ids(&opened), ["b"], "{:?}", opened.errors);
    assert_eq!(opened.study.subjects[0].sequence.frame_count(), 2);
}

#[test]
fn a_manifest_and_a_list_follow_links_out_of_the_study_no_more_than_a_folder() {
    let (root, store) = (tempfile::tempdir().unwrap(), tempfile::tempdir().unwrap());
    put(store.path(), "endo_0.obj", &ball(21.0));
    symlink(store.path(), root.path().join("b")).unwrap();
    let elsewhere = store.path().join("endo_0.obj").display().to_string();
    for (named, follow_links, read) in [
        ("b/endo_0.obj", false, false),
        ("b/endo_*.obj", false, false),
        ("b/endo_0.obj", true, true),
        (elsewhere.as_str(), false, true),
    ] {
        let toml = format!("[[subject]]\nid = \"a\"\nendo = {named:?}\n");
        fs::write(root.path().join("study.toml"), toml).unwrap();
        let limits = Limits {
            follow_links,
            ..Limits::default()
        };
        let opened = open_paths(&[root.path().to_owned()], &limits, &Progress::default()).unwrap();
        assert_eq!(opened.study.subjects.len(), usize::from(read), "{named}");
        let reports = |text: &str| {
            opened
                .errors
                .iter()
                .any(|error| error.reason.contains(text))
        };
        assert_eq!(
            reports("a link out of the study"),
            !read,
            "{named}: {:?}",
            opened.errors
        );
    }
    fs::remove_file(root.path().join("study.toml")).unwrap();
    let list =
        "{\"file-series-version\":\"1.0\",\"files\":[{\"name\":\"b/endo_0.obj\",\"time\":0}]}";
    fs::write(root.path().join("endo.obj.series"), list).unwrap();
    let opened = open(&[root.path().to_owned()]);
    assert!(
        opened.errors[0].reason.contains("a link out of the study"),
        "{:?}",
        opened.errors
    );
}
