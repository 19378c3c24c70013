//! Rows of every heart that can be assessed, words for the others, and nothing left behind by a stop.

use std::sync::Arc;

use super::*;
use crate::engine::export::write_files;
use crate::engine::store::StoreOptions;
use crate::study::built_in::{BuiltInParams, cohort};
use crate::study::{MeshSequence, SurfaceKind};

/// A well heart, one with a patch, and one of which only the endocardium is there.
fn study() -> Arc<Study> {
    let params = BuiltInParams {
        vertices: 600,
        ..BuiltInParams::default()
    };
    let whole = cohort(&params).unwrap().study;
    let ill = whole
        .subjects
        .iter()
        .find(|s| s.id.starts_with('P'))
        .unwrap();
    let mut cavity = (*whole.subjects[1]).clone();
    let endo = cavity.sequence.surface(SurfaceKind::Endocardium).unwrap();
    cavity.sequence = MeshSequence::new(vec![endo.clone()]).unwrap();
    Arc::new(Study {
        subjects: vec![
            Arc::clone(&whole.subjects[0]),
            Arc::new(cavity),
            Arc::clone(ill),
        ],
        ..whole
    })
}

fn store() -> Store {
    Store::start(StoreOptions::default()).unwrap()
}

fn rows(path: &Path) -> Vec<csv::StringRecord> {
    let mut reader = csv::Reader::from_path(path).unwrap();
    reader.records().map(Result::unwrap).collect()
}

#[test]
fn a_heart_without_a_wall_is_said_to_be_unassessed_and_the_others_have_their_rows() {
    let (study, folder) = (study(), tempfile::tempdir().unwrap());
    let settings = VerdictQuery::default();
    let mut tables = WallTables::new(&study, folder.path()).unwrap();
    tables
        .assess(&store(), &study, &settings, &Progress::default())
        .unwrap();
    let (files, walls) = tables.files(folder.path());
    assert_eq!(walls.unassessed.len(), 1);
    assert_eq!(walls.unassessed[0].subject, 1);
    let subjects = walls.summary["subjects"].as_array().unwrap().clone();
    assert_eq!(subjects[0]["assessed"], true);
    assert_eq!(subjects[0]["patches"].as_array().unwrap().len(), 0);
    assert_eq!(subjects[1]["assessed"], false);
    assert!(
        subjects[1]["reason"]
            .as_str()
            .unwrap()
            .starts_with("no wall: ")
    );
    assert!(subjects[2]["patches"][0]["share"].as_f64().unwrap() > 0.02);
    assert_eq!(walls.summary["parameters"]["patch_core"], 0.2);
    write_files(files.into()).unwrap();
    let atoms = rows(&folder.path().join("atoms.csv"));
    let per_frame = |subject: usize| {
        let sequence = &study.subjects[subject].sequence;
        let endo = sequence.surface(SurfaceKind::Endocardium).unwrap();
        endo.faces().vertex_count() * sequence.frame_count()
    };
    assert_eq!(atoms.len(), per_frame(0) + per_frame(2));
    let ids = |name: &str| {
        let mut ids: Vec<String> = (rows(&folder.path().join(name)).iter())
            .map(|row| row[0].to_owned())
            .collect();
        ids.dedup();
        ids
    };
    let [well, ill] = [0, 2].map(|subject: usize| study.subjects[subject].id.clone());
    assert_eq!(ids("patches.csv"), std::slice::from_ref(&ill));
    assert_eq!(ids("patch_segments.csv"), std::slice::from_ref(&ill));
    assert_eq!(ids("segments.csv"), [well, ill]);
    let listed = rows(&folder.path().join("patches.csv"))[0][4].to_owned();
    let rows_of_first: Vec<String> = (rows(&folder.path().join("patch_segments.csv")).iter())
        .filter(|row| &row[1] == "0")
        .map(|row| row[2].to_owned())
        .collect();
    assert_eq!(rows_of_first.join(" "), listed, "the same list, a row each");
    assert_eq!(rows(&folder.path().join("segments.csv")).len(), 34);
}

#[test]
fn a_stop_before_the_first_subject_leaves_no_file() {
    let (study, folder) = (study(), tempfile::tempdir().unwrap());
    let progress = Progress::default();
    progress.stop();
    let mut tables = WallTables::new(&study, folder.path()).unwrap();
    let stopped = tables.assess(&store(), &study, &VerdictQuery::default(), &progress);
    assert!(matches!(stopped, Err(Interrupted::Stopped)));
    assert!(tables.partial_files(folder.path()).is_empty());
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
}

#[test]
fn a_stop_leaves_the_rows_of_the_subjects_before_under_names_that_say_so() {
    let (study, folder) = (study(), tempfile::tempdir().unwrap());
    let mut tables = WallTables::new(&study, folder.path()).unwrap();
    let first = Arc::new(Study {
        subjects: study.subjects[..1].to_vec(),
        ..Study::clone(&study)
    });
    let settings = VerdictQuery::default();
    let (store, progress) = (store(), Progress::default());
    // The first subject's answer is known; whatever is asked then is stopped.
    let wall = WallThickeningQuery {
        subject: 0,
        settings: settings.thickening,
    };
    let answer = store.answer(&first, &wall, &progress).unwrap();
    tables.rows.add(&study, 0, Ok(answer)).unwrap();
    let stopped = tables.rows.add(&study, 1, Err(Interrupted::Stopped));
    assert!(matches!(stopped, Err(Interrupted::Stopped)));
    write_files(tables.partial_files(folder.path())).unwrap();
    let mut names: Vec<String> = std::fs::read_dir(folder.path())
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    let expected = ["atoms", "patch_segments", "patches", "segments"];
    assert_eq!(
        names,
        expected.map(|name| format!("{name}_of_1_of_3_subjects.csv"))
    );
    assert_eq!(rows(&folder.path().join(&names[3])).len(), 17);
}

#[test]
fn a_folder_that_cannot_be_is_named_before_anything_is_computed() {
    let folder = tempfile::tempdir().unwrap();
    let taken = folder.path().join("taken");
    std::fs::write(&taken, "a file").unwrap();
    let words = WallTables::new(&study(), &taken).unwrap_err().to_string();
    assert!(words.starts_with("cannot write: "), "{words}");
}
