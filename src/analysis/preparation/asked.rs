//! What somebody must say before an image gives walls: nothing of it is guessed.

use super::{ImageFacts, Preparation, Road};

/// What somebody must say before an image gives walls, or may say.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Asked {
    /// Distances between voxels.
    Spacing,
    /// Times of the volumes; walls can be made without.
    Times,
    /// Which label is which tissue.
    Labels,
    /// The tip of the ventricle.
    Apex,
    /// The middle of the mitral ring.
    Base,
    /// A point of the blood.
    Blood,
    /// Outlines of both surfaces.
    Outlines,
}

impl Asked {
    /// Whether there are no walls without it.
    pub fn is_needed(self) -> bool {
        self != Self::Times
    }

    /// What is missing, in words.
    pub fn words(self) -> &'static str {
        match self {
            Self::Spacing => "the distances between voxels",
            Self::Times => "the times of the volumes",
            Self::Labels => "which labels are cavity and wall",
            Self::Apex => "the apex",
            Self::Base => "the middle of the mitral ring",
            Self::Blood => "a point of the blood in the left ventricle",
            Self::Outlines => "outlines of endocardium and epicardium",
        }
    }
}

/// What somebody is asked for before an image gives walls by these settings, in the order in which it is needed.
pub fn asked(facts: &ImageFacts, preparation: &Preparation) -> Vec<Asked> {
    let mut asked = Vec::new();
    let mut ask = |what, missing: bool| {
        if missing {
            asked.push(what);
        }
    };
    let spacing_known = facts.spacing_known || preparation.spacing_mm.is_some();
    ask(Asked::Spacing, !spacing_known);
    match preparation.road {
        Road::Masks(labels) => {
            let occurs = |label| facts.labels.iter().flatten().any(|&other| other == label);
            let both = occurs(labels.cavity) && occurs(labels.wall);
            ask(Asked::Labels, !both);
        }
        Road::Spect => {}
        Road::Cine => {
            ask(Asked::Apex, preparation.points.apex.is_none());
            ask(Asked::Base, preparation.points.base.is_none());
            ask(Asked::Blood, preparation.points.blood.is_none());
        }
        Road::Contours => {
            let none = preparation.contours.is_empty() && facts.contours == 0;
            ask(Asked::Outlines, none);
        }
    }
    let times_known = facts.times_known || preparation.times.is_some();
    ask(Asked::Times, !times_known);
    asked
}
