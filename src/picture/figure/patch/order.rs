//! What a patch figure is made from.

use crate::analysis::verdicts::{SubjectThickening, Verdicts};
use crate::picture::figure::make::FigureOrder;
use crate::picture::patch_words::PatchStanding;

/// A patch figure: a figure, and the results beside the heart.
#[derive(Clone, Copy, Debug)]
pub struct PatchOrder<'a> {
    /// The heart and how it looks; the middle of its wall is among its extras where it is drawn.
    pub figure: FigureOrder<'a>,
    /// How its wall thickens.
    pub wall: &'a SubjectThickening,
    /// The verdicts of all subjects; `None` where they are not known.
    pub verdicts: Option<&'a Verdicts>,
    /// Which of them this one is.
    pub subject: usize,
}

impl PatchOrder<'_> {
    /// What the regions of low thickening are called.
    pub(super) fn standing(&self) -> PatchStanding {
        PatchStanding::of((self.verdicts).and_then(|all| all.subjects.get(self.subject)))
    }
}
