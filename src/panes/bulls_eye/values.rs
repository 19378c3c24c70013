//! What the polar map shows, as plain values.

use crate::analysis::segments::Segment;
use crate::panes::patch::WallState;
use crate::picture::BullsEyeScale;

/// A patch on the plot.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BullsEyePatch {
    /// Closed borders, x to the right and y up in the unit disc.
    pub borders: Vec<Vec<[f64; 2]>>,
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
    /// The selected subject.
    pub subject: Option<&'a str>,
    /// State of its measurement.
    pub state: &'a WallState,
    /// Why there is no map, where the wall is known and the long axis is not.
    pub without_axis: Option<&'a str>,
    /// What is shown, in which colours and words.
    pub scale: &'a BullsEyeScale,
    /// The pose on screen: "ES", "frame 3".
    pub moment: &'a str,
    /// One colour for each segment.
    pub by_segment: bool,
    /// Atoms, x to the right and y up in the unit disc.
    pub points: &'a [[f64; 2]],
    /// Faces over atoms.
    pub faces: &'a [[u32; 3]],
    /// Value of each atom; not a number where it does not take part.
    pub values: &'a [f32],
    /// Mean of each segment.
    pub segments: [Option<f64>; Segment::COUNT],
    /// Borders of the patches.
    pub patches: &'a [BullsEyePatch],
    /// The selected segment.
    pub selected: Option<Segment>,
    /// Whether septum and anterior wall are known, and so segments have names.
    pub oriented: bool,
}
