//! What a listener hears of subjects while others are still to be read.

use std::sync::Mutex;

use super::*;
use crate::study::ReadSubject;

/// Has one subject read first, and enough after so many.
struct Listener {
    wanted: &'static str,
    enough: usize,
    planned: Mutex<Vec<(String, Option<String>)>>,
    heard: Mutex<Vec<String>>,
}

impl OpenListener for Listener {
    fn planned(&self, study: Study, bytes: u64) {
        assert!(study.subjects.is_empty() && bytes > 1_000);
        let unread = study.unread.into_iter();
        *self.planned.lock().unwrap() = unread.map(|u| (u.id, u.label)).collect();
    }

    fn read(&self, (id, subject): ReadSubject) {
        let failed = if subject.is_none() { "!" } else { "" };
        self.heard.lock().unwrap().push(id + failed);
    }

    fn wanted(&self) -> Option<String> {
        let heard = self.heard.lock().unwrap();
        (!heard.is_empty()).then(|| self.wanted.to_owned())
    }

    fn enough(&self) -> bool {
        self.heard.lock().unwrap().len() >= self.enough
    }

    fn at_a_time(&self, _: usize) -> usize {
        1
    }
}

fn heard(enough: usize) -> (Opened, Listener) {
    let root = tempfile::tempdir().unwrap();
    for subject in 1..=5 {
        for frame in 0..2 {
            let radius = f64::from(30 + subject - frame);
            let name = format!("p{subject}/endo_{frame}.obj");
            put(root.path(), &name, &ball(radius));
        }
    }
    fs::write(root.path().join("p2/endo_1.obj"), "v 0 0 zero\n").unwrap();
    let listener = Listener {
        wanted: "p4",
        enough,
        planned: Mutex::default(),
        heard: Mutex::default(),
    };
    let paths = [root.path().to_owned()];
    let limits = Limits::default();
    let opened = open_paths_in_stages(&paths, &limits, &Progress::default(), &listener).unwrap();
    (opened, listener)
}

#[test]
fn the_first_subject_comes_first_then_the_one_that_is_wanted_and_the_study_has_their_order() {
    let (opened, listener) = heard(usize::MAX);
    let planned = listener.planned.into_inner().unwrap();
    let planned: Vec<String> = planned.into_iter().map(|(id, _)| id).collect();
    assert_eq!(planned, ["p1", "p2", "p3", "p4", "p5"]);
    let heard = listener.heard.into_inner().unwrap();
    assert_eq!(heard, ["p1", "p4", "p2!", "p3", "p5"]);
    assert_eq!(ids(&opened), ["p1", "p3", "p4", "p5"]);
    assert_eq!(opened.errors.len(), 1);
    assert!(opened.study.unread.is_empty());
}

#[test]
fn whoever_has_enough_keeps_what_was_read_and_is_told_what_was_not() {
    let (opened, _) = heard(2);
    assert_eq!(ids(&opened), ["p1", "p4"]);
    let stopped = "reading was stopped: 3 of 5 subjects were not read";
    assert!(opened.notices.iter().any(|notice| notice.text == stopped));
    // What holds for the cohort is told of those that were read.
    let alike = "both subjects have the same faces: their vertices correspond";
    assert!(opened.notices.iter().any(|notice| notice.text == alike));
}

#[test]
fn a_file_of_several_subjects_is_read_for_each() {
    let root = tempfile::tempdir().unwrap();
    put(root.path(), "all.obj", &ball(40.0));
    let subject = |id: u8| format!("[[subject]]\nid = \"s{id}\"\nendo = \"all.obj\"\n");
    let manifest: String = (0..9).map(subject).collect();
    fs::write(root.path().join("study.toml"), manifest).unwrap();
    let opened = open(&[root.path().join("study.toml")]);
    assert_eq!(opened.errors, []);
    assert_eq!(opened.study.subjects.len(), 9);
    assert_eq!(radii(&opened, 8), [40.0]);
    // What lists its faces alike holds them once.
    let faces = |subject: usize| opened.study.subjects[subject].sequence.surfaces()[0].faces();
    assert!(Arc::ptr_eq(faces(0), faces(8)));
}
