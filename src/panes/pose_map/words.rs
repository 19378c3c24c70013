//! The words of the pose map.

use crate::engine::{PoseMapQuery, Topic};
use crate::panes::scatter_map::{MapWords, play_command, stress_words};

/// The words of the map.
pub static POSE_MAP: MapWords = MapWords {
    job: Topic::of::<PoseMapQuery>(),
    name: "Pose map",
    item: "Poses",
    empty: "No poses",
    what: "Every pose of every subject is a point here; similar poses lie near each other.",
    none: "The pose map could not be computed",
    hints: &["Click to play this subject from this pose"],
    command: play_command,
};

/// How well the map fits, with what that means.
pub fn pose_map_note(stress: Option<f64>, neighbours: Option<usize>) -> [String; 2] {
    let stress = stress.map(|stress| format!("stress {stress:.2}"));
    let neighbours = neighbours.map(|neighbours| format!("{neighbours} neighbours"));
    let parts: Vec<String> = stress.into_iter().chain(neighbours).collect();
    [
        parts.join(" · "),
        format!("{} {EXPLANATION}", stress_words()),
    ]
}

const EXPLANATION: &str = "Only distances between points can be interpreted; the axes have no unit. \
                           Filled marks are end-diastole, open ones end-systole.";
