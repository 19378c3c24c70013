//! Where real data lies, for the tests that use it. It is no part of the project: where the folder is absent, a test says
//! that it is skipped.

use std::path::{Path, PathBuf};

use cardiomorph::analysis::measures::measure_subject;
use cardiomorph::analysis::medial::{MedialBeat, MedialParams, medial_beat};
use cardiomorph::analysis::segments::long_axis;
use cardiomorph::analysis::thickening::{Thickening, ThickeningParams, phases, thickening};
use cardiomorph::io::{Limits, open_paths};
use cardiomorph::progress::Progress;
use cardiomorph::study::{Study, Subject};

/// A path under `data`, or `None` with a message where the shared folder is absent.
pub fn shared_data(place: &str) -> Option<PathBuf> {
    let shared = std::env::var_os("CARDIOMORPH_SHARED").map_or_else(
        || Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared"),
        PathBuf::from,
    );
    let path = shared.join("data").join(place);
    if !path.exists() {
        println!("skipped: {} is absent", path.display());
        return None;
    }
    Some(path)
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
