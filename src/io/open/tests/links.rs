//! Links and pipes among the files of a study.

use super::habits::told;
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
    assert!(told(
        &opened,
        "everything: a link out of the study, to /, is not followed"
    ));
    assert!(told(&opened, "b: a link out of the study"));
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
