//! The bull's-eye of the selected subject: projected once, coloured at every pose.

use std::sync::Arc;

use crate::analysis::verdicts::SubjectThickening;
use crate::document::document::nearest_frame;
use crate::document::state::State;
use crate::panes::patch::view::wall_state;
use crate::picture::{
    BullsEyeScale, CohortColourRanges, PatchStanding, PolarMap, PolarValues, WallPart, part_name,
    percent,
};

use super::{BullsEyePatch, BullsEyeView};

/// What the atoms' colours are made from and how the plot is laid.
#[derive(Debug, Default)]
pub struct BullsEyeData {
    made_from: Option<Arc<SubjectThickening>>,
    flat: PolarMap,
    shown: PolarValues,
    patches: Vec<BullsEyePatch>,
    subject: String,
    moment: String,
    without_axis: Option<String>,
    scale: BullsEyeScale,
}

fn patch_name(found: &SubjectThickening, standing: PatchStanding, index: usize) -> String {
    let share = found
        .thickening
        .patches
        .get(index)
        .map_or(0.0, |patch| patch.share);
    let what = match standing {
        PatchStanding::NoVerdict => "",
        PatchStanding::AbnormalPatch => " · abnormal",
        PatchStanding::UnclassifiedPatch | PatchStanding::RegionOnly => " · low thickening",
    };
    let part = part_name(standing, index);
    format!("{part}{what} · {} of the LV", percent(share))
}

impl BullsEyeData {
    /// Lays the wall flat again where it changed, and takes the values of the pose on screen.
    pub fn refresh(&mut self, state: &State, cohort: &CohortColourRanges) {
        let document = &state.document;
        let quantity = document.bulls_eye;
        let unit = document.selected().map(|subject| subject.unit);
        let typed = document.limits_of(quantity.on_heart());
        let scale = BullsEyeScale::of(quantity, cohort, typed, unit.unwrap_or_default());
        let known = state.wall_of(document.subject).zip(document.selected());
        let Some(((Ok(found), _), subject)) = known else {
            *self = Self {
                scale,
                ..Self::default()
            };
            return;
        };
        let made = self.made_from.as_ref();
        if !made.is_some_and(|made| Arc::ptr_eq(made, found)) {
            *self = Self {
                made_from: Some(Arc::clone(found)),
                without_axis: found.without_axis.clone(),
                flat: PolarMap::of(found).unwrap_or_default(),
                ..Self::default()
            };
        }
        self.scale = scale;
        let frame = nearest_frame(document.position, found.beat.frames.len());
        self.subject.clone_from(&subject.id);
        self.moment = state.moment_name(document.subject, frame);
        self.shown = self.flat.values(found, subject, quantity, frame);
        let selected = document.selected_patch();
        let standing = state.patch_standing(state.document.subject);
        self.patches = (self.flat.patches.iter().enumerate())
            .filter(|_| state.document.visibility.patches)
            .map(|(index, shape)| BullsEyePatch {
                shape: shape.clone(),
                number: (index + 1).to_string(),
                name: patch_name(found, standing, index),
                faint: standing == PatchStanding::RegionOnly,
                selected: selected == Some(index),
            })
            .collect();
    }

    /// What the pane shows.
    pub fn view<'a>(&'a self, state: &'a State) -> BullsEyeView<'a> {
        let document = &state.document;
        BullsEyeView {
            state: wall_state(state),
            without_axis: self.without_axis.as_deref(),
            scale: &self.scale,
            subject: &self.subject,
            moment: &self.moment,
            by_segment: document.bulls_eye_segments,
            flat: &self.flat,
            shown: &self.shown,
            patches: &self.patches,
            selected: match document.part {
                Some(WallPart::Segment(segment)) => Some(segment),
                _ => None,
            },
        }
    }
}
