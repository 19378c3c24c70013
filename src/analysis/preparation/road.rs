//! The roads from an image to walls.

use crate::analysis::walls_from_masks::MaskLabels;

/// How walls are found in an image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Road {
    /// The values of the image are labels of tissues.
    Masks(MaskLabels),
    /// Gated perfusion: the myocardium is what is bright.
    Spect,
    /// Cine magnetic resonance: blood is bright, and somebody marked where the ventricle is.
    Cine,
    /// Somebody drew outlines in the slices.
    Contours,
}

impl Road {
    /// All of them, masks with the labels of ACDC.
    pub const ALL: [Self; 4] = [
        Self::Masks(MaskLabels {
            cavity: 3,
            wall: 2,
            right: Some(1),
        }),
        Self::Spect,
        Self::Cine,
        Self::Contours,
    ];

    /// The word for it in files and options.
    pub fn name(self) -> &'static str {
        match self {
            Self::Masks(_) => "masks",
            Self::Spect => "spect",
            Self::Cine => "cine",
            Self::Contours => "contours",
        }
    }

    /// What it starts from, in words.
    pub fn words(self) -> &'static str {
        match self {
            Self::Masks(_) => "label image",
            Self::Spect => "gated SPECT",
            Self::Cine => "cine MR",
            Self::Contours => "drawn contours",
        }
    }
}
