//! The words of the medial map.

use crate::engine::{MedialMapQuery, Topic};
use crate::panes::scatter_map::{MapWords, play_command, stress_words};

/// The words of the map.
pub static MEDIAL_MAP: MapWords = MapWords {
    job: Topic::of::<MedialMapQuery>(),
    name: "Medial map",
    item: "Medial path",
    empty: "No poses",
    what: "The akinetic region of each wall is a path here: poses of a patch have small \
           distances, those of a wall that thickens large ones.",
    none: "The medial map could not be computed",
    hints: &["Click to play this subject from this pose"],
    command: play_command,
};

/// How well the map fits, with what that means; `frame` are the axes in which subjects are compared.
pub fn medial_map_note(stress: Option<f64>, frame: &str) -> [String; 2] {
    let stress = stress.map(|stress| format!("stress {stress:.2}"));
    [
        stress.unwrap_or_default(),
        format!("{EXPLANATION} {}\nCompared by {frame}.", stress_words()),
    ]
}

const EXPLANATION: &str = "A point is a step of the beat: mean position, mean thickness ratio and \
                           mean normal of the medial atoms that do not thicken in it, of each patch \
                           or, without one, of the whole wall. Filled marks begin at \
                           end-diastole, open ones at end-systole; the axes have no unit.";

/// What the hover card says of a step: the patch with its mean thickness ratio, and how far apart the
/// poses of its path are.
pub fn medial_facts(patch: Option<usize>, ratio: f64, mean_distance: Option<f64>) -> Vec<String> {
    let region = match patch {
        Some(patch) => format!("Patch {}", patch + 1),
        None => "Akinetic region".to_owned(),
    };
    let ratio = format!("{region}: thickness ratio PT {ratio:.2}, mean over the step");
    let distance =
        mean_distance.map(|distance| format!("Mean pose distance of this path {distance:.2}"));
    [Some(ratio), distance].into_iter().flatten().collect()
}
