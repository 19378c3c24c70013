//! What is said of patches, in the window and in figures alike.

use crate::analysis::segments::{Level, Segment};
use crate::analysis::thickening::{Extent, Patch, Thickening};
use crate::analysis::verdicts::{Finding, NotAssessed, Verdict};
use crate::picture::medial::PatchLook;

/// Share of a patch below which a segment goes without saying.
const LEAST_OF_PATCH: f64 = 0.05;
/// What parts of the wall that do not thicken may be called. They are found in every heart where the wall thickens
/// unevenly; only the verdict on the whole heart says that they are abnormal.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum PatchStanding {
    /// Not judged yet.
    #[default]
    Untold,
    /// The verdict on the heart is an abnormal patch.
    Abnormal,
    /// It is something else: they are places that thicken little.
    ThickensLittle,
}

impl PatchStanding {
    /// What the verdict on a heart lets its parts be called: a patch is abnormal only where the verdict is that the
    /// heart has one.
    pub fn of(verdict: Option<&Result<Verdict, NotAssessed>>) -> Self {
        match verdict {
            None => Self::Untold,
            Some(Ok(verdict)) if verdict.finding == Finding::Patch => Self::Abnormal,
            Some(_) => Self::ThickensLittle,
        }
    }

    /// How the borders of these parts are drawn.
    pub fn look(self) -> PatchLook {
        match self {
            Self::ThickensLittle => PatchLook::Faint,
            Self::Untold | Self::Abnormal => PatchLook::Found,
        }
    }

    /// What one of them is called.
    pub fn part(self) -> &'static str {
        match self {
            Self::Untold | Self::Abnormal => "Patch",
            Self::ThickensLittle => "Place",
        }
    }
}

/// "1 abnormal patch · 31 % of the LV", or what else the verdict lets it be called.
pub fn patch_heading(found: &Thickening, standing: PatchStanding) -> String {
    match (found.extent, found.patches.as_slice()) {
        (Extent::HardlyAnywhere, _) => "Hardly any thickening anywhere".to_owned(),
        (_, []) => "No patch".to_owned(),
        (_, patches) => {
            let share: f64 = patches.iter().map(|patch| patch.share).sum();
            let [one, more] = match standing {
                PatchStanding::Untold => ["patch", "patches"],
                PatchStanding::Abnormal => ["abnormal patch", "abnormal patches"],
                PatchStanding::ThickensLittle => ["place thickens little", "places thicken little"],
            };
            let count = patches.len();
            let what = if count == 1 { one } else { more };
            format!("{count} {what} · {} of the LV", percent(share))
        }
    }
}

/// What could have been missed: "Patches from 2.1 cm² on (2 % of the LV) would have been found"; empty where nothing
/// is known of it.
pub fn smallest_words(found: &Thickening) -> String {
    let Some(least) = found.smallest else {
        return String::new();
    };
    let share = format!("{:.1} % of the LV", 100.0 * least.share);
    match least.area_cm2 {
        Some(area) => format!(
            "Patches from {} on ({share}) would have been found",
            area_text(area)
        ),
        None => format!("Patches from {share} on would have been found"),
    }
}

/// "Patch 1", "Place 1": a part of the wall by its place in the list.
pub fn part_name(standing: PatchStanding, index: usize) -> String {
    format!("{} {}", standing.part(), index + 1)
}

/// What the whole wall does, in a sentence.
pub fn extent_words(found: &Thickening) -> String {
    let well = percent(found.well.exp() - 1.0);
    match found.extent {
        Extent::HardlyAnywhere => {
            format!(
                "Even the part that works best thickens by {well}: no part stands out as a patch"
            )
        }
        Extent::Everywhere => format!("All of the wall thickens, where it works well by {well}"),
        Extent::AllButPatches => format!("The rest of the wall thickens by {well}"),
    }
}

