//! What is said of patches, in the window and in figures alike.

use crate::analysis::segments::{Level, Segment};
use crate::analysis::thickening::{Patch, Thickening, WallThickening};
use crate::analysis::verdicts::{Finding, NotAssessed, Verdict};
use crate::picture::medial::PatchLook;
use crate::report::PatchRow;
use crate::units::LengthUnit;

/// Share of a patch below which a segment is not named.
const MIN_OF_PATCH: f64 = 0.05;
/// What regions of low thickening are called. They are detected in every heart with heterogeneous thickening; only the
/// verdict on the whole heart makes them abnormal.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum PatchStanding {
    /// There is no verdict yet.
    #[default]
    NoVerdict,
    /// The verdict on the heart is an abnormal patch.
    AbnormalPatch,
    /// It is a patch of low thickening, which nothing has told to be abnormal.
    UnclassifiedPatch,
    /// It is something else: they are regions of low thickening.
    RegionOnly,
}

impl PatchStanding {
    /// What the verdict on a heart lets its parts be called: a patch is abnormal only where the verdict is that the
    /// heart has one.
    pub fn of(verdict: Option<&Result<Verdict, NotAssessed>>) -> Self {
        match verdict {
            None => Self::NoVerdict,
            Some(Ok(verdict)) if verdict.finding == Finding::AbnormalPatch => Self::AbnormalPatch,
            // The wall is told, but no classifier can say what of it is abnormal.
            Some(Err(NotAssessed::NotComparable(_))) => Self::UnclassifiedPatch,
            Some(_) => Self::RegionOnly,
        }
    }

    /// How the borders of these parts are drawn.
    pub fn look(self) -> PatchLook {
        match self {
            Self::RegionOnly => PatchLook::Faint,
            Self::NoVerdict | Self::UnclassifiedPatch | Self::AbnormalPatch => PatchLook::Found,
        }
    }

    /// What one of them is called.
    pub fn part(self) -> &'static str {
        match self {
            Self::NoVerdict | Self::UnclassifiedPatch | Self::AbnormalPatch => "Patch",
            Self::RegionOnly => "Region",
        }
    }
}

/// "1 abnormal patch · 31 % of the LV", or what else the verdict lets it be called.
pub fn patch_heading(thickening: &Thickening, standing: PatchStanding) -> String {
    match (thickening.wall_thickening, thickening.patches.as_slice()) {
        (WallThickening::HardlyAnywhere, _) => "Global hypokinesia".to_owned(),
        (_, []) => "No patch".to_owned(),
        (_, patches) => {
            let share: f64 = patches.iter().map(|patch| patch.share).sum();
            let [one, more] = match standing {
                PatchStanding::NoVerdict => ["patch", "patches"],
                PatchStanding::UnclassifiedPatch => {
                    ["patch of low thickening", "patches of low thickening"]
                }
                PatchStanding::AbnormalPatch => ["abnormal patch", "abnormal patches"],
                PatchStanding::RegionOnly => {
                    ["region of low thickening", "regions of low thickening"]
                }
            };
            let count = patches.len();
            let what = if count == 1 { one } else { more };
            format!("{count} {what} · {} of the LV", percent(share))
        }
    }
}

/// "Smallest detectable area 2.1 cm² (2.0 % of the LV)"; empty where nothing is known of it.
pub fn smallest_words(thickening: &Thickening) -> String {
    let Some(smallest) = thickening.smallest else {
        return String::new();
    };
    let share = format!("{:.1} % of the LV", 100.0 * smallest.share);
    match smallest.area_cm2 {
        Some(area) => format!("Smallest detectable area {} ({share})", area_text(area)),
        None => format!("Smallest detectable area {share}"),
    }
}

/// "Patch 1", "Region 1": by its place in the list.
pub fn part_name(standing: PatchStanding, index: usize) -> String {
    format!("{} {}", standing.part(), index + 1)
}

/// How much the wall thickens, in a sentence.
pub fn wall_thickening_words(thickening: &Thickening) -> String {
    let remote = percent(thickening.remote.exp() - 1.0);
    match thickening.wall_thickening {
        WallThickening::HardlyAnywhere => {
            format!(
                "Even the region of highest thickening reaches only {remote}: no patch is reported"
            )
        }
        WallThickening::Everywhere => {
            format!("No region of low thickening; remote myocardium thickens by {remote}")
        }
        WallThickening::AllButPatches => format!("Remote myocardium thickens by {remote}"),
    }
}

/// The walls that a patch touches, the largest share first, each with its levels: "basal–mid
/// anteroseptal, apical septal and inferior, apex".
pub fn segment_words(patch: &Patch) -> String {
    let mut walls: Vec<(&str, Vec<Level>)> = Vec::new();
    let named = (patch.segments.iter()).filter(|part| part.of_patch >= MIN_OF_PATCH);
    for part in named {
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

/// "4.3 cm²", with the digits of the column of areas.
pub fn area_text(area_cm2: f64) -> String {
    let column = PatchRow::AREA_CM2;
    format!(
        "{} {}",
        column.digits.shown(area_cm2),
        column.unit.symbol(LengthUnit::Millimetre)
    )
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
            stability: 1.0,
            path: Vec::new(),
            temporal_consistency: TemporalConsistency::default(),
        }
    }

    #[test]
    fn segments_are_said_as_a_person_would() {
        let words = |segments: &[u8]| segment_words(&patch(segments));
        assert_eq!(words(&[8]), "mid anteroseptal");
        assert_eq!(words(&[2, 8]), "basal–mid anteroseptal");
        assert_eq!(words(&[1, 13]), "basal and apical anterior");
        assert_eq!(words(&[7, 17, 1, 13]), "basal–apical anterior, apex");
        let wide = words(&[8, 2, 14, 16, 15, 9]);
        assert_eq!(
            wide,
            "basal–mid anteroseptal, apical septal, lateral and inferior, mid inferoseptal"
        );
        assert_eq!(words(&[]), "");
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
