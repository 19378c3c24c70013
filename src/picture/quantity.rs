//! What the colours on a subject can stand for, and which colours, title and unit that has.

use serde::{Deserialize, Serialize};

use crate::picture::colour_map::ColourMap;
use crate::units::LengthUnit;

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

    /// The title of its colour bar; `None` for tissue, which has no numbers.
    pub(crate) fn title(self) -> Option<&'static str> {
        match self {
            Self::Tissue => None,
            Self::Displacement => Some("Displacement from end-diastole"),
            Self::AreaRatio => Some("Area relative to end-diastole"),
            Self::ThicknessRatio => Some("PT, thickness ratio to end-diastole"),
            Self::Contribution => Some("Contribution to the distance"),
            Self::MotionDifference => Some("Difference from own motion"),
        }
    }

    /// The unit of its numbers; empty for ratios.
    pub(crate) fn unit(self, length: LengthUnit) -> &'static str {
        match self {
            Self::Displacement | Self::MotionDifference => length.length_symbol(),
            Self::Contribution => "relative to the mean",
            Self::Tissue | Self::AreaRatio | Self::ThicknessRatio => "",
        }
    }

    /// Its colours, the same on the surface, the bull's-eye and the legend; `None` for tissue.
    pub(crate) fn colour_map(self) -> Option<ColourMap> {
        match self {
            Self::Tissue => None,
            Self::Displacement => Some(ColourMap::viridis()),
            Self::AreaRatio | Self::ThicknessRatio => Some(ColourMap::ratio()),
            Self::Contribution | Self::MotionDifference => Some(ColourMap::cividis()),
        }
    }

    /// The next of [`Self::ALL`]; the first after the last, and after one that a subject has not by itself.
    pub fn next(self) -> Self {
        let place = Self::ALL.iter().position(|&other| other == self);
        Self::ALL[place.map_or(0, |place| (place + 1) % Self::ALL.len())]
    }

    /// Whether its numbers come from an analysis and not from the surfaces alone.
    pub fn is_analysed(self) -> bool {
        matches!(
            self,
            Self::ThicknessRatio | Self::Contribution | Self::MotionDifference
        )
    }
}
