//! What is said of patches: how many, how large, where, and whether they may be called abnormal.

use crate::analysis::segments::{Level, Segment};
use crate::analysis::thickening::{Extent, Patch, Thickening};
use crate::analysis::verdicts::Finding;
use crate::app::state::State;
use crate::picture::WallPart;
use crate::ui::{PatchNote, PatchStanding};

/// Share of a patch below which a segment goes without saying.
const LEAST_OF_PATCH: f64 = 0.05;

/// "1 abnormal patch · 31 % of the LV", or what else the verdict lets it be called.
pub fn heading(found: &Thickening, standing: PatchStanding) -> String {
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

/// What the whole wall does, in a sentence.
pub fn extent_note(found: &Thickening) -> String {
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

/// Why the parts are called so; empty where there are none, or where they are abnormal.
pub fn standing_note(state: &State, found: &Thickening) -> String {
    let subject = state.document.subject;
    if found.patches.is_empty() {
        return String::new();
    }
    let verdict = state
        .verdict_of(subject)
        .and_then(|told| told.as_ref().ok());
    let why = match (state.patch_standing(subject), verdict.map(|v| v.finding)) {
        (PatchStanding::Abnormal, _) => return String::new(),
        (PatchStanding::Untold, _) => "Whether that is abnormal is not told yet",
        (_, Some(Finding::Nothing)) => {
            "The verdict is no abnormal patch: the wall works as in normal hearts"
        }
        (_, Some(Finding::GlobalFailure)) => "The verdict is global failure: no part stands out",
        _ => "The verdict is no abnormal patch",
    };
    format!(". {why}")
}

/// "Patch 1", "Place 1": a part of the wall by its place in the list.
pub fn part_name(standing: PatchStanding, index: usize) -> String {
    format!("{} {}", standing.part(), index + 1)
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

/// What the picture of a heart says of its patches; `None` where they are hidden or nothing is known yet.
pub fn patch_note(state: &State, subject: usize) -> Option<PatchNote> {
    let document = &state.document;
    if !document.visibility.patches {
        return None;
    }
    let (Ok(found), _) = state.wall_of(subject)? else {
        return None;
    };
    let thickening = &found.thickening;
    let chosen = match document.part {
        Some(WallPart::Patch(patch)) if subject == document.subject => Some(patch),
        _ => None,
    };
    let one = match (thickening.patches.as_slice(), chosen) {
        ([only], _) => Some((0, only)),
        (patches, Some(index)) => patches.get(index).map(|patch| (index, patch)),
        _ => None,
    };
    let standing = state.patch_standing(subject);
    let mut heading = heading(thickening, standing);
    let mut lines = Vec::new();
    if let Some((index, patch)) = one {
        if thickening.patches.len() > 1 {
            let count = thickening.patches.len();
            heading = format!(
                "{} of {count} · {} of the LV",
                part_name(standing, index),
                percent(patch.share)
            );
        }
        if !patch.segments.is_empty() {
            lines.push(segment_words(patch));
        }
        let area = patch.area_cm2.map(|area| format!("{} · ", area_text(area)));
        lines.push(format!(
            "{}PT {:.2} × · elsewhere {:.2} ×",
            area.unwrap_or_default(),
            patch.thickening.exp(),
            thickening.well.exp()
        ));
    } else {
        for patch in thickening.patches.iter().take(3) {
            let area = patch
                .area_cm2
                .map_or_else(|| percent(patch.share), area_text);
            lines.push(match patch.segments.as_slice() {
                [] => area,
                _ => format!("{area} · {}", segment_words(patch)),
            });
        }
    }
    Some(PatchNote {
        heading,
        lines,
        found: !thickening.patches.is_empty() && standing != PatchStanding::ThickensLittle,
    })
}

/// No more digits than an area deserves.
fn area_text(area_cm2: f64) -> String {
    if area_cm2 < 9.95 {
        format!("{area_cm2:.1} cm²")
    } else {
        format!("{area_cm2:.0} cm²")
    }
}

pub fn percent(share: f64) -> String {
    format!("{:.0} %", 100.0 * share)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::analysis::thickening::{PatchSegment, Steadiness};
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
            steadiness: Steadiness::default(),
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
}
