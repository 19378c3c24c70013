//! What the window says of patches beside their numbers: the note over the picture, and why a part is not called abnormal.

use crate::analysis::thickening::{Thickening, WallThickening};
use crate::analysis::verdicts::Finding;
use crate::document::state::State;
use crate::panes::viewport::overlay::PatchNote;
use crate::picture::{PatchStanding, area_text, part_name, patch_heading, percent, segment_words};
use crate::report::PatchRow;
use crate::units::LengthUnit;

/// Why the parts are called so; empty where there are none, or where they are abnormal.
pub fn standing_note(state: &State, found: &Thickening) -> String {
    let subject = state.document.subject;
    if found.patches.is_empty() {
        return String::new();
    }
    let verdict = state
        .verdict_of(subject)
        .and_then(|verdict| verdict.as_ref().ok());
    let why = match (state.patch_standing(subject), verdict.map(|v| v.finding)) {
        (PatchStanding::AbnormalPatch, _) => return String::new(),
        (PatchStanding::NoVerdict, _) => "There is no verdict yet",
        (PatchStanding::UnclassifiedPatch, _) => "No classifier tells whether it is abnormal",
        (_, Some(Finding::Nothing)) => {
            "Verdict: no regional abnormality; the wall thickens as in normal subjects"
        }
        (_, Some(Finding::GlobalHypokinesia)) => {
            "Verdict: global hypokinesia without a regional abnormality"
        }
        _ => "Verdict: no abnormal patch",
    };
    format!(". {why}")
}

/// "patch 31 %", "2 patches 40 %", where a heading has no room; the heading itself where there is no patch.
fn short_heading(heading: &str, standing: PatchStanding, shares: &[f64]) -> String {
    let share = percent(shares.iter().sum());
    match (standing, shares.len()) {
        (_, 0) => heading.to_owned(),
        (PatchStanding::RegionOnly, _) => format!("low thickening {share}"),
        (_, 1) => format!("patch {share}"),
        (_, count) => format!("{count} patches {share}"),
    }
}

/// What the picture of a subject says of its patches; `None` where they are hidden or nothing is known yet.
pub fn patch_note(state: &State, subject: usize) -> Option<PatchNote> {
    let document = &state.document;
    if !document.visibility.patches {
        return None;
    }
    let found = match state.wall_of(subject)? {
        (Ok(found), _) => found,
        (Err(_), _) => {
            // Beside a subject without a patch, silence would mean the same.
            return Some(PatchNote {
                heading: "Patches not assessed".to_owned(),
                short: "not assessed".to_owned(),
                ..PatchNote::default()
            });
        }
    };
    let thickening = &found.thickening;
    let chosen = (document.selected_patch()).filter(|_| subject == document.subject);
    let one = match (thickening.patches.as_slice(), chosen) {
        ([only], _) => Some((0, only)),
        (patches, Some(index)) => patches.get(index).map(|patch| (index, patch)),
        _ => None,
    };
    let standing = state.patch_standing(subject);
    let mut heading = patch_heading(thickening, standing);
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
        let ratio = PatchRow::THICKNESS_RATIO;
        let shown = |value: f64| {
            let symbol = ratio.unit.symbol(LengthUnit::default());
            format!("{} {symbol}", ratio.digits.shown(value))
        };
        lines.push(format!(
            "{}{} {} · remote {}",
            area.unwrap_or_default(),
            ratio.heading,
            shown(patch.thickening.exp()),
            shown(thickening.remote.exp())
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
    let shares: Vec<f64> = match (one, thickening.wall_thickening) {
        (_, WallThickening::HardlyAnywhere) => Vec::new(),
        (Some((_, patch)), _) => vec![patch.share],
        (None, _) => (thickening.patches.iter())
            .map(|patch| patch.share)
            .collect(),
    };
    Some(PatchNote {
        short: short_heading(&heading, standing, &shares),
        heading,
        lines,
        found: !thickening.patches.is_empty() && standing != PatchStanding::RegionOnly,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_heading_without_room_still_tells_patches_from_none() {
        let short = |standing, shares: &[f64]| short_heading("No patch", standing, shares);
        assert_eq!(short(PatchStanding::AbnormalPatch, &[0.09]), "patch 9 %");
        let several = short(PatchStanding::NoVerdict, &[0.09, 0.12]);
        assert_eq!(several, "2 patches 21 %");
        let low = short(PatchStanding::RegionOnly, &[0.08]);
        assert_eq!(low, "low thickening 8 %");
        assert_eq!(short(PatchStanding::RegionOnly, &[]), "No patch");
    }
}
