//! What the colours on a heart can stand for.

use serde::{Deserialize, Serialize};

/// A number on every vertex, or plain tissue.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Quantity {
    /// Colour of tissue; no number.
    #[default]
    Tissue,
    /// Distance from the vertex's place at end-diastole.
    Displacement,
    /// Area around the vertex relative to end-diastole; 1 is unchanged.
    AreaRatio,
    /// PT: thickness of the wall relative to end-diastole, from its medial surface; 1 is unchanged.
    ThicknessRatio,
    /// Share in the squared distance of the two poses side by side, per area, relative to the mean.
    Contribution,
    /// Difference of a transported motion from the subject's own motion at the same phase.
    #[serde(rename = "carried-distance")]
    MotionDifference,
}

impl Quantity {
    /// Those that a heart has by itself, in the order in which one key steps through them.
    pub const ALL: [Self; 4] = [
        Self::Tissue,
        Self::Displacement,
        Self::AreaRatio,
        Self::ThicknessRatio,
    ];

    /// Those that two hearts have together.
    pub const OF_TWO: [Self; 2] = [Self::Contribution, Self::MotionDifference];

    /// The word in menus.
    pub fn name(self) -> &'static str {
        match self {
            Self::Tissue => "Tissue",
            Self::Displacement => "Displacement",
            Self::AreaRatio => "Area ratio",
            Self::ThicknessRatio => "Thickness ratio",
            Self::Contribution => "Contribution to the distance",
            Self::MotionDifference => "Difference from the subject's own motion",
        }
    }

    /// The word on the command line and in the text that a picture file holds.
    pub fn word(self) -> &'static str {
        match self {
            Self::Tissue => "tissue",
            Self::Displacement => "displacement",
            Self::AreaRatio => "area-ratio",
            Self::ThicknessRatio => "thickness-ratio",
            Self::Contribution => "contribution",
            Self::MotionDifference => "carried-distance",
        }
    }

    /// The next one of a heart by itself, and after the last the first.
    pub fn next(self) -> Self {
        match self {
            Self::Tissue => Self::Displacement,
            Self::Displacement => Self::AreaRatio,
            Self::AreaRatio => Self::ThicknessRatio,
            Self::ThicknessRatio | Self::Contribution | Self::MotionDifference => Self::Tissue,
        }
    }

    /// Whether its numbers come from an analysis and not from the surfaces alone.
    pub fn is_analysed(self) -> bool {
        matches!(
            self,
            Self::ThicknessRatio | Self::Contribution | Self::MotionDifference
        )
    }
}
