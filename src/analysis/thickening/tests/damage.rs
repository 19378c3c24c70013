//! What cannot be answered, and "stop".

use super::*;
use crate::progress::Stopped;

#[test]
fn damage_is_refused_with_its_numbers() {
    let params = ThickeningParams::default().check().unwrap();
    let run = |beat: &MedialBeat| {
        thickening(beat, &measures(0, 1), None, &params, &Progress::default()).unwrap_err()
    };
    let good = beat(&CURVE, |_| WELL);
    let one = MedialBeat {
        frames: good.frames[..1].to_vec(),
        ..good.clone()
    };
    assert_eq!(
        run(&one).to_string(),
        "1 pose; thickening needs at least two"
    );
    let mut bad = good.clone();
    bad.frames[2].atoms[7].radius = f64::NAN;
    assert_eq!(run(&bad).to_string(), "atom 7 of pose 2 has radius NaN");
    bad.frames[2].atoms[7].radius = 0.0;
    assert_eq!(run(&bad).to_string(), "atom 7 of pose 2 has radius 0");
    bad.frames[2].atoms.pop();
    let count = good.regular.len();
    let expected = format!("pose 2 has {} atoms where {count} are expected", count - 1);
    assert_eq!(run(&bad).to_string(), expected);
    let mut ends = good.clone();
    ends.regular[9..].fill(false);
    let expected = format!(
        "only 9 of {count} atoms are regular; at least {} are needed",
        count / 2
    );
    assert_eq!(run(&ends).to_string(), expected);
    let mut flat = good;
    for frame in &mut flat.frames {
        frame
            .atoms
            .iter_mut()
            .for_each(|atom| atom.position = Point3::origin());
    }
    assert_eq!(run(&flat), ThickeningError::NoArea);
}

#[test]
fn settings_out_of_range_are_refused_by_name() {
    let params = |change: fn(&mut ThickeningParams)| {
        let mut params = ThickeningParams::default();
        change(&mut params);
        params.check().map(|_| ()).unwrap_err().to_string()
    };
    let said = params(|p| p.core_threshold = f64::NAN);
    assert_eq!(said, "core threshold must be between 0 and 1, not NaN");
    let said = params(|p| p.extent_threshold = 0.1);
    assert_eq!(
        said,
        "the extent threshold, 0.1, must not be below the core threshold, 0.2"
    );
}

#[test]
fn a_stopped_search_says_so() {
    let progress = Progress::default();
    progress.stop();
    let params = ThickeningParams::default().check().unwrap();
    let stopped = thickening(
        &beat(&CURVE, |_| WELL),
        &measures(0, 3),
        None,
        &params,
        &progress,
    );
    assert_eq!(stopped, Err(ThickeningError::Stopped(Stopped)));
}
