//! What the polar map shows, as plain values.

use crate::analysis::segments::Segment;
use crate::panes::work_state::WorkState;
use crate::picture::{BullsEyeScale, PolarMap, PolarPatch, PolarValues};

/// A patch on the plot.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BullsEyePatch {
    /// Outline, hatch and middle in the unit disc.
    pub shape: PolarPatch,
    /// "1": its number in the table of patches.
    pub number: String,
    /// "Patch 1 · 31 % of the LV".
    pub name: String,
    /// Whether it is selected.
    pub selected: bool,
    /// Whether the verdict is not an abnormal patch: dashed and grey.
    pub faint: bool,
}

/// What the pane shows.
#[derive(Clone, Debug)]
pub struct BullsEyeView<'a> {
    /// State of the measurement of the wall.
    pub state: WorkState,
    /// Why there is no map, where the wall is known and the long axis is not.
    pub without_axis: Option<&'a str>,
    /// What is shown, in which colours and words.
    pub scale: &'a BullsEyeScale,
    /// Whose wall it is.
    pub subject: &'a str,
    /// The pose on screen: "ES", "frame 3".
    pub moment: &'a str,
    /// One colour for each segment.
    pub by_segment: bool,
    /// Where atoms lie, with faces over them; no atoms where there is no map.
    pub flat: &'a PolarMap,
    /// Values of atoms and segments.
    pub shown: &'a PolarValues,
    /// Borders of the patches.
    pub patches: &'a [BullsEyePatch],
    /// The selected segment.
    pub selected: Option<Segment>,
}
