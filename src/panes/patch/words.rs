//! What the window says of patches beside their numbers: the note over the picture, and why a part is not called abnormal.

use crate::analysis::thickening::Thickening;
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
        .and_then(|told| told.as_ref().ok());
    let why = match (state.patch_standing(subject), verdict.map(|v| v.finding)) {
        (PatchStanding::Abnormal, _) => return String::new(),
        (PatchStanding::NoVerdict, _) => "There is no verdict yet",
        (PatchStanding::Patch, _) => "No classifier tells whether it is abnormal",
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

/// What the picture of a subject says of its patches; `None` where they are hidden or nothing is known yet.
pub fn patch_note(state: &State, subject: usize) -> Option<PatchNote> {
    let document = &state.document;
    if !document.visibility.patches {
        return None;
    }
    let (Ok(found), _) = state.wall_of(subject)? else {
        return None;
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
    Some(PatchNote {
        heading,
        lines,
        found: !thickening.patches.is_empty() && standing != PatchStanding::LowThickening,
    })
}
