//! Where real data lies, for the tests that use it. It is no part of the project: where the folder is absent, they report
//! themselves as ignored (`build.rs` looks for it).

use std::path::{Path, PathBuf};

use cardiomorph::analysis::measures::measure_subject;
use cardiomorph::analysis::medial::{MedialBeat, MedialParams, medial_beat};
use cardiomorph::analysis::segments::long_axis;
use cardiomorph::analysis::thickening::{Thickening, ThickeningParams, phases, thickening};
use cardiomorph::io::{Limits, open_paths};
use cardiomorph::progress::Progress;
use cardiomorph::study::{Study, Subject};

/// A path of the shared folder, which must exist.
pub fn shared(place: &str) -> PathBuf {
    let path = Path::new(env!("SHARED_FOLDER")).join(place);
    assert!(path.exists(), "{} is absent", path.display());
    path
}

/// A path under `data` of the shared folder.
pub fn shared_data(place: &str) -> PathBuf {
    shared(&format!("data/{place}"))
}

/// The study at a path, which must open without an error.
pub fn opened(path: PathBuf) -> Study {
    let opened = open_paths(&[path], &Limits::default(), &Progress::default()).unwrap();
    assert!(opened.errors.is_empty(), "{:?}", opened.errors);
    opened.study
}

/// Atoms of a heart and what they do over the beat, by the settings that the program begins with.
pub fn thickened(subject: &Subject) -> Result<(MedialBeat, Thickening), String> {
    let (progress, measures) = (Progress::default(), measure_subject(subject));
    let medial = MedialParams::default().check().unwrap();
    let beat = medial_beat(subject, &medial, &progress).map_err(|error| error.to_string())?;
    let axis = long_axis(subject, phases(&beat, &measures)[0]).ok();
    let params = ThickeningParams::default().check().unwrap();
    let found = thickening(&beat, &measures, axis.as_ref(), &params, &progress)
        .map_err(|error| error.to_string())?;
    Ok((beat, found))
}

#[test]
fn the_folder_of_real_data_is_where_it_was() {
    let there = Path::new(env!("SHARED_FOLDER")).join("data").exists();
    assert_eq!(
        there,
        cfg!(shared_data),
        "the folder came or went since the tests were built: `touch tests/it/build.rs`"
    );
}
