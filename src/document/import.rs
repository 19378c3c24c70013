//! The import of images: at which step it is, and the settings of each person's images. Plain values that undo restores.

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::analysis::preparation::Preparation;

/// The steps from images to a subject of the cohort, in their order.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub enum ImportStep {
    /// What was read, and what the files do not say.
    #[default]
    Images,
    /// Apex, base, septum and blood.
    Orientation,
    /// What the wall is: a threshold with edits, labels, or outlines.
    Tissue,
    /// Surfaces of every instant, and how they fit.
    Walls,
    /// The subject among the others.
    Cohort,
}

impl ImportStep {
    /// All steps in their order.
    pub const ALL: [Self; 5] = [
        Self::Images,
        Self::Orientation,
        Self::Tissue,
        Self::Walls,
        Self::Cohort,
    ];

    /// Its number, from 1.
    pub fn number(self) -> usize {
        self as usize + 1
    }

    /// So many steps on or back; `None` beyond the first and the last.
    pub fn stepped(self, step: i32) -> Option<Self> {
        let place = (self as usize).checked_add_signed(step as isize)?;
        Self::ALL.get(place).copied()
    }
}

/// What a click into a slice does.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ImageTool {
    /// It is the tip of the ventricle.
    Apex,
    /// It is the middle of the mitral ring.
    Base,
    /// It is a point of the septum, or of the right ventricle beyond it.
    Septum,
    /// It is blood of the left ventricle.
    Blood,
    /// A sphere around it is taken away.
    Eraser,
    /// A plane through it takes away what is farther from the apex or the middle of the heart.
    Cut,
    /// Only what is connected to it is kept.
    Keep,
}

/// Radius of the eraser at first, in millimetres.
const ERASER_MM: f64 = 10.0;

/// An import as the document holds it.
#[derive(Clone, Debug, PartialEq)]
pub struct Import {
    /// The step that is open.
    pub step: ImportStep,
    /// Settings that somebody made, by the index of the images; others have those that are proposed.
    pub settings: BTreeMap<usize, Arc<Preparation>>,
    /// Radius of the eraser in millimetres.
    pub eraser_mm: f64,
    /// Whether walls of all images of the batch are made, not of those on screen alone.
    pub batch: bool,
}

impl Default for Import {
    fn default() -> Self {
        Self {
            step: ImportStep::default(),
            settings: BTreeMap::new(),
            eraser_mm: ERASER_MM,
            batch: false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_are_walked_forth_and_back_and_end_at_both_ends() {
        let mut step = ImportStep::Images;
        for number in 1..=5 {
            assert_eq!(step.number(), number);
            step = step.stepped(1).unwrap_or(step);
        }
        assert_eq!(step, ImportStep::Cohort);
        assert_eq!(step.stepped(1), None);
        assert_eq!(ImportStep::Images.stepped(-1), None);
        assert_eq!(step.stepped(-1), Some(ImportStep::Walls));
    }
}
