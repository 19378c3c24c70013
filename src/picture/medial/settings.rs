//! What of the middle of the wall is drawn, and of which heart.

use crate::analysis::segments::Segment;
use crate::analysis::verdicts::SubjectThickening;

use super::prepared::PreparedMedial;

/// A part of the wall that is selected.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum WallPart {
    /// A patch of the heart, by its place in the list.
    Patch(usize),
    /// A segment, of every heart.
    Segment(Segment),
}

/// How borders of patches look.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum PatchLook {
    /// As what was found in the heart.
    #[default]
    Found,
    /// As places that thicken little in a heart of which something else is said: dashed and grey.
    Faint,
}

/// What of the medial surface is drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct MedialSettings {
    /// Atoms as discs coloured by PT.
    pub atoms: bool,
    /// Spokes to both sides of the wall.
    pub spokes: bool,
    /// Borders of patches.
    pub patches: bool,
    /// How they look.
    pub patch_look: PatchLook,
    /// ANV as an arrow from MP.
    pub direction: bool,
    /// The part that is selected.
    pub part: Option<WallPart>,
    /// Typed limits of the colours of atoms.
    pub limits: Option<[f64; 2]>,
}

impl MedialSettings {
    /// What a patch figure draws: atoms, and borders of patches.
    pub fn of_patch_figure() -> Self {
        Self {
            atoms: true,
            patches: true,
            ..Self::default()
        }
    }
}

/// The medial surface of one subject, prepared, and its assessed wall.
#[derive(Clone, Copy, Debug)]
pub struct SubjectMedial<'a> {
    /// The atoms.
    pub prepared: &'a PreparedMedial,
    /// How they thicken, and the patches.
    pub wall: &'a SubjectThickening,
}