/// The walls that a patch touches, the largest share first, each with its levels: "basal–mid
/// anteroseptal, apical septal and inferior, apex".
pub fn segment_words(patch: &Patch) -> String {
    let mut walls: Vec<(&str, Vec<Level>)> = Vec::new();
    let told = (patch.segments.iter()).filter(|part| part.of_patch >= LEAST_OF_PATCH);
    for part in told {
        let wall = wall_of(part.segment);
        let level = part.segment.level();
        match walls.iter_mut().find(|(other, _)| *other == wall) {
            Some((_, levels)) => levels.push(level),
            None => walls.push((wall, vec![level])),
        }
    }
    // Walls of the same levels are said together.
    let mut groups: Vec<(String, Vec<&str>)> = Vec::new();
    for (wall, levels) in &mut walls {
        let levels = level_words(levels);
        match groups.iter_mut().find(|(other, _)| *other == levels) {
            Some((_, walls)) => walls.push(wall),
            None => groups.push((levels, vec![wall])),
        }
    }
    // The apex has no wall; it is said last.
    groups.sort_by_key(|(levels, _)| levels == Level::Apex.name());
    let words = groups.into_iter().map(|(levels, walls)| {
        if levels == Level::Apex.name() {
            levels
        } else {
            format!("{levels} {}", listed(&walls))
        }
    });
    words.collect::<Vec<_>>().join(", ")
}

/// "mid", "basal–apical", "basal and apical".
fn level_words(levels: &mut [Level]) -> String {
    levels.sort();
    match *levels {
        [] => String::new(),
        [only] => only.name().to_owned(),
        [first, .., last] => {
            let whole = last.index() - first.index() + 1 == levels.len();
            let between = if whole { "–" } else { " and " };
            format!("{}{between}{}", first.name(), last.name())
        }
    }
}

/// "septal, lateral and inferior".
fn listed(walls: &[&str]) -> String {
    match walls {
        [] => String::new(),
        [only] => (*only).to_owned(),
        [rest @ .., last] => format!("{} and {last}", rest.join(", ")),
    }
}

/// The name without its level: "anteroseptal".
fn wall_of(segment: Segment) -> &'static str {
    let name = segment.name();
    name.split_once(' ').map_or(name, |(_, wall)| wall)
}

/// No more digits than an area deserves.
pub fn area_text(area_cm2: f64) -> String {
    if area_cm2 < 9.95 {
        format!("{area_cm2:.1} cm²")
    } else {
        format!("{area_cm2:.0} cm²")
    }
}

/// "31 %".
pub fn percent(share: f64) -> String {
    format!("{:.0} %", 100.0 * share)
}

/// Never more certain than two digits can tell.
pub fn probability_words(probability: f64) -> String {
    if probability > 0.99 {
        "over 99 %".to_owned()
    } else if probability < 0.01 {
        "under 1 %".to_owned()
    } else {
        percent(probability)
    }
}

/// With a capital at its beginning.
pub fn sentence(words: &str) -> String {
    let mut letters = words.chars();
    match letters.next() {
        Some(first) => first.to_uppercase().chain(letters).collect(),
        None => String::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::thickening::{PatchSegment, TemporalConsistency};
    use crate::mesh::Point3;

    fn patch(segments: &[u8]) -> Patch {
        let part = |number: &u8| PatchSegment {
            segment: Segment::new(*number).unwrap(),
            of_segment: 0.5,
            of_patch: 1.0 / segments.len() as f64,
        };
        Patch {
            atoms: Vec::new(),
            area: 1.0,
            area_cm2: None,
            share: 0.1,
            segments: segments.iter().map(part).collect(),
            centroid: Point3::origin(),
            border: Vec::new(),
            thickening: 0.0,
            confidence: 1.0,
            path: Vec::new(),
            temporal_consistency: TemporalConsistency::default(),
        }
    }

    #[test]
    fn segments_are_said_as_a_person_would() {
        let said = |segments: &[u8]| segment_words(&patch(segments));
        assert_eq!(said(&[8]), "mid anteroseptal");
        assert_eq!(said(&[2, 8]), "basal–mid anteroseptal");
        assert_eq!(said(&[1, 13]), "basal and apical anterior");
        assert_eq!(said(&[7, 17, 1, 13]), "basal–apical anterior, apex");
        let wide = said(&[8, 2, 14, 16, 15, 9]);
        assert_eq!(
            wide,
            "basal–mid anteroseptal, apical septal, lateral and inferior, mid inferoseptal"
        );
        assert_eq!(said(&[]), "");
    }

    #[test]
    fn no_probability_is_certain() {
        assert_eq!(probability_words(0.9999), "over 99 %");
        assert_eq!(probability_words(0.83), "83 %");
        assert_eq!(probability_words(0.0), "under 1 %");
        assert_eq!(sentence("abnormal patch"), "Abnormal patch");
        assert_eq!(sentence(""), "");
    }
}
